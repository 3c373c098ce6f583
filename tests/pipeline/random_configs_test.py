#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What is accepted works: configurations drawn from a seed, and FILEs, with the lanes that they name. Of each the whole
design is linted by Verilator and elaborated by Yosys; small ones are simulated, random triangles under random stalls,
to the bit. Before that, faults that only some configurations show have to be found.
Usage: random_configs_test.py HALFSPACE FOLDER FILE … --library A.a --library B.a [--seed N] [--count N] [--small N]"""
import argparse
import concurrent.futures
import pathlib
import random
import shutil
import sys
import types

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tb" / "soak"), str(ROOT / "tb")]
from designs import RTL, Broken, Design, Refused, drawn, judge, run, stalls  # noqa: E402
from lint import lint  # noqa: E402
from units import below, parameters, yosys_elaborate  # noqa: E402

# A file, what was right there, and what is put in its place: of an odd frame, of any.
FAULTS = (("hs_raster_clip.sv", "32'(rows) > lane / LanesX", "rows > hs_formats_pkg::YBits'(lane / LanesX)"),
          ("hs_scan_index.sv", "StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1", "$clog2(StampsX * StampsY)"),
          ("hs_raster_clip.sv", "32'(columns) > lane % LanesX", "32'(columns) >= lane % LanesX"))


def elaborate(yosys, design, top, rtl):
    found = below(top, rtl)
    given = parameters(found[top].read_text(), design.lanes, design.numbers)
    script = yosys_elaborate(top, [design.package, *found.values()], given).split("; proc")[0]
    status, said = run([yosys, "-q", "-p", script])
    return said.strip() if status else ""


def looked_at(args, design, rtl=RTL):
    """What Verilator or Yosys say of the whole design, or ''."""
    for top in design.tops:
        tools = types.SimpleNamespace(rtl=rtl, verilator=args.verilator)
        for tool, said in (("lint", lint(tools, design.package, top, design.lanes, {})),
                           ("elaboration", elaborate(args.yosys, design, top, rtl))):
            if said:
                return f"{tool} of {top}: {said[:2000]}"
    return ""


def simulated(args, design, draw, rtl=RTL):
    """(words that were compared, what differs or '')."""
    words = 0
    for top in design.tops:
        bench = design.build(top, args.library, rtl=rtl, verilator=args.verilator, cxx=args.cxx)
        scene = design.scene(top, draw)
        if not scene:
            continue
        design.vectors(scene, design.folder / "vectors")
        for stall in (0, stalls(draw)):
            seed = draw.randint(1, 99)
            one, wrong = judge(bench, design.folder / "vectors", stall, seed, design.folder / "cosim.json")
            if wrong:
                return words, f"{top} on {' '.join(map(str, scene))}, stall {stall}, seed {seed}: {wrong}"
            words += one["words"]
    return words, ""


def faulty(folder, fault):
    """A copy of the RTL with a fault."""
    shutil.copytree(RTL, folder)
    name, old, new = fault
    path = next(folder.glob(f"*/{name}"))
    text = path.read_text()
    assert text.count(old) == 1, f"{name}: {old} is not there once"
    path.write_text(text.replace(old, new))
    return folder


def find_faults(args, folder):
    """Names of those that are not found in the smallest configuration of FILEs, whose frame is one stamp."""
    lost = []
    for number, fault in enumerate(FAULTS):
        work = folder / f"fault_{number}"
        work.mkdir(parents=True)
        design = Design(args.halfspace, work, args.file[0])
        rtl = faulty(work / "rtl", fault)
        wrong = looked_at(args, design, rtl) if number < 2 else simulated(args, design, random.Random(1), rtl)[1]
        if not wrong:
            lost.append(fault[2])
    return lost


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("halfspace")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("file", nargs="+")
    parser.add_argument("--library", action="append", required=True)
    parser.add_argument("--seed", type=int, default=1, help="of the first; the others follow (default: %(default)s)")
    parser.add_argument("--count", type=int, default=13, help="that are linted and elaborated (default: %(default)s)")
    parser.add_argument("--small", type=int, default=4, help="that are simulated as well (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--yosys", default="yosys")
    parser.add_argument("--cxx", default="c++")
    args = parser.parse_args()
    shutil.rmtree(args.folder, ignore_errors=True)
    lost = find_faults(args, args.folder)
    for fault in lost:
        print(f"a fault is not found: {fault}")

    def one(number):
        """What is said of a configuration, and whether it works."""
        is_file, small = number < len(args.file), number < len(args.file) + args.small
        seed = args.seed + number - len(args.file)
        folder = args.folder / str(number)
        what = args.file[number] if is_file else f"--random {seed}{' --small' if small else ''}"
        try:
            if is_file:
                folder.mkdir(parents=True)
            design = Design(args.halfspace, folder, what) if is_file else drawn(args.halfspace, folder, seed, small)
            words, wrong = 0, looked_at(args, design)
            if small and not wrong:
                words, wrong = simulated(args, design, random.Random(seed))
                wrong = wrong or ("" if words else "nothing was compared")
        except (Broken, Refused) as failure:
            words, wrong = 0, str(failure)
        if not wrong:
            shutil.rmtree(folder)
        print(f"{what}: {wrong or (f'{words} words equal' if small else 'elaborates')}", flush=True)
        return not wrong

    every = len(args.file) + args.small + args.count
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        passed = sum(pool.map(one, range(every)))
    print(f"{passed} of {every} configurations work, from seed {args.seed}; {len(FAULTS) - len(lost)} of {len(FAULTS)} "
          "faults found")
    return 0 if passed == every and not lost else 1


if __name__ == "__main__":
    sys.exit(main())
