#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Functions of hls/top/pixel, natively, on a vector set at one lane: what they return are its words. A bit of what is
expected is turned as well, to see that this is noticed.
Usage: pixel_test.py HALFSPACE CASES FOLDER SCENE CONFIG FUNCTION …"""
import pathlib
import shutil
import subprocess
import sys

from tops_test import turn_last_bit

EXPECTED = {"gouraud_pixel": "pixel", "phong_pixel": "pixel", "textured_pixel": "pixel", "motion_vector": "motion",
            "merged_stamp": "merged", "texel_address": None}  # which is held by the texel that it finds


def main():
    halfspace, cases, folder, scene, config, *functions = sys.argv[1:]
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([halfspace, "vectors", scene, "--config", config, "--lanes", "1", "--out", folder], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def status(function):
        ran = subprocess.run([cases, function, folder], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        print(ran.stderr, end="")
        return ran.returncode

    faults = [f"{function} does not return the words of the set" for function in functions if status(function) != 0]
    for stream in {EXPECTED[function] for function in functions} - {None}:
        turn_last_bit(folder / f"{stream}.hex")
    faults += [f"{function}: a bit was turned, and nothing noticed it" for function in functions
               if EXPECTED[function] and status(function) == 0]
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
