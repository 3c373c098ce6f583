#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the bench of one top module for any package of formats, without CMake: configurations from files, and RTL with
a fault in it."""

import argparse
import pathlib
import re
import subprocess
import sys

TB = pathlib.Path(__file__).resolve().parent
LANES_X = {1: 1, 2: 2, 4: 2, 8: 4, 16: 4}
CONFIG = re.compile(r"^// Number formats of configuration `([\w-]+)`", re.MULTILINE)


class Broken(Exception):
    """It could not be built: a sentence."""


def run(command, what):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if result.returncode:
        raise Broken(f"{what} failed: {(result.stdout + result.stderr).strip()[:2000]}")
    return result.stdout


def netlist_of(sources, top, lanes_x, lanes_y, out, yosys):
    """What Yosys understands of the sources, written out as Verilog: a tool may read a construct otherwise than Verilator
    does and say nothing (CONTRIBUTING.md)."""
    out.mkdir(parents=True, exist_ok=True)
    netlist = out / "netlist.v"
    files = " ".join(str(path) for path in sources)
    run([yosys, "-q", "-p", f"read_verilog -sv {files}; hierarchy -check -top {top} -chparam LanesX {lanes_x} -chparam LanesY "
         f"{lanes_y}; proc; opt; memory_collect; check -assert; chformal -remove; opt_clean; write_verilog -noattr {netlist}"], "yosys")
    return netlist


def build(package, lanes, top, out, libraries, rtl=TB.parent / "rtl", verilator="verilator", cxx="c++", optimize="-O0",
          yosys=None):
    """The bench of `top` (hs_units, hs_light_units, hs_phong_units, hs_texture_units, hs_motion_units, hs_compensate_units,
    hs_merge_units or hs_pipeline) in folder `out`. `libraries`: the harness and Verilator's, in this order. With `yosys`: of the netlist that it makes."""
    name = CONFIG.search(package.read_text()) if package.exists() else None
    if not name:
        raise Broken(f"{package}: no package of formats: print one with `halfspace package --config C -o {package}`")
    lanes_x = LANES_X[lanes]
    lanes_y = lanes // lanes_x
    sources = sorted(rtl.glob("*/hs_*.sv"))
    sources += {"hs_units": [TB / "hs_units.sv", TB / "hs_bench_ram.sv"], "hs_pipeline": [],
                "hs_phong_units": [TB / "hs_phong_units.sv", TB / "hs_bench_ram.sv"],
                "hs_texture_units": [TB / "hs_texture_units.sv", TB / "hs_bench_ram.sv"],
                "hs_motion_units": [TB / "hs_motion_units.sv", TB / "hs_bench_ram.sv"]}.get(top, [TB / f"{top}.sv"])
    if yosys:
        sources = [netlist_of([package, *sources], top, lanes_x, lanes_y, out, yosys)]
    flags = ["-Wno-fatal", "--noassert", "--x-initial", "unique"]
    run([sys.executable, TB / "verilate.py", "--verilator", verilator, "--top", top, "--lanes-x", lanes_x, "--lanes-y",
         lanes_y, "--out", out, "--package", package, *(["--netlist"] if yosys else []), *(f"--flag={flag}" for flag in flags), TB / "lint.vlt",
         *sources], "verilate.py")
    root = run([verilator, "--getenv", "VERILATOR_ROOT"], verilator).strip()
    # Everything in one go: the headers cost more than the model.
    (out / "all.cpp").write_text('#include "fast.cpp"\n#include "slow.cpp"\n#include "tb/harness/binding.cpp"\n')
    run([cxx, "-std=c++17", optimize, "-w", f"-I{out}", f"-I{TB.parent}", f"-I{root}/include", f"-I{root}/include/vltstd",
         f'-DHS_TOP="{top}"', f'-DHS_CONFIG="{name.group(1)}"', f"-DHS_LANES_X={lanes_x}", f"-DHS_LANES_Y={lanes_y}",
         out / "all.cpp", *libraries, "-pthread", "-o", out / "bench"], cxx)
    return out / "bench"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--package", type=pathlib.Path, required=True, help="what `halfspace package` printed")
    parser.add_argument("--lanes", type=int, default=4, choices=sorted(LANES_X))
    parser.add_argument("--top", default="hs_pipeline", choices=["hs_units", "hs_light_units", "hs_phong_units", "hs_texture_units", "hs_motion_units", "hs_compensate_units",
                                                                   "hs_merge_units", "hs_pipeline"])
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the model; the program is OUT/bench")
    parser.add_argument("--library", type=pathlib.Path, action="append", required=True,
                        help="the harness and Verilator's library, in this order: --library A.a --library B.a")
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--yosys", help="this program, to simulate the netlist that it makes of the RTL")
    parser.add_argument("--cxx", default="c++")
    parser.add_argument("--optimize", default="-O1", help="of the compiler (default: %(default)s)")
    args = parser.parse_args()
    try:
        print(build(args.package, args.lanes, args.top, args.out, args.library, verilator=args.verilator, cxx=args.cxx,
                    optimize=args.optimize, yosys=args.yosys))
    except Broken as e:
        print(f"model: {e}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
