#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on folders with too many files and on files with too many lines. Usage: size_test.py ROOT"""
import pathlib
import statistics
import sys
import tempfile

from sources import is_package, sources

FILES = 25   # of a folder
LINES = 400  # of a file
MEDIAN = 120
SHORTER = {"rtl/pipeline/hs_pipeline.sv": 330}  # what a board connects, and no more
# Longer than others, each with its reason. Packages, which are printed, do not count either.
LONGER = {}


def faults(root, longer=LONGER):
    lines, folders = {}, {}
    for path in sources(root):
        if is_package(path):
            continue
        name = str(path.relative_to(root))
        lines[name] = path.read_text(encoding="utf-8").count("\n")
        folders[path.parent] = folders.get(path.parent, 0) + 1
        limit = SHORTER.get(name, LINES)
        if lines[name] > limit and name not in longer:
            yield f"{name}: {lines[name]} lines, more than {limit}"
    for name in longer:
        if lines.get(name, 0) <= LINES:
            yield f"{name}: is named as longer than others, and is not"
    for folder, count in folders.items():
        if count > FILES:
            yield f"{folder.relative_to(root)}/: {count} files, more than {FILES}"
    if (median := statistics.median(lines.values())) > MEDIAN:
        yield f"half of the files have {median:g} lines or more, which should be {MEDIAN} at most"


def prove_that_it_fails():
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for folder in ("rtl/pipeline", "many", "a"):
            (root / folder).mkdir(parents=True)
        (root / "rtl/pipeline/hs_pipeline.sv").write_text("\n" * 331)
        (root / "a/long.py").write_text("\n" * 401)
        (root / "a/table.py").write_text("\n" * 401)
        (root / "a/hs_formats_pkg.sv").write_text("\n" * 401)
        for n in range(26):
            (root / f"many/{n}.py").write_text("\n" * 121)
        found = {fault.split(":")[0] for fault in faults(root, {"a/table.py": "", "a/short.py": ""})}
    expected = {"rtl/pipeline/hs_pipeline.sv", "a/long.py", "a/short.py", "many/",
                "half of the files have 121 lines or more, which should be 120 at most"}
    if found != expected:
        sys.exit(f"the test itself is broken: {sorted(found ^ expected)}")


def main():
    prove_that_it_fails()
    found = list(faults(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "sizes: folders and files are as small as they should be")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
