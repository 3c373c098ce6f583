#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates frames between key frames on ten built-in animations, in configurations that are made here: each CASE is
SIZE-FILTER-SAMPLES for motion_compensate, as low-bicubic-4, or SIZE-field-LANES for the pipeline that makes the motion
field, as middle-field-4. Key frames are five frames apart, the frame in between is the second; stalls 30 %.
Usage: animation_matrix_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a [--seeds N]"""
import argparse
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TESTS.parent / "tb"))
from model import build  # noqa: E402

# The number of the first key frame: where much moves.
SCENES = {"cube_slow": 20, "cube_fast": 20, "cube_zoom": 5, "pyramid_slow": 20, "pyramid_fast": 20, "wheel_in_out": 10,
          "wheel_turn": 20,
          "ring_fall": 20, "drone": 25, "jet": 25}
RATE = 30


def run(command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    return result.returncode, result.stdout + result.stderr


def configuration(size, keys, samples, path):
    text = (TESTS / "configs/motion" / f"motion_{size}.toml").read_text()
    values = {"name": f'"{path.parent.name}"', "samples": samples}
    if keys != "field":
        values["filter"] = f'"{keys}"'
    for key, value in values.items():
        text, count = re.subn(rf"^{key} = \S+", f"{key} = {value}", text, flags=re.MULTILINE)
        assert count == 1, (key, count)
    path.write_text(text)


def try_case(args, case):
    folder = pathlib.Path(args.folder) / case
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    size, keys, number = case.split("-")
    field = keys == "field"
    lanes, samples = (int(number), 1) if field else (4, int(number))
    toml, package = folder / "config.toml", folder / "hs_formats_pkg.sv"
    configuration(size, keys, samples, toml)
    code, text = run([args.halfspace, "package", "--config", toml, "-o", package])
    if code:
        return False, text
    bench = build(package, lanes, "hs_pipeline" if field else "hs_motion_compensate", folder / "model", args.library,
                  verilator=args.verilator, cxx=args.cxx)
    words = 0
    for scene, first in SCENES.items():
        own = ["--size", "160x120", "--time", (first + 2) / RATE, "--interval", f"{first / RATE}:{(first + 5) / RATE}",
               "--no-corners" if field else "--compensation"]
        code, text = run([sys.executable, TESTS / "pipeline/cosim_test.py", args.halfspace, bench, folder / "vectors",
                          scene, toml, lanes,
                          "--stall", 30, "--seeds", args.seeds, "--", *own])
        if code:
            return False, f"{scene}: {text}"
        words += int(re.search(r"^(\d+) words equal", text, re.MULTILINE).group(1))
    print(f"{case}: {len(SCENES)} animations, {words} words equal under {args.seeds} seeds", flush=True)
    shutil.rmtree(folder, ignore_errors=True)
    return words > 0, ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("halfspace")
    parser.add_argument("folder")
    parser.add_argument("case", nargs="+")
    parser.add_argument("--library", action="append", required=True)
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--cxx", default="c++")
    args = parser.parse_args()
    passed = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for case, (good, text) in zip(args.case, pool.map(lambda case: try_case(args, case), args.case)):
            passed += good
            if not good:
                print(f"{case} failed: {text}", flush=True)
    print(f"{passed} of {len(args.case)} configurations passed")
    return 0 if passed == len(args.case) else 1


if __name__ == "__main__":
    sys.exit(main())
