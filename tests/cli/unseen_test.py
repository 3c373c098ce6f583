#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scenes of which nothing is in view: a still is background, with the reason; films, vectors and the RTL have frames of
background where the scene has left the picture. Usage: unseen_test.py HALFSPACE BENCH, which is tb_pipeline_low_4"""
import base64
import json
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

HALFSPACE, BENCH = (str(pathlib.Path(name).resolve()) for name in sys.argv[1:3])
BACKGROUND = (26, 32, 46)


def scene(half=0.3, to=(3, 0, 0), at=(0, 0, 0), faces=(0, 1, 2, 0, 2, 3), copies=1):
    """A square in the plane z = 0 before an orthographic camera that sees ±1, on its way for a second."""
    corners = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
    parts = [struct.pack("<12f", *sum(corners, ())), struct.pack("<12f", *[0, 0, 1] * 4),
             struct.pack(f"<{len(faces) * copies}H", *faces * copies), struct.pack("<2f", 0, 1),
             struct.pack("<6f", *at, *to)]
    views, offset = [], 0
    for part in parts:
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(part)})
        offset += len(part)
    kinds = [(5126, 4, "VEC3"), (5126, 4, "VEC3"), (5123, len(faces) * copies, "SCALAR"), (5126, 2, "SCALAR"),
             (5126, 2, "VEC3")]
    data = base64.b64encode(b"".join(parts)).decode()
    accessors = [{"bufferView": n, "componentType": kind, "count": count, "type": form}
                 for n, (kind, count, form) in enumerate(kinds)]
    accessors[0].update(min=[-half, -half, 0], max=[half, half, 0])
    accessors[3].update(min=[0], max=[1])
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0, "translation": at}, {"camera": 0, "translation": [0, 0, 5]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}],
        "cameras": [{"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 100}}],
        "animations": [{"samplers": [{"input": 3, "output": 4}],
                        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
        "accessors": accessors, "bufferViews": views,
        "buffers": [{"byteLength": offset, "uri": "data:application/octet-stream;base64," + data}]})


class Unseen(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        (self.folder / "leave.gltf").write_text(scene())

    def tearDown(self):
        self.temporary.cleanup()

    def good(self, *args, status=0):
        done = subprocess.run([HALFSPACE, *map(str, args)], cwd=self.folder, capture_output=True, text=True,
                              timeout=300, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def colours(self, dump):
        data = (self.folder / dump / "colour.rgba8").read_bytes()
        return {tuple(data[n:n + 3]) for n in range(0, len(data), 4)}

    def test_a_still_says_why_it_is_background(self):
        cases = {"camera": (scene(), "1", "are outside of what the camera sees"),
                 "culling": (scene(faces=(0, 2, 1, 0, 3, 2)), "0", "2 triangles in the frame are seen from behind"),
                 "size": (scene(half=0.003), "0", "2 triangles in the frame cover no pixel centre"),
                 "area": (scene(faces=(0, 0, 1)), "0", "have no area")}
        for name, (text, time, words) in cases.items():
            (self.folder / f"{name}.gltf").write_text(text)
            for engine in ("ref", "hls", "ideal"):
                with self.subTest(name, engine=engine):
                    done = self.good("render", f"{name}.gltf", "--time", time, "--size", "32x32", "--engine", engine,
                                     "--dump", engine, "-o", "x.png", "--json", "x.json")
                    self.assertRegex(done.stderr, rf"^halfspace: {name}.gltf: nothing is in view: .*{words}")
                    self.assertEqual(len(done.stderr.splitlines()), 1)
                    self.assertEqual(self.colours(engine), {BACKGROUND})
            self.good("compare", "ref", "hls")
            done = self.good("report", f"{name}.gltf", "--time", time, "--size", "32x32", "--out", "report")
            self.assertIn(words, done.stderr)
        self.assertEqual(self.good("render", "leave.gltf", "--size", "32x32").stderr, "")
        both = self.good("render", "culling.gltf", "--size", "32x32", "--two-sided", "--dump", "both")
        self.assertEqual(both.stderr, "")
        self.assertEqual(len(self.colours("both")), 2)

    def test_a_view_without_a_camera_sees_all_times(self):
        away = json.loads(scene())
        away["nodes"][1] = {"translation": [0, 0, 5]}
        del away["cameras"]
        (self.folder / "framed.gltf").write_text(json.dumps(away))
        for time in (0, 0.5, 1):
            done = self.good("render", "framed.gltf", "--time", time, "--size", "64x64", "--json", "x.json")
            self.assertNotIn("nothing is in view", done.stderr)
            self.assertGreater(json.loads((self.folder / "x.json").read_text())["covered_pixels"], 50, time)

    def test_films_go_on_without_triangles(self):
        for engine in ("ref", "hls"):
            for more in ((), ("--method", "straight"), ("--static-buffer",), ("--keys", "auto")):
                with self.subTest(engine, more=more):
                    call = ("leave.gltf", "--engine", engine, "--size", "48x48", *more)
                    done = self.good("frames", *call, "-o", f"{engine}_%02d.png", "--json", "x.json")
                    numbers = json.loads((self.folder / "x.json").read_text())
                    self.assertEqual(numbers["frames"], 31)
                    self.assertEqual(len(list(self.folder.glob(f"{engine}_*.png"))), 31)
                    self.assertNotIn("nan", done.stdout)
                    last, other = ((self.folder / f"{engine}_{n}.png").read_bytes() for n in (30, 25))
                    self.assertEqual(last, other)
                    self.assertNotEqual(last, (self.folder / f"{engine}_03.png").read_bytes())
            done = self.good("quality", "leave.gltf", "--engine", engine, "--size", "48x48", "--json", "q.json")
            self.assertNotRegex(done.stdout, r"\bnan\b")
            self.assertNotIn("null", (self.folder / "q.json").read_text())
        away = ("leave.gltf", "--first", "20", "--size", "48x48")
        self.assertNotRegex(self.good("quality", *away).stdout, r"\bnan\b")
        tiny = self.good("quality", "cube_fast", "--frames", "15", "--size", "8x8")
        self.assertRegex(tiny.stdout, r"ffmpeg minterpolate +not measured: .*ffmpeg")
        self.assertRegex(self.good("cost", *away, status=1).stderr, r"^halfspace: leave.gltf: .*--first")

    def test_vectors_and_the_rtl_have_the_frame(self):
        for more in (("--no-corners",), ()):
            done = self.good("vectors", "leave.gltf", "--time", "1", "--size", "64x64", "--config", "low", "--lanes",
                             "4", *more, "--out", "v")
            self.assertIn("nothing is in view", done.stderr)
            bench = subprocess.run([BENCH, str(self.folder / "v")], capture_output=True, text=True, timeout=300,
                                   check=False)
            self.assertEqual(bench.returncode, 0, bench.stdout)
            self.assertRegex(bench.stdout, r"[1-9]\d* words, 0 mismatches|0 mismatches")
        motion = pathlib.Path(__file__).resolve().parent.parent / "configs/motion/motion_tiny.toml"
        self.good("vectors", "leave.gltf", "--config", motion, "--interval", "0.8:1", "--time", "0.9", "--size",
                  "16x16", "--out", "m")
        done = self.good("fit", "leave.gltf", "--size", "48x48", "--frames", "0:20", "--area", "none", "--no-cosim")
        self.assertIn("configurations tried", done.stdout)

    def test_a_film_that_is_too_large_for_middle_takes_high(self):
        most = 16384
        (self.folder / "many.gltf").write_text(scene(copies=most // 2 + 1))
        self.good("frames", "many.gltf", "--size", "32x32", "--frames", "3", "-o", "f%d.png", "--json", "x.json")
        self.assertEqual(json.loads((self.folder / "x.json").read_text())["config"], "high")
        done = self.good("frames", "many.gltf", "--size", "32x32", "--frames", "3", "--config", "middle", "-o",
                         "g%d.png", status=1)
        self.assertRegex(done.stderr, r"^halfspace: many.gltf: .*configuration high takes it$|take a larger")
        self.assertEqual(list(self.folder.glob("g*")), [])

    def test_faces_beyond_their_bits_and_times_that_are_none(self):
        motion = pathlib.Path(__file__).resolve().parent.parent / "configs/motion/motion_tiny.toml"
        bits = int(re.search(r"face_bits = (\d+)", motion.read_text()).group(1))
        (self.folder / "faces.gltf").write_text(scene(to=(0.5, 0, 0), copies=2 ** bits))
        call = ("faces.gltf", "--config", motion, "--interval", "0:1", "--time", "0.5", "--size", "16x16")
        for command in (("render",), ("vectors", "--out", "v"), ("vectors", "--compensation", "--out", "v")):
            done = self.good(command[0], *call, *command[1:])
            self.assertRegex(done.stderr, rf"^halfspace: faces.gltf: faces share the {2 ** bits - 1} numbers of .*"
                                          rf"motion_tiny.*: raise face_bits to {bits + 2}\n$")
        for command in (("render", "cube"), ("sweep", "cube"), ("vectors", "cube", "--out", "v")):
            for time in ("nan", "inf", "-inf", "1e999"):
                done = subprocess.run([HALFSPACE, *command, "--time", time], cwd=self.folder, capture_output=True,
                                      text=True, timeout=60, check=False)
                self.assertGreater(done.returncode, 0, (command, time))
                self.assertRegex(done.stderr, r"^halfspace: --time: .*\n$")
        film = self.good("frames", "faces.gltf", "--size", "16x16", "--frames", "3", "-o", "f%d.png")
        self.assertEqual(film.stderr, "")
        self.good("render", "cube_fast", "--config", motion, "--time", "0", "--interval", "0:inf", status=1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
