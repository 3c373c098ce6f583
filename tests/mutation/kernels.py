#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How many single faults in the kernels the fast tests find, by random ones from a seed, and which test finds which.

All mutants stand in one copy of hls/ and are chosen by a number at run time (kernel_mutants.py), so that each test is
compiled once. The programs are GoogleTests of a build folder, with what they need of model/, and vectors/bits.py, which
holds the words of every stream, on some configurations. Each mutant goes through the tests of its room until one fails.
A line tells of each how it was found, or that it survived; one that is equivalent stands with its reason in --reasons:
`FILE :: WHAT :: NEW TEXT :: REASON`.

With --faults named faults take the place of random ones, and each names the test that has to find it."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.dont_write_bytecode = True  # no __pycache__ between the sources
import kernel_mutants  # noqa: E402

ROOMS = "setup raster ztest shade texture motion objects".split()
# Beside those of the rooms.
OTHERS = ("formats/lanes.hpp", "formats/scan_pixels.hpp", "numbers/arithmetic.hpp")
# Which programs look at a room, the quickest first.
BASE = ["exhaustive_test", "frame_test", "bits:odd"]
PROGRAMS = {
    "setup": ["plane_test", "exhaustive_test", "cull_test", "bits:odd", "bits:lit_matte", "bits:phong_low",
              "bits:textured_low"],
    "raster": BASE,
    "ztest": ["ztest_plane_test", "frame_test", "index_pool_test", "gamma_test", "bits:odd", "bits:pool"],
    "shade": ["scan_index_test", "shaded_frame_test", "lighting_exact_test", "bits:phong_middle", "bits:lit_low",
              "bits:flat_only", "lighting_test", "phong_test"],
    "texture": ["scanned_frame_test", "texture_kernel_test", "bits:textured_low", "bits:textured_middle"],
    "motion": ["key_cache_test", "motion_vector_test", "film_frame_test", "film_units_test", "scanned_frame_test",
               "compensate_kernel_test", "motion_field_test", "bits:motion_cubic", "bits:film_tiny",
               "bits:film_textured"],
    "objects": ["whole_frame_test", "merge_test", "static_kernel_test", "bits:objects_low"],
    "formats": ["ztest_plane_test", "shaded_frame_test", "scanned_frame_test", "bits:odd", "bits:film_tiny"],
    "numbers": ["arithmetic_test", "plane_test", "lighting_exact_test", *BASE, "bits:textured_middle",
                "bits:motion_cubic"],
}
ENGINES = """#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "model/pipeline/engine.hpp"
namespace halfspace::model {
#define X(name, Type) \\
  std::unique_ptr<Engine> make_engine_##name(int lanes) { \\
    return make_runtime_engine(Type::config(), format_table(Type::config()), lanes); \\
  }
X(low, Low) X(middle, Middle) X(high, High)
}
"""
MEMORY = 6 << 30  # of a test: a loop that never ends may write words


def is_bits(program):
    """Whether it is test `bits`, of some configurations."""
    return program.startswith("bits:")


class Broken(Exception):
    """What the compiler says."""


class Tree:
    """The copy of hls/ with mutants, and what is compiled with it."""

    def __init__(self, args, chosen):
        self.args, self.chosen = args, dict(chosen)
        self.work = args.work.resolve()
        self.build = args.build.resolve()
        self.commands = {}
        for entry in json.loads((self.build / "compile_commands.json").read_text()):
            path = pathlib.Path(entry["file"])
            # Some files are compiled for other targets as well.
            if path not in self.commands or "halfspace_model.dir" in entry["command"]:
                self.commands[path] = entry
        self.lines, self.uncompiled = {}, {}
        self.closures = {}

    def write(self):
        """The files with mutants; what they are included by finds them there first."""
        shutil.rmtree(self.work / "hls", ignore_errors=True)
        self.files = sorted({path for path, _ in self.chosen.values()})
        for path in self.files:
            mine = {number: mutant for number, (where, mutant) in self.chosen.items() if where == path}
            text, self.lines[path] = kernel_mutants.applied(path.read_text(), mine)
            to = self.work / path.relative_to(ROOT)
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_text(text)
        (self.work / kernel_mutants.HEADER).write_text(kernel_mutants.SOURCE)

    def closure(self, path):
        """The files that a source includes, itself too."""
        if path not in self.closures:
            self.closures[path] = {path}
            for name in re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE):
                if (ROOT / name).exists():
                    self.closures[path] |= self.closure(ROOT / name)
        return self.closures[path]

    def compile(self, source, entry, to):
        words = shlex.split(entry["command"])
        if words[0].endswith("ccache"):
            words = words[1:]
        kept, skip = [], False
        for word in words[1:]:
            if skip:
                skip = False
            elif word in ("-o", "-include", "-c"):
                skip = True
            elif not re.fullmatch(r"-O\d|-Winvalid-pch|-f(no-)?sanitize\S*", word):
                kept.append(word)
        command = [words[0], f"-I{self.work}", "-include", kernel_mutants.HEADER, *kept, self.args.optimize, "-w",
                   "-fmax-errors=0", "-c", str(source), "-o", str(to)]
        said = subprocess.run(command, cwd=entry["directory"], capture_output=True, text=True)
        if not said.returncode:
            return set()
        wrong = self.guilty(said.stderr)
        if not wrong:
            raise Broken(f"{source}: {said.stderr[:3000]}")
        return wrong

    def guilty(self, said):
        """The mutants that errors are of: of the place, or of that which it was needed from."""
        wrong, block = set(), []
        for line in said.splitlines() + ["error: end"]:
            if "error:" in line:
                block.append(line)
                numbers = []
                for place in reversed(block):
                    for path, at in re.findall(r"(\S+?\.hpp):(\d+)", place):
                        path = pathlib.Path(path)
                        if path.is_relative_to(self.work):
                            number = self.lines.get(ROOT / path.relative_to(self.work), {}).get(int(at))
                            if number:
                                numbers.append(number)
                wrong |= set(numbers[:1])
                block = []
            else:
                block.append(line)
        return wrong

    def compile_all(self, programs):
        """Objects of what depends on a mutant, again without those that do not compile."""
        objects = self.work / "objects"
        shutil.rmtree(objects, ignore_errors=True)
        objects.mkdir(parents=True)
        tests = {program: next(path for path in self.commands if path.stem == program)
                 for program in programs if not is_bits(program)}
        jobs = [(path, self.commands[path], objects / f"{path.stem}.o") for path in tests.values()]
        # Tests that go by kernels alone need nothing of model/.
        with_model = len(tests) < len(programs) or any(
            path.is_relative_to(ROOT / "model") for test in tests.values() for path in self.closure(test))
        if with_model:
            # The kernels of named configurations are those that are chosen at run time, so that they are compiled once.
            engines, named = self.work / "engines.cpp", re.compile("engine_(low|middle|high)")
            engines.write_text(ENGINES)
            model = [path for path in self.commands if path.is_relative_to(ROOT / "model")]
            jobs += [(path, self.commands[path], objects / f"{path.stem}.o") for path in model
                     if not named.fullmatch(path.stem)]
            jobs.append((engines, self.commands[ROOT / "model/pipeline/engine_low.cpp"], objects / "engines.o"))
        always = {job[0] for job in jobs} - {path for path in self.commands if path.is_relative_to(ROOT / "model")}
        while True:
            self.write()
            due = [job for job in jobs if job[0] in always or self.closure(job[0]) & set(self.files)]
            wrong = set()
            with concurrent.futures.ThreadPoolExecutor(self.args.jobs) as pool:
                for some in pool.map(lambda job: self.compile(*job), due):
                    wrong |= some
            if not wrong:
                break
            print(f"{len(wrong)} mutants do not compile", flush=True)
            for number in wrong:
                self.uncompiled[number] = self.chosen.pop(number)
        self.model = [str(to) for path, _, to in due if path not in tests.values()]
        for program in tests:
            self.link(program, objects / f"{program}.o")
        if any(map(is_bits, programs)):
            self.link("halfspace", None)

    def link(self, target, own):
        """As the build folder does, with objects in the place of others."""
        said = subprocess.run(["ninja", "-C", self.build, "-t", "commands", target], capture_output=True, text=True,
                              check=True).stdout
        words = shlex.split(said.strip().splitlines()[-1].removeprefix(": && ").removesuffix(" && :"))
        at = words.index("-o")
        words[at + 1] = str(self.work / target)
        words = [str(own) if own and word.endswith(f"/{target}.cpp.o") else word for word in words]
        words[at + 2:at + 2] = self.model
        linked = subprocess.run(words, cwd=self.build, capture_output=True, text=True)
        if linked.returncode:
            raise Broken(f"{target}: {linked.stderr[:3000]}")


def run(args, program, number):
    """'' or what a test says of a mutant."""
    command = [args.work.resolve() / program, "--gtest_brief=1", "--gtest_fail_fast"]
    if is_bits(program):
        command = [sys.executable, ROOT / "vectors/bits.py", args.work.resolve() / "halfspace", "--held",
                   ROOT / "vectors/standard/bits.sha256", "--only", program.removeprefix("bits:")]

    def limits():
        os.setsid()
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (args.seconds, args.seconds))

    process = subprocess.Popen(command, cwd=args.work, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               env=dict(os.environ, HALFSPACE_MUTANT=str(number)), preexec_fn=limits, errors="replace")
    try:
        said = process.communicate(timeout=30 * args.seconds)[0]  # of a machine that others use
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return "no end"
    if process.returncode == 0:
        return ""
    if process.returncode == -signal.SIGKILL:
        return f"no end in {args.seconds} s"
    failed = re.search(r"\[  FAILED  \] (\S+)", said)
    return failed[1].rstrip(",") if failed else (said.strip().splitlines() or [f"status {process.returncode}"])[-1][:80]


def judge(args, path, number, programs):
    """(test, what it says) of what finds a mutant, or ('', '')."""
    for program in PROGRAMS[path.parent.name]:
        if program in programs and (found := run(args, program, number)):
            return program, found
    return "", ""


def read_faults(path):
    """{number: (path, (site, name, text), test)}"""
    blocks = []
    for line in path.read_text().splitlines():
        key, _, value = line.partition(" ")
        if key == "fault":
            blocks.append({})
        if key and key != "#":
            blocks[-1][key] = value.strip()
    faults = {}
    for number, block in enumerate(blocks, 1):
        where = ROOT / "hls" / block["file"]
        code = kernel_mutants.blank(where.read_text())
        found = [(site, " ".join(code[site[1]:site[2]].split())) for site in kernel_mutants.sites(code)]
        found = [(site, said) for site, said in found if block["find"] in said]
        if len(found) != 1:
            raise Broken(f"{block['fault']}: its text stands {len(found)} times in {where.name}, not once")
        site, said = found[0]
        faults[number] = (where, (site, block["fault"], said.replace(block["find"], block["with"])), block["test"])
    return faults


def try_faults(args):
    """Whether each named fault is found by its test."""
    faults = read_faults(args.faults)
    programs = list(dict.fromkeys(test for _, _, test in faults.values()))
    tree = Tree(args, {number: (path, mutant) for number, (path, mutant, _) in faults.items()})
    tree.compile_all(programs)
    for program in programs:
        if said := run(args, program, 0):
            raise Broken(f"without a fault: {program}: {said}")
    passed = 0
    for number, (path, (_, name, _), test) in faults.items():
        found = number in tree.chosen and run(args, test, number)
        passed += bool(found)
        print(f"{'pass' if found else 'FAIL'}  {name:24} {path.name:20} {test}: {found or 'finds nothing'}", flush=True)
    print(f"faults: {passed} passed, {len(faults) - passed} failed")
    return 0 if faults and passed == len(faults) else 1


def reasons_of(path):
    rows = [line.split(" :: ") for line in path.read_text().splitlines() if line and not line.startswith("#")]
    return {tuple(row[:3]): row[3] for row in rows}


def all_mutants(files):
    return [(path, mutant) for path in files
            for mutant in kernel_mutants.mutants(path.read_text(), path.stem == "arithmetic")]


def labels_of(every):
    """Of each mutant (file, what, new text), with a number where the same stands several times in a file."""
    seen, labels = {}, []
    for path, (_, what, new) in every:
        seen[path, what, new] = times = seen.get((path, what, new), 0) + 1
        labels.append((path.name, what, new if times == 1 else f"{new} #{times}"))
    return labels


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build", help="a build folder (default: build)")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for the copy and its programs")
    parser.add_argument("--files", nargs="+", default=[], help="of hls/, as setup/plane.hpp (default: all kernels)")
    parser.add_argument("--programs", nargs="+", help="tests alone (default: all that are known, and `bits`)")
    parser.add_argument("--count", type=int, default=200, help="mutants (default: %(default)s); 0: all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--least", type=float, default=0, help="percent of those that are not equivalent, to be found")
    parser.add_argument("--reasons", type=pathlib.Path, default=HERE / "equivalent.list")
    parser.add_argument("--seconds", type=int, default=60,
                        help="of a run, of the processor (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--optimize", default="-O1")
    parser.add_argument("--faults", type=pathlib.Path, help="faults of this file in the place of random ones")
    args = parser.parse_args()
    args.work.mkdir(parents=True, exist_ok=True)
    if args.faults:
        try:
            return try_faults(args)
        except Broken as e:
            print(f"kernels: {e}", file=sys.stderr)
            return 2
    names = args.files or [str(path.relative_to(ROOT / "hls")) for room in ROOMS
                           for path in sorted((ROOT / "hls" / room).glob("*.hpp"))] + list(OTHERS)
    every = all_mutants([ROOT / "hls" / name for name in names])
    count = min(args.count or len(every), len(every))
    some = sorted(random.Random(args.seed).sample(range(len(every)), count))
    chosen = {number: every[at] for number, at in enumerate(some, 1)}
    labels = labels_of(every)
    label = {number: labels[at] for number, at in enumerate(some, 1)}
    rooms = {path.parent.name for path, _ in chosen.values()}
    known = dict.fromkeys(program for room, some in PROGRAMS.items() if room in rooms for program in some)
    programs = args.programs or list(known)
    tree = Tree(args, chosen)
    try:
        tree.compile_all(programs)
    except Broken as e:
        print(f"kernels: {e}", file=sys.stderr)
        return 2
    for program in programs:
        if said := run(args, program, 0):
            print(f"kernels: without a fault: {program}: {said}", file=sys.stderr)
            return 2
    reasons = reasons_of(args.reasons) if args.reasons.exists() else {}
    found = equivalent = 0
    by = dict.fromkeys(programs, 0)
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        numbers = sorted(tree.chosen)
        results = pool.map(lambda number: judge(args, tree.chosen[number][0], number, programs), numbers)
        for number, (program, how) in zip(numbers, results):
            path, (site, _, _) = tree.chosen[number]
            reason, (_, what, new) = reasons.get(label[number], ""), label[number]
            found += bool(program)
            equivalent += not program and bool(reason)
            if program:
                by[program] += 1
            state = "found   " if program else "the same" if reason else "SURVIVES"
            at = kernel_mutants.line_of(path.read_text(), site[1])
            print(f"{state} {number:4} {path.name}:{at} :: {what} :: {new} :: {program} {how or reason}", flush=True)
    different = len(tree.chosen) - equivalent
    share = 100 * found / different if different else 0
    print(", ".join(f"{program} {number}" for program, number in by.items() if number))
    print(f"mutation of kernels: seed {args.seed}, {len(tree.chosen)} of {len(every)} mutants, {len(tree.uncompiled)} "
          f"more do not compile, {found} found, {equivalent} equivalent, {different - found} survive: "
          f"{share:.1f} % found")
    return 0 if found and share >= args.least else 1


if __name__ == "__main__":
    sys.exit(main())
