#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The file lists of the RTL: halfspace.core and Bender.yml are what rtl/files.py prints; each module stands after those
that it instantiates; and Verilator and Yosys elaborate what each of them names, and what a .f file names.
Usage: files_test.py SOURCE VERILATOR YOSYS"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import yaml

SOURCE, VERILATOR, YOSYS = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
CONFIGS = ("low", "middle", "high")
BESIDE = ("motion_compensate", "ztest_merge", "static_run", "static_frames", "up_convert")
WHOLES = ("board", "system")
LANES = (4, 2)


def tool(*options):
    return subprocess.run([sys.executable, str(SOURCE / "rtl/files.py"), *options], capture_output=True, text=True)


def core():
    return yaml.safe_load((SOURCE / "halfspace.core").read_text())


def files_of_core(target):
    description = core()
    sets = description["targets"][target]["filesets"]
    return [path for name in sets for path in description["filesets"][name]["files"]]


def bender_holds(target, chosen):
    """Whether a target of Bender.yml is met: names, all(), any(), not()."""
    known = {name: name in chosen for name in re.findall(r"\w+", target)}
    known |= {"all": lambda *of: all(of), "any": lambda *of: any(of), "not_": lambda one: not one}
    return eval(re.sub(r"\bnot\(", "not_(", target), {"__builtins__": {}}, known)  # pylint: disable=eval-used


def files_of_bender(*chosen):
    sources = yaml.safe_load((SOURCE / "Bender.yml").read_text())["sources"]
    return [path for source in sources if bender_holds(source.get("target", "all()"), chosen)
            for path in source["files"]]


def files_of_f(config, top="hs_pipeline"):
    printed = tool("--config", config, "--top", top)
    if printed.returncode:
        raise AssertionError(printed.stderr)
    return printed.stdout.split("\n")[:-1]


def run(*command):
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, cwd=SOURCE)
    return result.returncode, result.stdout + result.stderr


def lint(files, top="hs_pipeline", lanes=True):
    parameters = [f"-GLanes{side}={count}" for side, count in zip("XY", LANES)] if lanes else []
    return run(VERILATOR, "--lint-only", "-Wall", "tb/lint.vlt", "--top-module", top, *parameters, *files)


def elaborate(files, top="hs_pipeline"):
    read = " ".join(f'"{path}"' for path in files)
    given = " ".join(f"-chparam Lanes{side} {count}" for side, count in zip("XY", LANES))
    return run(YOSYS, "-q", "-p", f"read_verilog -sv {read}; hierarchy -check -top {top} {given}; proc; check -assert")


class Files(unittest.TestCase):
    def test_committed_is_what_is_printed(self):
        for name, form in (("halfspace.core", "core"), ("Bender.yml", "bender")):
            self.assertEqual((SOURCE / name).read_text(), tool("--format", form).stdout,
                             f"python3 rtl/files.py --format {form} > {name}")

    def test_elaborates(self):
        for config in CONFIGS:
            lists = {"core": files_of_core(config), "lint of core": files_of_core(f"lint_{config}"),
                     "Bender": files_of_bender(config), "f": files_of_f(config)}
            for form, files in lists.items():
                with self.subTest(form=form, config=config):
                    self.assertIn(f"rtl/formats/{config}/hs_formats_pkg.sv", files[0])
                    self.assertGreater(len(files), 20)
                    verilog = [path for path in files if path.endswith(".sv")]
                    self.assertEqual(lint(verilog), (0, ""))
                    self.assertEqual(elaborate(verilog), (0, ""))

    def test_default_is_middle(self):
        self.assertEqual(files_of_core("default"), files_of_core("middle"))
        self.assertEqual(files_of_bender(), files_of_bender("middle"))

    def test_own_package(self):
        """Lists without a package, to which one is added; they have the units that stand beside the pipeline too."""
        for name, files in (("core", files_of_core("modules")),
                            ("Bender", files_of_bender("own_package", *BESIDE, *WHOLES))):
            with self.subTest(name):
                self.assertFalse([path for path in files if path.endswith("hs_formats_pkg.sv")])
                self.assertEqual(set(files), {str(path.relative_to(SOURCE)) for path in SOURCE.glob("rtl/*/hs_*.sv")})

    def test_a_unit(self):
        for unit in ("raster_pineda", "hs_ztest_index"):
            files = files_of_f("low", unit)
            self.assertLess(len(files), len(files_of_f("low")) / 3)
            self.assertEqual(elaborate(files, f"hs_{unit.removeprefix('hs_')}"), (0, ""))

    def test_cmake_reads_its_form(self):
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder) / "list.cmake"
            script.write_text(tool("--format", "cmake").stdout + 'message("${HALFSPACE_RTL}")\n')
            code, words = run("cmake", "-P", script)
            self.assertEqual((code, words.strip().split(";")), (0, files_of_f("middle")))

    def test_order(self):
        for files in (files_of_core("modules"), files_of_f("high")):
            stems = [pathlib.Path(path).stem for path in files]
            self.assertEqual(len(stems), len(set(stems)))
            for place, path in enumerate(files):
                text = (SOURCE / path).read_text()
                below = re.findall(r"^\s*(hs_\w+)\s+(?:#\s*\(|\w+\s*\()", text, re.MULTILINE)
                self.assertLessEqual(set(below) & set(stems), set(stems[:place]), path)

    def test_a_missing_file_is_found(self):
        """What the test of elaboration would say of a list that lacks a module."""
        files = [path for path in files_of_core("low") if not path.endswith("hs_raster_walk.sv")]
        self.assertNotEqual(lint(files)[0], 0)
        self.assertNotEqual(elaborate(files)[0], 0)

    def test_refusals(self):
        for options, word in ((("--config", "none"), "low, middle, high"), (("--top", "none"), "hs_none")):
            result = tool(*options)
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (1, 1))
            self.assertIn(word, result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
