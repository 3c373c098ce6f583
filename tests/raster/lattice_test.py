#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The RTL of the setup and the rasterizer against the kernels on every triangle whose vertices lie on a lattice of 9x9
half pixels on a frame of 3x3 and beyond: 531,441. A CASE is WHICH-LANES: `all`, or `sets`, each set of three places
once, in one of its orders. A fault of tb/faults in each of the units has to be found on the same triangles.
Usage: lattice_test.py HALFSPACE FOLDER CASE … --library A.a --library B.a"""
import itertools
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "pipeline"))
from cases import TESTS, Failed, changed, main, run  # noqa: E402

ROOT = TESTS.parent
sys.path.insert(0, str(ROOT / "tb"))
sys.path.insert(0, str(ROOT / "tb/faults"))
from model import build  # noqa: E402
from run import read_faults, seed_fault  # noqa: E402

GRID, FRAME = 9, 3  # places each way, from the corner of the frame; pixels
UNITS = ("triangle_setup", "raster_pineda")
LAST = re.compile(r"(\d+) words on \d+ streams compared, (\d+) mismatches")


def triangles(which):
    """Numbers of places."""
    if which == "all":
        return list(itertools.product(range(GRID * GRID), repeat=3))
    orders = list(itertools.permutations(range(3)))
    sets = itertools.combinations_with_replacement(range(GRID * GRID), 3)
    return [tuple(one[v] for v in orders[n % 6]) for n, one in enumerate(sets)]


def write(path, some):
    def vertex(n):
        x, y = n % GRID / 2, n // GRID / 2
        return f" {x} {y} {(n * 5 % 8) / 7:.3f} {n * 3 % 256} {n * 7 % 256} {n * n % 256}"

    corners = [vertex(n) for n in range(GRID * GRID)]
    path.write_text(f"size {FRAME} {FRAME}\n" + "".join(f"t{corners[a]}{corners[b]}{corners[c]}\n" for a, b, c in some))


def bench(case, unit, vectors, rtl, folder):
    """Words, and mismatches, of the bench of a unit."""
    package = case.folder / "hs_formats_pkg.sv"
    program = build(package, case.lanes, f"hs_{unit}", folder, case.args.library, rtl=rtl,
                    verilator=case.args.verilator, cxx=case.args.cxx, optimize="-O1")
    try:
        said = run([program, vectors, "--stall", "0", "--seed", "1"])
    except Failed as failure:
        said = str(failure)
    found = LAST.search(said)
    if not found:
        raise Failed(f"{unit}: no last line\n{said[-2000:]}")
    return int(found[1]), int(found[2])


def try_case(args, case):
    which, lanes = case.name.split("-")
    shutil.rmtree(case.folder, ignore_errors=True)
    case.folder.mkdir(parents=True)
    some = triangles(which)
    case.lanes = int(lanes)
    case.toml.write_text(changed("base/micro.toml", {"name": '"lattice"', "triangles": len(some)}))
    run([args.halfspace, "package", "--config", case.toml, "-o", case.folder / "hs_formats_pkg.sv"])
    write(case.folder / "lattice.tri", some)
    vectors = case.folder / "vectors"
    run([args.halfspace, "vectors", case.folder / "lattice.tri", "--config", case.toml, "--lanes", lanes,
         "--no-corners", "--out", vectors])
    for unit in UNITS:
        words, wrong = bench(case, unit, vectors, ROOT / "rtl", case.folder / unit)
        if wrong or words < len(some):
            raise Failed(f"{unit}: {wrong} of {words} words differ")
        case.say(f"{unit}: {len(some)} triangles, {words} words equal")
    # A stamp of more pixels than one leaves no row of three to walk in.
    faults = {"triangle_setup": "tie_rule", "raster_pineda": "walk_forgets_left" if lanes == "1" else "clip_off_by_one"}
    for unit, name in faults.items():
        fault = next(one for one in read_faults(ROOT / "tb/faults/faults.txt") if one["name"] == name)
        rtl = case.folder / f"{name}_rtl"
        shutil.copytree(ROOT / "rtl", rtl)
        seed_fault(fault, rtl)
        words, wrong = bench(case, unit, vectors, rtl, case.folder / name)
        if not wrong:
            raise Failed(f"{unit}: {name} is not found")
        case.say(f"{unit}: {name}: {wrong} of {words} words differ")


if __name__ == "__main__":
    sys.exit(main(__doc__, try_case))
