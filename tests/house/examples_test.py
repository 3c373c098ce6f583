#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every example that `halfspace COMMAND --help` gives works as it stands, in a folder of one's own, is of that command,
and writes what it names. Those that take minutes go with --long. It shows first that it finds wrong ones.
Usage: examples_test.py HALFSPACE [--long]"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# Yosys, or a bench that is built.
LONG = re.compile(r"halfspace (fit (?!.*--no-cosim)|.*--area xilinx)")
LEAST = 20  # examples in all
# They take what other commands write, and stand in `halfspace --help` behind these; shrink takes a bench that fails.
NONE = {"compare", "inspect", "shrink"}


def run(line, folder, halfspace):
    """As a shell would, with halfspace in the path."""
    path = f"{halfspace.parent}:{os.environ['PATH']}"
    return subprocess.run(["bash", "-c", line], cwd=folder, capture_output=True, text=True, timeout=3600, check=False,
                          env={**os.environ, "PATH": path})


def examples(text):
    """(call, what it is for) of each line."""
    return re.findall(r"^  (halfspace \S.*?)(?:  +(\S.*))?$", text, re.MULTILINE)


def written(call):
    return re.findall(r"\s(?:-o|--out|--dump|--json|--toml|--gappa|--plot)\s+([^\s-]\S*)", call)


def faults_of(command, text, halfspace, long):
    """Of the examples of a help text, in one folder, one after the other."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for call, what in examples(text):
            if command and call.split()[1] != command:
                yield f"{command} --help: '{call}' is of another command"
            if bool(LONG.search(call)) != long:
                continue
            done = run(call, folder, halfspace)
            if done.returncode and "status 1" not in what:
                yield f"{command} --help: '{call}' ends with {done.returncode}: {done.stderr.strip()}"
            for name in written(call):
                if not list(folder.glob(re.sub(r"%\d*d", "*", name))):
                    yield f"{command} --help: '{call}' did not write {name}"


def main():
    halfspace, long = pathlib.Path(sys.argv[1]).resolve(), "--long" in sys.argv
    wrong = "  halfspace render nonesuch   x\n  halfspace config low --toml other/x.toml\n  halfspace streams\n"
    if len(list(faults_of("config", wrong, halfspace, False))) != 5:
        print("wrong examples are not found")
        return 1
    top = run("halfspace --help", ".", halfspace).stdout
    commands = re.findall(r"^  (\w+) +\S", top.split("Subcommands:")[-1].split("examples")[0], re.MULTILINE)
    faults, count = [], 0
    for command in ["", *commands]:
        text = run(f"halfspace {command} --help", ".", halfspace).stdout
        found = len(examples(text))
        if not found and command not in NONE:
            faults.append(f"{command} --help has no example")
        count += found
        faults += faults_of(command, text, halfspace, long)
    if count < LEAST:
        faults.append(f"only {count} examples were found in the help of {commands}")
    print("\n".join(faults) or f"{count} examples are sound{', the long ones run' if long else ''}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
