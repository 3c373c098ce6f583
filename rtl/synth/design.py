# SPDX-License-Identifier: Apache-2.0
"""What is measured: hs_pipeline as Yosys elaborates it for a package and a number of lanes, taken apart.

The parts are the units, and `composition`: all that hs_pipeline adds to them (queues, frame control, the multiplexers
of the I-buffer). Each part is a flat module in RTLIL in which nothing is left of a file's place, of its line numbers, or
of the numbers that Yosys counts up: so a part has the same text whenever it is the same hardware.
"""

import dataclasses
import pathlib
import re
import tempfile

from rtlil import TOP, canonical, memories, module, ports
from tools import AreaError, run, say

UNITS = ("triangle_setup", "shade_setup", "raster_pineda", "ztest_index", "ztest_plane", "scan_index", "shade_gouraud")
# Units that other configurations have, measured alone.
OTHERS = ("light_vertex", "phong_setup", "shade_phong")
COMPOSITION = "composition"
# Memories of the frame, which an FPGA may hold elsewhere: they are counted in bits, not mapped.
BUFFERS = ("depth_buffer", "visibility_database", "index_buffer", "shading_database")
LANES = {1: (1, 1), 2: (2, 1), 4: (2, 2), 8: (4, 2), 16: (4, 4)}


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
    named = re.search(r"Number formats of configuration `([^`]+)`", text)
    if not named or "package hs_formats_pkg" not in text:
        raise AreaError(f"{package} is not a package of number formats: print one with `halfspace package`")
    return text, named.group(1), f"{package}, {lanes} lane{'s' * (lanes > 1)}"


def elaborate_alone(yosys, rtl, package, lanes, units):
    """The Design of these units alone, without hs_pipeline and the memories of the frame."""
    package, rtl = pathlib.Path(package), pathlib.Path(rtl).resolve()
    text, config, title = opened(package, lanes)
    given, parts = {unit: values(text, unit, title) for unit in units}, {}
    say(f"{title}: elaboration")
    for unit in units:
        bodies = flatten(yosys, rtl, package, f"hs_{unit}", lanes, title, values=given[unit])
        parts[unit] = part(unit, bodies, next(name for name in bodies if f"hs_{unit}" in name))
    return Design(str(package), config, lanes, parts, {}, alone=True)


def values(text, unit, title):
    """Of the parameters that have no defaults: {name: value}, from the package."""
    found = dict(re.findall(r"localparam int unsigned (\w+) = (\d+);", text))
    needs = {"light_vertex": "Lights", "phong_setup": "NormalPlaneBits", "shade_phong": "NormalPlaneBits"}
    if needs.get(unit, "HasDepth") not in found:
        raise AreaError(f"{title}: its configuration has no {unit}: take one with lighting, or leave the unit out")
    if unit == "light_vertex":
        return {"Vertices": 3 if found["Gouraud"] == "1" else 1}
    return {"NormalBits": found["NormalBits"]} if unit == "phong_setup" else {}


def elaborate(yosys, rtl, package, lanes, units):
    """The Design of one package file and one number of lanes, with these units and the composition."""
    package, rtl = pathlib.Path(package), pathlib.Path(rtl).resolve()
    text, config, title = opened(package, lanes)
    say(f"{title}: elaboration")
    # One of the two Z-tests is there: ztest_plane has depth and no Z-buffer.
    planes = re.search(r" HasDepth = 1;", text) and re.search(r" StoresDepth = 0;", text)
    units = [unit for unit in units if unit != ("ztest_index" if planes else "ztest_plane")]
    # A unit is elaborated alone, with nothing read but what it stands on: how Yosys names and orders depends on all that
    # it has read before.
    parts = {}
    for unit in units:
        bodies = flatten(yosys, rtl, package, f"hs_{unit}", lanes, title)
        parts[unit] = part(unit, bodies, f"\\hs_{unit}")
    # A module of its own for each instance: no queue shares the module of a memory of the frame.
    keep = (f"uniquify; select -set memories {' '.join(f'hs_pipeline.*u_{name}*' for name in BUFFERS)} "
            f"{'%u ' * (len(BUFFERS) - 1)} A:hdlname=*hs_ram_1r1w %i; "
            f"setattr -mod -set keep_hierarchy 1 @memories {' '.join(f'hs_pipeline.*u_{name}' for name in UNITS)}; ")
    bodies = flatten(yosys, rtl, package, "hs_pipeline", lanes, title, keep)
    parts[COMPOSITION] = part(COMPOSITION, bodies, "\\hs_pipeline")
    buffers = {}
    for name, body in bodies.items():
        if instance(name) in parts and instance(name) != COMPOSITION and ports(body) != parts[instance(name)].ports:
            raise AreaError(f"{title}: hs_pipeline gives parameters to {name} that {__file__} does not")
        if instance(name) in BUFFERS:
            buffers.setdefault(instance(name), []).extend(memories(body))
    if not buffers:
        raise AreaError(f"{title}: hs_pipeline has no memories named {', '.join(BUFFERS)}: name them in {__file__}")
    return Design(str(package), config, lanes, parts, buffers)


def below(rtl, top):
    """The sources of a module and all that it instantiates."""
    found, waiting = {}, [top]
    while waiting:
        stem = waiting.pop()
        path = rtl / f"{stem}.sv"
        if stem not in found and path.exists():
            found[stem] = path.read_text()
            waiting += re.findall(r"^\s*(hs_\w+)\s+(?:#\s*\(|u_\w+)", found[stem], re.MULTILINE)
    if top not in found:
        raise AreaError(f"there is no {top}.sv in {rtl}: name the folder with --rtl")
    return dict(sorted(found.items()))


def flatten(yosys, rtl, package, top, lanes, title, keep="", values=()):
    """{name: RTLIL} of a module, flat but for the modules that the commands `keep` mark."""
    sources = below(rtl, top)
    given = dict(values)
    if re.search(r"\bparameter\b.*\bLanesX\b", sources[top]):
        given["LanesX"], given["LanesY"] = LANES[lanes]
    parameters = " ".join(f"-chparam {name} {value}" for name, value in given.items())
    with tempfile.TemporaryDirectory(prefix="halfspace-area-") as folder:
        out = pathlib.Path(folder) / "flat.il"
        script = (f'read_verilog -sv "{package.resolve()}" {" ".join(f"{stem}.sv" for stem in sources)}; '
                  f"hierarchy -check -top {top} {parameters}; proc; chformal -remove; check -assert; {keep}"
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
    named = re.search(r"\.u_(\w+)", module_name)
    return named.group(1) if named else COMPOSITION
