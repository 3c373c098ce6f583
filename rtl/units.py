#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The modules of the RTL: where they lie, what stands below one, which units a configuration has, and their parameters.

Prints the units of the pipeline of PACKAGE, one a line. Usage: units.py PACKAGE"""
import pathlib
import re
import sys

RTL = pathlib.Path(__file__).resolve().parent
LANES = {1: (1, 1), 2: (2, 1), 4: (2, 2), 8: (4, 2), 16: (4, 4)}
CONFIG = re.compile(r"^// Number formats of configuration `([\w-]+)`", re.MULTILINE)
# Configurations that have a unit, by the numbers of their package; the others of hls/units.txt are in every pipeline.
GAMMA, PHONG, MOTION = ((lambda c: c["HasDepth"] and not c["StoresDepth"]), (lambda c: c["Phong"]),
                        (lambda c: c["HasMotion"]))
FILM = lambda c: c["UpConverts"]  # noqa: E731
SHADES = lambda c: not MOTION(c) or FILM(c)  # noqa: E731
OBJECTS, TEXTURE = (lambda c: c["HasObjects"]), (lambda c: c["HasTexture"])
INDICES = (lambda c: c["GivesIndices"])
HAVE = {"index_pool": INDICES, "ztest_index": lambda c: not GAMMA(c), "ztest_plane": GAMMA,
        "visible_select": lambda c: c["Lights"] or TEXTURE(c) or MOTION(c),
        "shade_setup": lambda c: not PHONG(c) and SHADES(c), "shade_gouraud": lambda c: not PHONG(c) and SHADES(c),
        "light_vertex": lambda c: c["Lights"] and not PHONG(c), "phong_setup": PHONG, "shade_phong": PHONG,
        "texture_setup": TEXTURE, "shade_texture": TEXTURE,
        "motion_setup": MOTION, "motion_field": MOTION, "motion_compensate": MOTION,
        "pixel_store": FILM, "motion_order": FILM, "hole_find": FILM, "hole_scan": FILM, "film_scan": FILM,
        "up_convert": FILM, "scan_object": OBJECTS, "ztest_merge": OBJECTS, "static_run": OBJECTS,
        "static_frames": OBJECTS}
# Not in the pipeline: memories lie between; what it is a part of; and what stands in its place where there are films.
BESIDE = ("motion_compensate", "ztest_merge", "static_run", "static_frames", "up_convert")
# What units are put together in besides, and is none: it has no words in vector sets.
WHOLES = ("board", "system")


def units():
    """Every unit, in the order of the pipeline and then what stands beside it."""
    text = (RTL.parent / "hls" / "units.txt").read_text()
    return [name for name in re.findall(r"^[a-z]+/(\w+)$", text, re.MULTILINE) if name != "pipeline"]


def constants(package):
    """{name: number} of the text of a package."""
    return {name: int(number) for name, number in re.findall(r"localparam int unsigned (\w+) = (\d+);", package)}


def has(unit, numbers):
    """Whether the configuration with these numbers has the unit."""
    return bool(HAVE.get(unit, lambda c: True)(numbers))


def sources(rtl=RTL):
    """{stem: path} of every module."""
    return {path.stem: path for path in sorted(rtl.glob("*/hs_*.sv"))}


def instantiated(path, known):
    """The names in a module that are modules, in alphabetical order."""
    code = re.sub(r'"[^"\n]*"|//[^\n]*|/\*.*?\*/', "", path.read_text(), flags=re.DOTALL)
    return sorted(set(re.findall(r"\bhs_\w+\b", code)) & known - {path.stem})


def ordered(tops, rtl=RTL):
    """{stem: path} of modules and of all below them, each after those that it instantiates."""
    paths, found = sources(rtl), {}

    def visit(stem):
        if stem in found or stem not in paths:
            return
        for name in instantiated(paths[stem], set(paths)):
            visit(name)
        found[stem] = paths[stem]

    for top in tops:
        visit(top)
    return found


def below(top, rtl=RTL):
    """The same of one module, packages first, and by name: what tools make of sources depends on the order in which
    they read them."""
    return dict(sorted(ordered([top], rtl).items(), key=lambda item: (not item[0].endswith("_pkg"), item[0])))


def parameters(module, lanes, numbers):
    """{name: value} that a module is given: the lanes where it has them; and each parameter without a default has the
    value of the constant of that name in the package. Vertices is no constant: three have a colour, or the triangle
    has."""
    known = {**numbers, "Vertices": 3 if numbers.get("Gouraud") else 1, "LanesX": LANES[lanes][0],
             "LanesY": LANES[lanes][1]}
    head = module[:module.index(");")] if ");" in module else module
    given = {}
    for name, default in re.findall(r"^\s*parameter int unsigned (\w+)( =)?", head, re.MULTILINE):
        if name in ("LanesX", "LanesY") or not default:
            given[name] = known[name]
    return given


def yosys_elaborate(top, read, given):
    """Commands of Yosys that read these files and elaborate the module with these parameters. They are set before: with
    the option of `hierarchy` Yosys 0.23 makes a module of a loop twice, and gives up."""
    files = " ".join(f'"{path}"' for path in read)
    chosen = " ".join(f"-set {name} {value}" for name, value in given.items())
    chparam = f"chparam {chosen} {top}; " if given else ""
    return f"read_verilog -sv {files}; {chparam}hierarchy -check -top {top}; proc; opt"


def main():
    numbers = constants(pathlib.Path(sys.argv[1]).read_text())
    print("\n".join(unit for unit in units() if has(unit, numbers) and unit not in BESIDE))
    return 0


if __name__ == "__main__":
    sys.exit(main())
