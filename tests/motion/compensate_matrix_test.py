#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates motion_compensate in configurations that are made here, each CASE being SIZE-FILTER-SAMPLES, as
low-bicubic-4, or that and -netlist, for the netlist that Yosys makes: under several stall seeds, and without stalls,
where the cycles are held to the kernel's.
Usage: compensate_matrix_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a [--seeds N]"""
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


def run(command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    return result.returncode, result.stdout + result.stderr


def configuration(size, keys, samples, path):
    text = (TESTS / "configs/motion" / f"motion_{size}.toml").read_text()
    for key, value in {"name": f'"{path.parent.name}"', "filter": f'"{keys}"', "samples": samples}.items():
        text, count = re.subn(rf"^{key} = \S+", f"{key} = {value}", text, flags=re.MULTILINE)
        assert count == 1, (key, count)
    path.write_text(text)


def try_case(args, case):
    folder = pathlib.Path(args.folder) / case
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    size, keys, samples, *netlist = case.split("-")
    toml, package = folder / "config.toml", folder / "hs_formats_pkg.sv"
    configuration(size, keys, samples, toml)
    code, text = run([args.halfspace, "package", "--config", toml, "-o", package])
    if code:
        return False, text
    bench = build(package, 4, "hs_motion_compensate", folder / "model", args.library, verilator=args.verilator,
                  cxx=args.cxx, yosys=args.yosys if netlist else None)
    for stall, seeds in ((30, args.seeds), (0, 1)):
        code, text = run([sys.executable, TESTS / "pipeline/cosim_test.py", args.halfspace, bench, folder / "vectors",
                          "compensation",
                          toml, 4, "--stall", stall, "--seeds", seeds])
        if code:
            return False, text
        print(f"{case}, stall {stall} %: {text.strip().splitlines()[-1]}", flush=True)
    shutil.rmtree(folder, ignore_errors=True)
    return True, ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("halfspace")
    parser.add_argument("folder")
    parser.add_argument("case", nargs="+")
    parser.add_argument("--library", action="append", required=True)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--yosys", default="yosys")
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
