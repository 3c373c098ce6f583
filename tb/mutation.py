#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How many single faults in the RTL the benches find, by random ones from a seed.

faults/benches.list tells which modules are looked at by which unit, in which configurations. All mutants of the modules
of a unit stand in one copy and are chosen by a number at run time (mutants.py), so that one Verilated model serves all
of them. Each is run under three seeds and without stalls, in each configuration that has it, until one reports it: what
is right and takes more cycles than the RTL itself is found as well. A line tells of each how it was found, or that it
survived. One that is equivalent stands with its reason in --reasons: `FILE | WHAT | TEXT OF THE LINE | REASON`."""

import argparse
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys

TB = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(TB))
import mutants  # noqa: E402
from model import Broken, build, parameter, run  # noqa: E402
from units import RTL, below, sources  # noqa: E402

RUNS = ((1, 35), (2, 35), (3, 75), (1, 0))  # seed, stall
LAST = re.compile(r"compared, (\d+) mismatches, (?:(\d+) missing, )?(\d+) cycles$", re.MULTILINE)
FAIL = re.compile(r"^FAIL \w+: (.*)$", re.MULTILINE)
WHOLE = ("pipeline", "up_convert", "static_frames")  # units that have others in them
OTHERS = ("board", "system")  # rooms whose benches are others
# Where a model asks for the number: of those that it does not ask for it has no code.
ASKS = re.compile(r"(0x[0-9a-f]+|\d+)U\s*[=!]=\s*vlSymsp->\w*hs_mutant(?:\.|->)number")


def lines_of(path):
    return [line for line in path.read_text().splitlines() if line and not line.startswith("#")]


def modules_of(benches):
    """{unit: (names of modules, names of benches)}; each module of rtl/ in which there is something to change has one
    unit, but for rooms with benches of their own."""
    cells = [line.split(" | ") for line in lines_of(benches)]
    rows = {unit: (modules.split(), names.split()) for unit, modules, names in cells}
    named = [name for modules, _ in rows.values() for name in modules]
    every = {stem.removeprefix("hs_"): path for stem, path in sources().items() if path.parent.name not in OTHERS}
    wrong = set(named) - set(every) | {name for name in named if named.count(name) > 1}
    wrong |= {name for name in set(every) - set(named) if mutants.mutants(every[name].read_text())}
    if wrong:
        raise Broken(f"{benches}: not once there, or not in rtl/: {', '.join(sorted(wrong))}")
    return rows


def chosen_of(rows, units, modules, count, seed):
    """{unit: {number: (stem, mutant)}}, and of how many."""
    every = [(unit, f"hs_{name}", mutant) for unit in units for name in rows[unit][0] if re.fullmatch(modules, name)
             for mutant in mutants.mutants(sources()[f"hs_{name}"].read_text())]
    some = random.Random(seed).sample(range(len(every)), min(count, len(every)))
    chosen = {}
    for number, at in enumerate(sorted(some), 1):
        unit, stem, mutant = every[at]
        chosen.setdefault(unit, {})[number] = (stem, mutant)
    return chosen, len(every)


class Bench:
    """The model of a unit in a configuration, with mutants in it; `name`: CONFIG/LANES/SCENE/PARAMETER=VALUE,… or the
    begin of it, and before it UNIT: that of another unit."""

    def __init__(self, args, unit, name, chosen):
        other, rest = re.fullmatch(r"(?:(\w+):)?(.*)", name).groups()
        config, lanes, scene, given = (*rest.split("/"), "", "", "")[:4]
        self.args, self.unit, self.name = args, other or unit, name
        self.own = self.unit == unit or self.unit not in WHOLE
        lanes, scene = int(lanes or 4), scene or "standard"
        path = next((TB.parent / "tests" / "configs").glob(f"*/{config}.toml"), config)
        package = args.work / f"{config}.sv"
        if not package.exists():
            run([args.halfspace, "package", "--config", path, "-o", package], "halfspace package")
        self.vectors = args.work / "vectors" / f"{config}_{lanes}_{scene}"
        if not self.vectors.exists() and scene == "words":
            run([sys.executable, args.words, package, self.vectors, lanes], args.words)
        elif not self.vectors.exists():
            scene, *options = scene.split("+")
            run([args.halfspace, "vectors", scene, "--config", path, "--lanes", lanes, "--out", self.vectors,
                 *options], "halfspace vectors")
        self.work = args.work / unit / name.replace(":", "_").replace("/", "_")
        shutil.rmtree(self.work, ignore_errors=True)
        shutil.copytree(args.rtl, self.work / "rtl")
        files = below(f"hs_{self.unit}", self.work / "rtl")
        for stem in {stem for stem, _ in chosen.values()} & set(files):
            mine = {number: mutant for number, (where, mutant) in chosen.items() if where == stem}
            files[stem].write_text(mutants.applied(files[stem].read_text(), mine))
        # Read before all others: the file that stands first in the alphabet.
        first = files[min(files)]
        first.write_text(mutants.SOURCE + first.read_text())
        model = self.work / "model"
        build(package, lanes, f"hs_{self.unit}", model, args.library, rtl=self.work / "rtl", verilator=args.verilator,
              cxx=args.cxx, optimize="-O1", chosen=dict(parameter(each) for each in given.split(",") if each))
        code = "".join(file.read_text() for file in model.glob("Vmodel*.cpp"))
        self.has = {int(number, 0) for number in ASKS.findall(code)}
        self.pace = {}
        for seed, stall in RUNS:
            self.pace[seed, stall], wrong = self.run(0, seed, stall)
            if wrong:
                raise Broken(f"{unit} {name}, without a fault: {wrong}")

    def run(self, number, seed, stall):
        """(cycles, what is wrong or '') with a mutant."""
        command = [self.work / "model" / "bench", self.vectors, "--seed", str(seed), "--stall", str(stall), "--mutant",
                   str(number)]
        try:
            said = subprocess.run(command, capture_output=True, text=True, timeout=self.args.seconds)
        except subprocess.TimeoutExpired:
            return 0, f"no end in {self.args.seconds} s"
        reports, last = FAIL.findall(said.stdout), LAST.search(said.stdout)
        if said.returncode or reports or not last:
            return 0, reports[0] if reports else said.stderr.strip() or f"exit status {said.returncode}"
        return int(last[3]), ""

    def judge(self, number):
        """How a mutant is found, or ''."""
        for seed, stall in RUNS if number in self.has else ():
            cycles, wrong = self.run(number, seed, stall)
            if wrong or cycles > self.pace[seed, stall]:
                wrong = wrong or f"{cycles} cycles, and not {self.pace[seed, stall]}"
                return f"{self.unit} {self.name}, seed {seed}, stall {stall}: {wrong}"
        return ""


class Tally:
    def __init__(self):
        self.mutants = self.found = self.own = self.same = 0

    def add(self, other):
        for name in vars(self):
            setattr(self, name, getattr(self, name) + getattr(other, name))

    @property
    def different(self):
        return self.mutants - self.same

    def share(self, part):
        return 100 * part / self.different if self.different else 100

    def __str__(self):
        return (f"{self.mutants} mutants, {self.same} equivalent; of {self.different} others {self.found} found "
                f"({self.share(self.found):.1f} %), {self.own} at their own unit ({self.share(self.own):.1f} %)")


def try_unit(args, unit, names, chosen, reasons):
    """Prints a line a mutant; the tally."""
    left, how, own, has = dict(chosen), {}, set(), set()
    for name in names:
        if not left:
            break
        bench = Bench(args, unit, name, left)
        has |= bench.has
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            for number, said in zip(list(left), pool.map(bench.judge, left)):
                if not said:
                    continue
                how[number] = said
                own |= {number} if bench.own else set()
                del left[number]
        if not args.keep:
            shutil.rmtree(bench.work)
    tally = Tally()
    for number, (stem, ((_, begin, _), what, _)) in chosen.items():
        text = sources()[stem].read_text()
        at = mutants.line_of(text, begin)
        line = text.splitlines()[at - 1].strip()
        reason = reasons.get(f"{stem}.sv | {what} | {line}", "")
        tally.mutants += 1
        tally.found += number in how
        tally.own += number in own
        tally.same += number not in how and bool(reason)
        state = "found   " if number in how else "the same" if reason else "SURVIVES"
        told = how.get(number, "")[:150] or reason or ("" if number in has else "in none of the models")
        print(f"{state} {number:4} {stem}.sv:{at} {what} | {line} | {told}", flush=True)
    return tally


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--halfspace", type=pathlib.Path, required=True, help="the program, for packages and vectors")
    parser.add_argument("--unit", action="append", help="of these units alone (default: all)")
    parser.add_argument("--modules", default=".*", help="regular expression: of these modules alone, without hs_")
    parser.add_argument("--count", type=int, default=100, help="mutants (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--least", type=float, default=0, help="percent of those that are not equivalent, to be found")
    parser.add_argument("--least-own", type=float, default=0, help="and at their own unit")
    parser.add_argument("--library", type=pathlib.Path, action="append",
                        help="the harness and Verilator's library, in this order: --library A.a --library B.a "
                             "(default: those beside the program, in tb/)")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for copies and models")
    parser.add_argument("--benches", type=pathlib.Path, default=TB / "faults" / "benches.list")
    parser.add_argument("--reasons", type=pathlib.Path, default=TB / "faults" / "equivalent.list")
    parser.add_argument("--words", type=pathlib.Path, default=TB.parent / "tests" / "motion" / "film_words.py",
                        help="the script that makes the words of SCENE `words`")
    parser.add_argument("--seconds", type=int, default=60, help="of a run (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", action="store_true", help="keep the models")
    parser.add_argument("--rtl", type=pathlib.Path, default=RTL)
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--cxx", default="c++")
    args = parser.parse_args()
    libraries = args.halfspace.parent.parent / "tb"
    args.library = args.library or [libraries / "libhalfspace_tb.a", libraries / "libhalfspace_verilated.a"]
    args.halfspace = pathlib.Path(os.path.abspath(args.halfspace))
    shutil.rmtree(args.work / "vectors", ignore_errors=True)
    (args.work / "vectors").mkdir(parents=True)
    try:
        rows = modules_of(args.benches)
        units = args.unit or list(rows)
        if unknown := set(units) - set(rows):
            raise Broken(f"{args.benches}: no unit {', '.join(unknown)}")
        reasons = dict(line.rsplit(" | ", 1) for line in lines_of(args.reasons))
        chosen, every = chosen_of(rows, units, args.modules, args.count, args.seed)
        tallies, total = {}, Tally()
        for unit, mine in chosen.items():
            tallies[unit] = try_unit(args, unit, rows[unit][1], mine, reasons)
            total.add(tallies[unit])
    except Broken as e:
        print(f"mutation: {e}", file=sys.stderr)
        return 2
    for unit, tally in tallies.items():
        print(f"{unit}: {tally}")
    print(f"mutation, seed {args.seed}, {total.mutants} of {every}: {total}")
    good = total.share(total.found) >= args.least and total.share(total.own) >= args.least_own
    return 0 if total.found and good else 1


if __name__ == "__main__":
    sys.exit(main())
