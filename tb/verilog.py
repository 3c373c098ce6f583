#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a module of the RTL, with all that is below it, as one file of Verilog-2001, by Yosys: for tools that do not
take its SystemVerilog, as Icarus 11 and 12. Ports and their widths are the same, parameters have their values."""

import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "rtl"))
from units import LANES, RTL, below, constants, parameters  # noqa: E402
from verilate import Broken, netlist_of  # noqa: E402


def write(package, top, lanes, out, rtl=RTL, yosys="yosys"):
    """How many lines the file has."""
    if not package.exists():
        raise Broken(f"{package}: no package of formats: print one with `halfspace package --config C -o {package}`")
    read = below(top, rtl)
    if not read:
        raise Broken(f"there is no module {top} in {rtl}")
    given = parameters(read[top].read_text(), lanes, constants(package.read_text()))
    out.parent.mkdir(parents=True, exist_ok=True)
    netlist_of([package, *read.values()], top, given, out, yosys)
    return out.read_text().count("\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--package", type=pathlib.Path, required=True, help="hs_formats_pkg.sv of the configuration")
    parser.add_argument("--top", default="hs_pipeline", help="the module (default: %(default)s)")
    parser.add_argument("--lanes", type=int, default=4, choices=sorted(LANES))
    parser.add_argument("-o", "--out", type=pathlib.Path, required=True, help="the file")
    parser.add_argument("--rtl", type=pathlib.Path, default=RTL)
    parser.add_argument("--yosys", default="yosys")
    args = parser.parse_args()
    try:
        lines = write(args.package, args.top, args.lanes, args.out, args.rtl, args.yosys)
    except Broken as e:
        print(f"verilog: {e}", file=sys.stderr)
        return 1
    print(f"{args.out}: {args.top} in Verilog, {lines} lines")
    return 0


if __name__ == "__main__":
    sys.exit(main())
