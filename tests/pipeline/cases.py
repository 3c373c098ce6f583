# SPDX-License-Identifier: Apache-2.0
"""What tests share that co-simulate configurations of their own making: a test is a list of CASEs, a bench is built
for each, and sets of vectors go through it."""
import argparse
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TESTS.parent / "tb"))
sys.path.insert(0, str(TESTS.parent / "rtl"))
from model import build  # noqa: E402


class Failed(Exception):
    """What a program said before it failed."""


def run(command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if result.returncode:
        raise Failed(result.stdout + result.stderr)
    return result.stdout


def changed(toml, values):
    """The text of a file of tests/configs with other values of fields that it has."""
    text = (TESTS / "configs" / toml).read_text()
    for key, value in values.items():
        text, count = re.subn(rf"^{key} = \S+", f"{key} = {value}", text, flags=re.MULTILINE)
        assert count == 1, (key, count)
    return text


class Case:
    """A configuration in a folder of its own, which is empty before and gone after it has passed."""

    def __init__(self, args, name):
        self.args, self.name = args, name
        self.folder = pathlib.Path(args.folder) / name
        self.toml = self.folder / "config.toml"

    def build(self, text, top, lanes, yosys=None, chosen=None):
        """The bench of module `top` in the configuration of this text; `chosen`: {name: value} of its parameters."""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.toml.write_text(text)
        self.lanes, package = lanes, self.folder / "hs_formats_pkg.sv"
        run([self.args.halfspace, "package", "--config", self.toml, "-o", package])
        self.bench = build(package, lanes, top, self.folder / "model", self.args.library,
                           verilator=self.args.verilator, cxx=self.args.cxx, yosys=yosys, chosen=chosen)

    def cosimulate(self, scene, stall, seeds, options=()):
        """What cosim_test.py says of the bench on a scene."""
        return run([sys.executable, TESTS / "pipeline/cosim_test.py", self.args.halfspace, self.bench,
                    self.folder / "vectors", scene, self.toml, self.lanes, "--stall", stall, "--seeds", seeds,
                    "--", *options])

    def say(self, what):
        print(f"{self.name}, {what}", flush=True)


def main(document, try_case, seeds=2, options=()):
    """Runs try_case(args, case) on each; the exit status. `options`: (name, what argparse takes of it) of the test's
    own."""
    parser = argparse.ArgumentParser(description=document, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("halfspace")
    parser.add_argument("folder")
    parser.add_argument("case", nargs="+")
    parser.add_argument("--library", action="append", required=True)
    parser.add_argument("--seeds", type=int, default=seeds)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--cxx", default="c++")
    for name, about in options:
        parser.add_argument(name, **about)
    args = parser.parse_args()

    def passes(name):
        case = Case(args, name)
        try:
            try_case(args, case)
        except Failed as failure:
            print(f"{name}: FAIL\n{failure}", flush=True)
            return False
        shutil.rmtree(case.folder, ignore_errors=True)
        return True

    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        passed = sum(pool.map(passes, args.case))
    print(f"{passed} of {len(args.case)} cases equal to the bit")
    return 0 if passed == len(args.case) else 1
