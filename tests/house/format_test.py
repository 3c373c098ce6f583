#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on what `make -f Makefile.sim format` would change, and on lines that are too long.
Usage: format_test.py ROOT [--write]

A line of C++, Python, CMake, make, shell and Markdown has 120 characters at most, one of SystemVerilog 100. Apart from
that: packages that `halfspace package` prints; in Markdown tables, code, and what a link points to. Configurations and
lists (.toml, .txt) have a line an entry. --write mends what can be mended: clang-format, blanks at the end of a line,
the last newline.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from sources import CPP, SV, is_list, is_package, sources


def badly_formatted(paths):
    """The C++ files that clang-format would change."""
    run = subprocess.run(["clang-format", "--dry-run", *map(str, paths)], capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stderr)
    return sorted(set(re.findall(r"^(.+?):\d+:\d+: warning: code should be clang-formatted", run.stderr, re.M)))


def prose(text):
    """The lines of Markdown with what may be longer left out: code, tables, what links point to."""
    text = re.sub(r"^(```|~~~).*?^\1", lambda code: "\n" * code.group().count("\n"), text, flags=re.M | re.S)
    for line in text.split("\n"):
        yield "" if line.startswith("|") else re.sub(r"\]\([^)]*\)|https?://\S+", "", line)


def tidied(path, text):
    """Without blanks at the ends of lines, with one newline at the end of the file; tabs in makefiles alone."""
    lines = [line.rstrip() for line in text.split("\n")]
    if not path.name.startswith("Makefile"):
        lines = [line.expandtabs(4) for line in lines]
    return "\n".join(lines).rstrip("\n") + "\n" if text else ""


def faults(root):
    paths = sources(root)
    formatted = [path for path in paths if path.suffix in CPP]
    for name in badly_formatted(formatted) if formatted else []:
        yield f"{pathlib.Path(name).relative_to(root)}: is not as clang-format has it"
    for path in paths:
        here, text = path.relative_to(root), path.read_text(encoding="utf-8")
        if text != tidied(path, text):
            yield f"{here}: has tabs, blanks at the end of a line, or not one newline at its end"
        limit = 100 if path.suffix in SV else 120
        lines = prose(text) if path.suffix == ".md" else text.split("\n")
        for number, line in enumerate(lines, 1):
            if len(line) > limit and not is_package(path) and not is_list(path):
                yield f"{here}:{number}: {len(line)} characters, more than {limit}"


# Files with a fault each, and files without one.
BROKEN = {"a.cpp": "int  a;\n", "b.sv": "/" * 101 + "\n", "c.py": "#" * 121 + "\n", "d.py": "a = 1 \n", "e.py": "a = 1",
          "f.cmake": "\tset(a)\n", "g.md": "a " * 60 + "b\n", "h.md": "```\na\n```\n" + "b" * 121 + "\n",
          "i.md": "a\n\n\n", "Makefile": "#" * 121 + "\n", "j.sh": "#" * 121 + "\n", "CMakeLists.txt": "#" * 121 + "\n"}
SOUND = {"hs_formats_pkg.sv": "/" * 101 + "\n", "k.sv": "/" * 100 + "\n", "l.py": "#" + "é" * 119 + "\n",
         "m.md": "|" * 121 + "\n\n```\n" + "a" * 121 + "\n```\n[a](" + "b" * 121 + ")\n", "n.toml": "#" * 121 + "\n",
         "Makefile.sim": "a:\n\tb\n", "empty.py": ""}


def prove_that_it_fails():
    """Each rule finds its fault, and what is allowed has none."""
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for file, text in (BROKEN | SOUND).items():
            (root / file).write_text(text, encoding="utf-8")
        found = {fault.split(":")[0] for fault in faults(root)}
    if found != set(BROKEN):
        sys.exit(f"the test itself is broken: {sorted(found ^ set(BROKEN))}")


def write(root):
    for path in sources(root):
        text = path.read_text(encoding="utf-8")
        if text != tidied(path, text):
            path.write_text(tidied(path, text), encoding="utf-8")
    subprocess.run(["clang-format", "-i", *(str(path) for path in sources(root) if path.suffix in CPP)], check=True)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which("clang-format"):
        sys.exit("clang-format is not installed: apt-get install clang-format")
    prove_that_it_fails()
    if "--write" in sys.argv[2:]:
        write(root)
    found = list(faults(root))
    print("\n".join(found) or f"format: {len(sources(root))} files are as they should be")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
