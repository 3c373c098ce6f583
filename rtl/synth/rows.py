# SPDX-License-Identifier: Apache-2.0
"""The lines of the result: units, their composition, the pipeline, and the memories of the frame."""

import clock
import netlist
from design import COMPOSITION, UNITS
from jobs import Job
from targets import add, counts

PIPELINE = "pipeline"


def measured(designs, runner):
    """The rows: each design, each target, each unit."""
    args, jobs = runner.args, {}
    for index, design in enumerate(designs):
        wanted, targets = asked(args, design)
        for target in targets:
            for name in design.parts:
                if PIPELINE not in wanted and name not in wanted:
                    continue
                timed = args.clock and target == "ice40" and name in wanted and name != COMPOSITION
                title = f"{design.config}, {design.lanes} lane{'s' * (design.lanes > 1)}: {name}, {target}"
                jobs[index, target, name] = Job(design.parts[name], target, timed, title)
    results = dict(zip(jobs, runner.run(jobs.values())))
    rows = []
    for index, design in enumerate(designs):
        wanted, targets = asked(args, design)
        for target in targets:
            found = {name: results.get((index, target, name)) for name in design.parts}
            for name in wanted:
                if name != PIPELINE and name not in design.parts:
                    continue
                if name == PIPELINE:
                    units = {unit: found[unit] for unit in UNITS if unit in found}
                    found[PIPELINE] = {"cells": add(result["cells"] for result in found.values()),
                                       "depth": netlist.joined_depth(found[COMPOSITION], units)}
                rows.append(row(design, target, name, found[name], args.clock))
    return rows


def asked(args, design):
    """The units and the targets of a design."""
    return (list(design.parts), args.alone_targets) if design.alone else (args.units, args.targets)


def row(design, target, name, result, clock_wanted):
    parts = design.parts.values() if name == PIPELINE else [design.parts[name]]
    number = counts(target, result["cells"])
    if not clock_wanted:
        why = "no clock was asked for"
    elif target != "ice40":
        why = "nothing is placed and routed for this target"
    elif name in (COMPOSITION, PIPELINE):
        why = clock.why_not(number["lut"], number["bram"]) or "only units are placed"
    else:
        why = result["why"]
    mhz = result.get("clock_mhz") if clock_wanted else None
    return {"package": design.package, "config": design.config, "unit": name, "lanes": design.lanes, "target": target,
            **number, "memory_bits": sum(part.memory_bits for part in parts), "depth": result["depth"],
            "clock_mhz": mhz, "clock_device": f"{clock.DEVICE}-{clock.PACKAGE}" if mhz else None, "why": why,
            "cells": result["cells"]}


def buffers(design):
    """The memories of the frame: banks and lanes are memories of their own."""
    return [{"config": design.config, "lanes": design.lanes, "buffer": name, "memories": len(memories),
             "words": memories[0][0], "width": memories[0][1], "bits": sum(words * width for words, width in memories),
             "blocks_18k": sum(blocks(*memory, 0) for memory in memories),
             "blocks_36k": sum(blocks(*memory, 1) for memory in memories)}
            for name, memories in design.buffers.items()]


def blocks(words, width, double):
    """Block RAMs of 18 kbit (of 36 kbit, if double) for a memory: the fewest with all of one shape."""
    shapes = [(512, 36), (1024, 18), (2048, 9), (4096, 4), (8192, 2), (16384, 1)]
    return min(-(-words // (deep << double)) * -(-width // wide) for deep, wide in shapes + [(256, 72)] * double)
