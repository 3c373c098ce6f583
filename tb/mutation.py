#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How many single faults in the RTL a bench finds, by random ones from a seed.

All mutants of the modules below a unit stand in one copy and are chosen by a number at run time (mutants.py), so that
one Verilated model serves all of them. Each is run under three seeds and without stalls, until one reports it: what is
right and takes more cycles than the RTL itself is found as well. A line tells of each how it was found, or that it
survived; one that is equivalent stands with its reason in --reasons, as `FILE | WHAT | TEXT OF THE LINE | REASON`."""

import argparse
import concurrent.futures
import pathlib
import random
import re
import shutil
import subprocess
import sys

TB = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(TB))
import mutants  # noqa: E402
from model import LANES, Broken, build, run  # noqa: E402
from units import RTL, below  # noqa: E402

RUNS = ((1, 35), (2, 35), (3, 75), (1, 0))  # seed, stall
LAST = re.compile(r"compared, (\d+) mismatches, (\d+) cycles$", re.MULTILINE)
FAIL = re.compile(r"^FAIL \w+: (.*)$", re.MULTILINE)


def chosen_of(files, count, seed):
    """{number: (path, mutant)}, in the order of the files."""
    every = [(path, mutant) for path in files for mutant in mutants.mutants(path.read_text())]
    some = random.Random(seed).sample(range(len(every)), min(count, len(every)))
    return {number: every[at] for number, at in enumerate(sorted(some), 1)}, len(every)


def write_mutants(files, chosen):
    for path in files:
        mine = {number: mutant for number, (where, mutant) in chosen.items() if where == path}
        if mine:
            path.write_text(mutants.applied(path.read_text(), mine))
    # Read before all others: the file that stands first in the alphabet.
    first = min(files, key=lambda path: path.stem)
    first.write_text(mutants.SOURCE + first.read_text())


def try_bench(args, number, seed, stall):
    """(cycles, what is wrong or '') of a run of the bench with a mutant."""
    try:
        said = subprocess.run([args.work / "model" / "bench", args.vectors, "--seed", str(seed), "--stall", str(stall),
                               "--mutant", str(number)], capture_output=True, text=True, timeout=args.seconds)
    except subprocess.TimeoutExpired:
        return 0, f"no end in {args.seconds} s"
    reports, last = FAIL.findall(said.stdout), LAST.search(said.stdout)
    if said.returncode or reports or not last:
        return 0, reports[0] if reports else said.stderr.strip() or f"exit status {said.returncode}"
    return int(last[2]), ""


def judge(args, number, pace):
    """How a mutant was found, or ''."""
    for seed, stall in RUNS:
        cycles, found = try_bench(args, number, seed, stall)
        if found or cycles > pace[seed, stall]:
            return f"seed {seed}, stall {stall}: {found or f'{cycles} cycles, and not {pace[seed, stall]}'}"
    return ""


def reasons_of(path):
    rows = [line.split(" | ") for line in path.read_text().splitlines() if line and not line.startswith("#")]
    return {tuple(cell.strip() for cell in row[:3]): row[3] for row in rows}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--unit", required=True)
    parser.add_argument("--package", type=pathlib.Path, required=True)
    parser.add_argument("--lanes", type=int, default=4, choices=sorted(LANES))
    parser.add_argument("--vectors", type=pathlib.Path, required=True, help="a set of the package's configuration")
    parser.add_argument("--library", type=pathlib.Path, action="append", required=True,
                        help="the harness and Verilator's library, in this order: --library A.a --library B.a")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for the copy and its model")
    parser.add_argument("--count", type=int, default=100, help="mutants (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--least", type=float, default=0, help="percent of those that are not equivalent, to be found")
    parser.add_argument("--reasons", type=pathlib.Path, default=TB / "faults" / "equivalent.list")
    parser.add_argument("--seconds", type=int, default=60, help="of a run (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--rtl", type=pathlib.Path, default=RTL)
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--cxx", default="c++")
    args = parser.parse_args()
    shutil.rmtree(args.work, ignore_errors=True)
    shutil.copytree(args.rtl, args.work / "rtl")
    files = list(below(f"hs_{args.unit}", args.work / "rtl").values())
    texts = {path: path.read_text() for path in files}
    chosen, total = chosen_of(files, args.count, args.seed)
    write_mutants(files, chosen)
    try:
        build(args.package, args.lanes, f"hs_{args.unit}", args.work / "model", args.library, rtl=args.work / "rtl",
              verilator=args.verilator, cxx=args.cxx, optimize="-O1")
    except Broken as e:
        print(f"mutation: {e}", file=sys.stderr)
        return 2
    pace = {}
    for seed, stall in RUNS:
        pace[seed, stall], wrong = try_bench(args, 0, seed, stall)
        if wrong:
            print(f"mutation: without a fault: {wrong}", file=sys.stderr)
            return 2
    reasons = reasons_of(args.reasons) if args.reasons.exists() else {}
    found = equivalent = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for number, how in zip(chosen, pool.map(lambda number: judge(args, number, pace), chosen)):
            path, ((_, begin, _), what, _) = chosen[number]
            at = mutants.line_of(texts[path], begin)
            line = texts[path].splitlines()[at - 1].strip()
            reason = reasons.get((path.name, what, line), "")
            found += bool(how)
            equivalent += not how and bool(reason)
            state = "found   " if how else "the same" if reason else "SURVIVES"
            print(f"{state} {number:4} {path.name}:{at} {what} | {line} | {how[:100] or reason}", flush=True)
    different = len(chosen) - equivalent
    share = 100 * found / different if different else 0
    print(f"mutation of {args.unit}: seed {args.seed}, {len(chosen)} of {total} mutants, {found} found, {equivalent} "
          f"equivalent, {different - found} survive: {share:.1f} % found")
    return 0 if found and share >= args.least else 1


if __name__ == "__main__":
    sys.exit(main())
