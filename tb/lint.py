#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Verilator's lint with all warnings over every unit of the RTL, in every configuration or with the packages given.

A unit is a module that docs/architecture.md lists; the modules below it are seen through it, and a file that no unit
reaches is a fault. tb/lint.vlt holds the waivers. Ends with a count: silence would prove nothing.
"""

import argparse
import pathlib
import re
import subprocess
import sys

TOPS = ["hs_triangle_setup", "hs_shade_setup", "hs_raster_pineda", "hs_ztest_index", "hs_ztest_plane", "hs_scan_index",
        "hs_shade_gouraud", "hs_pipeline"]
# What configurations with lighting have: a bench with the units that others have not, and the pipeline.
LIT_TOPS = ["hs_light_units", "hs_pipeline"]
PHONG_TOPS = ["hs_phong_units", "hs_pipeline"]
TEXTURE_TOPS = ["hs_texture_units"]  # besides
MOTION_TOPS = ["hs_motion_units", "hs_compensate_units", "hs_pipeline"]
OBJECT_TOPS = ["hs_merge_units", "hs_pipeline"]
BESIDE_PIPELINE = ["hs_motion_compensate", "hs_ztest_merge"]
LIT_PACKAGE = re.compile(r"\bLights = [1-9]")
PHONG_PACKAGE = re.compile(r"\bPhong = 1;")
TEXTURE_PACKAGE = re.compile(r"\bHasTexture = 1;")
MOTION_PACKAGE = re.compile(r"\bHasMotion = 1;")
OBJECT_PACKAGE = re.compile(r"\bHasObjects = 1;")
CONFIGS = ["low", "middle", "high"]
STAMPS = [(1, 1), (2, 2), (4, 4)]


def sources(root):
    """{stem: path} of the modules."""
    return {path.stem: path for path in root.glob("*/hs_*.sv")}


def lint(args, root, package, top, lanes):
    """What Verilator says, or '' if nothing."""
    bench = pathlib.Path(__file__).parent
    source = sources(root).get(top, bench / f"{top}.sv")
    text = source.read_text()
    command = [args.verilator, "--lint-only", "-Wall", "--top-module", top,
               str(pathlib.Path(__file__).with_name("lint.vlt")), str(package), str(source)]
    command += [part for room in sorted({path.parent for path in sources(root).values()}) for part in ("-y", str(room))]
    if source.parent == bench:
        command += ["-y", str(bench)]
    if re.search(r"\bparameter\b[^,;)]*\bLanesX\b", text):
        command += [f"-GLanesX={lanes[0]}", f"-GLanesY={lanes[1]}"]
    result = subprocess.run(command, capture_output=True, text=True)
    output = result.stdout + result.stderr
    return output if result.returncode or output.strip() else ""


def reached(root, top):
    """The stems of the files below `top`, itself included."""
    found, todo, paths = set(), [top], sources(root)
    while todo:
        stem = todo.pop()
        if stem in found or stem not in paths:
            continue
        found.add(stem)
        todo += re.findall(r"^\s*(hs_\w+)\s+(?:#\s*\(|u_\w+)", paths[stem].read_text(), re.MULTILINE)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--verilator", default="verilator", help="the program (default: %(default)s)")
    parser.add_argument("--package", type=pathlib.Path, action="append", help="of a configuration (default: low, middle, high)")
    parser.add_argument("--rtl", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent / "rtl")
    args = parser.parse_args()
    root = args.rtl
    packages = args.package or [root / "formats" / config / "hs_formats_pkg.sv" for config in CONFIGS]
    faults, todo = 0, []
    for top in TOPS:
        if top not in sources(root):
            print(f"lint: {root}: {top}.sv is missing")
            faults += 1
            continue
    for package in packages:
        text = package.read_text()
        tops = PHONG_TOPS if PHONG_PACKAGE.search(text) else LIT_TOPS if LIT_PACKAGE.search(text) else TOPS
        if MOTION_PACKAGE.search(text):
            tops = MOTION_TOPS
        if OBJECT_PACKAGE.search(text):
            tops = OBJECT_TOPS
        tops = tops + (TEXTURE_TOPS if TEXTURE_PACKAGE.search(text) else [])
        todo += [(top, package, lanes) for top in tops for lanes in STAMPS]
    for top, package, lanes in todo:
        if output := lint(args, root, package, top, lanes):
            print(f"lint: {top}, {package}, {lanes[0]}x{lanes[1]}:\n{output}")
            faults += 1
    seen = set().union(*(reached(root, top) for top in TOPS + BESIDE_PIPELINE))
    for path in sorted(sources(root).values()):
        if path.stem not in seen:
            print(f"lint: no unit uses {path}: remove it, or add its unit to TOPS in tb/lint.py")
            faults += 1
    print(f"lint: {len(todo)} runs, {len(seen)} files, {faults} faults")
    return 1 if faults or not todo else 0


if __name__ == "__main__":
    sys.exit(main())
