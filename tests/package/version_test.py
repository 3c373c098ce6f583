#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The version is that of the project() line everywhere; an installed program stands on what was installed with it; and
the presets name targets that there are. Usage: version_test.py CMAKE HALFSPACE SOURCE BUILD"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import yaml

CMAKE, HALFSPACE, SOURCE, BUILD = sys.argv[1], *map(pathlib.Path, sys.argv[2:5])


def output(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=True, **options).stdout


def first(pattern, path):
    return re.search(pattern, path.read_text(), re.MULTILINE).group(1)


VERSION = first(r"^project\(halfspace VERSION (\S+)", SOURCE / "CMakeLists.txt")


class Version(unittest.TestCase):
    def test_of_the_program_and_the_sources(self):
        self.assertEqual(output(HALFSPACE, "--version"), f"halfspace {VERSION}\nfiles: {SOURCE.resolve()}\n")
        core = yaml.safe_load((SOURCE / "halfspace.core").read_text())
        self.assertEqual(core["name"], f"::halfspace:{VERSION}")
        self.assertEqual(first(r"^# halfspace (\S+) for Bender", SOURCE / "Bender.yml"), VERSION)
        self.assertEqual(first(r"^## (\S+)", SOURCE / "CHANGELOG.md"), VERSION)
        consumer = SOURCE / "tests/package/consumer/CMakeLists.txt"
        self.assertTrue(VERSION.startswith(first(r"find_package\(halfspace (\S+)", consumer) + "."))

    def test_of_what_is_installed(self):
        with tempfile.TemporaryDirectory() as folder:
            prefix = pathlib.Path(folder).resolve() / "prefix"
            output(CMAKE, "--install", BUILD, "--prefix", prefix)
            found = output("pkg-config", "--modversion", "halfspace",
                           env={**os.environ, "PKG_CONFIG_PATH": str(prefix / "share/pkgconfig")})
            self.assertEqual(found.strip(), VERSION)
            package = prefix / "share/cmake/halfspace/halfspaceConfigVersion.cmake"
            self.assertEqual(first(r'set\(PACKAGE_VERSION "(\S+)"\)', package), VERSION)
            data = prefix / "share/halfspace"
            program = prefix / "bin/halfspace"
            self.assertEqual(output(program, "--version"), f"halfspace {VERSION}\nfiles: {data}\n")
            for name in ("tb/model.py", "rtl/synth/area.py", "halfspace.core", "vectors/standard/low.json"):
                self.assertEqual((data / name).read_bytes(), (SOURCE / name).read_bytes())
            self.assertEqual(output(sys.executable, data / "rtl/files.py").count(str(data)),
                             output(sys.executable, SOURCE / "rtl/files.py").count("\n"))
            # Without its files it says so, and does not take those of the sources.
            data.rename(prefix / "away")
            sweep = ["sweep", "cube", "--area", "xilinx", "--list", "--out", prefix / "sweep"]
            result = subprocess.run([program, *sweep], capture_output=True, text=True)
            self.assertEqual((result.returncode, result.stderr.count("\n")), (1, 1), result.stderr)
            self.assertIn(f"{data}/rtl is not there", result.stderr)


class Presets(unittest.TestCase):
    def test_targets_are_there(self):
        listed = output(CMAKE, "--list-presets=all", cwd=SOURCE)
        presets = json.loads((SOURCE / "CMakePresets.json").read_text())
        there = output(CMAKE, "--build", BUILD, "--target", "help")
        targets = set(re.findall(r"^(?:\.\.\. )?([\w/]+)", there, re.MULTILINE))  # of Make and of Ninja
        for preset in presets["buildPresets"]:
            self.assertIn(f'"{preset["name"]}"', listed)
            for target in preset["targets"]:
                if not target.endswith(("_ap", "_ac")):  # of libraries that may not be at hand
                    self.assertIn(target, targets)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
