#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The command line as a person meets it: help, good calls, and bad input, which must give one sentence, a status that
is not 0, and nothing half-written. Usage: command_line_test.py HALFSPACE TESTMODELS"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

HALFSPACE, MODELS = sys.argv[1], pathlib.Path(sys.argv[2])
CONFIGS = pathlib.Path(__file__).resolve().parent.parent / "configs"
COMMANDS = ("render", "vectors", "compare", "inspect", "config", "package", "report", "bounds", "fit", "stability",
            "sweep", "frames", "quality", "cost")
TRIANGLE = "t 1 1 0.5 255 0 0  30 2 0.5 0 255 0  4 20 0.25 0 0 255\n"


def run(*args):
    return subprocess.run([HALFSPACE, *map(str, args)], capture_output=True, text=True, timeout=120, check=False)


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def good(self, *args):
        result = run(*args)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def bad(self, *args, words=()):
        """The call fails with one sentence that has all the words, and leaves no file behind."""
        before = sorted(self.folder.rglob("*"))
        result = run(*args)
        self.assertGreater(result.returncode, 0, f"{args} was accepted (or crashed: {result.returncode})")
        lines = result.stderr.strip().splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(sorted(self.folder.rglob("*")), before, "something was left behind")
        return lines[0]

    def test_help_teaches(self):
        for command in ([], *([name] for name in COMMANDS)):
            text = self.good(*command, "--help")
            self.assertGreater(len(text.splitlines()), 5)

    def test_textures_that_do_not_fit_are_scaled_with_a_warning(self):
        for name, scaled in (("textured_low", True), ("textured_high", False), ("lit_low", False)):
            config = CONFIGS / name.split("_")[0] / f"{name}.toml"
            result = run("render", MODELS / "Collada" / "duck.dae", "--config", config, "--engine", "ref", "--texture",
                         "nearest")
            self.assertEqual(result.returncode, 0, result.stderr)
            if scaled:
                self.assertRegex(result.stderr, r"^warning: .*: 512x512 texels are scaled to 64x64: configuration "
                                                r"textured_low has 4096")
            else:
                self.assertEqual(result.stderr, "")

    def test_render_writes_picture_dump_and_numbers(self):
        tri = self.file("a.tri", "size 40 30\n" + TRIANGLE)
        out, dump, numbers = self.folder / "a.png", self.folder / "dump", self.folder / "a.json"
        self.good("render", tri, "-o", out, "--dump", dump, "--json", numbers)
        self.assertEqual(out.read_bytes()[1:4], b"PNG")
        self.assertEqual((dump / "index.u32").stat().st_size, 40 * 30 * 4)
        self.assertEqual((dump / "depth.u32").stat().st_size, 40 * 30 * 4)
        self.assertEqual((dump / "colour.rgba8").stat().st_size, 40 * 30 * 4)
        index = struct.unpack("<1200I", (dump / "index.u32").read_bytes())
        self.assertEqual(set(index), {0, 1})
        self.assertEqual(index.count(1), json.loads(numbers.read_text())["covered_pixels"])
        self.assertEqual(sorted(p.name for p in dump.iterdir()),
                         ["colour.rgba8", "depth.u32", "index.u32", "triangles.tri"])

    def test_a_static_buffer_is_held_against_none(self):
        numbers = self.folder / "quality.json"
        self.good("quality", "court", "--static-buffer", "--size", "160x120", "--first", "60", "--frames", "11",
                  "--json", numbers)
        with_buffer = json.loads(numbers.read_text())
        without = with_buffer["without_static_buffer"]
        self.assertEqual(with_buffer["pixels"]["background"], without["pixels"]["background"])
        self.assertEqual(with_buffer["pixels"]["static"] + with_buffer["motion_words"], without["motion_words"])
        self.assertEqual((without["pixels"]["static"], without["static_triangles"]), (0, 0))
        self.assertLess(with_buffer["triangles"] + with_buffer["static_triangles"], without["triangles"])
        for key in ("cache_misses", "key_bytes", "compensation_cycles"):
            self.assertLess(10 * with_buffer[key], without[key])
        self.assertGreaterEqual(with_buffer["compensated"]["psnr_y_db"], without["compensated"]["psnr_y_db"] - 0.01)
        boxes = MODELS / "ASE" / "anim2.ASE"  # one stands
        self.good("frames", boxes, "--static-buffer", "--size", "64x48", "--frames", "11", "-o",
                  self.folder / "frame_%03d.png", "--json", numbers)
        pixels = json.loads(numbers.read_text())["pixels"]
        self.assertGreater(pixels["static"], pixels["blended"] + pixels["copied"] + pixels["rendered"])
        self.good("cost", "court", "--size", "80x60", "--first", "60", "--json", numbers)
        names = [row["name"] for row in json.loads(numbers.read_text())["rows"]]
        self.assertIn("made of key frames, S-buffer", names)
        self.assertIn("would be empty", self.good("cost", "cube_zoom", "--size", "80x60", "--json", numbers))
        self.assertEqual(json.loads(numbers.read_text())["static_instances"], 0)
        self.bad("quality", "court", "--static-buffer", "--half", "--frames", "6", words=("--static-buffer", "--half"))

    def test_a_dump_renders_to_itself(self):
        a, b = self.folder / "a", self.folder / "b"
        self.good("render", "cube", "--size", "200x150", "--dump", a)
        self.good("render", a / "triangles.tri", "--dump", b)
        result = run("compare", a, b)
        self.assertIn("index.u32: 30000 values, equal", result.stdout)
        self.assertIn("depth.u32: 30000 values, equal", result.stdout)
        lines = (a / "triangles.tri").read_text().splitlines()
        self.assertEqual(lines[0], "size 200 150")
        self.assertEqual({line[0] for line in lines[1:]}, {"t"})
        self.assertEqual((a / "triangles.tri").read_text(), (b / "triangles.tri").read_text())

    def test_engines_agree_but_for_rounding(self):
        for engine in ("ref", "hls"):
            self.good("render", "ring", "--engine", engine, "--dump", self.folder / engine)
        result = run("compare", self.folder / "ref", self.folder / "hls", "--json", self.folder / "c.json")
        parts = {p["part"]: p for p in json.loads((self.folder / "c.json").read_text())["parts"]}
        self.assertEqual(parts["index.u32"]["different"], 0)
        self.assertLessEqual(parts["colour.rgba8"]["largest"], 1)
        self.assertEqual(result.returncode, 1 if sum(p["different"] for p in parts.values()) else 0)

    def test_compare_names_the_first_difference(self):
        a, b = self.folder / "a", self.folder / "b"
        for folder in (a, b):
            self.good("render", "cube", "--size", "64x48", "--dump", folder)
        data = bytearray((b / "index.u32").read_bytes())
        data[4 * (64 * 20 + 30)] ^= 1
        (b / "index.u32").write_bytes(data)
        result = run("compare", a, b)
        self.assertEqual(result.returncode, 1)
        self.assertIn("pixel (30, 20)", result.stdout)
        self.assertIn("1 different", result.stdout)

    def test_vectors(self):
        out = self.folder / "v"
        self.good("vectors", "pyramid", "--config", "low", "--lanes", "2", "--out", out)
        manifest = json.loads((out / "manifest.json").read_text())
        self.assertEqual(manifest["lanes_x"] * manifest["lanes_y"], 2)
        self.assertEqual(len(list(out.iterdir())), 10)

    def test_vectors_of_buffers_that_are_merged(self):
        config = CONFIGS / "objects/objects_tiny.toml"
        out = self.folder / "m"
        self.good("vectors", "merge", "--config", config, "--out", out)
        manifest = json.loads((out / "manifest.json").read_text())
        self.assertEqual([s["name"] for s in manifest["streams"]], ["merge", "stored", "entry", "merged", "found"])
        self.assertTrue(all(frame["cycles"] > 1 for frame in manifest["frames"]))
        self.good("vectors", "static", "--config", config, "--frames", "4", "--buffers", "2", "--out", out)
        passes, runs = (json.loads((out / part / "manifest.json").read_text()) for part in ("pipeline", "merge"))
        self.assertEqual([s["name"] for s in passes["streams"]], ["triangle", "visible", "scan", "entry"])
        self.assertTrue(all(frame["triangles"] <= 100 for frame in passes["frames"]))
        self.assertIn("frame 3, frame", runs["frames"][-1]["note"])
        for scene in ("merge", "static"):
            self.bad("vectors", scene, "--config", "low", "--out", out, words=("object_bits",))
        self.bad("vectors", "static", "--config", config, "--buffers", "0", "--out", out)
        self.bad("vectors", "static", "--config", config, "--size", "21x17", "--out", out, words=("21x17",))

    def test_tri_winding_and_ties(self):
        forward = "t 1 1 .5 9 9 9  30 2 .5 9 9 9  4 20 .5 9 9 9\n"
        backward = "t 1 1 .5 7 7 7  4 20 .5 7 7 7  30 2 .5 7 7 7\n"
        self.good("render", self.file("a.tri", "size 40 30\n" + forward + backward), "--dump", self.folder / "a")
        index = struct.unpack("<1200I", (self.folder / "a" / "index.u32").read_bytes())
        self.assertEqual(set(index), {0, 1}, "the first drawn wins a tie, whatever the winding")

    def test_bad_tri_files(self):
        cases = {"empty": "", "no size": TRIANGLE, "no triangle": "size 40 30\n", "zero": "size 0 30\n" + TRIANGLE,
                 "negative": "size -4 30\n" + TRIANGLE, "short": "size 40 30\nt 1 2 3\n",
                 "long": "size 40 30\n" + TRIANGLE.strip() + " 5\n",
                 "words": "size 40 30\n" + TRIANGLE.replace("255", "red"),
                 "nan": "size 40 30\n" + TRIANGLE.replace("30 2", "nan 2"),
                 "inf": "size 40 30\n" + TRIANGLE.replace("30 2", "inf 2"),
                 "depth": "size 40 30\n" + TRIANGLE.replace("0.25", "1.25"),
                 "colour": "size 40 30\n" + TRIANGLE.replace("255", "256"),
                 "huge": "size 99999999999 30\n" + TRIANGLE, "far": "size 40 30\n" + TRIANGLE.replace("30 2", "1e9 2"),
                 "binary": bytes(range(256)) * 10, "cut": ("size 40 30\n" + TRIANGLE)[:-9]}
        for name, content in cases.items():
            with self.subTest(name):
                path = self.file("bad.tri", content)
                self.bad("render", path, "-o", self.folder / "x.png", "--dump", self.folder / "d", words=["bad.tri"])

    def test_bad_meshes(self):
        good = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        cases = {"empty.obj": "", "vertices.obj": good, "index.obj": good + "f 1 2 9\n",
                 "nan.obj": good.replace("v 1", "v nan") + "f 1 2 3\n",
                 "inf.obj": good.replace("v 1", "v 1e999") + "f 1 2 3\n", "text.obj": "hello\n",
                 "cut.gltf": '{"asset": {"version": "2.0"',
                 "garbage.glb": b"glTF\x02\0\0\0\xff\xff\xff\xff" + bytes(40), "unknown.xyz": "1 2 3\n",
                 "empty.dae": "<COLLADA/>"}
        for name, content in cases.items():
            with self.subTest(name):
                self.bad("render", self.file(name, content), "-o", self.folder / "x.png", words=[name])
        self.bad("render", self.folder / "none.obj", words=["none.obj"])
        self.bad("render", self.folder, "-o", self.folder / "x.png")

    def test_invalid_models_of_the_package(self):
        found = [p for folder in (MODELS.parent, MODELS) for p in folder.rglob("invalid/*") if p.is_file()]
        for path in found[:40]:
            with self.subTest(path.name):
                result = run("render", path, "--size", "32x24", "-o", self.folder / "x.png")
                self.assertIn(result.returncode, (0, 1), f"{path}: {result.stderr}")
                self.assertLessEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)

    def test_what_does_not_fit_names_what_would(self):
        self.bad("render", "teapot", "--config", "low", "--size", "640x480", "-o", self.folder / "x.png",
                 words=["low", "middle"])
        self.bad("render", "teapot", "--size", "4000x3000", words=["4000"])
        self.bad("render", self.file("big.tri", "size 4000 20\n" + TRIANGLE), words=["4000"])
        self.bad("render", self.file("b.tri", "size 40 30\n" + TRIANGLE.replace("30 2", "900 2")), "--config", "low",
                 words=["middle"])
        many = self.file("many.tri", "size 40 30\n" + TRIANGLE * 4097)
        self.bad("render", many, "--config", "low", words=["4097", "middle"])
        self.good("render", self.file("fits.tri", "size 40 30\n" + TRIANGLE * 4096), "--config", "low")

    def test_bad_options(self):
        self.bad("render", "cube", "--size", "0x5", words=["0x5"])
        self.bad("render", "cube", "--size", "12", words=["12"])
        self.bad("render", "cube", "--config", "huge", words=["huge"])
        self.bad("render", "cube", "--lanes", "3", words=["3"])
        self.bad("render", "nonesuch", words=["nonesuch"])
        for args in (["render"], ["render", "cube", "--engine", "x"], ["nonesuch"], [], ["vectors", "cube"]):
            self.assertNotEqual(run(*args).returncode, 0, args)

    def test_unwritable_output(self):
        self.bad("render", "cube", "-o", "/proc/none/x.png")
        self.bad("render", "cube", "--dump", "/proc/none")
        self.bad("render", "cube", "-o", self.folder / "x.nonesuch", words=["png"])
        self.bad("vectors", "cube", "--config", "low", "--out", "/proc/none")
        self.bad("render", "cube", "--json", "/proc/none/x.json")
        blocked = self.file("file", "")
        self.bad("render", "cube", "--dump", blocked / "d")
        self.bad("compare", self.folder, self.folder)
        self.bad("compare", self.folder / "none", self.folder / "none")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
