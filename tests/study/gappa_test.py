#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Gappa proves every bound of a configuration, and does not prove what is not so. The scripts are printed by the
program.
Usage: gappa_test.py HALFSPACE GAPPA"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HALFSPACE, GAPPA = sys.argv[1:3]
NAMED = ["low", "middle", "high"]
# Beyond the named ones, what differs from low: the widest numbers, the narrowest, planes of 32 bits, a long reciprocal.
UNNAMED = {
    "wide": {"width": 8000, "height": 4320, "range_bits": 15, "subpixel_bits": 8, "depth_bits": 24,
             "reciprocal_bits": 28,
             "depth_fraction": 16, "colour_fraction": 18},
    "narrow": {"width": 20, "height": 10, "range_bits": 6, "subpixel_bits": 1, "depth_bits": 2, "colour_bits": 1,
               "reciprocal_bits": 10, "depth_fraction": 9, "colour_fraction": 8},
    "deep": {"depth_bits": 32, "reciprocal_bits": 36, "depth_fraction": 15},
    "long": {"depth_bits": 10, "colour_bits": 6, "reciprocal_bits": 37},
}
# With lighting, from files, and how many proofs they have.
CONFIGS = pathlib.Path(__file__).resolve().parent.parent / "configs/lit"
LIT = {CONFIGS / "lit_low.toml": 13, CONFIGS / "lit_middle.toml": 13, CONFIGS / "lit_high.toml": 13,
       CONFIGS / "lit_matte.toml": 3,
       CONFIGS / "phong_low.toml": 13, CONFIGS / "phong_high.toml": 13}
# A number that is as small as it can be: mantissa, exponent.
TIGHT = re.compile(r"in \[(-?\d+(?:b-?\d+)?), (\d+)b(-?\d+)\]")


def run(*args):
    result = subprocess.run([HALFSPACE, *map(str, args)], capture_output=True, text=True, timeout=60, check=False)
    assert result.returncode == 0, result.stderr


def prove(text):
    """Whether Gappa proves it. It does so in silence: a warning would be of a hint that it could not check."""
    result = subprocess.run([GAPPA], input=text, capture_output=True, text=True, timeout=60, check=False)
    said = result.stdout + result.stderr
    if result.returncode == 0 and said == "":
        return True
    refused = re.search(r"Error: (some properties were not satisfied|no contradiction was found)", said)
    assert result.returncode == 1 and refused, f"Gappa did not judge this:\n{text}\n{said}"
    return False


class Proofs(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def scripts(self, config):
        out, numbers = self.folder / pathlib.Path(config).stem, self.folder / "bounds.json"
        run("bounds", "--config", config, "--triangles", 0, "--gappa", out, "--json", numbers)
        found = {path.stem: path.read_text() for path in out.glob("*.g")}
        named = {row["proof"] for row in json.loads(numbers.read_text())["rows"] if not row["exact"]}
        self.assertEqual(named, set(found), "every proof that the table names is written, and no other")
        self.assertEqual(len(found), LIT.get(config, 10))
        return found

    def test_every_bound_is_proved(self):
        configs = list(NAMED)
        for name, numbers in UNNAMED.items():
            path = self.folder / f"{name}.toml"
            run("config", "low", "--toml", path)
            text = path.read_text().replace('"low"', f'"{name}"')
            for field, number in numbers.items():
                text, found = re.subn(rf"(?m)^{field} = \d+", f"{field} = {number}", text)
                self.assertEqual(found, 1)
            path.write_text(text)
            configs.append(path)
        for config in configs + list(LIT):
            for name, text in self.scripts(config).items():
                with self.subTest(config=config, script=name):
                    self.assertTrue(prove(text), text)

    def test_no_bound_can_be_lower_by_a_sixteenth(self):
        """Each number of the goals that is a bound, alone, times 15/16."""
        lowered = 0
        lit = {name: text for name, text in self.scripts(CONFIGS / "lit_high.toml").items() if name.startswith("light")}
        for name, text in {**self.scripts("high"), **lit}.items():
            premises, goals = text.split("->", 1)
            for match in TIGHT.finditer(goals.split("}", 1)[0]):
                low, mantissa, exponent = match.groups()
                less = f"in [{low}, {int(mantissa) * 15}b{int(exponent) - 4}]"
                with self.subTest(script=name, goal=match.group(0)):
                    self.assertFalse(prove(premises + "->" + goals[:match.start()] + less + goals[match.end():]))
                lowered += 1
        self.assertEqual(lowered, 23)

    def test_nothing_is_proved_from_other_premises(self):
        scripts = {**self.scripts(CONFIGS / "lit_high.toml"), **self.scripts("high")}
        for script, changes in {
                "light_cosine": [("rho in [-1b-17", "rho in [-1b-15"), ("C = fixed<-16,nu>", "C = fixed<-16,dn>"),
                                 ("P = fixed<-16,nu>", "P = fixed<-15,nu>")],
                "light_power": [("S3 = fixed<-16,nu>", "S3 = fixed<-16,dn>"),
                                ("C0 - X0 in [-3b-17", "C0 - X0 in [-4b-17")],
                "light_sum": [("kd in [0, 255]", "kd in [0, 256]"), ("ks in [0, 255]", "ks in [0, 256]")],
                "snap": [("ne>", "dn>")],
                "triangle_setup_reciprocal": [("nu>", "dn>"), ("[1, 2]", "[1, 3]"), ("[1, 2]", "[0, 2]")],
                "triangle_setup_product": [("24,dn", "25,dn"), ("H in [-1b", "H in [-1b9")],
                # Two reciprocals, gradients that are cut, a vertex or a value farther away.
                "raster_pineda_depth": [("(q*R)", "(q*R2)"), ("B = fixed<-15,nu>", "B = fixed<-15,dn>"),
                                        ("x0 in [-8192", "x0 in [-9000"), ("t in [-", "t in [-1")],
                "shade_gouraud_colour": [("(q*R)", "(q*R2)"), ("x in [1b-1, 3839b-1]", "x in [1b-1, 4839b-1]")],
                "raster_pineda_rounded": [("nu>", "dn>"), ("V - v in [-", "V - v in [-1")]}.items():
            text = scripts[script]
            for old, new in changes:
                with self.subTest(script=script, change=f"{old} -> {new}"):
                    self.assertIn(old, text)
                    changed = text.replace(old, new, 1)
                    if "R2" in new:
                        changed = changed.replace("A = ", "R2 = fixed<-28,dn>(1 / m);\nA = ", 1)
                    self.assertFalse(prove(changed))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
