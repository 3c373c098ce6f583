# SPDX-License-Identifier: Apache-2.0
"""A mapped netlist: how many cells of each type, and its logic depth.

Depth is the number of cells on the longest path between registers (flip-flops, block RAMs, registers inside a DSP) or
ports, as Yosys' `ltp` counts: LUTs, multiplexers, reads of LUT-RAM, DSPs without registers, and each carry cell.
Netlists of parts are joined by their summaries, so that the depth of the whole includes paths through several parts.
"""

import collections

from cells import add_cell, add_register
from design import UNITS, instance
from paths import Paths


def box_of(cell):
    """The unit or the memory of the frame that a black box stands for, or ''."""
    return instance(cell["type"]) if cell["type"].startswith("hs_pipeline.") else ""


def boundary(module):
    """{name: bit} of what paths come from and of what they go to: the ports, and those of the units inside turned
    round."""
    ends = {"input": {}, "output": {}}
    found = [("", port, value["direction"], value["bits"]) for port, value in module["ports"].items()]
    turned = {"input": "output", "output": "input"}
    for cell in module["cells"].values():
        if (unit := box_of(cell)) in UNITS:
            found += [(f"{unit} ", port, turned[direction], cell["connections"].get(port, []))
                      for port, direction in cell["port_directions"].items()]
    for prefix, port, direction, bits in found:
        for number, bit in enumerate(bits):
            if isinstance(bit, int):
                ends[direction][f"{prefix}{port} {number}"] = bit
    return ends["input"], ends["output"]


def measure(module):
    """{"cells": numbers by type, "depth", "summary": paths to and from the boundary} of a module in Yosys' JSON."""
    paths, number = Paths(), collections.Counter()
    for cell in module["cells"].values():
        box = box_of(cell)
        if not box:
            add_cell(paths, cell)
            number[cell["type"]] += 1
        elif box not in UNITS:
            add_box(paths, cell)
    inputs, outputs = boundary(module)
    order = paths.order()
    started = paths.arrivals(paths.starts, order)
    leaving = paths.departures(paths.ends, order)
    summary = {"out": {name: started[bit] for name, bit in outputs.items() if bit in started},
               "in": {name: leaving[bit] for name, bit in inputs.items() if bit in leaving},
               "through": through(paths, inputs, outputs, order)}
    within = max((started[bit] + cells for bit, cells in paths.ends.items() if bit in started), default=0)
    across = [*summary["out"].values(), *summary["in"].values(), *(cells for _, _, cells in summary["through"])]
    return {"cells": dict(sorted(number.items())), "depth": max([within, *across]), "summary": summary}


def add_box(paths, cell):
    """A memory of the frame is a register."""
    bits = [(direction, bit) for port, direction in cell["port_directions"].items()
            for bit in cell["connections"].get(port, []) if isinstance(bit, int)]
    add_register(paths, [pin for pin in bits if pin[0] == "input"], [pin for pin in bits if pin[0] == "output"])


def through(paths, inputs, outputs, order):
    """[input, output, cells] of each pair with a path that meets no register."""
    names = collections.defaultdict(list)
    for name, bit in outputs.items():
        names[bit].append(name)
    reaching = paths.departures(dict.fromkeys(names, 0), order)
    order = [bit for bit in order if bit in reaching]
    return [[name, other, cells] for name, bit in inputs.items() if bit in reaching
            for sink, cells in paths.arrivals({bit: 0}, order).items() for other in names.get(sink, ())]


def joined_depth(whole, units):
    """The depth of a part with its units in it, from what `measure` says of each."""
    paths = Paths()
    for prefix, part in [("", whole), *((f"{name} ", unit) for name, unit in units.items())]:
        for name, cells in part["summary"]["out"].items():
            paths.start(prefix + name, cells)
        for name, cells in part["summary"]["in"].items():
            paths.end(prefix + name, cells)
        for source, sink, cells in part["summary"]["through"]:
            paths.arc(prefix + source, prefix + sink, cells)
    arrived = paths.arrivals(paths.starts, paths.order())
    across = (arrived[name] + cells for name, cells in paths.ends.items() if name in arrived)
    return max([whole["depth"], *(unit["depth"] for unit in units.values()), *across])
