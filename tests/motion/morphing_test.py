#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What keys keep of holes, what half a field saves, and the tables of bi-directional morphing: numbers that follow from
each other do. Usage: morphing_test.py HALFSPACE"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HALFSPACE = sys.argv[1]


def run(*words):
    with tempfile.TemporaryDirectory() as folder:
        figures = pathlib.Path(folder) / "figures.json"
        done = subprocess.run([HALFSPACE, *words, "--json", figures], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return json.loads(figures.read_text()), done.stdout


class Holes(unittest.TestCase):
    def test_two_faces_and_finer_keys_leave_fewer(self):
        numbers, text = run("holes", "gouraud", "supersampled", "--scene", "jet", "wheel_turn", "--size", "80x60")
        of = {(row["kind"], row["key_faces"], row["key_scale"], row["scene"]): row for row in numbers["rows"]}
        self.assertEqual(len(of), 2 * (2 + 5))
        for scene in ("jet", "wheel_turn"):
            pure, most, two = (of["supersampled", faces, 1, scene]["rendered_samples_share"]
                               for faces in ("pure", "most", "two"))
            self.assertLess(most, pure / 2)
            self.assertLess(two, most / 1.5)
            self.assertLess(of["supersampled", "two", 2, scene]["rendered_samples_share"], two)
            self.assertLess(of["gouraud", "two", 2, scene]["rendered_share"],
                            of["gouraud", "two", 1, scene]["rendered_share"] / 1.5)
            for row in of.values():
                self.assertLessEqual(row["rendered_samples_share"], row["rendered_share"])
        # jet has a quarter of its pixels rendered at this size.
        self.assertEqual(text.count("missed") + text.count(": met"), 7)
        self.assertIn("missed", text)

    def test_half_a_field_saves_what_its_units_do(self):
        numbers, _ = run("cost", "wheel_turn", "--size", "160x120", "--first", "25", "--half")
        whole, half = numbers["whole"], numbers["half"]
        self.assertAlmostEqual(half["words"] / whole["words"], 0.25, delta=0.03)
        self.assertAlmostEqual(half["units"]["motion_field"] / whole["units"]["motion_field"], 0.25, delta=0.05)
        # All triangles are set up for either.
        self.assertAlmostEqual(half["units"]["triangle_setup"] / whole["units"]["triangle_setup"], 1, delta=0.05)
        self.assertGreater(whole["psnr_y_db"], half["psnr_y_db"] + 5)
        for row in (whole, half):
            self.assertEqual(row["cycles"], max(row["units"].values()))
            self.assertAlmostEqual(row["bytes_a_pixel"], row["word_bytes_a_pixel"] + row["key_bytes_a_pixel"] + 3)


class Morphing(unittest.TestCase):
    def test_vectors(self):
        numbers, _ = run("repro", "D", "--scene", "jet", "cube_slow", "wheel_turn", "--frames", "11", "--size", "80x60",
                         "--table", "vectors", "--between", "1", "4")
        of = {(row["between"], row["form"]): row for row in numbers["vectors"]}
        self.assertEqual(len(of), 2 * 4)
        for row in of.values():
            self.assertAlmostEqual(row["blended"] + row["copied"] + row["rendered"], 1)
            self.assertGreater(row["psnr_y_db"], row["temporal_average_db"])
            self.assertEqual(row["rendered"] > 0, "without" not in row["form"], row["form"])
        for between in (1, 4):
            cut, untested, own, relit = (of[key]["psnr_y_db"] for key in of if key[0] == between)
            self.assertGreater(cut, untested + 2)
            self.assertGreater(own, cut - 0.5)
            self.assertGreater(relit, own)

    def test_time_lines(self):
        with tempfile.TemporaryDirectory() as folder:
            numbers, _ = run("repro", "D", "--size", "80x60", "--table", "time", "--out", folder)
            pictures = sorted(picture.name for picture in pathlib.Path(folder).iterdir())
            self.assertEqual(len(pictures), 6)
        self.assertEqual(len(numbers["time"]), 6)
        for row in numbers["time"]:
            cycles = row["cycles"].values()
            self.assertAlmostEqual(row["overlapped"]["period"], max(cycles), places=3)
            self.assertAlmostEqual(row["in_turn"]["period"], sum(cycles), places=3)
            self.assertLess(row["as_often"]["delay"], row["in_turn"]["delay"])
            self.assertGreater(row["overlapped"]["delay"], 5 * row["overlapped"]["period"])
            of = {(step["unit"], step["frame"]): step for step in row["work"]}
            for unit in row["cycles"]:  # one frame at a time
                steps = sorted((s["start"], s["end"]) for (u, _), s in of.items() if u == unit)
                self.assertTrue(all(a[1] <= b[0] + 1e-6 for a, b in zip(steps, steps[1:])))
            for (unit, frame), step in of.items():
                if unit == "motion_compensate":  # not before either key, nor its own vectors
                    key = frame // 5 * 5
                    for other in (("shading", key), ("shading", key + 5), ("motion_field", frame)):
                        self.assertGreaterEqual(step["start"] + 1e-6, of[other]["end"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
