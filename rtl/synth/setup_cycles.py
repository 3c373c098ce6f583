#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What units of setup in turn are worth: the cycles of scenes with each SetupCycles and number of lanes, as the
pipeline is simulated on them, beside the bound of the frame; and what hs_setup_turns and hs_shade_turns take of a
7-series by Yosys, and the cells of their longest path. Rows of a table of Markdown on standard output.

    python3 rtl/synth/setup_cycles.py --halfspace build/cli/halfspace --library build/tb/libhalfspace_tb.a \\
      --library build/tb/libhalfspace_verilated.a --work build/setup_cycles teapot castle

It goes on where it stopped: what is measured stays in --work."""
import argparse
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parent.parent / "tb")]
from model import build  # noqa: E402
from tools import AreaError, run, say, write_file  # noqa: E402
from units import RTL, below  # noqa: E402

CELLS = re.compile(r"^\s+(LUT\d|FD\w+|DSP48\w*|CARRY4)\s+(\d+)$", re.MULTILINE)
PATH = re.compile(r"Longest topological path in \w+ \(length=(\d+)\)")
BOUND = re.compile(r"^bound of a frame: (\d+) cycles .*measured (\d+):", re.MULTILINE)


def once(path, make):
    """What make() gave, kept as JSON."""
    if path.exists():
        return json.loads(path.read_text())
    made = make()
    write_file(path, json.dumps(made))
    return made


def area_of(args, top, cycles):
    """(LUT, FF, DSP48, cells of the longest path) of a module."""
    say(f"{top}, SetupCycles {cycles}: synthesis")
    sources = " ".join(str(path) for path in below(top, RTL).values())
    lanes = "-chparam LanesX 1 -chparam LanesY 1" if top == "hs_setup_turns" else ""
    script = (f"read_verilog -sv {args.package} {sources}; hierarchy -top {top} -chparam SetupCycles {cycles} {lanes}; "
              "synth_xilinx -family xc7 -noiopad -noclkbuf -flatten; stat; ltp -noff")
    text = run([args.yosys, "-p", script], top)
    cells = {name: int(count) for name, count in CELLS.findall(text)}
    count = lambda start: sum(n for name, n in cells.items() if name.startswith(start))  # noqa: E731
    return count("LUT"), count("FD"), count("DSP48"), int(PATH.findall(text)[-1])


def cycles_of(args, cycles, lanes):
    """{scene: (bound, measured)}"""
    say(f"SetupCycles {cycles}, {lanes} lanes: simulation")
    folder = args.work / f"{lanes}_{cycles}"
    bench = build(args.package, lanes, "hs_pipeline", folder / "model", args.library, optimize="-O1",
                  chosen={"SetupCycles": cycles, "BackgroundFifoDepth": args.background})
    found = {}
    for scene in args.scene:
        vectors = args.work / f"{lanes}_{pathlib.Path(scene).stem}"
        if not (vectors / "manifest.json").exists():
            run([args.halfspace, "vectors", scene, "--config", args.config, "--lanes", lanes, "--no-corners",
                 "--out", vectors], "vectors")
        found[scene] = [int(n) for n in BOUND.findall(run([bench, vectors, "--frames", 3], "bench"))[-1]]
        run([bench, vectors, "--stall", 40, "--seed", 3], "bench")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="+", help="built-in scenes or files")
    parser.add_argument("--halfspace", required=True)
    parser.add_argument("--library", type=pathlib.Path, action="append", required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--config", default="middle", help="low, middle or high (default: %(default)s)")
    parser.add_argument("--cycles", type=int, nargs="+", default=[29, 16, 8, 4, 2, 1], metavar="SETUP_CYCLES")
    parser.add_argument("--lanes", type=int, nargs="+", default=[1, 4, 16])
    parser.add_argument("--background", type=int, default=512, help="BackgroundFifoDepth (default: %(default)s)")
    parser.add_argument("--yosys", default="yosys")
    args = parser.parse_args()
    args.package = RTL / "formats" / args.config / "hs_formats_pkg.sv"
    args.work.mkdir(parents=True, exist_ok=True)
    try:
        for cycles in args.cycles:
            parts = [once(args.work / f"{top}_{cycles}.json", lambda top=top: area_of(args, top, cycles))
                     for top in ("hs_setup_turns", "hs_shade_turns")]
            lut, ff, dsp = (sum(part[i] for part in parts) for i in range(3))
            area = f"{lut} | {ff} | {dsp} | {max(part[3] for part in parts)}"
            for lanes in args.lanes:
                found = once(args.work / f"{lanes}_{cycles}.json", lambda: cycles_of(args, cycles, lanes))
                row = " | ".join(f"{measured} ({measured / bound:.2f})" for bound, measured in found.values())
                print(f"| {cycles} | {lanes} | {row} | {area} |", flush=True)
    except (AreaError, subprocess.CalledProcessError) as error:
        print(f"setup_cycles: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
