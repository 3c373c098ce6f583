#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What Yosys finds in a module: each FIND is an assertion of its command `select`. Nothing divides in any.
Usage: synthesis_test.py YOSYS PACKAGE MODULE LANES FIND …"""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "rtl"))
from units import below, constants, parameters, yosys_elaborate  # noqa: E402


def main():
    yosys, package, top, lanes, *finds = sys.argv[1:]
    sources = below(top)
    given = parameters(sources[top].read_text(), int(lanes), constants(pathlib.Path(package).read_text()))
    finds = "; ".join(f"select {find}" for find in [*finds, "-assert-none t:$div t:$mod"])
    script = (f"{yosys_elaborate(top, [package, *sources.values()], given)}; check -assert; flatten; opt; "
              f"memory_collect; {finds}")
    return subprocess.run([yosys, "-q", "-p", script], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
