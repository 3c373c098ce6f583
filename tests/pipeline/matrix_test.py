#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates the whole pipeline of configurations that are made here: a size, an architecture, a shading, a texture,
each CASE being SIZE-ARCHITECTURE-SHADING[-FILTER-MAPPING][-objects], as low-gamma-phong. The corner cases and random
frames under several stall seeds, and a scene.
Usage: matrix_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a [--lanes N] [--seeds N]"""
import pathlib
import sys

from cases import changed, main

NORMAL_FRACTION = {"low": 13, "middle": 15, "high": 18}
TEXTURE = {"low": {"texels": 4096, "textures": 16, "coordinate_bits": 16, "coordinate_fraction": 13},
           "middle": {"texels": 65536, "textures": 32, "coordinate_bits": 24, "coordinate_fraction": 14},
           "high": {"texels": 1048576, "textures": 64, "coordinate_bits": 24, "coordinate_fraction": 15}}


def configuration(case):
    """The text of a case: that of the size, with what the case changes."""
    size, architecture, shading, *texture = case.removesuffix("-objects").split("-")
    changes = {"name": f'"{case.replace("-", "_")}"', "architecture": f'"{architecture}"', "shading": f'"{shading}"'}
    if shading != "gouraud":
        changes["colour_fraction"] = "0"
    if shading == "phong":
        changes["normal_fraction"] = NORMAL_FRACTION[size]
    text = changed(f"lit/lit_{size}.toml", changes)
    if texture:
        text += f'texture = "{texture[0]}"\nmapping = "{texture[1]}"\n'
        text += "".join(f"{key} = {value}\n" for key, value in TEXTURE[size].items())
    if case.endswith("-objects"):
        text += "object_bits = 12\n"
    return text


def try_case(args, case):
    case.build(configuration(case.name), "hs_pipeline", args.lanes)
    scene = args.textured_scene if case.name.removesuffix("-objects").count("-") > 2 else "teapot"
    for scene, seeds, options in (("standard", args.seeds, []), (scene, 1, ["--no-corners", "--size", "160x120"])):
        text = case.cosimulate(scene, 30, seeds, options)
        case.say(f"{pathlib.Path(scene).stem}: {text.strip().splitlines()[-1]}")


if __name__ == "__main__":
    sys.exit(main(__doc__, try_case, options=[
        ("--textured-scene", {"help": "a file with textures, for the cases with texture"}),
        ("--lanes", {"type": int, "default": 4})]))
