#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`halfspace sweep` on lights, textures and motion: each number and each choice can be varied, measures are those of
pictures of other commands, and what costs less or is more accurate is told so.
Usage: sweep_features_test.py HALFSPACE MODELS CONFIGS"""
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HALFSPACE, MODELS, CONFIGS = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
DUCK, SIZE = MODELS / "Collada/duck.dae", ["--size", "64x48"]


def good(*args):
    done = subprocess.run([HALFSPACE, *map(str, args)], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, f"{args}: {done.stderr}"
    return done.stdout


def sweep(folder, *args):
    """The rows by what was varied, {"texels256": row}; the base is ""."""
    base = json.loads(good("sweep", *args, *SIZE, "--star", "--no-named", "--out", folder) and
                      (folder / "sweep.json").read_text())["rows"]
    with open(folder / "sweep.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(base)
    return {row["config"].partition("-")[2]: row for row in rows}


def psnr(a, b):
    squares = sum((x - y) ** 2 for n, (x, y) in enumerate(zip(a, b)) if n % 4 != 3)
    return math.inf if squares == 0 else 10 * math.log10(255 ** 2 * len(a) * 3 / 4 / squares)


def keys_of(vary):
    return [word for key in vary for word in ("--vary", key)]


class Features(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.temporary.name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def picture(self, scene, engine, config):
        good("render", scene, *SIZE, "--camera", "auto", "--engine", engine, "--config", config, "--dump",
             self.root / engine)
        return (self.root / engine / "colour.rgba8").read_bytes()

    def changed(self, config, **values):
        text = (CONFIGS / config).read_text()
        for key, value in values.items():
            text, count = re.subn(rf"^{key} = \S+", f"{key} = {value}", text, flags=re.MULTILINE)
            self.assertEqual(count, 1, key)
        path = self.root / "changed.toml"
        path.write_text(text)
        return path

    def plots(self, folder, keys):
        for key in keys:
            self.assertTrue((folder / f"{key.partition('=')[0]}.png").exists(), key)

    def test_textures(self):
        vary = ["texels=256,4096", "textures=1,8", "coordinate_bits=10,20", "coordinate_fraction=15,18",
                "texture=none,nearest,bilinear", "mapping=affine,perspective"]
        out = self.root / "textured"
        rows = sweep(out, DUCK, "--camera", "auto", "--config", CONFIGS / "textured/textured_middle.toml",
                     *keys_of(vary))
        self.assertEqual({row["ideal"] for row in rows.values()}, {"gouraud, bilinear"})
        value = {name: float(row["psnr_db"]) for name, row in rows.items()}
        self.assertLess(value["texturenone"] + 10, value["texels256"])
        self.assertLess(value["texels256"] + 3, value["texels4096"])
        self.assertLess(value["texels4096"] + 3, value[""])
        self.assertLess(value["texturenearest"], value[""])
        memory = {name: int(row["memory_bits"]) for name, row in rows.items()}
        self.assertEqual(memory["texels4096"] - memory["texels256"], 24 * (4096 - 256))
        traffic = {name: int(row["bytes_texture"]) for name, row in rows.items()}
        self.assertEqual(traffic["texturenone"], 0)
        self.assertEqual((traffic[""] - traffic["texturenearest"]) % 9, 0)  # three texels more a pixel
        self.assertLess(traffic["mappingaffine"], traffic[""])
        # Against the ideal, in which texels are those of the file, and against the reference, which has as many.
        config = self.changed("textured/textured_middle.toml", texels=256)
        ideal = self.picture(DUCK, "ideal", CONFIGS / "textured/textured_middle.toml")
        kernels, reference = (self.picture(DUCK, engine, config) for engine in ("hls", "ref"))
        self.assertAlmostEqual(value["texels256"], psnr(ideal, kernels), delta=0.1)
        self.assertAlmostEqual(float(rows["texels256"]["reference_psnr_db"]), psnr(reference, kernels))
        self.plots(out, vary[:1] + vary[2:])

    def test_lights(self):
        vary = ["normal_bits=9,16", "gloss=0,8,16", "lights=1,2", "materials=1,512", "normal_fraction=16,18",
                "shading=flat,gouraud,phong", "lanes=1,4", "architecture=gamma"]
        out = self.root / "lit"
        rows = sweep(out, "teapot", "--config", CONFIGS / "lit/phong_middle.toml", *keys_of(vary))
        self.assertEqual({row["ideal"] for row in rows.values()}, {"phong, lights at infinity"})
        value = {name: float(row["psnr_db"]) for name, row in rows.items()}
        self.assertLess(value["normal_bits9"], value["normal_bits16"])
        self.assertLess(value["gloss8"] + 5, value[""])
        self.assertLess(value["shadingflat"] + 5, value["shadinggouraud"])
        self.assertLess(value["shadinggouraud"] + 5, value[""])
        self.assertEqual(value["architecturegamma"], value[""])
        # The reference has the largest exponent of its configuration.
        self.assertGreater(min(float(rows[name]["reference_psnr_db"]) for name in ("gloss0", "gloss8", "")), 50)
        ideal = self.picture("teapot", "ideal", CONFIGS / "lit/phong_middle.toml")
        kernels = self.picture("teapot", "hls", self.changed("lit/phong_middle.toml", gloss=8))
        self.assertAlmostEqual(value["gloss8"], psnr(ideal, kernels), delta=0.1)
        self.plots(out, ["normal_bits", "gloss", "shading", "lanes", "front"])

    def test_a_choice_brings_its_numbers(self):
        rows = sweep(self.root / "brought", "teapot", "--config", "low", "--vary", "texture=nearest", "--vary",
                     "lights=1", "--vary", "shading=flat")
        numbers = ("lights", "normal_bits", "texels", "coordinate_bits", "colour_fraction")
        found = {name: [int(rows[name][number]) for number in numbers] for name in rows}
        self.assertEqual(found, {"": [0, 0, 0, 0, 14], "texturenearest": [0, 0, 65536, 16, 14],
                                 "lights1": [1, 13, 0, 0, 14], "shadingflat": [0, 0, 0, 0, 0]})
        # In perspective, also where one of them is given.
        good("sweep", "cube_fast", *SIZE, "--vary", "texture=bilinear", "--vary", "texels=64,1024", "--out",
             self.root / "bricks")
        with open(self.root / "bricks" / "sweep.csv", encoding="utf-8") as file:
            few, many = csv.DictReader(file)
        self.assertEqual((few["mapping"], many["mapping"]), ("perspective", "perspective"))
        self.assertLess(float(few["psnr_db"]) + 5, float(many["psnr_db"]))

    def test_motion(self):
        vary = ["vector_fraction=1,4,8", "weight_bits=2,8", "filter=nearest,bilinear,area,bicubic",
                "relight=0,1", "samples=1,2", "face_bits=8,14", "coordinate_bits=12,20", "keys=1,3",
                "mapping=affine,perspective"]
        out = self.root / "motion"
        rows = sweep(out, MODELS / "X/Testwuson.X", "--camera", "auto", "--config",
                     CONFIGS / "motion/motion_middle.toml", "--frames", "0:4", *keys_of(vary))
        value = {name: float(row["reference_psnr_db"] or math.inf) for name, row in rows.items()}
        self.assertLess(value["vector_fraction1"], value["vector_fraction4"])
        self.assertLess(value["vector_fraction4"], value["vector_fraction8"])
        self.assertLess(value["weight_bits2"], value["weight_bits8"])
        self.assertEqual([rows[name]["frames_between"] for name in ("", "keys3")], ["2", "3"])
        memory = {name: int(row["memory_bits"]) for name, row in rows.items()}
        self.assertEqual(memory[""] - memory["face_bits8"], 2 * 6 * 640 * 480 + 2 * 6 * 16384)
        self.assertLess(int(rows["filternearest"]["bytes"]), int(rows["filterbicubic"]["bytes"]))
        self.plots(out, vary[:3] + ["keys"])
        # A vector that the range does not hold shows nothing: its pixels are rendered.
        rows = sweep(self.root / "range", "cube_fast", "--config", CONFIGS / "motion/motion_middle.toml", "--frames",
                     "0:4", "--vary", "vector_range=1,6,8")
        share = {name: float(row["rendered_share"]) for name, row in rows.items()}
        self.assertGreater(share["vector_range1"], 4 * share["vector_range6"])
        self.assertEqual(share["vector_range6"], share[""])

    def test_fronts_of_memory_and_bytes(self):
        out = self.root / "front"
        good("sweep", "teapot", *SIZE, "--config", "low", "--vary", "subpixel_bits=2,4", "--vary",
             "colour_fraction=12,14", "--vary", "depth_bits=10,16", "--no-named", "--out", out)
        with open(out / "sweep.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for flag, cost in (("pareto_bytes", "bytes"), ("pareto_memory", "memory_bits")):
            points = {row["config"]: (-float(row["psnr_db"]), int(row[cost])) for row in rows}
            front = {name for name, mine in points.items()
                     if not any(other != mine and other[0] <= mine[0] and other[1] <= mine[1]
                                for other in points.values())}
            self.assertEqual({row["config"] for row in rows if row[flag] == "true"}, front, flag)
            self.assertTrue(0 < len(front) < len(rows), front)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
