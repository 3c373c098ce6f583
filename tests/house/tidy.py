#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy, with the checks of .clang-tidy, over the C++ of the project; fails on any warning.

Usage: tidy.py ROOT BUILD [--jobs N] [FILE …]   FILE: from the root; all that BUILD compiles, if none is named
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

# Includes what Verilator makes of the RTL.
NEEDS_MODEL = {"tb/harness/binding.cpp"}
WARNING = re.compile(r"^(\S+?:\d+:\d+: (?:warning|error): .*)$", re.M)


def for_clang(command):
    """The words of a compiler's call that clang knows: without the cache, GCC's own options and its precompiled
    header."""
    words = [word for word in shlex.split(command) if pathlib.Path(word).name != "ccache"]
    words = [word for word in words if not word.startswith(("-mprefer-vector-width", "-Winvalid-pch"))]
    kept = []
    while words:
        word = words.pop(0)
        if word == "-include" and words[0].endswith("cmake_pch.hxx"):
            words.pop(0)
        else:
            kept.append(word)
    return kept


def commands(root, build):
    """{file: entry} of what is compiled below the root and is not printed into the build folder; one entry a file, also
    where CMake compiles several as one."""
    entries = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"]).resolve()
        paths = [path]
        if path.name.startswith("unity_") and path.exists():
            paths = [pathlib.Path(name).resolve() for name in re.findall(r'^#include "(.+)"', path.read_text(), re.M)]
        for own in paths:
            is_own = root in own.parents and build not in own.parents
            if is_own and str(own.relative_to(root)) not in NEEDS_MODEL:
                words = for_clang(entry["command"].replace(entry["file"], str(own)))
                entries.setdefault(own, {"directory": entry["directory"], "file": str(own), "arguments": words})
    return entries


def tidy(database, path, checks):
    run = subprocess.run(["clang-tidy", "--quiet", "-p", database, f"--config-file={checks}", str(path)],
                         capture_output=True, text=True)
    said = run.stdout.replace(f"{path.parents[0]}/../", "")
    return sorted(set(WARNING.findall(said))) or ([run.stderr or said] if run.returncode else [])


def prove_that_it_fails(checks):
    """What no check would say passes everything."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "ref" / "a.cpp"
        path.parent.mkdir()
        path.write_text("double half(int a) { return a / 2; }\n")
        entry = {"directory": folder, "file": str(path), "arguments": ["c++", "-c", str(path)]}
        (pathlib.Path(folder) / "compile_commands.json").write_text(json.dumps([entry]))
        if not any("bugprone-integer-division" in said for said in tidy(folder, path, checks)):
            sys.exit("the test itself is broken: clang-tidy finds no integer division")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("files", nargs="*")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    args = parser.parse_intermixed_args()
    root, build = args.root.resolve(), args.build.resolve()
    if not shutil.which("clang-tidy"):
        sys.exit("clang-tidy is not installed: apt-get install clang-tidy")
    prove_that_it_fails(root / ".clang-tidy")
    entries = commands(root, build)
    wanted = [root / name for name in args.files] or sorted(entries)
    if missing := [str(path) for path in wanted if path not in entries]:
        sys.exit(f"not compiled by {build}: {', '.join(missing)}")
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "compile_commands.json").write_text(json.dumps(list(entries.values())))
        warnings = set()
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            for found in pool.map(lambda path: tidy(folder, path, root / ".clang-tidy"), wanted):
                for warning in sorted(set(found) - warnings):
                    print(warning, flush=True)
                warnings.update(found)
    print(f"tidy: {len(wanted)} files, {len(warnings) or 'no'} warning{'s' * (len(warnings) > 1)}")
    return 1 if warnings or not wanted else 0


if __name__ == "__main__":
    sys.exit(main())
