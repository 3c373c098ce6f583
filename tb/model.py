#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the bench of one module, a unit or hs_pipeline, for any package of formats, without CMake: configurations that
nobody named, and RTL with a fault in it."""

import argparse
import pathlib
import sys

from verilate import LANES, RTL, TB, Broken, run, verilate


def compile_command(verilator, cxx, optimize):
    """How a model is compiled, and what it includes."""
    root = run([verilator, "--getenv", "VERILATOR_ROOT"], verilator).strip()
    return [cxx, "-std=c++17", "-pthread", optimize, "-w", f"-I{TB.parent}", f"-I{root}/include",
            f"-I{root}/include/vltstd"]


def precompile(header, verilator, cxx):
    """Leaves HEADER.gch beside a copy of tb/harness/header.hpp, for models that are compiled as build() does."""
    run([*compile_command(verilator, cxx, "-O0"), "-x", "c++-header", header, "-o", f"{header}.gch"], cxx)


def build(package, lanes, top, out, libraries, rtl=RTL, verilator="verilator", cxx="c++", optimize="-O0", yosys=None):
    """The bench of `top` in folder `out`. `libraries`: the harness and Verilator's, in this order. With `yosys`: of the
    netlist that it makes."""
    verilate(package, top, lanes, out, rtl, verilator, yosys)
    # The compiler takes what is precompiled where it was compiled in the same way, and the header itself otherwise.
    header = pathlib.Path(libraries[0]).parent / "header.hpp"
    include = ["-include", header] if header.exists() else []
    # Everything in one go: the headers cost more than the model.
    run([*compile_command(verilator, cxx, optimize), *include, f"-I{out}", out / "model.cpp", *libraries,
         "-o", out / "bench"], cxx)
    return out / "bench"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--package", type=pathlib.Path, help="what `halfspace package` printed")
    parser.add_argument("--header", type=pathlib.Path,
                        help="precompile this copy of tb/harness/header.hpp, and build no bench")
    parser.add_argument("--lanes", type=int, default=4, choices=sorted(LANES))
    parser.add_argument("--top", default="hs_pipeline",
                        help="the module: hs_pipeline (default), or that of a unit, as hs_ztest_index")
    parser.add_argument("--out", type=pathlib.Path,
                        help="folder for the model; the program is OUT/bench")
    parser.add_argument("--library", type=pathlib.Path, action="append",
                        help="the harness and Verilator's library, in this order: --library A.a --library B.a")
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--yosys", help="this program, to simulate the netlist that it makes of the RTL")
    parser.add_argument("--cxx", default="c++")
    parser.add_argument("--optimize", default="-O1", help="of the compiler (default: %(default)s)")
    args = parser.parse_args()
    if not args.header and not (args.package and args.out and args.library):
        parser.error("a bench takes --package, --out and --library")
    try:
        if args.header:
            precompile(args.header, args.verilator, args.cxx)
            return 0
        print(build(args.package, args.lanes, args.top, args.out, args.library, verilator=args.verilator, cxx=args.cxx,
                    optimize=args.optimize, yosys=args.yosys))
    except Broken as e:
        print(f"model: {e}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
