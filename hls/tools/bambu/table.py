#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What Bambu's logs say of the tops, as a table in Markdown. Usage: table.py FOLDER: of hls/tools/bambu/Makefile"""
import pathlib
import re
import sys

OF_TOP = {"states": r"State Transition Graph Information of function {top}_top:\n\s*Number of states: (\d+)",
          "calls": r"Number of executions\s*: (\d+)", "cycles": r"Total cycles\s*: (\d+)",
          "words": r"(\d+) words compared, 0 wrong"}


def figures(top, log, luts):
    """Functions that are not part of their caller have figures of their own; each is there once."""
    row = {name: re.findall(pattern.format(top=top), log) for name, pattern in OF_TOP.items()}
    registers = dict(re.findall(r"Total number of flip-flops in function (\S+): (\d+)", log))
    bound = re.findall(r"Module binding information for function (\S+):.*?Estimated number of DSPs: (\d+)", log, re.S)
    clocks = re.findall(r"Estimated max frequency \(MHz\): ([\d.]+)", log)
    row = {name: values[-1] if values else "–" for name, values in row.items()}
    row["LUT"] = str(sum(map(int, re.findall(r"^\s+LUT[1-6]\s+(\d+)", luts, re.M)))) if luts else "–"
    row["FF"] = str(sum(map(int, registers.values()))) if registers else "–"
    row["DSP"] = str(sum(map(int, dict(bound).values()))) if bound else "–"
    row["MHz"] = f"{min(map(float, clocks)):.0f}" if clocks else "–"
    return {name: row[name] for name in ("states", "LUT", "FF", "DSP", "MHz", "calls", "cycles", "words")}


def text_of(path):
    return path.read_text(errors="replace") if path.exists() else ""


def rows(folder):
    for run in sorted(folder.glob("*/")):
        log = text_of(run / "cosim/log") or text_of(run / "synthesis/log")
        if log:
            top, config, lanes = run.name.rsplit(".", 2)
            yield {"top": top, "configuration": config, "lanes": lanes,
                   **figures(top, log, text_of(run / "synthesis/luts.txt"))}


def table(found):
    yield "| " + " | ".join(found[0]) + " |"
    yield "|" + "---|" * len(found[0])
    yield from ("| " + " | ".join(row.values()) + " |" for row in found)


def main():
    folder = pathlib.Path(sys.argv[1])
    found = list(rows(folder))
    if not found:
        sys.exit(f"{folder}: nothing was run: make -C hls/tools/bambu TOP=raster_pineda cosim")
    print("\n".join(table(found)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
