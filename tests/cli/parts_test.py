#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`halfspace config --parts`: what it knows of circuits is what docs/area.md has, its blocks are those of the table of
memories there, and its verdicts follow from both. `halfspace fit --part` asks for less until the memories have room.
Usage: parts_test.py HALFSPACE SOURCE CONFIGS"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HALFSPACE, SOURCE, CONFIGS = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
AREA = (SOURCE / "docs/area.md").read_text()
NAMED = ("low", "middle", "high")


def run(*options, command="config"):
    done = subprocess.run([HALFSPACE, command, *map(str, options)], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def table():
    """{first cell: the cells of the configurations} of what is printed for low, middle, high."""
    rows = {}
    for line in run("--parts")[1].splitlines():
        cells = re.split(r"\s{2,}", line[46:].strip())
        rows[line[:46].strip()] = cells
    return rows


def of_page(config):
    """(LUT, DSP, BRAM) of the pipeline for 7-series, ECP5 and iCE40, which has no DSP."""
    row = re.search(rf"^### {config}, 1 lane$.*?^\| `pipeline` \|(.*?)$", AREA, re.M | re.S).group(1)
    n = [int(cell.replace(",", "")) if re.fullmatch(r" [\d,]+ ", cell) else None for cell in row.split("|")]
    return {"7-series": (n[0], n[2], n[3]), "ECP5": (n[5], n[7], n[8]), "iCE40": (n[10], 0, n[12])}


class Parts(unittest.TestCase):
    def test_circuits_are_those_of_the_page(self):
        rows = table()
        for place, config in enumerate(NAMED):
            for family, numbers in of_page(config).items():
                with self.subTest(config=config, family=family):
                    cell = rows[f"{family}: LUTs / multipliers / blocks besides"][place]
                    self.assertEqual(cell, " / ".join(map(str, numbers)))

    def test_blocks_are_those_of_the_page(self):
        rows = table()
        for place, config in enumerate(NAMED):
            memories = re.findall(rf"^\| {config} \| 1 \| `\w+` \|[^|]*\|[^|]*\| (\d+) \|", AREA, re.M)
            self.assertEqual(len(memories), 3)
            for family in ("7-series", "ECP5"):
                self.assertEqual(rows[f"{family}: blocks of 18 kbit for a frame"][place],
                                 str(sum(map(int, memories))))

    def test_verdicts(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "parts.json"
            code, _, said = run("--parts", "--json", path)
            self.assertEqual(code, 0, said)
            found = json.loads(path.read_text())
        self.assertEqual(len(found["low"]), 10)
        self.assertEqual(found["low"]["artix-100t"], "inside")   # 255 + 9 of 270 blocks
        self.assertEqual(found["low"]["artix-35t"], "outside")
        self.assertEqual(found["middle"]["artix-200t"], "outside")
        self.assertEqual(found["high"]["zynq-7010"], "outside")
        self.assertIn("LUTs", found["low"]["hx8k"])
        self.assertEqual(found["low"]["ecp5-25"], "outside")

    def test_a_file_is_judged_by_its_memories(self):
        code, out, said = run(CONFIGS / "base" / "tiny.toml", "--parts")
        self.assertEqual((code, said), (0, ""))
        self.assertRegex(out, r"up5k .*inside\?")

    def test_fit_asks_for_less_until_the_part_holds_it(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "part.toml"
            ends = [run("two_tone", "--size", size, "--psnr", psnr, "--part", part, "--area", "none", "--no-cosim",
                        "--work", folder, "-o", out, command="fit")
                    for size, psnr, part in (("160x120", 30, "up5k"), ("320x240", 20, "hx8k"))]
            self.assertEqual(ends[0][0], 0, ends[0][2])
            self.assertIn("up5k at 30 dB: holds the memories", ends[0][1])
            self.assertIn('architecture = "delta"', out.read_text())
            # A bit of index a pixel and two banks are more than the 32 blocks of 4 kbit.
            self.assertNotEqual(ends[1][0], 0)
            self.assertIn("hx8k at 15 dB: no: ", ends[1][1])
            self.assertIn("fits hx8k: take a smaller --size", ends[1][2])

    def test_refusals(self):
        code, _, said = run("cube", "--part", "none", command="fit")
        self.assertNotEqual(code, 0)
        self.assertIn("there is no part none: use one of up5k, hx8k", said)
        code, _, said = run("--parts", "--area", "virtex")
        self.assertNotEqual(code, 0)
        self.assertIn("there is no target 'virtex'", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
