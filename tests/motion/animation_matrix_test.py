#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates frames between key frames on ten built-in animations, in configurations that are made here: each CASE is
SIZE-FILTER-SAMPLES for motion_compensate, as low-bicubic-4, or SIZE-field-LANES for the pipeline that makes the motion
field, as middle-field-4. Key frames are five frames apart, the frame in between is the second; stalls 30 %.
Usage: animation_matrix_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a [--seeds N]"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "pipeline"))
from cases import Failed, changed, main  # noqa: E402

# The number of the first key frame: where much moves.
SCENES = {"cube_slow": 20, "cube_fast": 20, "cube_zoom": 5, "pyramid_slow": 20, "pyramid_fast": 20, "wheel_in_out": 10,
          "wheel_turn": 20,
          "ring_fall": 20, "drone": 25, "jet": 25}
RATE = 30


def try_case(args, case):
    size, keys, number = case.name.split("-")
    field = keys == "field"
    lanes, samples = (int(number), 1) if field else (4, int(number))
    values = {"name": f'"{case.name}"', "samples": samples}
    if not field:
        values["filter"] = f'"{keys}"'
    case.build(changed(f"motion/motion_{size}.toml", values), "hs_pipeline" if field else "hs_motion_compensate", lanes)
    words = 0
    for scene, first in SCENES.items():
        own = ["--size", "160x120", "--time", (first + 2) / RATE, "--interval", f"{first / RATE}:{(first + 5) / RATE}",
               "--no-corners" if field else "--compensation"]
        try:
            text = case.cosimulate(scene, 30, args.seeds, own)
        except Failed as failure:
            raise Failed(f"{scene}: {failure}") from failure
        words += int(re.search(r"^(\d+) words equal", text, re.MULTILINE).group(1))
    if words == 0:
        raise Failed("no words")
    case.say(f"{len(SCENES)} animations, {words} words equal under {args.seeds} seeds")


if __name__ == "__main__":
    sys.exit(main(__doc__, try_case))
