#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The area tool on the smallest unit: numbers, cache, errors, and docs/area.md beside it. Usage: area_test.py ROOT"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv[1]).resolve()
SYNTH = ROOT / "rtl" / "synth"
LOW = ROOT / "rtl" / "formats" / "low" / "hs_formats_pkg.sv"
UNIT = "scan_index"


class Area(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="area test ")  # a space: paths are quoted
        cls.folder = pathlib.Path(cls.temporary.name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_tool(self, *args):
        command = [sys.executable, SYNTH / "area.py", "--units", UNIT, "--cache", self.folder / "cache", *args]
        return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, check=False)

    def good(self, package, targets="ecp5,ice40", *more):
        """The result, and how many times Yosys mapped something."""
        out = self.folder / "out.json"
        done = self.run_tool("--package", package, "--targets", targets, "--json", out, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads(out.read_text())
        self.assertEqual(result["format"], "halfspace-area 1")
        self.assertTrue(result["yosys"].startswith("0."), result["yosys"])
        return result, len(re.findall(rf": {UNIT}, ", done.stderr))

    def bad(self, *args, words):
        before = sorted(self.folder.rglob("*"))
        done = self.run_tool(*args)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before, "something was left behind")

    def package(self, *changes):
        """`low` with some of its text changed."""
        text = LOW.read_text()
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        path = self.folder / "package.sv"
        path.write_text(text)
        return path

    def test_rows_cache_and_documentation(self):
        first, mapped = self.good(LOW)
        self.assertEqual(mapped, 2)
        self.assertEqual([row["target"] for row in first["rows"]], ["ecp5", "ice40"])
        for row in first["rows"]:
            self.assertEqual((row["config"], row["unit"], row["lanes"]), ("low", UNIT, 1))
            self.plausible(row)
        bits = {line["buffer"]: line["bits"] for line in first["buffers"]}
        self.assertEqual(bits, {"depth_buffer": 320 * 200 * 16, "index_buffer": 2 * 320 * 200 * 13,
                                "shading_database": 2 * 4096 * 9 * 22})

        again, mapped = self.good(LOW)
        self.assertEqual(mapped, 0, "the cache was not used")
        self.assertEqual(again, first)
        self.documented(first["rows"])

        # What the unit does not see: names, comments, and the colour planes.
        unseen = self.package(("configuration `low`", "configuration `other`"), ("[21:0]", "[22:0]"),
                              ("ColourFraction = 14", "ColourFraction = 15"),
                              ("ColourPlaneBits = 22", "ColourPlaneBits = 23"),
                              (" PlanesWordBits = 213", " PlanesWordBits = 222"))
        other, mapped = self.good(unseen)
        self.assertEqual(mapped, 0, "the key holds more than the unit sees")
        for mine, theirs in zip(first["rows"], other["rows"]):
            self.assertEqual(theirs, {**mine, "config": "other", "package": str(unseen)})
        wider = {line["buffer"]: line["bits"] for line in other["buffers"]}
        self.assertEqual(wider["shading_database"] - bits["shading_database"], 2 * 4096 * 9)

        # What it does see: an index of one bit more goes through; rows 64 stamps longer take other constants.
        wide = self.package(("[12:0]", "[13:0]"), ("IndexBits = 13", "IndexBits = 14"),
                            ("MaxWidth = 320", "MaxWidth = 384"))
        changed, mapped = self.good(wide)
        self.assertEqual(mapped, 2, "the key does not hold what the unit sees")
        for mine, theirs in zip(first["rows"], changed["rows"]):
            self.assertNotEqual(theirs["cells"], mine["cells"])

        # The unit without its pipeline is the same part: nothing is mapped again, and the rows are equal.
        out = self.folder / "out.json"
        done = self.run_tool("--alone", f"{LOW}@1:{UNIT}", "--targets", "ecp5,ice40", "--alone-targets", "ice40",
                             "--json", out)
        self.assertEqual((done.returncode, len(re.findall(rf": {UNIT}, ", done.stderr))), (0, 0), done.stderr)
        alone = json.loads(out.read_text())
        self.assertEqual((alone["rows"], alone["buffers"]), (first["rows"][1:], []))

        one, mapped = self.good(LOW, "xilinx", "--tries", 1)
        self.assertEqual(mapped, 1)
        self.plausible(one["rows"][0])

    def plausible(self, row):
        # Position, last position, position in the record; the address; the address of a row, a multiple of 2^6, as
        # a row is 320 stamps; active, clear, valid, last.
        self.assertEqual(row["ff"], 3 * (9 + 8) + 16 + (16 - 6) + 4)
        self.assertGreater(row["lut"], 20)
        self.assertGreater(row["carry"], 0)
        self.assertGreater(row["depth"], 3)
        self.assertEqual((row["dsp"], row["bram"], row["memory_bits"], row["clock_mhz"]), (0, 0, 0, None))
        self.assertTrue(row["why"])

    def documented(self, rows):
        """The line of docs/area.md says the same."""
        text = (ROOT / "docs" / "area.md").read_text()
        table = text.partition("### low, 1 lane\n")[2].partition("###")[0]
        words = next((line.split("|") for line in table.splitlines() if line.startswith(f"| `{UNIT}` |")), [])
        expected = [f"{row[name]:,}" for row in rows for name in ("lut", "ff", "dsp", "bram", "depth")
                    if (row["target"], name) != ("ice40", "dsp")]
        # The unit, five columns of 7-series; after those of the two targets the clock.
        self.assertEqual([word.strip() for word in words[7:-2]], expected,
                         "docs/area.md is out of date: make -f Makefile.sim area")

    def test_every_unit_is_measured(self):
        """visible_select, which is a few gates, is a part of what lies between the units; static_frames and up_convert
        are units."""
        sys.dont_write_bytecode = True
        sys.path[:0] = [str(SYNTH), str(SYNTH.parent)]
        import design
        import units
        self.assertEqual(set(units.units()) - set(design.UNITS), {"visible_select", "static_frames", "up_convert"})
        self.assertLessEqual(set(design.UNITS), set(units.units()))
        page = (ROOT / "docs" / "area.md").read_text()
        self.assertEqual([unit for unit in design.UNITS if f"| `{unit}` |" not in page], [])

    def test_depth_is_that_of_ltp(self):
        sys.dont_write_bytecode = True
        sys.path.insert(0, str(SYNTH))
        import design
        import netlist
        import targets
        part = design.elaborate("yosys", ROOT / "rtl", LOW, 1, [UNIT]).parts[UNIT]
        ice40 = targets.TARGETS["ice40"]
        (self.folder / "part.il").write_text(part.text)
        script = (f'read_rtlil "{self.folder}/part.il"; {ice40.to_gates}; {ice40.to_luts}; '
                  f'json -o "{self.folder}/part.json" part; '
                  "select -set logic part/w:* part/t:SB_LUT4 part/t:SB_CARRY; ltp @logic")
        said = subprocess.run(["yosys", "-p", script], capture_output=True, text=True, timeout=300, check=True).stdout
        longest = int(re.search(r"Longest topological path in part \(length=(\d+)\)", said).group(1))
        measured = netlist.measure(json.loads((self.folder / "part.json").read_text())["modules"]["part"])
        self.assertEqual(measured["depth"], longest)

    def test_bad_calls_say_why(self):
        self.bad("--package", self.folder / "none.sv", words=["none.sv", "halfspace package"])
        self.bad("--package", ROOT / "LICENSE", words=["LICENSE", "not a package"])
        self.bad("--package", LOW, "--lanes", "3", words=["lanes", "not 3"])
        self.bad("--package", LOW, "--targets", "gowin", words=["gowin", "ecp5"])
        self.bad("--alone", f"{LOW}:light_vertex", words=["light_vertex", "another"])
        self.bad("--alone", f"{LOW}:no_unit", words=["no_unit", "shade_phong"])
        self.bad("--package", LOW, "--markdown", ROOT / "LICENSE", words=["LICENSE", "begin"])
        self.bad("--package", LOW, "--yosys", self.folder / "no_yosys", words=["no_yosys"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
