#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The soak on one small configuration: rounds compare fragments, are the same again, and are not run twice; a fault in
the RTL is found, shrunk, and repeated by the command that is left.
Usage: soak_test.py HALFSPACE FOLDER CONFIG OPTION …, the options for tb/soak/soak.py"""
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
HALFSPACE, FOLDER, CONFIG, *OPTIONS = sys.argv[1:]
FOLDER = pathlib.Path(FOLDER)
FAULT = ("hs_vertex_order.sv", "if (key2 < key0 && key2 < key1) first_q", "if (key2 < key0) first_q")


def soak(out, *options):
    """Status and text."""
    said = subprocess.run([sys.executable, ROOT / "tb/soak/soak.py", "--halfspace", HALFSPACE, "--out", FOLDER / out,
                           "--seed", "7", "--config", CONFIG, "--sets", "1", "--frames", "2", "--runs", "2",
                           "--optimize=-O0", *OPTIONS, *options], capture_output=True, text=True, check=False)
    return said.returncode, said.stdout + said.stderr


def rounds(out):
    return {path.name: json.loads(path.read_text()) for path in (FOLDER / out / "rounds").glob("*.json")}


class Soak(unittest.TestCase):
    def test_rounds_go_on(self):
        status, said = soak("right", "--rounds", "1")
        self.assertEqual(status, 0, said)
        first = rounds("right")["0.json"]
        self.assertGreater(first["fragments"], 0)
        self.assertEqual(first["runs"], 2)
        status, said = soak("right", "--rounds", "2")
        self.assertEqual(status, 0, said)
        both = rounds("right")
        self.assertEqual(sorted(both), ["0.json", "1.json"])
        self.assertEqual(both["0.json"], first)  # with its seconds: it was not run again
        self.assertNotEqual(both["1.json"]["words"], first["words"])
        self.assertIn(f"{first['fragments'] + both['1.json']['fragments']} fragments", said)
        self.assertEqual(soak("right", "--told")[0], 0)
        self.assertEqual(soak("right", "--rounds", "2", "--seed", "8")[0], 2)

    def test_fault_is_found_and_shrunk(self):
        rtl = FOLDER / "rtl"
        shutil.copytree(ROOT / "rtl", rtl)
        file, old, new = FAULT
        path = next(rtl.glob(f"*/{file}"))
        text = path.read_text()
        self.assertEqual(text.count(old), 1)
        path.write_text(text.replace(old, new))
        status, said = soak("wrong", "--rounds", "1", "--rtl", rtl)
        self.assertEqual(status, 1, said)
        failures = rounds("wrong")["0.json"]["failures"]
        self.assertEqual(len(failures), 1, said)
        kept = pathlib.Path(failures[0])
        self.assertIn("triangle_setup", (kept / "wrong.txt").read_text())
        triangles = [line for line in (kept / "smallest.tri").read_text().splitlines() if line.startswith("t")]
        self.assertEqual(len(triangles), 1)
        repeat = subprocess.run(["sh", kept / "repeat.sh"], capture_output=True, text=True, check=False)
        self.assertIn("first wrong in flow order: triangle_setup", repeat.stdout)
        self.assertNotEqual(soak("wrong", "--told")[0], 0)


if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    unittest.main(argv=sys.argv[:1])
