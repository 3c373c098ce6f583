#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Co-simulates the whole pipeline of configurations that are made here: a size, an architecture, a shading, a texture,
each CASE being SIZE-ARCHITECTURE-SHADING[-FILTER-MAPPING][-objects], as low-gamma-phong. The corner cases and random
frames under several stall seeds, and a scene.
Usage: matrix_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a [--lanes N] [--seeds N]"""
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

NORMAL_FRACTION = {"low": 13, "middle": 15, "high": 18}
TEXTURE = {"low": {"texels": 4096, "textures": 16, "coordinate_bits": 16, "coordinate_fraction": 13},
           "middle": {"texels": 65536, "textures": 32, "coordinate_bits": 24, "coordinate_fraction": 14},
           "high": {"texels": 1048576, "textures": 64, "coordinate_bits": 24, "coordinate_fraction": 15}}


def configuration(case, path):
    """Writes the .toml file of a case: that of the size, with what the case changes."""
    size, architecture, shading, *texture = case.removesuffix("-objects").split("-")
    text = (TESTS / "configs/lit" / f"lit_{size}.toml").read_text()
    changes = {"name": f'"{case.replace("-", "_")}"', "architecture": f'"{architecture}"', "shading": f'"{shading}"'}
    if shading != "gouraud":
        changes["colour_fraction"] = "0"
    if shading == "phong":
        changes["normal_fraction"] = NORMAL_FRACTION[size]
    for key, value in changes.items():
        text, count = re.subn(rf"^{key} = \S+", f"{key} = {value}", text, flags=re.MULTILINE)
        assert count == 1, (key, count)
    if texture:
        text += f'texture = "{texture[0]}"\nmapping = "{texture[1]}"\n'
        text += "".join(f"{key} = {value}\n" for key, value in TEXTURE[size].items())
    if case.endswith("-objects"):
        text += "object_bits = 12\n"
    path.write_text(text)


def run(command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    return result.returncode, result.stdout + result.stderr


def try_case(args, case):
    folder = pathlib.Path(args.folder) / case
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    toml, package = folder / "config.toml", folder / "hs_formats_pkg.sv"
    configuration(case, toml)
    code, text = run([args.halfspace, "package", "--config", toml, "-o", package])
    if code:
        return False, text
    bench = build(package, args.lanes, "hs_pipeline", folder / "model", args.library, verilator=args.verilator,
                  cxx=args.cxx)
    scene = args.textured_scene if case.removesuffix("-objects").count("-") > 2 else "teapot"
    for scene, seeds, options in (("standard", args.seeds, []), (scene, 1, ["--no-corners", "--size", "160x120"])):
        code, text = run([sys.executable, TESTS / "pipeline/cosim_test.py", args.halfspace, bench, folder / "vectors",
                          scene, toml,
                          args.lanes, "--stall", 30, "--seeds", seeds, "--", *options])
        if code:
            return False, text
        print(f"{case}, {pathlib.Path(scene).stem}: {text.strip().splitlines()[-1]}", flush=True)
    shutil.rmtree(folder, ignore_errors=True)
    return True, ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("halfspace")
    parser.add_argument("folder")
    parser.add_argument("case", nargs="+")
    parser.add_argument("--library", action="append", required=True)
    parser.add_argument("--textured-scene", help="a file with textures, for the cases with texture")
    parser.add_argument("--lanes", type=int, default=4)
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--cxx", default="c++")
    args = parser.parse_args()
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for case, (good, text) in zip(args.case, pool.map(lambda case: try_case(args, case), args.case)):
            if not good:
                failed += 1
                print(f"{case}: FAIL\n{text}")
    print(f"matrix: {len(args.case) - failed} of {len(args.case)} cases equal to the bit")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
