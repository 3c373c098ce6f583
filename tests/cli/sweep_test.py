#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`halfspace sweep` from end to end: which rows there are and which are refused, measures computed a second time from
pictures of other commands and from the co-simulation, the Pareto fronts by brute force, and that it goes on where it
was cut off. Usage: sweep_test.py HALFSPACE TB_PIPELINE_LOW_4"""
import csv
import itertools
import json
import math
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

HALFSPACE, BENCH = sys.argv[1], sys.argv[2]
SIZE = ["--size", "64x48"]
SUBPIXEL, FRACTION = (1, 3, 4), (8, 12, 13)  # 8 is refused in low
SWEEP = ["cube", "castle", "--config", "low", *SIZE, "--vary", "subpixel_bits=1,3,4", "--vary",
         "depth_fraction=8,12..13"]
# Keeps the script, and draws what ends as a PNG does.
FAKE_GNUPLOT = """#!/bin/sh
cat > "$SCRIPTS/$$"
printf 'PNG: IEND----'
"""
# In the place of python3: an area tool whose numbers follow from the package and the lanes, so that a test knows them.
FAKE_AREA = """#!/bin/sh
while [ $# -gt 0 ]; do
  case $1 in --package) package=$2;; --json) json=$2;; --lanes) lanes=$2;; esac
  shift
done
size=$(grep -c "" "$package")
[ "$lanes" = 2 ] && echo "no such part" && exit 3
echo '{"rows": [{"unit": "shade_setup", "target": "xilinx", "lut": 1},
 {"unit": "pipeline", "target": "xilinx", "lut": '$((size + 100 * lanes))', "dsp": 9, "cells": {}}],
 "buffers": [{"bits": 30}, {"bits": 12}], "yosys": "none"}' > "$json"
"""


def run(*args, **options):
    return subprocess.run([HALFSPACE, *map(str, args)], capture_output=True, text=True, timeout=120, check=False,
                          **options)


def good(*args, **options):
    result = run(*args, **options)
    if result.returncode:
        raise AssertionError(f"{args}: {result.stderr}")
    return result.stdout


def table(folder):
    with open(folder / "sweep.csv", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def measured(rows):
    return [row for row in rows if not row["refused"]]


def without_times(rows):
    return [{key: value for key, value in row.items() if key != "native_ms"} for row in rows]


def pareto(rows, costs):
    """Names of the rows that no other row of the scene beats, by comparing each with each."""
    points = {(row["scene"], row["config"]): [-float(row["psnr_db"]), *(float(row[cost]) for cost in costs)]
              for row in measured(rows) if row["psnr_db"]}
    return {key for key, mine in points.items()
            if not any(key[0] == other[0] and theirs != mine and all(a <= b for a, b in zip(theirs, mine))
                       for other, theirs in points.items())}


def words(path):
    data = path.read_bytes()
    return struct.unpack(f"<{len(data) // 4}I", data)


def channels(path):
    return [value for at, value in enumerate(path.read_bytes()) if at % 4 != 3]


def psnr(a, b):
    squares = sum((x - y) ** 2 for x, y in zip(a, b))
    return math.inf if squares == 0 else 10 * math.log10(255 ** 2 * len(a) / squares)


class Sweep(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.temporary.name)
        cls.out = cls.root / "it's a sweep"
        cls.told = good("sweep", *SWEEP, "--out", cls.out)
        cls.rows = table(cls.out)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def row(self, scene, config):
        found = [row for row in self.rows if (row["scene"], row["config"]) == (scene, config)]
        self.assertEqual(len(found), 1, config)
        return found[0]

    def toml(self, subpixel, fraction):
        path = self.root / f"low-subpixel_bits{subpixel}-depth_fraction{fraction}.toml"
        good("config", "low", "--toml", path)
        text = path.read_text().replace("subpixel_bits = 4", f"subpixel_bits = {subpixel}")
        text = text.replace("depth_fraction = 13", f"depth_fraction = {fraction}")
        path.write_text(text.replace('"low"', f'"{path.stem}"'))
        return path

    def test_rows_are_the_product_and_the_named(self):
        numbers = [(row["scene"], int(row["subpixel_bits"]), int(row["depth_fraction"])) for row in self.rows
                   if row["named"] in ("", "low")]
        self.assertEqual(numbers, list(itertools.product(("cube", "castle"), SUBPIXEL, FRACTION)))
        self.assertEqual([row["named"] for row in self.rows if row["named"]], 2 * ["low", "middle", "high"])
        self.assertEqual([row["config"] for row in self.rows if row["base"] == "true"],
                         2 * ["low-subpixel_bits4-depth_fraction13"])
        self.assertEqual(self.row("castle", "high")["depth_bits"], "24")
        self.assertEqual({(row["width"], row["height"]) for row in self.rows}, {("64", "48")})
        self.assertEqual(json.loads((self.out / "sweep.json").read_text())["vary"],
                         {"subpixel_bits": ["1", "3", "4"], "depth_fraction": ["8", "12", "13"]})

    def test_objects_cost_memory_and_nothing_else(self):
        out = self.root / "objects"
        good("sweep", "castle", "--config", "low", *SIZE, "--vary", "object_bits=0,4,7", "--no-named", "--out", out)
        none, *some = table(out)
        self.assertEqual([row["object_bits"] for row in [none, *some]], ["0", "4", "7"])
        for row in some:
            for same in ("psnr_db", "cycles", "bytes_depth_written", "bytes_index_read", "shimmer_rms_lsb"):
                self.assertEqual(row[same], none[same])
            depths = int(row["bytes_depth_read"]) - int(none["bytes_depth_read"])
            self.assertEqual(depths, 64 * 48 * int(row["depth_bits"]) // 8)
            written = int(row["triangles_drawn"]) * int(row["object_bits"])
            self.assertEqual(int(row["bytes_objects_written"]), -(-written // 8))
            self.assertGreater(int(row["bytes_objects_read"]), 0)
            added = depths + int(row["bytes_objects_read"]) + int(row["bytes_objects_written"])
            self.assertEqual(int(row["bytes"]) - int(none["bytes"]), added)

    def test_refused_with_the_reason_that_config_gives(self):
        refused = [row for row in self.rows if row["refused"]]
        self.assertEqual([row["depth_fraction"] for row in refused], 6 * ["8"])
        for row in refused[:3]:
            told = run("config", self.toml(row["subpixel_bits"], 8))
            self.assertEqual(told.returncode, 1)
            reason = row["refused"].split(" is refused: ")[1]
            self.assertIn(reason, told.stderr)
            self.assertIn(reason, self.told)
            self.assertEqual(row["psnr_db"] + row["cycles"] + row["pareto_cycles"], "")

    def test_json_and_csv_agree(self):
        rows = json.loads((self.out / "sweep.json").read_text())["rows"]
        self.assertEqual(len(rows), len(self.rows))
        for one, other in zip(rows, self.rows):
            self.assertEqual(list(one), list(other))
            for key, value in one.items():
                text = "" if value is None else str(value).lower() if isinstance(value, bool) else str(value)
                self.assertEqual(float(text) if isinstance(value, float) else text,
                                 float(other[key]) if isinstance(value, float) else other[key], key)

    def test_measures_of_a_point_from_other_commands(self):
        row, config = self.row("castle", "low-subpixel_bits3-depth_fraction12"), self.toml(3, 12)
        for engine in ("ideal", "ref", "hls"):
            good("render", "castle", *SIZE, "--engine", engine, "--config", config, "--dump", self.root / engine,
                 "--json", self.root / f"{engine}.json")
        index, depth, colour = ({e: read(self.root / e / name) for e in ("ideal", "ref", "hls")} for read, name in
                                ((words, "index.u32"), (words, "depth.u32"), (channels, "colour.rgba8")))
        pixels = range(64 * 48)
        self.assertEqual(int(row["triangles_drawn"]), json.loads((self.root / "hls.json").read_text())["triangles"])
        self.assertEqual(int(row["wrong_coverage_pixels"]),
                         sum((index["ideal"][n] == 0) != (index["hls"][n] == 0) for n in pixels))
        self.assertGreaterEqual(int(row["wrong_index_pixels"]), int(row["wrong_coverage_pixels"]))
        # The dump of the ideal picture is rounded to 8 bits.
        self.assertAlmostEqual(float(row["psnr_db"]), psnr(colour["ideal"], colour["hls"]), delta=0.1)
        self.assertAlmostEqual(float(row["reference_psnr_db"]) if row["reference_psnr_db"] else math.inf,
                               psnr(colour["ref"], colour["hls"]))
        same = [n for n in pixels if index["ref"][n] == index["hls"][n] != 0]
        self.assertEqual(int(row["reference_wrong_index_pixels"]),
                         sum(index["ref"][n] != index["hls"][n] for n in pixels))
        share = sum(depth["ref"][n] != depth["hls"][n] for n in same) / len(same)
        self.assertGreater(share, 0)
        self.assertAlmostEqual(float(row["depth_misrounded_share"]), share)
        differ = sum(colour["ref"][3 * n + c] != colour["hls"][3 * n + c] for n in same for c in range(3))
        share = differ / (3 * len(same))
        self.assertAlmostEqual(float(row["colour_misrounded_share"]), share)

    def test_bits_buy_accuracy(self):
        for scene in ("cube", "castle"):
            coarse, fine = (self.row(scene, f"low-subpixel_bits{f}-depth_fraction13") for f in (1, 4))
            self.assertGreater(float(fine["psnr_db"]), float(coarse["psnr_db"]))
            for measure in ("wrong_index_pixels", "depth_rms_ppm", "shimmer_rms_lsb", "shimmer_pixels"):
                self.assertLess(float(fine[measure]), float(coarse[measure]), measure)
            # Rounding to the nearest is off by up to 1/2, and by the bound of the planes beyond (docs/bounds.md).
            for row in (coarse, fine, self.row(scene, "high")):
                self.assertTrue(0.4 < float(row["stored_depth_largest_lsb"]) < 0.85, row)

    def test_cycles_of_the_cosimulation(self):
        for scene in ("cube", "castle"):
            vectors, report = self.root / f"{scene}.v", self.root / f"{scene}.cosim.json"
            good("vectors", scene, "--config", "low", "--lanes", 4, *SIZE, "--no-corners", "--out", vectors)
            subprocess.run([BENCH, vectors, "--json", report], check=True, capture_output=True)
            cycles = json.loads(report.read_text())["runs"][0]["cycles"]
            modelled = int(self.row(scene, "low-subpixel_bits4-depth_fraction13")["cycles"])
            self.assertAlmostEqual(modelled, cycles, delta=2 + 0.001 * cycles, msg=scene)

    def test_pareto_front_by_brute_force(self):
        front = pareto(self.rows, ["cycles"])
        self.assertEqual({(r["scene"], r["config"]) for r in self.rows if r["pareto_cycles"] == "true"}, front)
        self.assertTrue(2 <= len(front) < len(measured(self.rows)))

    def test_pictures(self):
        self.assertEqual(sorted(path.name for path in self.out.glob("*.png")),
                         ["depth_fraction.png", "front.png", "subpixel_bits.png"])
        good("sweep", "cube", "--config", "low", *SIZE, "--vary", "reciprocal_bits=18..19",
             "--vary", "colour_fraction=13..14", "--out", self.root / "map")
        for path in [*self.out.glob("*.png"), *(self.root / "map").glob("*.png")]:
            self.assertEqual(path.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
            self.assertGreater(path.stat().st_size, 8000, path)
        self.assertTrue((self.root / "map" / "map.png").exists())

    def test_plots_say_what_they_were_drawn_at(self):
        tools, scripts = self.root / "plots", self.root / "scripts"
        tools.mkdir(), scripts.mkdir()
        (tools / "gnuplot").write_text(FAKE_GNUPLOT)
        (tools / "gnuplot").chmod(0o755)
        environment = {"PATH": f"{tools}:/usr/bin:/bin", "SCRIPTS": str(scripts)}
        good("sweep", "cube", "castle", "--config", "low", *SIZE, "--no-named", "--vary", "subpixel_bits=2,3", "--vary",
             "depth_bits=15..16", "--out", self.root / "drawn", env=environment)
        titles = sorted(re.search(r"set multiplot .* title '(.*?)'", path.read_text()).group(1)
                        for path in scripts.iterdir())
        size = "frame " + SIZE[1]
        self.assertEqual(titles, ["accuracy and what it takes",
                                  f"depth bits; all else as in low, subpixel_bits = 2, {size}",
                                  f"sub-pixel bits f; all else as in low, {size}"])
        front = next(text for text in (path.read_text() for path in scripts.iterdir()) if "what it takes" in text)
        for cost in ("memories", "multipliers", "cycles"):
            self.assertEqual(len(re.findall(rf"set title 'c\w+: .*{cost}.*'", front)), 2, cost)
        rows = table(self.root / "drawn")
        for row in rows:
            f, b, g, h = (int(row[key]) for key in ("subpixel_bits", "depth_bits", "depth_fraction", "colour_fraction"))
            c, colour = int(row["range_bits"]) + f, int(row["colour_bits"])
            wide = [max(bits + c + 1, bits + fraction + f) for bits, fraction in ((b, g), (colour, h))]
            sides = sum((int(row[key]) - 1).bit_length() + 1 for key in ("largest_width", "largest_height"))
            self.assertEqual(int(row["multiplier_bits"]), (c + 1) ** 2 + 18 * sum(wide) + 3 * (colour + h) * sides)
        memory = {row["depth_bits"]: int(row["memory_bits"]) for row in rows}
        self.assertEqual(memory["16"] - memory["15"], 320 * 200)
        for flag, cost in (("pareto_memory", "memory_bits"), ("pareto_multiplier", "multiplier_bits")):
            self.assertEqual({(r["scene"], r["config"]) for r in rows if r[flag] == "true"}, pareto(rows, [cost]), flag)

    def test_goes_on_where_it_was_cut_off(self):
        out, sweep = self.root / "cut", ["cube", *SIZE, "--config", "low", "--vary", "lanes=1,4,16", "--no-named"]
        good("sweep", *sweep, "--out", out)
        whole, points = table(out), sorted((out / "points").iterdir())
        self.assertEqual(len(points), 3)
        cycles = [int(row["cycles"]) for row in whole]
        self.assertTrue(cycles[0] > cycles[1] >= cycles[2], cycles)
        for spoil in (lambda path: path.unlink(), lambda path: path.write_bytes(path.read_bytes()[:100])):
            spoil(points[1])
            states = [line.split("\t") for line in good("sweep", *sweep, "--out", out, "--list").splitlines()]
            self.assertEqual(sorted(state[-1] for state in states), ["done", "done", "to do"])
            before = {path: path.stat().st_mtime_ns for path in points if path != points[1]}
            failed = run("sweep", *sweep, "--out", out, "--merge")
            self.assertEqual((failed.returncode, len(failed.stderr.strip().splitlines())), (1, 1), failed.stderr)
            self.assertIn("1 of 3 points are not there", failed.stderr)
            good("sweep", *sweep, "--out", out)
            self.assertEqual({path: path.stat().st_mtime_ns for path in before}, before)
            self.assertEqual(without_times(table(out)), without_times(whole))
        # Point by point, as a workflow engine does.
        other = self.root / "pointwise"
        for number in (3, 1, 2):
            good("sweep", *sweep, "--out", other, "--point", number)
            self.assertFalse((other / "sweep.csv").exists())
        times = [path.stat().st_mtime_ns for path in sorted((other / "points").iterdir())]
        good("sweep", *sweep, "--out", other, "--point", 2)
        good("sweep", *sweep, "--out", other, "--merge")
        self.assertEqual([path.stat().st_mtime_ns for path in sorted((other / "points").iterdir())], times)
        self.assertEqual(without_times(table(other)), without_times(whole))

    def test_jobs_and_star(self):
        star = ["cube", "--config", "low", *SIZE, "--star", "--no-named", "--vary", "subpixel_bits=2,4",
                "--vary", "lanes=1,2"]
        for jobs in (1, 2):
            good("sweep", *star, "--out", self.root / f"star{jobs}", "--jobs", jobs)
        rows = table(self.root / "star1")
        self.assertEqual([row["config"] for row in rows], ["low", "low-subpixel_bits2", "low-lanes1", "low-lanes2"])
        self.assertEqual(without_times(rows), without_times(table(self.root / "star2")))

    def test_area_and_its_fronts(self):
        tools = self.root / "tools"
        tools.mkdir()
        (tools / "python3").write_text(FAKE_AREA)
        (tools / "python3").chmod(0o755)
        environment = {"PATH": f"{tools}:/usr/bin:/bin"}
        sweep = ["castle", *SIZE, "--config", "low", "--vary", "shading=gouraud,flat", "--area", "xilinx"]
        out = self.root / "area"
        good("sweep", *sweep, "--vary", "lanes=1,4,16", "--out", out, env=environment)
        rows = table(out)
        for row in rows:
            self.assertEqual((row["dsp_xilinx"], row["ff_xilinx"], row["buffer_bits"]), ("9", "", "42"))
        lut = {row["config"]: int(row["lut_xilinx"]) for row in rows}
        self.assertEqual(lut["low-shadinggouraud-lanes16"] - lut["low-shadinggouraud-lanes1"], 1500)
        for flag, costs in (("pareto_lut", ["lut_xilinx"]), ("pareto", ["cycles", "lut_xilinx"])):
            self.assertEqual({(r["scene"], r["config"]) for r in rows if r[flag] == "true"}, pareto(rows, costs), flag)
        self.assertFalse((out / "area").exists(), "files of the area tool were left")
        # A point that fails does not take the others with it, and is told.
        failed = run("sweep", *sweep, "--lanes", 2, "--no-named", "--out", self.root / "failed", env=environment)
        self.assertEqual(failed.returncode, 1)
        self.assertIn("2 of 4 points failed", failed.stderr)
        self.assertEqual(len(list((self.root / "failed/points").iterdir())), 2)
        self.assertFalse((self.root / "failed/sweep.csv").exists())

    def test_an_edited_module_is_measured_again(self):
        data = self.root / "data"
        shutil.copytree(pathlib.Path(good("--version").split("files: ")[1].strip()) / "rtl", data / "rtl")

        def points():
            return good("sweep", "cube", *SIZE, "--config", "low", "--area", "xilinx", "--list", "--out",
                        self.root / "w",
                        env={**os.environ, "HALFSPACE_DATA": str(data)}).splitlines()
        before = points()
        self.assertEqual(before, points())
        module = data / "rtl/raster/hs_raster_pineda.sv"
        module.write_text(module.read_text().replace("module ", "module  "))
        changed = set(before) - set(points())
        self.assertTrue(changed and all("area" in line for line in changed), changed)

    def test_bad_input(self):
        (self.root / "a.tri").write_text("size 40 30\nt 1 1 .5 9 9 9  30 2 .5 9 9 9  4 20 .5 9 9 9\n")
        out = self.root / "bad"
        cases = (
            (["nonesuch"], "nonesuch"), (["cube", "cube"], "twice"), (["cube", "--config", "none"], "none"),
            (["cube", "--vary", "bits=1"], "subpixel_bits"), (["cube", "--vary", "subpixel_bits"], "no values"),
            (["cube", "--vary", "subpixel_bits=2,x"], "'x'"), (["cube", "--vary", "subpixel_bits=1..99999"], "fewer"),
            (["cube", "--vary", "subpixel_bits=4..2"], "no values"), (["cube", "--vary", "shading=motion"], "motion"),
            (["cube", "--vary", "normal_bits=9"], "lights"),
            (["cube", "--vary", "mapping=affine,straight"], "straight"),
            (["cube", "--vary", "texels=64,128"], "texture"), (["cube", "--vary", "keys=1,2"], "motion"),
            (["cube", "--vary", "subpixel_bits=1", "--vary", "subpixel_bits=2"], "already"),
            (["cube", "--size", "9"], "640x480"), ([self.root / "a.tri", "--size", "9x9"], "40x30"),
            (["cube", "--area", "asic"], "asic"), (["cube", "--point", "99"], "--list"),
            (["cube", "--merge"], "--merge"))
        for args, word in cases:
            with self.subTest(args):
                result = run("sweep", *args, "--out", out)
                self.assertEqual(result.returncode, 1, result.stdout)
                self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
                self.assertIn(word, result.stderr)
                self.assertFalse(out.exists(), "something was written")
        for args in ([], ["cube", "--jobs", "0"], ["cube", "--list", "--merge"]):
            self.assertNotEqual(run("sweep", *args, "--out", out).returncode, 0)
        self.assertEqual(run("sweep", "cube", *SIZE, "--out", "/proc/none").returncode, 1)
        nothing = run("sweep", "cube", *SIZE, "--no-named", "--vary", "subpixel_bits=0", "--out", out)
        self.assertEqual((nothing.returncode, len(nothing.stderr.strip().splitlines())), (1, 1))
        self.assertIn("nothing could be measured", nothing.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
