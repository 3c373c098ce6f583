#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates whole films by hs_up_convert on built-in animations, triangles in and the film out, in configurations
that are made here: each CASE is CONFIG-BETWEEN-LANES, as phong-1-4: film_phong with one frame between two key frames.
Stalls 30 %.
Usage: film_matrix_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a [--seeds N] [--size WxH]"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "pipeline"))
from cases import Failed, changed, main  # noqa: E402

# The number of the first frame: where much moves.
SCENES = {"cube_slow": 20, "cube_fast": 20, "cube_zoom": 5, "pyramid_slow": 20, "pyramid_fast": 20, "wheel_in_out": 10,
          "wheel_turn": 20, "ring_fall": 20, "drone": 25, "jet": 25}


def try_case(args, case):
    name, between, lanes = case.name.split("-")
    values = {"name": f'"{case.name}"', "frames_between": between}
    case.build(changed(f"film/film_{name}.toml", values), "hs_up_convert", int(lanes))
    words = 0
    for scene, first in SCENES.items():
        own = ["--size", args.size, "--first", first, "--intervals", 2]
        try:
            text = case.cosimulate(scene, 30, args.seeds, own)
        except Failed as failure:
            raise Failed(f"{scene}: {failure}") from failure
        of_scene = int(re.search(r"^(\d+) words equal", text, re.MULTILINE).group(1))
        frames = re.search(r"^film of (\d+) frames: (\d+) cycles each; .*", text, re.MULTILINE)
        if of_scene == 0 or not frames:
            raise Failed(f"{scene}: no words, or no film")
        case.say(f"{scene}: {of_scene} words, {frames.group(0)}")
        words += of_scene
    case.say(f"{words} words equal under {args.seeds} seeds")


if __name__ == "__main__":
    sys.exit(main(__doc__, try_case, seeds=1, options=[("--size", {"default": "93x61"})]))
