#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the bench says of RTL that is wrong: the unit that is to blame, what follows from it, words that lack, the
cycle, the waveform around it, the map of wrong pixels, and the smallest frame that fails.
Usage: explain_test.py HALFSPACE ROOT FOLDER TB_LIBRARY VERILATED_LIBRARY VERILATOR CXX"""
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

HALFSPACE, ROOT, FOLDER, *LIBRARIES, VERILATOR, CXX = sys.argv[1:8]
ROOT, FOLDER = pathlib.Path(ROOT), pathlib.Path(FOLDER)
FAULTS = {"order": ("hs_vertex_order.sv", "if (key2 < key0 && key2 < key1) first_q", "if (key2 < key0) first_q"),
          "stuck": ("hs_scan_index.sv", "assign scan_valid_o = scan_valid_q;", "assign scan_valid_o = 1'b0;")}


def build(top, fault, name):
    """The bench of a module in RTL with this fault, or without one."""
    out = FOLDER / name
    rtl = out / "rtl"
    shutil.copytree(ROOT / "rtl", rtl)
    if fault:
        file, old, new = FAULTS[fault]
        path = next(rtl.glob(f"*/{file}"))
        text = path.read_text()
        assert text.count(old) == 1, f"{old} is not once in {file}"
        path.write_text(text.replace(old, new))
    libraries = [word for library in LIBRARIES for word in ("--library", library)]
    subprocess.run([sys.executable, ROOT / "tb/model.py", "--package", ROOT / "rtl/formats/low/hs_formats_pkg.sv",
                    "--lanes", "4", "--top", top, "--rtl", rtl, "--out", out / "model", *libraries, "--verilator",
                    VERILATOR, "--cxx", CXX, "--optimize=-O0"], check=True, capture_output=True)
    return out / "model/bench"


def run(bench, *options):
    """Status and text."""
    result = subprocess.run([bench, FOLDER / "vectors", *options], capture_output=True, text=True, check=False)
    return result.returncode, result.stdout + result.stderr


def wave_times(path):
    """First and last time of an .fst file, from the block at its begin."""
    kind, _, first, last = struct.unpack(">BQQQ", path.read_bytes()[:25])
    assert kind == 0, "no header of an .fst file"
    return first, last


def red_and_blue(path):
    """Pixels of these colours in a PNG file of the bench, which stores rows without a filter."""
    data, at, rows, size = path.read_bytes(), 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + body)
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        rows += body if kind == b"IDAT" else b""
        at += 12 + length
    raw = zlib.decompress(rows)
    width, height = size
    pixels = [raw[y * (4 * width + 1) + 1 + 4 * x:][:3] for y in range(height) for x in range(width)]
    return pixels.count(bytes((255, 40, 40))), pixels.count(bytes((40, 80, 255)))


class Explain(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        subprocess.run([HALFSPACE, "vectors", "teapot", "--config", "low", "--lanes", "4", "--size", "64x48",
                        "--no-corners", "--out", FOLDER / "vectors"], check=True, capture_output=True)

    def test_the_first_unit_and_what_follows(self):
        bench, pictures = build("hs_pipeline", "order", "order"), FOLDER / "pictures"
        pictures.mkdir()
        status, text = run(bench, "--pictures", pictures)
        self.assertEqual(status, 1)
        told = [line.split()[2] for line in text.splitlines() if line.startswith("FAIL pipeline: ")]
        self.assertTrue(told and set(told) <= {"setup", "attributes", "hang:"}, told)
        self.assertIn("first wrong in flow order: triangle_setup; from it follows:\n", text)
        self.assertRegex(text, r"\n  stamp word \d+ \(raster_pineda")
        self.assertRegex(text, r"FAIL pipeline: setup word .*, cycle \d+: ")
        self.shrinks(bench)
        wrong, lacks = map(int, re.search(r"wrong_pixels.png: (\d+) pixels .* (\d+) never", text).groups())
        self.assertGreater(wrong, 0)
        self.assertEqual(red_and_blue(pictures / "wrong_pixels.png"), (wrong, lacks))
        self.assertEqual(red_and_blue(pictures / "frame_rtl.png"), (0, 0))

    def shrinks(self, bench):
        """The fewest triangles of the same scene on which it still fails, and the command that repeats it."""
        out = FOLDER / "smallest"
        subprocess.run([HALFSPACE, "shrink", "teapot", "--config", "low", "--lanes", "4", "--size", "64x48", "--stall",
                        "30", "--bench", bench, "--out", out, "--json", FOLDER / "shrink.json"], check=True,
                       capture_output=True)
        found = json.loads((FOLDER / "shrink.json").read_text())
        self.assertLessEqual(found["triangles"], 3)
        self.assertLess(found["width"] * found["height"], 64 * 48 / 4)
        self.assertEqual((found["stall"], found["frames"], found["first_wrong"]), (0, 1, "triangle_setup"))
        lines = (out / "smallest.tri").read_text().splitlines()
        self.assertEqual(lines[0], f"size {found['width']} {found['height']}")
        self.assertEqual(sum(line.startswith("t ") for line in lines), found["triangles"])
        again = subprocess.run(["sh", out / "repeat.sh"], capture_output=True, text=True, check=False)
        self.assertEqual(again.returncode, 1)
        self.assertIn("FAIL pipeline: setup word", again.stdout)

    def test_words_that_lack_are_not_mismatches(self):
        status, text = run(build("hs_pipeline", "stuck", "stuck"), "--hang", "2000")
        self.assertEqual(status, 1)
        self.assertIn("first wrong in flow order: scan_index; from it follows:\n  missing: ", text)
        self.assertRegex(text, r"FAIL pipeline: missing: \d+ of \d+ words on scan ")
        self.assertNotRegex(text, r"FAIL pipeline: missing: \d+ of \d+ words on pixel ")
        self.assertRegex(text, r", 0 mismatches, [1-9]\d* missing, \d+ cycles\n$")

    def test_a_waveform_around_the_first_failure(self):
        bench, wave = build("hs_triangle_setup", "order", "wave"), FOLDER / "wave.fst"
        status, text = run(bench, "--wave", wave, "--around", "30")
        self.assertEqual(status, 1)
        cycles = [int(number) for number in re.findall(r"FAIL .* cycle (\d+): ", text)]
        first = int(re.search(r"the first failure is in cycle (\d+), at \d+ ns", text).group(1))
        self.assertEqual(first, min(cycles[:2]))
        self.assertEqual(wave_times(wave), (10 * (first - 30), 10 * (first + 30) + 5))
        # The model is built for it, and no sooner.
        self.assertTrue((FOLDER / "wave.fst.model/bench").exists())
        bench, wave = build("hs_triangle_setup", None, "right"), FOLDER / "none.fst"
        none = subprocess.run([HALFSPACE, "shrink", "cube", "--config", "low", "--size", "16x12", "--bench", bench,
                               "--out", FOLDER / "none"], capture_output=True, text=True, check=False)
        self.assertEqual(none.returncode, 1)
        self.assertIn("there is nothing to shrink", none.stderr)
        status, text = run(bench, "--wave", wave)
        self.assertEqual(status, 0)
        self.assertIn("not written: nothing failed", text)
        self.assertEqual(list(FOLDER.glob("none.fst*")), [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
