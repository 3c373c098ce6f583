#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The makefiles of hls/tools, for every top of the list, without the tools: the Tcl of Vitis and Catapult runs in tclsh
against commands that record their calls, and a script in the place of bambu records its arguments. Each run names its
top, files that exist, the macros that compile them, and the vectors of its scene; loops that have directives exist.
Scripts that were broken on purpose show that this is noticed. Usage: scripts_test.py ROOT TCLSH FOLDER"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

STUB = pathlib.Path(__file__).with_name("tool_stub.tcl")
# Writes an empty file, or a set without words.
HALFSPACE = """#!/bin/sh
for word; do
  case "$before" in --header) : > "$word";; --out) mkdir -p "$word" && : > "$word/manifest.json";; esac
  before=$word
done
"""
# With the lines of its log that have figures: of a top, and of a function that is no part of its caller.
BAMBU = """#!/bin/sh
echo "$*"
top=${2#--top-fname=}
for name in shared $top; do cat <<END
    Estimated max frequency (MHz): 1${#name}1.7
  State Transition Graph Information of function $name:
    Number of states: ${#name}
  Module binding information for function $name:
    Number of modules instantiated: 774
    Estimated number of DSPs: 2
  Total number of flip-flops in function $name: 100
END
done
mkdir -p HLS_output/simulation
echo "top: 1 frames, 3 words compared, ${WRONG:-0} wrong" > HLS_output/simulation/testbench.log
echo "  Total cycles             : 1091 cycles"
echo "  Number of executions     : 4"
"""

OF_MAKE = ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES", "BUILD", "SCENE", "CONFIG", "LANES", "SIZE", "TIME",
           "SEED", "STALL", "UNIT", "JOBS")


class Tools:
    """A copy of the scripts and of what they read."""

    def __init__(self, root, tclsh, folder):
        shutil.rmtree(folder, ignore_errors=True)
        for name in ("hls", "tests/configs"):
            shutil.copytree(root / name, folder / name)
        (folder / "bin").mkdir()
        for name, text in (("halfspace", HALFSPACE), ("bambu", BAMBU)):
            (folder / "bin" / name).write_text(text)
            (folder / "bin" / name).chmod(0o755)
        self.folder, self.tclsh = folder, tclsh
        self.rows = [line.split() for line in (folder / "hls/top/tops.txt").read_text().splitlines() if line[:1] != "#"]
        self.labels = {label for path in (folder / "hls").rglob("*.?pp") for label in re.findall(
            r"^ *(\w+):\n *(?:HS_\w+ )?(?:for|while) \(", path.read_text(), re.M)}

    def make(self, tool, target, **variables):
        """What it printed, or why it failed."""
        words = [f"{name}={value}" for name, value in variables.items()]
        # Beneath `make test` are its own options and its CONFIG, LANES and more.
        environment = {name: value for name, value in os.environ.items() if name not in OF_MAKE}
        run = subprocess.run(
            ["make", "-s", "-C", self.folder / "hls/tools" / tool, target, f"HALFSPACE={self.folder}/bin/halfspace",
             f"VITIS_HLS={self.tclsh} {STUB} vitis", f"CATAPULT={self.tclsh} {STUB} catapult", *words],
            env={**environment, "PATH": f"{self.folder}/bin:{os.environ['PATH']}"}, capture_output=True, text=True)
        return run.stdout if run.returncode == 0 else f"failed: {run.stdout}{run.stderr}"

    def written(self, pattern):
        found = sorted((self.folder / "build/hls").glob(pattern))
        return found[0].read_text() if len(found) == 1 else f"failed: {len(found)} files are {pattern}"

    def missing(self, text):
        paths = set(re.findall(re.escape(str(self.folder)) + r"/[\w./-]+", text))
        return sorted(path for path in paths if not pathlib.Path(path).exists())


def needs(row, stream, driven=True):
    """Of a run: what it is, and an expression for it."""
    top, scene, config = row
    stem = pathlib.Path(config).stem
    yield "its macro for streams", rf"-DHALFSPACE_STREAM_{stream}\b"
    yield "its configuration", rf"-DHALFSPACE_TOP_CONFIG={''.join(map(str.capitalize, stem.split('_')))}\b"
    if config.endswith(".toml"):
        yield "its header", rf"-DHALFSPACE_TOP_HEADER={stem}\.hpp\b"
    yield "its source", rf"/hls/top/(film/|composed/)?{top}_top\.cpp\b"
    if driven:
        yield "its bench", rf"-DHALFSPACE_BENCH={top}\b"
        yield "its vectors", rf"/vectors/{stem}\.{scene}\.1\b"


def check(tools, where, text, wanted):
    if not text or text.startswith("failed"):
        yield f"{where}: {text or 'nothing is printed'}"
        return
    yield from (f"{where}: has not {what}" for what, expression in wanted if not re.search(expression, text, re.M))
    yield from (f"{where}: names {path}, which is not there" for path in tools.missing(text))


def of_vitis(tools, row, targets):
    for target in targets:
        steps = {"csim": "csim_design .*\n", "cosim": "csynth_design\ncall cosim_design .*\n",
                 "export": "csynth_design\ncall export_design .*\n"}[target]
        text = tools.make("vitis", target, TOP=row[0], PART="xczu7ev-ffvc1156-2-e")
        yield from check(tools, f"vitis, {target} of {row[0]}", text, [
            ("its top", f"^call set_top {row[0]}_top$"), ("its part", "^call set_part xczu7ev-ffvc1156-2-e$"),
            ("its steps", rf"^call create_clock .*\ncall {steps}\Z"),
            *needs(row, "HLS", target != "export")])
    text = tools.make("vitis", "cfg", TOP=row[0])
    if not text.startswith("failed"):
        text = tools.written(f"vitis/{row[0]}.*/*.cfg")
    yield from check(tools, f"vitis, cfg of {row[0]}", text, [
        ("its top", f"^syn.top={row[0]}_top$"), *needs(row, "HLS")])


def of_catapult(tools, row):
    where = f"catapult, extract of {row[0]}"
    text = tools.make("catapult", "extract", TOP=row[0])
    yield from check(tools, where, text, [
        ("its top", f"^call directive set -DESIGN_HIERARCHY {row[0]}_top$"), ("the end", "^call go extract$"),
        ("a loop", f"^call directive set /{row[0]}_top/core/.*/UNROLL yes$"), *needs(row, "AC", False)])
    named = re.findall(r"^call directive set /\w+/core/(\w+)/(?:UNROLL yes|PIPELINE_INIT_INTERVAL \d+)$", text, re.M)
    yield from (f"{where}: there is no loop {label}" for label in sorted(set(named) - tools.labels))


def of_bambu(tools, row):
    text = tools.make("bambu", "cosim", TOP=row[0])
    if not text.startswith("failed"):
        text = tools.written(f"bambu/{row[0]}.*/cosim/log")
    yield from check(tools, f"bambu, cosim of {row[0]}", text, [
        ("its top", rf"--top-fname={row[0]}_top\b"), *needs(row, "AC")])


def faults(tools, tops):
    for number, row in enumerate(row for row in tools.rows if row[0] in tops):
        yield from of_vitis(tools, row, ("csim", "cosim", "export") if number == 0 else ("cosim",))
        yield from of_catapult(tools, row)
        yield from of_bambu(tools, row)


# A fault each, and what has to be said of it.
BROKEN = [("vitis/run.tcl", "set_top $env(TOP)_top", "set_top $env(TOP)", "has not its top"),
          ("vitis/run.tcl", "csynth_design", "csynth_desing", "invalid command name"),
          ("vitis/Makefile", "STREAM_HLS", "STREAM_AC", "has not its macro for streams"),
          ("catapult/loops.py", "{label}={said}", "{label}x={said}", "there is no loop"),
          ("catapult/run.tcl", "go extract", "go", "has not the end"),
          ("bambu/Makefile", "--tb-arg=$(VECTORS)", "", "has not its vectors"),
          ("top.mk", "top/bench/main.cpp", "top/bench/gone.cpp", "gone.cpp")]


def unnoticed(tools, top):
    for name, right, wrong, says in BROKEN:
        path = tools.folder / "hls/tools" / name
        text = path.read_text()
        if right not in text:
            yield f"the test itself is broken: {name} has no {right}"
        path.write_text(text.replace(right, wrong))
        shutil.rmtree(tools.folder / "build/hls", ignore_errors=True)
        if not any(says in fault for fault in faults(tools, [top])):
            yield f"hls/tools/{name} has '{wrong}', and nothing says that it {says}"
        path.write_text(text)
    shutil.rmtree(tools.folder / "build/hls", ignore_errors=True)
    if "3 words compared, 1 wrong" not in tools.make("bambu", "cosim", TOP=top, WRONG=1):
        yield "bambu: a co-simulation with a wrong word is taken for a right one"


def main():
    root, tclsh, folder = sys.argv[1:]
    tools = Tools(pathlib.Path(root).resolve(), tclsh, pathlib.Path(folder).resolve())
    tops = [row[0] for row in tools.rows]
    found = list(faults(tools, tops))
    table = tools.make("bambu", "table")
    stem = pathlib.Path(tools.rows[0][2]).stem
    row = f"| {tops[0]} | {stem} | 1 | {len(tops[0]) + 4} | – | 200 | 4 | 162 | 4 | 1091 | 3 |"
    if table.count("\n") != len(tops) + 2 or row not in table:
        found.append(f"bambu: the table has not a line a top, or not {row}:\n{table}")
    found += unnoticed(tools, "light_vertex")
    print("\n".join(found) or f"scripts: {len(tops)} tops, three tools; {len(BROKEN) + 1} faults were noticed")
    return 1 if found or not tops else 0


if __name__ == "__main__":
    sys.exit(main())
