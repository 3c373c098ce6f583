#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""glTF files that change one thing each: the reference and the kernels draw what is right, or refuse it by name.
Usage: gltf_cases_test.py HALFSPACE CASES TEXTURED_CONFIG"""
import collections
import pathlib
import subprocess
import sys
import tempfile
import unittest

HALFSPACE, CASES, TEXTURED = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
SIZE = 64
BACKGROUND, FULL = (26, 32, 46), 244  # full colour under the light that is set where a file has none


class Picture:
    def __init__(self, folder):
        data = (pathlib.Path(folder) / "colour.rgba8").read_bytes()
        self.pixels = [tuple(data[4 * i:4 * i + 3]) for i in range(SIZE * SIZE)]

    def at(self, x, y):
        return self.pixels[y * SIZE + x]

    def colours(self):
        return collections.Counter(self.pixels)

    def box(self):
        drawn = [(i % SIZE, i // SIZE) for i, pixel in enumerate(self.pixels) if pixel != BACKGROUND]
        columns, rows = zip(*drawn)
        return min(columns), max(columns), min(rows), max(rows)


def run(name, engine, *args):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([HALFSPACE, "render", CASES / name, "--size", f"{SIZE}x{SIZE}", "--engine", engine,
                               "--dump", folder, *args], capture_output=True, text=True, timeout=120)
        return done.returncode, done.stderr, Picture(folder) if done.returncode == 0 else None


class Cases(unittest.TestCase):
    def drawn(self, name, *args):
        """The picture of each engine, and what it says."""
        for engine in ("ref", "hls"):
            with self.subTest(file=name, engine=engine):
                status, words, picture = run(f"gltf/{name}", engine, *args)
                self.assertEqual(status, 0, words)
                yield picture, words

    def textured(self, name):
        yield from self.drawn(f"texture/{name}", "--config", TEXTURED)

    def expect_box(self, name, box, *args):
        for picture, _ in self.drawn(name, *args):
            self.assertEqual(picture.box(), box)
            self.assertEqual(picture.at(*box[::2]), (FULL, 0, 0))

    def expect_refused(self, name, sentence, *args):
        for engine in ("ref", "hls"):
            status, words, _ = run(name, engine, *args)
            self.assertNotEqual(status, 0)
            self.assertIn(sentence, words)
            self.assertEqual(words.count("\n"), 1, words)

    def expect_quarters(self, name, wanted):
        """The colours at the centres of the quarters, row by row."""
        for picture, words in self.textured(name):
            self.assertEqual(words, "")
            for (x, y), colour in zip(((16, 16), (47, 16), (16, 47), (47, 47)), wanted):
                for channel, full in zip(picture.at(x, y), colour):
                    self.assertAlmostEqual(channel, full * FULL, delta=8)

    def test_the_camera_of_the_file(self):
        everywhere = (0, 63, 0, 63)
        for name in ("ok", "camera_dropped", "cam_wall_3"):
            self.expect_box(f"geometry/{name}.gltf", everywhere)
        self.expect_box("geometry/a_camera_name.gltf", (16, 47, 16, 47))

    def test_accessors(self):
        self.expect_box("geometry/quantised.gltf", (0, 63, 0, 63))

    def test_unlit_materials(self):
        for picture, words in self.drawn("geometry/unlit.gltf"):
            self.assertEqual((words, picture.colours()), ("", {(255, 102, 0): SIZE * SIZE}))

    def test_normals(self):
        for picture, _ in self.drawn("geometry/dome_indexed.gltf"):
            self.assertEqual(len(picture.colours()), 5)
        for name in ("geometry/tilt_node.gltf", "motion/tilt_joint.gltf"):
            for picture, _ in self.drawn(name):
                for channel in picture.at(32, 32):
                    self.assertAlmostEqual(channel, 223, delta=1)
        for engine in ("ref", "hls"):
            status, words, picture = run("bad/cube_nonormal.gltf", engine)
            self.assertEqual((status, words, len(picture.colours())), (0, "", 4))

    def test_animations(self):
        self.expect_box("motion/step.gltf", (26, 37, 26, 37), "--time", "0.5")
        self.expect_box("motion/a_cubic.gltf", (46, 49, 24, 39), "--time", "0.5")
        self.expect_box("motion/names.gltf", (26, 53, 3, 37), "--time", "0.5")
        for _, words in self.drawn("motion/two_animations.gltf"):
            self.assertIn("2 animations, of which the first moves", words)

    def test_skins_and_targets(self):
        self.expect_box("motion/skin_u8.gltf", (6, 57, 19, 44))
        self.expect_box("motion/skin_samename.gltf", (6, 57, 19, 44))
        self.expect_box("motion/mirror_armature_minus.gltf", (29, 60, 19, 44))
        self.expect_box("motion/morph_node_weights.gltf", (16, 47, 16, 47))

    def test_textures(self):
        ordinary = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0))
        for name in ("ok_textured", "alpha", "emissive", "uri", "uv_u16", "uv_set_both"):
            self.expect_quarters(f"{name}.gltf", ordinary)
        self.expect_quarters("uv_transform.gltf", (ordinary[1], ordinary[0], ordinary[3], ordinary[2]))
        for _, words in self.textured("wrap_clamp.gltf"):
            self.assertIn("textures that clamp or mirror at their edges are drawn as repeated", words)

    def test_what_is_refused(self):
        self.expect_refused("gltf/geometry/required.gltf", "requires the extension EXT_not_known")
        self.expect_refused("gltf/texture/uv_nan.gltf", "TEXCOORD_0, has NaN or infinity")
        self.expect_refused("bad/dag24.gltf", "node 1 is a child of node 0 and of node 0")
        self.expect_refused("bad/sparse400m.gltf", "400000000 elements without a buffer")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
