# SPDX-License-Identifier: Apache-2.0
"""What is measured: hs_pipeline as Yosys elaborates it for a package and a number of lanes, taken apart.

The parts are the units, and `composition`: all that hs_pipeline adds to them (queues, frame control, the multiplexers
of the I-buffer). hs_ztest_merge, hs_static_run and hs_motion_compensate, which stand beside it, are ones where the
configuration has them. Each part is a flat module in RTLIL in which nothing is left of a file's place, of its line
numbers, or of the numbers that Yosys counts up: so a part has the same text whenever it is the same hardware.
"""

import dataclasses
import pathlib
import re
import sys
import tempfile

from rtlil import TOP, canonical, memories, module, ports
from tools import AreaError, run, say

sys.set_int_max_str_digits(0)  # constants are as long as what a memory starts with
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from units import CONFIG, LANES, below, constants, has, parameters  # noqa: E402

UNITS = ("index_pool", "triangle_setup", "light_vertex", "shade_setup", "phong_setup", "texture_setup", "motion_setup",
         "raster_pineda", "ztest_index", "ztest_plane", "scan_index", "shade_gouraud", "shade_phong", "shade_texture",
         "motion_field", "motion_compensate", "hole_scan", "pixel_store", "motion_order", "hole_find", "film_scan",
         "scan_object", "ztest_merge", "static_run")
COMPOSITION = "composition"
# Memories of the frame, which an FPGA may hold elsewhere: they are counted in bits, not mapped.
BUFFERS = ("depth_buffer", "visibility_database", "shading_database", "texture_database", "motion_database",
           "index_buffer", "object_table")


@dataclasses.dataclass
class Part:
    name: str
    text: str           # RTLIL; the modules it stands on are black boxes
    ports: list         # (name, width, direction)
    memories: list      # (words, width) of each memory declared

    @property
    def memory_bits(self):
        return sum(words * width for words, width in self.memories)


@dataclasses.dataclass
class Design:
    package: str
    config: str
    lanes: int
    parts: dict         # name -> Part
    buffers: dict       # name -> [(words, width)]
    alone: bool = False  # units without hs_pipeline and the memories of the frame


def opened(package, lanes):
    """The text of a package, the name of its configuration, and a title."""
    try:
        text = package.read_text()
    except (OSError, UnicodeDecodeError) as error:
        raise AreaError(f"cannot read the package {package} ({getattr(error, 'strerror', None) or 'not text'}): "
                        "print one with `halfspace package`") from None
    named = CONFIG.search(text)
    if not named or "package hs_formats_pkg" not in text:
        raise AreaError(f"{package} is not a package of number formats: print one with `halfspace package`")
    return text, named.group(1), f"{package}, {lanes} lane{'s' * (lanes > 1)}"


def elaborate_alone(yosys, rtl, package, lanes, units):
    """The Design of these units alone, without hs_pipeline and the memories of the frame."""
    package, rtl = pathlib.Path(package), pathlib.Path(rtl).resolve()
    text, config, title = opened(package, lanes)
    for unit in units:
        if not has(unit, constants(text)):
            raise AreaError(f"{title}: its configuration has no {unit}: take another, or leave the unit out")
    say(f"{title}: elaboration")
    parts = {unit: unit_alone(yosys, rtl, package, lanes, title, text, unit) for unit in units}
    return Design(str(package), config, lanes, parts, {}, alone=True)


def unit_alone(yosys, rtl, package, lanes, title, text, unit):
    """A unit with nothing read but what it stands on: how Yosys names and orders depends on all that it has read
    before."""
    bodies = flatten(yosys, rtl, package, f"hs_{unit}", lanes, title, text)
    return part(unit, bodies, next(name for name in bodies if re.fullmatch(rf"(.*\\)?hs_{unit}", name)))


def elaborate(yosys, rtl, package, lanes, units):
    """The Design of one package file and one number of lanes, with these units and the composition."""
    package, rtl = pathlib.Path(package), pathlib.Path(rtl).resolve()
    text, config, title = opened(package, lanes)
    say(f"{title}: elaboration")
    parts = {unit: unit_alone(yosys, rtl, package, lanes, title, text, unit) for unit in units
             if has(unit, constants(text))}
    # A module of its own for each instance: no queue shares the module of a memory of the frame.
    keep = (f"uniquify; select -set memories {' '.join(f'hs_pipeline.*u_{name}*' for name in BUFFERS)} "
            f"{'%u ' * (len(BUFFERS) - 1)} A:hdlname=*hs_ram_1r1w %i; "
            f"setattr -mod -set keep_hierarchy 1 @memories {' '.join(f'hs_pipeline.*u_{name}' for name in UNITS)}; ")
    bodies = flatten(yosys, rtl, package, "hs_pipeline", lanes, title, text, keep)
    parts[COMPOSITION] = part(COMPOSITION, bodies, "\\hs_pipeline")
    buffers = {}
    for name, body in bodies.items():
        if instance(name) in parts and instance(name) != COMPOSITION and ports(body) != parts[instance(name)].ports:
            raise AreaError(f"{title}: hs_pipeline gives parameters to {name} that {__file__} does not")
        if instance(name) in BUFFERS:
            buffers.setdefault(instance(name), []).extend(memories(body))
    if not buffers:
        raise AreaError(f"{title}: hs_pipeline has no memories named {', '.join(BUFFERS)}: name them in {__file__}")
    # In an order that does not depend on how deep each lies.
    buffers = {name: buffers[name] for name in BUFFERS if name in buffers}
    return Design(str(package), config, lanes, parts, buffers)


def flatten(yosys, rtl, package, top, lanes, title, text, keep=""):
    """{name: RTLIL} of a module, flat but for the modules that the commands `keep` mark."""
    sources = below(top, rtl)
    if not sources:
        raise AreaError(f"there is no {top}.sv in {rtl}: name the folder with --rtl")
    given = parameters(sources[top].read_text(), lanes, constants(text))
    # Set before: with the option of `hierarchy` Yosys 0.23 makes a module of a loop twice, and gives up.
    chosen = " ".join(f"-set {name} {value}" for name, value in given.items())
    chparam = f"chparam {chosen} {top}; " if given else ""
    with tempfile.TemporaryDirectory(prefix="halfspace-area-") as folder:
        out = pathlib.Path(folder) / "flat.il"
        files = " ".join(str(path.relative_to(rtl)) for path in sources.values())
        script = (f'read_verilog -sv "{package.resolve()}" {files}; {chparam}'
                  f"hierarchy -check -top {top}; proc; chformal -remove; check -assert; {keep}"
                  f'flatten; opt_clean; write_rtlil "{out}"')
        run([yosys, "-q", "-p", script], title, cwd=rtl)
        found = re.findall(r"^module (\S+)\n(.*?)^end$", out.read_text(), re.MULTILINE | re.DOTALL)
    others = re.compile(r"^ *attribute (?!\\init |\\keep ).*\n", re.MULTILINE)  # than those that change what is mapped
    return {name: others.sub("", body) for name, body in found}


def part(name, bodies, top):
    body = bodies[top]
    boxes = sorted(cell for cell in set(re.findall(r"^  cell (\S+) ", body, re.MULTILINE)) if cell in bodies)
    text = "".join(module(cell, bodies[cell], box=True) for cell in boxes) + module(f"\\{TOP}", body)
    return Part(name, canonical(text), ports(body), memories(body))


def instance(module_name):
    """hs_pipeline.gen_depths.u_depth_buffer.gen_depth.u_ram: depth_buffer."""
    known = [name for name in re.findall(r"\.u_(\w+)", module_name) if name in UNITS or name in BUFFERS]
    return known[-1] if known else COMPOSITION
