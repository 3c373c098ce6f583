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
CONFIGS = pathlib.Path(__file__).resolve().parent.parent / "configs"
FILES = {path.stem: path for path in sorted(CONFIGS.glob("*/*.toml"))}
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
        self.assertEqual(named - {"every field"}, set(found), "every proof that the table names is written, no other")
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
        self.assertGreaterEqual(len(FILES), 40)
        # Many scripts of two configurations are the same but for its name.
        proved = set()
        for config in configs + list(FILES.values()):
            for name, text in self.scripts(config).items():
                proof = text.split("\n\n", 1)[1]
                if proof in proved:
                    continue
                proved.add(proof)
                with self.subTest(config=config, script=name):
                    self.assertTrue(prove(text), text)
        self.assertGreaterEqual(len(proved), 250)

    def test_no_bound_can_be_lower_by_a_sixteenth(self):
        """Each number of the goals that is a bound, alone, times 15/16."""
        lowered = set()
        scripts = {**self.scripts("high")}
        for config in ("lit_high", "phong_high", "textured_high", "motion_high", "motion_area"):
            scripts.update({f"{config} {name}": text for name, text in self.scripts(FILES[config]).items()
                            if name.split("_")[0] in ("light", "shade", "texture", "motion", "shown")})
        for name, text in scripts.items():
            premises, goals = text.split("->", 1)
            for match in TIGHT.finditer(goals.split("}", 1)[0]):
                low, mantissa, exponent = match.groups()
                less = f"in [{low}, {int(mantissa) * 15}b{int(exponent) - 4}]"
                with self.subTest(script=name, goal=match.group(0)):
                    self.assertFalse(prove(premises + "->" + goals[:match.start()] + less + goals[match.end():]))
                lowered.add((name, match.start()))
        self.assertGreaterEqual(len(lowered), 90)

    def test_nothing_is_proved_from_other_premises(self):
        scripts = {}
        for config in ("motion_area", "motion_high", "textured_high", "phong_high", "lit_high"):
            scripts.update(self.scripts(FILES[config]))
        scripts["shown between"] = self.scripts(FILES["motion_high"])["shown"]
        scripts["shown textured"] = self.scripts(FILES["textured_high"])["shown"]
        scripts["key of four"] = self.scripts(FILES["motion_area"])["motion_compensate_key"]
        scripts.update(self.scripts("high"))
        for script, changes in {
                "light_cosine": [("rho in [-1b-17", "rho in [-1b-15"), ("C = fixed<-16,nu>", "C = fixed<-16,dn>"),
                                 ("P = fixed<-16,nu>", "P = fixed<-15,nu>")],
                "light_power": [("S3 = fixed<-16,nu>", "S3 = fixed<-16,dn>"),
                                ("C0 - X0 in [-3b-17", "C0 - X0 in [-4b-17")],
                "light_sum": [("kd in [0, 255]", "kd in [0, 256]"), ("ks in [0, 255]", "ks in [0, 256]")],
                "light_rounded": [("fixed<0,nu>", "fixed<0,dn>")],
                "shade_phong_colour": [("len in [1b-1", "len in [1b-2"), ("err*1b-1", "err"), ("nu>", "up>")],
                "shade_texture_place": [("rho in [-1b-18", "rho in [-1b-16"), ("q - Q in [-", "q - Q in [-1"),
                                        ("Q in [1b23", "Q in [1b22"), ("fixed<-8,dn>", "fixed<-7,dn>")],
                "shade_texture_filter": [("nu>", "dn>"), ("fixed<-8", "fixed<-7")],
                "shade_texture_product": [("fixed<0,dn>(P", "fixed<2,dn>(P"), ("fixed<0,nu>", "fixed<0,dn>")],
                "motion_field_vector": [("fixed<-6,nu>", "fixed<-6,dn>"), ("fixed<-6,nu>", "fixed<-5,nu>"),
                                        ("s - S in [-", "s - S in [-1")],
                "motion_compensate_weight": [("c = fixed<-8,nu>", "c = fixed<-8,dn>"),
                                             ("b = fixed<-8", "b = fixed<-7")],
                "motion_compensate_key": [("p in [1, 2473b-11]", "p in [1, 3000b-11]"), ("d in [-", "d in [-1")],
                "key of four": [("v - y in [-", "v - y in [-1"), ("m in [-", "m in [-1")],
                "motion_compensate_colour": [("nu>", "dn>")],
                "shown textured": [("t - f in [-", "t - f in [-1"), ("z in [0, 255]", "z in [0, 256]"),
                                   ("v - V in [0, 0]", "v - V in [0, 1]")],
                "shown between": [("du in [-", "du in [-1"), ("r in [-", "r in [-1")],
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
