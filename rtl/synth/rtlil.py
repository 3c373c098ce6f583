# SPDX-License-Identifier: Apache-2.0
"""Modules in the text of RTLIL: what they declare, and the order and names of what they hold."""

import random
import re

TOP = "part"  # the module of a part in its text


def memories(body):
    found = re.findall(r"^  memory(?: width (\d+))?(?: size (\d+))?(?: offset \d+)? \S+$", body, re.MULTILINE)
    return [(int(words or 1), int(width or 1)) for width, words in found]


def ports(body):
    found = re.findall(r"^  wire(?: width (\d+))?(?: \w+ \d+)*? (input|output) \d+(?: signed)? \\(\S+)$", body,
                       re.MULTILINE)
    return sorted((name, int(width or 1), direction) for width, direction, name in found)


def module(name, body, box=False):
    """The text of a module; of a black box its ports alone."""
    if not box:
        return f"module {name}\n{body}end\n"
    lines = [line for line in body.splitlines(True) if re.match(r"  wire .*\b(?:input|output) \d+", line)]
    return f"attribute \\blackbox 1\nmodule {name}\n{''.join(lines)}end\n"


def statements(body):
    """The statements of a module, each with its attributes."""
    return re.findall(r"(?:^  attribute .*\n)*^  (?:cell .*\n(?:    .*\n)*  end|(?!attribute|cell).*)\n", body,
                      re.MULTILINE)


def canonical(text):
    """The text with its own numbering of the names that Yosys made up, which hold a line and a counter.

    Statements are sorted by name with numbers as numbers, so that a digit more changes nothing. Types of cells stay.
    """
    names, lines = {}, []
    for head, body in re.findall(r"^(.*?^module .*?\n)(.*?)^end$", text, re.MULTILINE | re.DOTALL):
        lines += [head.lstrip("\n"), *sorted(statements(body), key=natural), "end\n"]
    return re.sub(r"(?<=\s)\$\S*[$\\]\S*", lambda found: names.setdefault(found.group(), f"$n${len(names)}"),
                  "".join(lines))


def reordered(text, seed):
    """The text with the cells of TOP in the order of this seed; 0 leaves them as they are."""
    found = re.search(rf"^module \\{TOP}\n(.*?)^end$", text, re.MULTILINE | re.DOTALL)
    kinds = {"cell": [], "connect": [], "other": []}
    for statement in statements(found.group(1)):
        kind = re.match(r"(?:  attribute .*\n)*  (\w+)", statement).group(1)
        kinds[kind if kind in kinds else "other"].append(statement)
    if seed:
        random.Random(seed).shuffle(kinds["cell"])
    body = "".join([*kinds["other"], *kinds["cell"], *kinds["connect"]])
    return text[:found.start(1)] + body + text[found.end(1):]


def natural(statement):
    """What is declared comes first; then by name (the last word of the line, but for connections), numbers as
    numbers."""
    words = re.sub(r"^  attribute .*\n", "", statement, flags=re.MULTILINE).split("\n", 1)[0].split()
    name = " ".join(words[1:]) if words[0] == "connect" else words[-1]
    kind = ("parameter", "wire", "memory", "cell", "connect").index(words[0])
    return kind, [(int(word), "") if word.isdigit() else (-1, word) for word in re.split(r"(\d+)", name)]
