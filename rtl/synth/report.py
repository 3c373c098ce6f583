# SPDX-License-Identifier: Apache-2.0
"""The rows as text and as the tables of docs/area.md."""

from targets import TARGETS
from tools import AreaError

BEGIN, END = "<!-- area.py: begin -->", "<!-- area.py: end -->"
COLUMNS = ("lut", "ff", "dsp", "bram", "depth")


def text(result):
    columns = ("lut", "ff", "dsp", "bram", "memory_bits", "carry", "depth")
    lines = [f"{'config':10} {'lanes':>5} {'unit':15} {'target':7} " +
             " ".join(f"{name:>11}" for name in (*columns, "clock_mhz"))]
    for row in result["rows"]:
        numbers = [row[name] for name in columns]
        lines.append(f"{row['config']:10} {row['lanes']:5} {row['unit']:15} {row['target']:7} " +
                     " ".join(f"{number:11}" for number in numbers) + f" {row['clock_mhz'] or '-':>11}")
    for line in result["buffers"]:
        lines.append(f"{line['config']:10} {line['lanes']:5} {line['buffer']:16} {line['memories']} x {line['words']} "
                     f"words of {line['width']} bits, {line['bits']} bits: {line['blocks_18k']} blocks of 18 kbit, "
                     f"or {line['blocks_36k']} of 36 kbit")
    return "\n".join(lines)


def table(head, lines):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
                      *("| " + " | ".join(map(str, line)) + " |" for line in lines)]) + "\n"


def markdown(result):
    """A table of units for each configuration and number of lanes, and one of the memories of the frame."""
    points = list(dict.fromkeys((row["config"], row["lanes"]) for row in result["rows"]))
    clocks = any(row["clock_mhz"] for row in result["rows"])
    blocks = [f"Measured with Yosys {result['yosys']}, the smallest of {result['tries']} tries.\n"]
    for config, lanes in points:
        rows = {(row["unit"], row["target"]): row for row in result["rows"]
                if (row["config"], row["lanes"]) == (config, lanes)}
        targets = list(dict.fromkeys(target for _, target in rows))
        clock = clocks and "ice40" in targets
        head = ["unit"] + [f"{TARGETS[target].title}: LUT" if name == "lut" else
                           name.upper() if name != "depth" else name
                           for target in targets for name in COLUMNS if shown(target, name)]
        lines = []
        for unit in dict.fromkeys(unit for unit, _ in rows):
            numbers = [f"{rows[unit, target][name]:,}" for target in targets for name in COLUMNS
                       if shown(target, name)]
            lines.append([f"`{unit}`", *numbers, *([mhz(rows[unit, "ice40"])] if clock else [])])
        blocks.append(f"### {config}, {lanes} lane{'s' * (lanes > 1)}\n\n" +
                      table(head + ["MHz on HX8K"] * clock, lines))
    lines = [[line["config"], line["lanes"], f"`{line['buffer']}`",
              f"{line['memories']} × {line['words']:,} × {line['width']}", f"{line['bits']:,}", line["blocks_18k"],
              line["blocks_36k"]] for line in result["buffers"]]
    blocks.append("### Memories of the frame\n\n" +
                  table(["configuration", "lanes", "memory", "memories × words × bits", "bits", "18-kbit blocks",
                         "or 36-kbit blocks"], lines))
    return "\n".join(blocks)


def shown(target, name):
    return name != "dsp" or TARGETS[target].title != "iCE40 HX"


def mhz(row):
    return f"{row['clock_mhz']:.1f}" if row["clock_mhz"] else "—"


def between_markers(path, new):
    """The text of the file with what stands between its markers replaced."""
    try:
        old = path.read_text()
    except OSError as error:
        raise AreaError(f"cannot read {path} ({error.strerror}): it needs the lines {BEGIN} and {END}") from None
    if old.count(BEGIN) != 1 or old.count(END) != 1 or old.index(BEGIN) > old.index(END):
        raise AreaError(f"{path} has no lines {BEGIN} and {END}: write them where the tables shall stand")
    return old[:old.index(BEGIN)] + BEGIN + "\n\n" + new + "\n" + old[old.index(END):]
