#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What pages give to paste can be pasted as it is: each line of "What you can do with it" in the README, and the calls
of halfspace in the other pages below. It ends well, writes what it names, and leaves the sources alone. Those that
build a bench go with --long. examples_test has the examples of `--help`.
Usage: paste_test.py HALFSPACE ROOT [--long]"""
import pathlib
import re
import sys

from pasting import copy_of, paste, strewn

README_LINES = 5
PAGES = ["docs/using.md", "docs/vectors.md", "examples/own_unit/README.md"]
# Installs packages and builds all: what runs this test has done so.
LEFT_OUT = re.compile(r"^make ")
LONG = re.compile(r"halfspace fit ")


def blocks(text):
    """The lines of the blocks for a shell."""
    found = re.findall(r"^```sh\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    return [line for block in found for line in block.splitlines() if line and line[0] != "#"]


def readme_lines(text):
    section = re.search(r"^## What you can do with it\n(.*?)^## ", text, re.DOTALL | re.MULTILINE)
    return blocks(section.group(1)) if section else []


def written(line):
    """The files and folders that a line says it writes."""
    return re.findall(r"\s(?:-o|--out|--dump|--json)\s+(\S+)", line.split(" # ")[0])


def faults_of(page, lines, folder, long):
    variables, before = "", strewn(folder)
    for line in lines:
        if re.match(r"[A-Z]+=", line):
            variables += line + "\n"
        elif not LEFT_OUT.search(line) and bool(LONG.search(line)) == long:
            done = paste(variables + line, folder)
            # A comparison that finds something says so in its status, and its line tells.
            if done.returncode and "status 1" not in line:
                yield f"{page}: {line}\n  ends with {done.returncode}: {done.stderr.strip()}"
            missing = [name for name in written(line) if not (folder / name).exists()]
            yield from (f"{page}: {line}\n  did not write {name}" for name in missing)
            after = strewn(folder)
            yield from (f"{page}: {line}\n  leaves '{name}' in the sources" for name in after if name not in before)
            before = after


def main():
    halfspace, root = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    lines = {"README.md": readme_lines((root / "README.md").read_text())}
    found = len(lines["README.md"])
    faults = [] if found == README_LINES else [f"README.md: {found} lines to paste, {README_LINES} were expected"]
    lines.update((page, blocks((root / page).read_text())) for page in PAGES)
    with copy_of(root, halfspace) as folder:
        for page, of_page in lines.items():
            if not of_page:
                faults.append(f"{page}: no line to paste was found")
            faults += faults_of(page, of_page, folder, "--long" in sys.argv)
    print("\n".join(faults) or f"{sum(map(len, lines.values()))} lines pasted, the sources are as they were")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
