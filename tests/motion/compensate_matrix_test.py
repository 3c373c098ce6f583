#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates motion_compensate in configurations that are made here, each CASE being SIZE-FILTER-SAMPLES, as
low-bicubic-4, or that and -netlist, for the netlist that Yosys makes: under several stall seeds, and without stalls,
where the cycles are held to the kernel's.
Usage: compensate_matrix_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a [--seeds N]"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "pipeline"))
from cases import changed, main  # noqa: E402


def try_case(args, case):
    size, keys, samples, *netlist = case.name.split("-")
    values = {"name": f'"{case.name}"', "filter": f'"{keys}"', "samples": samples}
    case.build(changed(f"motion/motion_{size}.toml", values), "hs_motion_compensate", 4,
               yosys=args.yosys if netlist else None)
    for stall, seeds in ((30, args.seeds), (0, 1)):
        text = case.cosimulate("compensation", stall, seeds)
        case.say(f"stall {stall} %: {text.strip().splitlines()[-1]}")


if __name__ == "__main__":
    sys.exit(main(__doc__, try_case, seeds=3, options=[("--yosys", {"default": "yosys"})]))
