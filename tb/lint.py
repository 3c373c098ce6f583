#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Verilator's lint with all warnings over every unit of the RTL and the pipeline, in every configuration or with the
packages given.

A unit is a module that hls/units.txt lists; the modules below it are seen through it, and a file that no unit reaches
is a fault. tb/lint.vlt holds the waivers. Ends with a count: silence would prove nothing.
"""

import argparse
import pathlib
import subprocess
import sys

TB = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(TB.parent / "rtl"))
from units import (FILM, GAMMA, MOTION, OBJECTS, RTL, WHOLES, below, constants, has, parameters,  # noqa: E402
                   sources, units)

CONFIGS = ["low", "middle", "high"]
LANES = [1, 4, 16]
COMPOSED = ["pipeline", "system"]  # no units


def lint(args, package, top, lanes, chosen):
    """What Verilator says, or '' if nothing."""
    found = below(top, args.rtl)
    given = {**parameters(found[top].read_text(), lanes, constants(package.read_text())), **chosen}
    command = [args.verilator, "--lint-only", "-Wall", "--top-module", top,
               *(f"-G{name}={value}" for name, value in given.items()),
               TB / "lint.vlt", package, *found.values()]
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    output = result.stdout + result.stderr
    return output if result.returncode or output.strip() else ""


def tops_of(package, chosen):
    """The chosen units that a configuration has; each has the pipeline, which has most of the others in it, or of a
    film what stands in its place."""
    numbers = constants(package.read_text())
    chosen = [unit for unit in chosen if unit != "system" or not (MOTION(numbers) or OBJECTS(numbers))]
    whole = "up_convert" if FILM(numbers) else "pipeline"
    return [f"hs_{whole if unit == 'pipeline' else unit}" for unit in chosen
            if unit in COMPOSED or (has(unit, numbers) and unit != whole)]


def outside_of(top, package):
    """The pipeline is looked at with memory inside and, where it can have it so, outside."""
    numbers = constants(package.read_text())
    can = top in ("hs_pipeline", "hs_system") and not (GAMMA(numbers) or OBJECTS(numbers) or MOTION(numbers))
    return [{}, {"OutsideFrame": 1, "OutsidePlanes": 1}] if can else [{}]


def lanes_of(module, package):
    """The lanes that a module is looked at with."""
    takes = parameters(module.read_text(), 1, constants(package.read_text()))
    return LANES if "LanesX" in takes else LANES[:1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--verilator", default="verilator", help="the program (default: %(default)s)")
    parser.add_argument("--package", type=pathlib.Path, action="append",
                        help="of a configuration (default: low, middle, high)")
    parser.add_argument("--units", nargs="+", choices=[*units(), *COMPOSED], default=[*units(), *COMPOSED],
                        metavar="UNIT", help="these alone (default: all, the pipeline and the system)")
    parser.add_argument("--rtl", type=pathlib.Path, default=RTL)
    args = parser.parse_args()
    packages = args.package or [args.rtl / "formats" / config / "hs_formats_pkg.sv" for config in CONFIGS]
    known = sources(args.rtl)
    # What is no unit is linted by its own tests, with the configurations that it is for.
    seen = set().union(*(below(f"hs_{unit}", args.rtl) for unit in [*units(), "pipeline", *WHOLES]))
    faults = [f"there is no module hs_{unit}" for unit in units() if f"hs_{unit}" not in known]
    faults += [f"no unit uses {path}: remove it, or add its unit to hls/units.txt"
               for stem, path in known.items() if stem not in seen]
    todo = [(package, top, lanes, chosen) for package in packages for top in tops_of(package, args.units)
            if top in known for lanes in lanes_of(known[top], package) for chosen in outside_of(top, package)]
    faults += [f"{top}, {package}, {lanes} lanes {chosen or ''}:\n{output}" for package, top, lanes, chosen in todo
               if (output := lint(args, package, top, lanes, chosen))]
    print("".join(f"lint: {fault}\n" for fault in faults), end="")
    print(f"lint: {len(todo)} runs, {len(seen)} files, {len(faults)} faults")
    return 1 if faults or not todo else 0


if __name__ == "__main__":
    sys.exit(main())
