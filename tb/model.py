#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the bench of one module, a unit or hs_pipeline, for any package of formats, without CMake: configurations that
nobody named, and RTL with a fault in it."""

import argparse
import os
import pathlib
import sys

from verilate import LANES, RTL, TB, Broken, parameter, run, verilate


def compile_command(verilator, cxx, optimize):
    """How a model is compiled, and what it includes."""
    root = run([verilator, "--getenv", "VERILATOR_ROOT"], verilator).strip()
    return [cxx, "-std=c++17", "-pthread", optimize, "-w", f"-I{TB.parent}", f"-I{root}/include",
            f"-I{root}/include/vltstd"]


def precompile(header, verilator, cxx):
    """Leaves HEADER.gch beside a copy of tb/harness/header.hpp, for models that are compiled as build() does."""
    run([*compile_command(verilator, cxx, "-O0"), "-x", "c++-header", header, "-o", f"{header}.gch"], cxx)


def trace_library(folder, out, verilator, cxx):
    """What writes waves, as an object file: compiled once beside the other libraries, or where nobody may write there
    beside the model."""
    folder = folder if os.access(folder, os.W_OK) else out
    source = pathlib.Path(run([verilator, "--getenv", "VERILATOR_ROOT"], verilator).strip()) / "include"
    made = folder / "verilated_fst_c.o"
    if not made.exists():
        part = made.with_suffix(f".{os.getpid()}.o")
        run([*compile_command(verilator, cxx, "-O1"), "-c", source / "verilated_fst_c.cpp", "-o", part], cxx)
        part.replace(made)
    return made


def build(package, lanes, top, out, libraries, rtl=RTL, verilator="verilator", cxx="c++", optimize="-O0", yosys=None,
          trace=False, chosen=None):
    """The bench of `top` in folder `out`. `libraries`: the harness and Verilator's, in this order. With `yosys`: of the
    netlist that it makes; `trace`: it writes waves, and takes Verilator's library for these as well; `chosen`:
    {name: value} of parameters of `top`."""
    folder = pathlib.Path(libraries[0]).parent
    verilate(package, top, lanes, out, rtl, verilator, yosys, trace, folder, cxx, chosen)
    # The compiler takes what is precompiled where it was compiled in the same way, and the header itself otherwise.
    header = folder / "header.hpp"
    include = ["-include", header] if header.exists() else []
    if trace:
        libraries = [libraries[0], trace_library(folder, out, verilator, cxx), *libraries[1:2], "-lz"]
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
    parser.add_argument("--rtl", type=pathlib.Path, default=RTL,
                        help="the modules, in folders as those of rtl/: to try RTL of one's own (default: %(default)s)")
    parser.add_argument("--parameter", type=parameter, action="append", default=[], metavar="NAME=VALUE",
                        help="a parameter of the module, as SetupCycles=8 of hs_pipeline")
    parser.add_argument("--trace", action="store_true", help="so that --wave of the bench writes waves")
    parser.add_argument("--log", type=pathlib.Path, help="write here what goes wrong, and nothing else anywhere")
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
        bench = build(args.package, args.lanes, args.top, args.out, args.library, args.rtl, args.verilator, args.cxx,
                      args.optimize, args.yosys, args.trace, dict(args.parameter))
        if not args.log:
            print(bench)
    except Broken as e:
        if args.log:
            args.log.parent.mkdir(parents=True, exist_ok=True)
            args.log.write_text(f"{e}\n")
            return 1
        print(f"model: {e}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
