#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`halfspace repro`: the numbers that the papers print come out of their formulas, and ours lie where docs/repro.md
says.
Usage: repro_test.py HALFSPACE"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HALFSPACE = sys.argv[1]


def repro(folder, *args):
    report = pathlib.Path(folder) / "report.json"
    done = subprocess.run([HALFSPACE, "repro", *args, "--json", str(report), "--out", str(folder)], capture_output=True,
                          text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(report.read_text()), done.stdout


class Repro(unittest.TestCase):
    def test_index_rendering(self):
        with tempfile.TemporaryDirectory() as folder:
            report, _ = repro(folder, "A", "castle", "polyhedron")
            for name in ("lightings", "buffers", "bandwidth"):
                self.assertGreater((pathlib.Path(folder) / f"{name}.png").stat().st_size, 5000)
        seen = set()
        for row in report["lightings"]:
            rates = {name: row[name] for name in ("alpha", "beta", "gamma", "delta")}
            for other in rates.values():
                for name in ("triangles", "reduced_triangles", "fragments", "reduced_fragments", "visible_pixels"):
                    self.assertEqual(other[name], rates["alpha"][name])
            each = {"flat": 1, "gouraud": 3, "phong": 0}[row["shading"]]
            phong = row["shading"] == "phong"
            self.assertEqual(rates["alpha"]["lightings"],
                             rates["alpha"]["reduced_fragments"] if phong else each * rates["alpha"]["triangles"])
            self.assertEqual(rates["beta"]["lightings"],
                             rates["beta"]["visible_pixels"] if phong else each * rates["beta"]["triangles"])
            for name in ("gamma", "delta"):
                self.assertEqual(rates[name]["lightings"],
                                 rates[name]["visible_pixels"] if phong else each * rates[name]["reduced_triangles"])
            saved = 1 - rates["delta"]["lightings"] / rates["alpha"]["lightings"]
            if row["scene"] == "castle":
                low, high = (0.3, 0.95) if phong else (0.1, 0.7)
                self.assertTrue(low <= saved <= high, (row["width"], row["shading"], saved))
            elif not phong:
                self.assertEqual(saved, 0)
            seen.add((row["scene"], row["width"], row["shading"]))
        self.assertEqual(len(seen), 2 * 5 * 3)
        for row in report["sizes"]:
            if row["wide_pixel"] == "planes" and row["shading"] != "flat" and row["width"] >= 320:
                for name in ("gamma", "delta"):
                    self.assertLess(row[name]["total"], 0.3 * row["beta"]["total"], row)
        for row in report["bandwidth"]:
            if row["wide_pixel"] == "planes" and row["shading"] != "flat":
                self.assertLess(row["delta"]["total"], 0.5 * row["beta"]["total"], row)
                self.assertLess(row["gamma"]["total"] - row["gamma"]["visibility_database"], 0.5 * row["beta"]["total"],
                                row)

    def test_dual_pipeline(self):
        with tempfile.TemporaryDirectory() as folder:
            report, text = repro(folder, "B", "castle")
        for number in ("1281k", "78.4%", "52.6%", "56.1%", "36.6%"):
            self.assertIn(number, text)
        for n in [*report["printed"].values(), *report["measured"]]:
            self.assertEqual(n["type_1"], 231 * n["a"] + 405 * n["b"])
            self.assertEqual(n["type_2"], 636 * n["a"])
            self.assertEqual(n["dual"], 132 * n["a"] + 504 * n["c"])
        castle = report["measured"][0]
        self.assertTrue(castle["a"] > castle["b"] > castle["c"] > 0)
        self.assertLess(castle["corners_visible"], castle["corners_facing"])
        self.assertGreater(castle["light_facing_ms"], 0)

    def test_static_objects(self):
        with tempfile.TemporaryDirectory() as folder:
            report, text = repro(folder, "E", "--objects", "300", "--layers", "20", "--moving", "5", "20", "--frames",
                                 "25", "--full-frames", "2", "--interval", "8", "--width", "160", "--height", "120",
                                 "--seed", "7")
            for name in ("static_objects", "crowd"):
                self.assertGreater((pathlib.Path(folder) / f"{name}.png").stat().st_size, 5000)
        self.assertIn("seed 7", text)
        self.assertEqual(report["triangles"], 300 * 4512)
        self.assertEqual(report["compared_pixels"], 2 * 2 * 3 * 160 * 120)
        self.assertLess(report["memory_mb"], 4096)
        skipped = 0
        for step in report["steps"]:
            everything, plain, query, many = (step[name] for name in ("all", "no_query", "query", "query_many"))
            self.assertEqual((everything["objects_drawn"]["mean"], everything["cycles"]["frames"]), (300, 2))
            self.assertGreater(plain["starts"], 10)
            self.assertEqual(plain["updates"], plain["starts"])
            for way in (plain, query, many):
                self.assertEqual(way["starts"], plain["starts"])
                self.assertEqual(way["objects_drawn"]["frames"], 25)
                # What moves, what stops, and what is drawn again.
                self.assertGreaterEqual(way["objects_drawn"]["mean"], step["moving"] + way["redrawn"]["mean"])
                for number in ("objects_drawn", "triangles", "cycles"):
                    self.assertLess(way[number]["mean"], everything[number]["mean"])
                self.assertGreater(way["ms"]["mean"], 0)
            self.assertLess(query["objects_drawn"]["mean"], plain["objects_drawn"]["mean"])
            self.assertLess(many["redrawn"]["largest"], plain["redrawn"]["largest"])
            skipped += query["starts"] - query["updates"]
        self.assertGreater(skipped, 10)

    def test_up_conversion(self):
        with tempfile.TemporaryDirectory() as folder:
            numbers, _ = repro(folder, "C", "gouraud", "--frames", "6", "--size", "160x120")
            self.assertGreater((pathlib.Path(folder) / "blocks_gouraud_drone.png").stat().st_size, 5000)
        self.assertEqual(len(numbers["rows"]), 10)
        for row in numbers["rows"]:
            made, average = row["kernels"]["compensated"], row["kernels"]["temporal_average"]
            self.assertGreater(made["psnr_y_db"], average["psnr_y_db"] + 8, row["scene"])
            self.assertGreater(made["psnr_y_db"], row["as_printed"]["compensated"]["psnr_y_db"], row["scene"])
            self.assertEqual(made["blocks"]["very bad"], 0, row["scene"])
            self.assertEqual(row["kernels"]["keys"], [0, 5])
        self.assertEqual(sum(row["printed"]["compensated_db"] for row in numbers["rows"]) // 10, 33)

    def test_bad_calls_say_why(self):
        for args, words in ((["E", "--objects", "10", "--moving", "8"], "8 of 10 objects"),
                            (["A", "nowhere.obj"], "nowhere.obj"),
                            (["C", "teapot"], "teapot")):
            done = subprocess.run([HALFSPACE, "repro", *args], capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
