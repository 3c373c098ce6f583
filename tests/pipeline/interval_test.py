#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds SetupInterval of a package to the cycles that hs_triangle_setup takes for triangles of either winding, and of
one that the configuration culls the 7 cycles that such a triangle takes.
Usage: interval_test.py HALFSPACE BENCH PACKAGE CONFIG LANES FOLDER"""
import json
import math
import pathlib
import random
import re
import subprocess
import sys

TRIANGLES = 100
CULLED = 7
LATENCY = 60  # of the first and the last one


def triangles(clockwise):
    """Small ones, each over some pixels of a frame of 100x100: D > 0 if clockwise, as rows go downward."""
    draw = random.Random(1)
    lines = ["size 100 100"]
    for _ in range(TRIANGLES):
        x, y, turn = draw.uniform(5, 95), draw.uniform(5, 95), draw.uniform(0, math.tau)
        corners = [(x + 3 * math.cos(turn + k * math.tau / 3), y + 3 * math.sin(turn + k * math.tau / 3))
                   for k in range(3)]
        lines.append("t" + "".join(f" {a} {b} 0.5 9 9 9" for a, b in (corners if clockwise else corners[::-1])))
    return "\n".join(lines) + "\n"


def cycles(halfspace, bench, config, lanes, folder, clockwise, culled):
    scene, report = folder / "triangles.tri", folder / "report.json"
    scene.write_text(triangles(clockwise))
    subprocess.run([halfspace, "vectors", scene, "--config", config, "--lanes", lanes, "--no-corners", "--out", folder],
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run([bench, folder, "--stall", "0", "--json", report], check=True,
                   stdout=subprocess.DEVNULL)
    (run,) = json.loads(report.read_text())["runs"]
    # Of a frame of empty triangles the last one alone has attributes.
    assert run["words"] == TRIANGLES + (1 if culled else TRIANGLES) and run["mismatches"] == 0, run
    return run["cycles"]


def main():
    halfspace, bench, package, config, lanes, folder = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    number = {name: int(value) for name, value in re.findall(r" (\w+) = (\d+);", pathlib.Path(package).read_text())}
    for clockwise in (True, False):
        culled = bool(number["CullsBack" if clockwise else "CullsFront"])
        taken = cycles(halfspace, bench, config, lanes, folder, clockwise, culled)
        low = TRIANGLES * (CULLED if culled else number["SetupInterval"])
        high = low + (0 if clockwise or culled else TRIANGLES) + LATENCY
        print(f"{'D > 0' if clockwise else 'D < 0'}: {taken} cycles for {TRIANGLES} triangles, "
              f"SetupInterval {number['SetupInterval']}{', culled' if culled else ''}")
        if not low <= taken <= high:
            print(f"not {low} to {high}")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
