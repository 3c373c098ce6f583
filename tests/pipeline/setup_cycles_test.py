#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates the setup and the pipeline with several units of setup in turn, each CASE being CONFIG-CYCLES-LANES,
as odd-8-4, of a configuration of tests/configs and the interval that is asked for (SetupCycles): under several stall
seeds, and without stalls, where triangles that are not empty take that interval on the average (not where the frame is
too small for them, or there is lighting).
Usage: setup_cycles_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a [--seeds N]"""
import json
import sys

from cases import TESTS, Failed, main, run
from interval_test import LATENCY, TRIANGLES, triangles
from units import constants

BACKGROUND = 16  # stamps that the queues about shade_gouraud hold


def interval(args, case, cycles):
    """Holds the interval of triangles of either winding."""
    for clockwise in (True, False):
        scene, report = case.folder / "triangles.tri", case.folder / "report.json"
        scene.write_text(triangles(clockwise))
        run([args.halfspace, "vectors", scene, "--config", case.toml, "--lanes", case.lanes, "--no-corners",
             "--out", case.folder / "vectors"])
        run([case.bench, case.folder / "vectors", "--stall", 0, "--json", report])
        (result,) = json.loads(report.read_text())["runs"]
        if not result["cycles"] <= TRIANGLES * cycles + LATENCY:
            raise Failed(f"{result['cycles']} cycles for {TRIANGLES} triangles, SetupCycles {cycles}")
        case.say(f"{result['cycles']} cycles for {TRIANGLES} triangles")


def try_case(args, case):
    config, cycles, lanes = case.name.split("-")
    (toml,) = (TESTS / "configs").glob(f"*/{config}.toml")
    chosen = {"SetupCycles": int(cycles)}
    case.build(toml.read_text(), "hs_setup_turns", int(lanes), chosen=chosen)
    for stall in (0, 35, 75):
        case.say(f"stall {stall} %: {case.cosimulate('standard', stall, args.seeds).strip().splitlines()[-1]}")
    numbers = constants((case.folder / "hs_formats_pkg.sv").read_text())
    if min(numbers["MaxWidth"], numbers["MaxHeight"]) >= 100 and not numbers["Lights"]:
        interval(args, case, int(cycles))
    case.build(toml.read_text(), "hs_pipeline", int(lanes), chosen={**chosen, "BackgroundFifoDepth": BACKGROUND})
    for stall in (0, 35):
        case.say(f"stall {stall} %: {case.cosimulate('standard', stall, args.seeds).strip().splitlines()[-1]}")


if __name__ == "__main__":
    sys.exit(main(__doc__, try_case))
