#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a vector set and runs a Verilated program on it under several stall seeds. Judges by what the reports count:
every stream has words, none mismatches.
Usage: cosim_test.py HALFSPACE PROGRAM FOLDER SCENE CONFIG LANES [--stall P] [--seeds N] [--bound X] [-- options of `halfspace vectors`]"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys


def run(command):
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    # A failure tells more on standard error; progress there is of no interest.
    return result.returncode, result.stdout + (result.stderr if result.returncode else "")


def rates(args, engine, options):
    """Of the scene by the reference or by the kernels."""
    report = pathlib.Path(args.folder) / f"{engine}.json"
    architecture = ["--architecture", "delta"] if engine == "ref" else ["--lanes", args.lanes]
    code, text = run([args.halfspace, "render", args.scene, "--config", args.config, "--engine", engine, *architecture,
                      *options, "--json", str(report)])
    if code:
        raise SystemExit(text)
    found = json.loads(report.read_text())["rates"]
    for name in ("lightings", "texture_fetches"):
        found.pop(name, None)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("halfspace", "program", "folder", "scene", "config", "lanes"):
        parser.add_argument(name)
    parser.add_argument("--stall", type=int, default=30)
    parser.add_argument("--seeds", type=int, default=1, help="run seeds 1 … N")
    parser.add_argument("--bound", type=float, default=0, help="cycles a frame at most, as a multiple of the bound")
    own = sys.argv[1:]
    at = own.index("--") if "--" in own else len(own)
    args = parser.parse_args(own[:at])

    folder = pathlib.Path(args.folder)
    shutil.rmtree(folder, ignore_errors=True)
    code, text = run([args.halfspace, "vectors", args.scene, "--config", args.config, "--lanes", args.lanes, "--out",
                      str(folder), *own[at + 1:]])
    print(text, end="")
    if code:
        return code
    report = folder / "report.json"
    words = 0
    for seed in range(1, args.seeds + 1):
        report.unlink(missing_ok=True)
        code, text = run([args.program, str(folder), "--seed", str(seed), "--stall", str(args.stall), "--json", str(report)])
        if code or not report.exists():
            print(text, end="")
            print(f"seed {seed}: {args.program} failed with status {code}")
            return 1
        runs = json.loads(report.read_text())["runs"]
        for one in runs:
            bad = [s["name"] for s in one["streams"] if s["words"] == 0 or s["mismatches"] != 0]
            if bad or not one["streams"] or one["mismatches"] or one["failures"] or not one["passed"]:
                print(text, end="")
                print(f"seed {seed}, {one['unit']}: streams {bad or 'none'} without words or with mismatches")
                return 1
            words += one["words"]
            # Data rates counted at the RTL's streams, in the kernels and by the reference; of a scene alone.
            if seed == 1 and one["unit"] == "pipeline" and "--no-corners" in own:
                options = [option for option in own[at + 1:] if option != "--no-corners"]
                for engine in ("ref", "hls"):
                    counted = rates(args, engine, options)
                    if counted != one["rates"] or not counted["visible_pixels"]:
                        print(f"the rates differ: {engine} {counted}, RTL {one['rates']}")
                        return 1
            bound = one.get("bound", {}).get("cycles", 0)
            if args.bound and not 0 < one["cycles"] <= args.bound * bound:
                print(f"{one['cycles']} cycles a frame, more than {args.bound} times the bound of {bound}")
                return 1
        print(text.strip().splitlines()[-1] + f" (seed {seed})")
    print(f"{words} words equal under {args.seeds} seeds")
    shutil.rmtree(folder, ignore_errors=True)
    return 0 if words else 1


if __name__ == "__main__":
    sys.exit(main())
