#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which lines of the RTL the benches reach, and which bits of its signals change, by Verilator: of the bench
of each unit in a small configuration, under stalls. Prints a table of the units, and with --missed what is not
reached, by module. What was done is kept in --work, and the next run goes on from there.

tb/faults and tb/mutation.py say whether a bench notices what it reaches; this says what it cannot notice."""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path.insert(0, str(HERE))
import verilate  # noqa: E402
from model import build, compile_command  # noqa: E402

# unit, configuration, lanes, scene: as the tests run them.
BASE = ("triangle_setup", "shade_setup", "raster_pineda", "ztest_index", "scan_index", "shade_gouraud")
CASES = [(unit, "low", 4, "standard") for unit in BASE] + [
    ("ztest_plane", "gamma", 4, "standard"), ("visible_select", "lit_low", 4, "standard"),
    ("light_vertex", "lit_high", 4, "standard"), ("phong_setup", "phong_low", 4, "standard"),
    ("shade_phong", "phong_low", 4, "standard"), ("texture_setup", "textured_middle", 4, "standard"),
    ("shade_texture", "textured_middle", 4, "standard"), ("motion_setup", "motion_middle", 4, "standard"),
    ("motion_field", "motion_middle", 4, "standard"), ("motion_compensate", "motion_high", 4, "compensation"),
    ("ztest_merge", "objects_low", 4, "merge"), ("index_pool", "pool", 4, "standard"),
    ("pixel_store", "film_tiny", 1, "film"), ("motion_order", "film_tiny", 1, "film"),
    ("hole_find", "film_tiny", 1, "film"), ("hole_scan", "film_tiny", 1, "film"),
    ("film_scan", "film_tiny", 1, "film"), ("pipeline", "low", 4, "standard")]
SEEDS = (1, 2, 3)
POINT = re.compile(r"^C '(.*)' (\d+)$")


def config_of(name):
    return next(ROOT.glob(f"tests/configs/*/{name}.toml"), name)


def run(command, **more):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)
    if result.returncode:
        raise SystemExit(f"{' '.join(map(str, command[:3]))} … failed: {(result.stdout + result.stderr)[-1500:]}")


def library(args):
    """Verilator's for coverage, an object file."""
    made = args.work / "verilated_cov.o"
    if not made.exists():
        root = verilate.run([args.verilator, "--getenv", "VERILATOR_ROOT"], args.verilator).strip()
        run([*compile_command(args.verilator, args.cxx, "-O1"), "-c", f"{root}/include/verilated_cov.cpp", "-o", made])
    return made


def measure(args, unit, config, lanes, scene):
    """Leaves the points of a case."""
    name = f"{unit}_{config}_{lanes}"
    done, work = args.work / f"{name}.dat", args.work / name
    if done.exists():
        return done
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    package, vectors = work / "hs_formats_pkg.sv", work / "vectors"
    run([args.halfspace, "package", "--config", config_of(config), "-o", package])
    run([args.halfspace, "vectors", scene, "--config", config_of(config), "--lanes", lanes, "--out", vectors])
    libraries = [args.library[0], library(args), args.library[1]]
    bench = build(package, lanes, f"hs_{unit}", work / "model", libraries, verilator=args.verilator, cxx=args.cxx)
    for seed in SEEDS:
        run([bench, vectors, "--stall", "30", "--seed", seed],
            env={**os.environ, "HALFSPACE_COVERAGE": str(work / f"seed{seed}_")})
    run(["verilator_coverage", "--write", done, *sorted(work.glob("seed*.dat"))])
    shutil.rmtree(work)
    return done


def points(path):
    """{(module, kind, line, what): times} of a case; instances of a module count together."""
    found = {}
    for line in path.read_text(errors="replace").splitlines():
        if not (match := POINT.match(line)):
            continue
        parts = dict(part.split("\x02", 1) for part in match[1].split("\x01") if "\x02" in part)
        kind, _, _ = parts.get("page", "").partition("/")
        file = pathlib.Path(parts.get("f", "")).stem
        if file.startswith("hs_") and not file.endswith("_pkg"):
            key = file, "toggle" if "toggle" in kind else "line", int(parts["l"]), parts.get("o", "")
            found[key] = found.get(key, 0) + int(match[2])
    return found


def share(found, kind):
    counts = [times for (_, of, _, _), times in found.items() if of == kind]
    reached = sum(times > 0 for times in counts)
    return f"{reached:,} of {len(counts):,} | {100 * reached / max(len(counts), 1):.1f} %"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--halfspace", type=pathlib.Path, default=ROOT / "build/cli/halfspace")
    parser.add_argument("--library", type=pathlib.Path, action="append", required=True,
                        help="the harness and Verilator's library, in this order: --library A.a --library B.a")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/coverage")
    parser.add_argument("--units", nargs="+", help="of these alone")
    parser.add_argument("--missed", action="store_true", help="tell what is not reached")
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--cxx", default="c++")
    args = parser.parse_args()
    args.work.mkdir(parents=True, exist_ok=True)
    verilate.FLAGS += ["--coverage-line", "--coverage-toggle"]
    print("| unit | configuration | lines | | bits that change | |\n|---|---|---|---|---|---|")
    everything = {}
    for case in CASES:
        if args.units and case[0] not in args.units:
            continue
        found = points(measure(args, *case))
        if not found:
            raise SystemExit(f"{case[0]}: Verilator tells no point")
        for key, times in found.items():
            everything[key] = everything.get(key, 0) + times
        print(f"| `{case[0]}` | {case[1]}, {case[2]} lanes | {share(found, 'line')} | {share(found, 'toggle')} |",
              flush=True)
    print(f"| all | | {share(everything, 'line')} | {share(everything, 'toggle')} |")
    if args.missed:
        for (module, kind, line, what), times in sorted(everything.items()):
            if times == 0:
                print(f"{module}.sv:{line}: {kind} {what}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
