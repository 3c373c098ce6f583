#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What HS_PIPELINE and HS_UNROLL say of the loops of a top, by label, for a tool whose directives have to name them:
LABEL=interval or LABEL=unroll, a line a label. Labels of functions that this top does not call are among them.
Usage: loops.py SOURCE …: from anywhere; SOURCE is a file below hls/"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
LOOP = re.compile(r"^ *(\w+):\n *(?:HS_\w+ )?(?:for|while) \([^\n]*\n *(?:HS_PIPELINE\((\d+)\)|HS_(UNROLL)\b)?", re.M)
INCLUDE = re.compile(r'^#include "(hls/[^"]+)"', re.M)


def read_with(path, seen):
    """The file and what it includes, each once."""
    if path in seen or not path.exists():
        return
    text = path.read_text()
    seen[path] = text
    for name in INCLUDE.findall(text):
        read_with(ROOT / name, seen)


def loops(sources):
    """{label: interval, 'unroll' or '', where nothing is said}. Ends with a sentence where one label means two."""
    files = {}
    for source in sources:
        read_with(pathlib.Path(source).resolve(), files)
    found = {}
    for path, text in files.items():
        for label, interval, unroll in LOOP.findall(text):
            directive = interval or unroll.lower()
            if found.setdefault(label, directive) != directive:
                says = [f"'{said}'" if said else "left to the tool" for said in (directive, found[label])]
                sys.exit(f"{path.relative_to(ROOT)}: the loop {label} is {says[0]}, and in another file of the top "
                         f"{says[1]}: give it a label of its own")
    return found


if __name__ == "__main__":
    print("\n".join(f"{label}={said}" for label, said in loops(sys.argv[1:]).items() if said))
