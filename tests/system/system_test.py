#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a vector set and draws it by hs_system under several options of the bench: each stream has words and none
differs, the video is right, and no rule of a channel is broken.
Usage: system_test.py HALFSPACE BENCH FOLDER SCENE CONFIG LANES --runs "OPTIONS" … -- options of `halfspace vectors`"""
import pathlib
import re
import shutil
import subprocess
import sys

LAST = re.compile(r"^bench system \S+ \S+: (\d+) words on (\d+) streams compared, 0 mismatches, \d+ cycles$", re.M)


def main():
    own = sys.argv[1:]
    at = own.index("--")
    halfspace, bench, folder, scene, config, lanes, _, *runs = own[:at]
    shutil.rmtree(folder, ignore_errors=True)
    pathlib.Path(folder).parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([halfspace, "vectors", scene, "--config", config, "--lanes", lanes, "--out", folder, *own[at + 1:]],
                   check=True, stdout=subprocess.DEVNULL)
    for options in runs:
        done = subprocess.run([bench, folder, *options.split()], capture_output=True, text=True, check=False)
        found = LAST.search(done.stdout)
        gives_up = any(word in options for word in ("--stop-at", "--reset-at", "--break-"))
        if done.returncode or not found or "FAIL" in done.stdout or gives_up != ("given up: " in done.stdout):
            print(f"{options}: {done.stdout}{done.stderr}")
            return 1
        if int(found.group(1)) == 0 or int(found.group(2)) < 9:
            print(f"{options}: only {found.group(1)} words on {found.group(2)} streams")
            return 1
        print(f"{options}: {found.group(0)}")
    shutil.rmtree(folder, ignore_errors=True)
    return 0 if runs else 1


if __name__ == "__main__":
    sys.exit(main())
