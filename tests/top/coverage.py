#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which lines of the kernels the vector sets reach, by gcov: of the programs that `halfspace_tops` builds, a kernel a
top, compiled again with --coverage and run on the set that their test takes. Prints a table by room; with --missed the
lines that are not reached. What was compiled is kept in --work.
Usage: coverage.py [--build DIR] [--work DIR] [--missed]"""
import argparse
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# Program, configuration, lanes, sets.
PROGRAMS = [("low", 1, ("standard",)), ("gamma", 4, ("standard",)), ("lit_low", 4, ("standard",)),
            ("phong_low", 4, ("standard",)), ("textured_middle", 4, ("standard",)),
            ("motion_middle", 4, ("standard", "compensation")), ("objects_low", 4, ("standard", "merge")),
            ("pool", 4, ("standard",)), ("film_tiny", 1, ("film",))]


def run(command, cwd=ROOT, **more):
    result = subprocess.run([str(word) for word in command], cwd=cwd, capture_output=True, text=True, check=False,
                            **more)
    if result.returncode:
        raise SystemExit(f"{' '.join(map(str, command[:3]))} … failed: {(result.stdout + result.stderr)[-1500:]}")
    return result.stdout


def compile_program(args, target, work):
    """The program with counters, and its tops."""
    lines = run(["ninja", "-C", args.build, "-t", "commands", target]).splitlines()
    objects, tops = [], []
    for line in lines:
        source = re.search(r" -c (\S+\.cpp)", line)
        if not source and "--header" in line:
            run(["sh", "-c", line], cwd=args.build)
        if not source or not re.search(r"/(hls|tests/top)/", source[1]):
            continue  # of the program that prints the header
        words = [word for word in shlex.split(line) if word != "ccache" and not re.match(r"-O\d$|-M[DTF]?$", word)]
        out = work / (pathlib.Path(source[1]).stem + ".o")
        while "-o" in words:
            at = words.index("-o")
            del words[at:at + 2]
        words = [word for word in words if not word.endswith((".o", ".o.d"))]
        run([*words, "-O0", "--coverage", "-o", out], cwd=args.build)
        objects.append(out)
        if found := re.search(r"/(\w+)_top\.cpp$", source[1]):
            tops.append(found[1])
    run(["c++", "--coverage", *objects, "-o", work / "tops"])
    return tops


def measure(args, config, lanes, scenes):
    work = args.work / f"{config}_{lanes}"
    done = work / "done"
    if done.exists():
        return work
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    path = next(ROOT.glob(f"tests/configs/*/{config}.toml"), config)
    tops = compile_program(args, f"tops_{config}_{lanes}", work)
    for scene in scenes:
        folder = work / scene
        run([args.build / "cli/halfspace", "vectors", scene, "--config", path, "--lanes", lanes, "--out", folder])
        for top in tops:
            # A set without the streams of a top is another top's.
            subprocess.run([str(work / "tops"), top, str(folder)], capture_output=True, check=False)
        shutil.rmtree(folder)
    done.touch()
    return work


def counted(work):
    """{file: {line: times}} of hls/."""
    lines = {}
    for data in sorted(work.glob("*.gcda")):
        for text in run(["gcov", "--json-format", "--stdout", data], cwd=work).splitlines():
            for file in json.loads(text)["files"]:
                path = pathlib.Path(file["file"])
                name = str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else ""
                if not name.startswith("hls/") or name.startswith("hls/top/"):
                    continue
                of_file = lines.setdefault(name, {})
                for line in file["lines"]:
                    of_file[line["line_number"]] = of_file.get(line["line_number"], 0) + line["count"]
    return lines


def share(counts):
    total, reached = len(counts), sum(times > 0 for times in counts)
    return f"{reached:,} of {total:,} | {100 * reached / max(total, 1):.1f} %"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/coverage/kernels")
    parser.add_argument("--only", help="regular expression of the configurations")
    parser.add_argument("--missed", action="store_true", help="tell the lines that are not reached")
    args = parser.parse_args()
    args.build, args.work = args.build.resolve(), args.work.resolve()
    lines = {}
    for config, lanes, scenes in PROGRAMS:
        if not re.search(args.only or "", config):
            continue
        print(f"{config}, {lanes} lanes", file=sys.stderr, flush=True)
        for file, counts in counted(measure(args, config, lanes, scenes)).items():
            of_file = lines.setdefault(file, {})
            for line, times in counts.items():
                of_file[line] = of_file.get(line, 0) + times
    if not lines:
        raise SystemExit("gcov tells no line of hls/")
    print("| kernels | lines | |\n|---|---|---|")
    for room in sorted({file.split("/")[1] for file in lines}):
        of_room = [times for file, counts in lines.items() if file.split("/")[1] == room for times in counts.values()]
        print(f"| `hls/{room}` | {share(of_room)} |")
    print(f"| all | {share([times for counts in lines.values() for times in counts.values()])} |")
    if args.missed:
        for file, counts in sorted(lines.items()):
            for line, times in sorted(counts.items()):
                if times == 0:
                    print(f"{file}:{line}: {(ROOT / file).read_text().splitlines()[line - 1].strip()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
