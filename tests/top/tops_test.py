#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tops of a configuration, compiled natively as a synthesis tool compiles them, on a vector set: equal words. One bit
of what is expected of a top is turned as well, to see that this is noticed.
Usage: tops_test.py HALFSPACE BENCH FOLDER SCENE CONFIG LANES TOP …"""
import pathlib
import re
import shutil
import subprocess
import sys

CLOSING = re.compile(r"(\w+): \d+ frames, (\d+) words compared, (\d+) wrong")
# What a top is checked against: a stream of each.
EXPECTED = {"raster_pineda": "stamp", "raster_pineda_plane": "triangle_depth", "ztest_index": "visible",
            "ztest_plane": "visible", "visible_select": "visible_attributes", "triangle_setup": "setup",
            "shade_setup": "planes",
            "shade_setup_lit": "planes", "light_vertex": "colours", "phong_setup": "planes",
            "texture_setup": "texture_planes", "motion_setup": "motion_planes", "scan_index": "scan",
            "motion_field": "motion", "ztest_merge": "found", "motion_compensate": "compensated",
            "front": "visible", "back": "pixel", "pipeline": "pixel",
            "back_compensate": "compensated", "static_frames": "shown",
            "pixel_store": "shown", "motion_order": "ordered", "hole_find": "asked", "hole_scan": "masked",
            "film_scan": "film"}


def run(bench, top, folder):
    result = subprocess.run([bench, top, folder], capture_output=True, text=True)
    found = CLOSING.search(result.stdout)
    if not found:
        sys.exit(f"{top}: the bench ended with {result.returncode} and no closing line\n{result.stdout}{result.stderr}")
    return result.returncode, int(found[2]), int(found[3]), result.stdout


def turn_last_bit(file):
    lines = file.read_text().splitlines()
    for n in range(len(lines) - 1, -1, -1):
        if lines[n] and not lines[n].startswith("/"):
            lines[n] = lines[n][:-1] + f"{int(lines[n][-1], 16) ^ 1:x}"
            break
    file.write_text("\n".join(lines) + "\n")


def main():
    halfspace, bench, folder, scene, config, lanes, *tops = sys.argv[1:]
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([halfspace, "vectors", scene, "--config", config, "--lanes", lanes, "--out", folder], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    wrong = 0
    for top in tops:
        status, compared, differ, output = run(bench, top, folder)
        print(output, end="")
        wrong += status != 0 or compared == 0 or differ != 0
        if top not in EXPECTED:
            continue
        file = folder / f"{EXPECTED[top]}.hex"
        right = file.read_text()
        turn_last_bit(file)
        status, _, differ, output = run(bench, top, folder)
        file.write_text(right)
        if status == 0 or differ == 0:
            print(f"{top}: a bit of {file.name} was turned, and the bench did not notice it")
            wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
