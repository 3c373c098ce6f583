#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What docs/port.md tells to expect of each kernel: its interval is that of the kernel's head; a loop that has one of a
cycle is pipelined at 1; and multipliers are those of docs/area.md where that has the unit. A loop of hls/ that has a
directive has a label, by which Catapult's directives name it.
Usage: interval_test.py ROOT"""
import pathlib
import re
import sys

# Tops that share a kernel with another one.
OTHERS = {"raster_pineda_plane", "shade_setup_lit"}
ROW = re.compile(r"^\| `(\w+)` \| ([^|]+) \| ([^|]+) \| ([^|]+) \|$", re.M)
LOOP = re.compile(r"^(.*)(?=\n *(?:HS_\w+ )?(?:for|while) \(.*\n *HS_(?:PIPELINE|UNROLL)\b)", re.M)
INTERVAL = re.compile(r"^// Interval( of the RTL)?: ((?:.*\n)(?://  ?\S.*\n)*)#ifndef", re.M)


def table(text):
    part = text[text.index("<!-- intervals -->"):text.index("<!-- /intervals -->")]
    return {name: (interval, multipliers) for name, interval, _, multipliers in ROW.findall(part)}


def said(head):
    """Of a kernel's head: the interval, and whether it is of the RTL alone."""
    found = INTERVAL.search(head)
    return (re.sub(r"\s*\n(// )?", " ", found[2]).strip().removesuffix("."), bool(found[1])) if found else ("", False)


def without_label(name, text):
    for found in LOOP.finditer(text):
        if not re.fullmatch(r" *\w+:", found[1]):
            yield f"{name}:{text.count(chr(10), 0, found.start(1)) + 2}: a loop with a directive, and without a label"


def dsp_of(area, unit):
    """In the first of its tables: *low*, or the configuration `low` that has it."""
    found = re.search(rf"^\| `{unit}` \| [\d,]+ \| [\d,]+ \| (\d+) \|", area, re.M)
    return int(found[1]) if found else None


def faults(tops, kernels, page, area):
    """Of `kernels`: the head and the sources of each by its name."""
    rows = table(page)
    names = [name for name in tops if name not in OTHERS]
    if list(rows) != names:
        yield f"docs/port.md expects something of {list(rows)}, and hls/top/tops.txt has {names}"
    for name, (interval, multipliers) in rows.items():
        if name not in kernels:
            continue
        head, sources = kernels[name]
        text, of_rtl = said(head)
        if interval != text + (" (RTL)" if of_rtl else ""):
            yield f"docs/port.md: the interval of {name} is `{interval}`, and its head says `{text}`"
        if not of_rtl and "HS_PIPELINE(1)" not in sources:
            yield f"{name}: its head says `{text}`, and no loop is pipelined"
        dsp = dsp_of(area, name)
        if dsp is not None and int(re.match(r"\d+", multipliers)[0]) != dsp:
            yield f"docs/port.md: {name} takes {multipliers} multipliers, and docs/area.md has {dsp}"


PAGE = "<!-- intervals -->\n| `a` | a word a cycle | 3 | 2 |\n| `b` | 24 cycles (RTL) | 40 | 1 |\n<!-- /intervals -->\n"
KERNELS = {"a": ("// A.\n//\n// Interval: a word a\n// cycle.\n#ifndef A\n", "HS_PIPELINE(1)"),
           "b": ("// Interval of the RTL: 24 cycles.\n#ifndef B\n", "")}
AREA = "| `a` | 1,000 | 20 | 2 | 0 |\n"


def prove_that_it_fails():
    assert not list(faults(["a", "b"], KERNELS, PAGE, AREA))
    for case in ((["a"], KERNELS, PAGE, AREA), (["a", "b"], KERNELS, PAGE.replace("a word", "two words"), AREA),
                 (["a", "b"], {**KERNELS, "a": (KERNELS["a"][0], "")}, PAGE, AREA),
                 (["a", "b"], KERNELS, PAGE.replace(" (RTL)", ""), AREA),
                 (["a", "b"], KERNELS, PAGE, AREA.replace("| 2 |", "| 3 |"))):
        assert list(faults(*case)), case
    assert not list(without_label("a", "Lanes:\n  for (;;) {\n    HS_UNROLL\n"))
    assert list(without_label("a", "Lanes:\n  for (;;) {\n    HS_UNROLL\n    for (;;) {\n      HS_UNROLL\n"))


def source_of(root, name):
    files = (root / f"hls/top/{folder}{name}_top.cpp" for folder in ("", "film/"))
    return next((file for file in files if file.exists()), None)


def main():
    root = pathlib.Path(sys.argv[1])
    prove_that_it_fails()
    tops = [name for name in re.findall(r"^(\w+)", (root / "hls/top/tops.txt").read_text(), re.M)
            if source_of(root, name)]  # composed ones are in a folder of their own
    kernels, found = {}, []
    for path in sorted((root / "hls").glob("*/*.hpp")):
        found += without_label(path.relative_to(root), path.read_text())
        if top := source_of(root, path.stem):
            kernels[path.stem] = path.read_text(), path.read_text() + top.read_text()
    found += list(faults(tops, kernels, (root / "docs/port.md").read_text(), (root / "docs/area.md").read_text()))
    print("\n".join(found) or f"intervals: {len(kernels)} kernels")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
