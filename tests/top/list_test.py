#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""hls/top/tops.txt, which the scripts of hls/tools read, names the tops that there are: those of hls/top/*_top.cpp, of
hls/top/tops.hpp and of the bench; and what it says of one exists. Usage: list_test.py ROOT"""
import pathlib
import re
import sys
import tempfile

SCENES = ("standard", "merge", "compensation", "between", "static_frames", "film")
BUILT_IN = ("low", "middle", "high")


def rows(root):
    lines = (root / "hls/top/tops.txt").read_text().splitlines()
    return [line.split() for line in lines if line and not line.startswith("#")]


def difference(where, there, listed):
    for name in sorted(there - listed):
        yield f"hls/top/tops.txt: has no line for {name}, which {where} has"
    for name in sorted(listed - there):
        yield f"hls/top/tops.txt: names {name}, which {where} has not"


def faults(root):
    top = root / "hls/top"
    listed = [row[0] for row in rows(root)]
    yield from (f"hls/top/tops.txt: names {name} twice" for name in sorted(set(listed)) if listed.count(name) > 1)
    listed = set(listed)
    sources = {path.name.removesuffix("_top.cpp") for path in top.rglob("*_top.cpp")}
    yield from difference("hls/top/*_top.cpp", sources, listed)
    declared = set(re.findall(r"^void (\w+)_top\(", (top / "tops.hpp").read_text(), re.M))
    yield from difference("hls/top/tops.hpp", declared, listed)
    driven = {name for path in (top / "bench").glob("*.hpp") for name in
              re.findall(r"^void frame_of_(\w+)\(", path.read_text(), re.M)}
    yield from difference("hls/top/bench", driven, listed)
    for name, *rest in rows(root):
        if len(rest) != 2:
            yield f"hls/top/tops.txt: {name}: a line has a name, a scene and a configuration"
            continue
        scene, config = rest
        if scene not in SCENES:
            yield f"hls/top/tops.txt: {name}: the scene is one of {', '.join(SCENES)}, not {scene}"
        if config not in BUILT_IN and not (root / config).is_file():
            yield f"hls/top/tops.txt: {name}: there is no configuration {config}"


LIST = """# a comment
a standard low
b static c.toml
c merge high
c merge high
d
"""


def prove_that_it_fails():
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        (root / "hls/top/bench").mkdir(parents=True)
        for top in "abcde":
            (root / f"hls/top/{top}_top.cpp").write_text("")
        (root / "hls/top/tops.txt").write_text(LIST)
        (root / "hls/top/tops.hpp").write_text("".join(f"void {top}_top(int a);\n" for top in "abdf"))
        (root / "hls/top/bench/frames.hpp").write_text("".join(f"void frame_of_{top}(B& b) {{\n" for top in "abc"))
        found = {fault.removeprefix("hls/top/tops.txt: ") for fault in faults(root)}
    expected = {"names c twice", "has no line for e, which hls/top/*_top.cpp has",
                "has no line for f, which hls/top/tops.hpp has", "names c, which hls/top/tops.hpp has not",
                "names d, which hls/top/bench has not", "d: a line has a name, a scene and a configuration",
                "b: the scene is one of standard, merge, compensation, between, static_frames, film, not static",
                "b: there is no configuration c.toml"}
    if found != expected:
        sys.exit(f"the test itself is broken: {sorted(found ^ expected)}")


def main():
    prove_that_it_fails()
    root = pathlib.Path(sys.argv[1]).resolve()
    found = list(faults(root))
    print("\n".join(found) or f"tops: {len(rows(root))}, as the sources have them")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
