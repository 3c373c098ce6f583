#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/add_a_unit.md, walked through: its blocks make the unit in a copy of the tree, where the kernel keeps its test
(and a wrong one does not), both compositions have it, lint is clean and the arrows hold.
Usage: walk_test.py ROOT [--apply: makes the unit in ROOT itself]"""
import pathlib
import re
import subprocess
import sys
import tempfile

from pasting import copy_of

PAGE = "docs/add_a_unit.md"
LEAST_FILES, LEAST_EDITS = 3, 6
# Both ends of the new stream by the table, and a stamp through the composition.
COMPOSITION = """
#include <cstdio>
#include <cstring>
#include "hls/formats/configs/low.hpp"
#include "hls/formats/formats.hpp"
#include "hls/pipeline/pipeline.hpp"
using namespace halfspace;
using F = Formats<Low, Stamp4>;
struct Ends {
  template <class S>
  void operator()(S&, const StreamRow& row) {
    if (!std::strcmp(row.name, "tinted") || !std::strcmp(row.name, "pixel"))
      std::printf("%s: %s to %s\\n", row.name, row.from, row.to);
  }
};
int main() {
  static Streams<F> s;
  static Buffers<F> b;
  Frame<F> frame{};
  frame.r = from_raw<F::Colour>(255), frame.g = from_raw<F::Colour>(0), frame.b = from_raw<F::Colour>(0);
  s.visit(Ends());
  Scan<F> scan{};
  s.scan.write(scan);
  pipeline_shade(frame, s, b);
  const Pixel<F> pixel = s.pixel.read();
  std::printf("red is %d %d %d\\n", int(raw(pixel.r[3])), int(raw(pixel.g[3])), int(raw(pixel.b[3])));
}
"""
SAYS = "tinted: shade_gouraud to shade_grey\npixel: shade_grey to frame\nred is 77 77 77\n"


class Fault(Exception):
    pass


def run(command, folder, fails=False):
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, check=False)
    if bool(done.returncode) != fails:
        what = "did not fail" if fails else "failed"
        raise Fault(f"{' '.join(map(str, command))}\n{what}: {done.stdout}{done.stderr}")
    return done.stdout


def edits(block):
    """(path, old lines, new lines) of each hunk of a diff; line numbers do not count."""
    path = ""
    for part in re.split(r"^(?=--- a/|@@)", block, flags=re.MULTILINE):
        if part.startswith("--- a/"):
            path = re.search(r"^\+\+\+ b/(\S+)$", part, re.MULTILINE).group(1)
        elif part.startswith("@@"):
            lines = part.splitlines()[1:]
            yield (path, "".join(line[1:] + "\n" for line in lines if line[:1] != "+"),
                   "".join(line[1:] + "\n" for line in lines if line[:1] != "-"))


def apply(folder, text):
    """Makes the files and the edits of the page. Returns how many of each."""
    files = changed = 0
    for kind, path, block in re.findall(r"^```(\w+) ?(\S*)\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        if path:
            (folder / path).write_text(block)
            files += 1
        elif kind == "diff":
            for name, old, new in edits(block):
                source = (folder / name).read_text()
                if source.count(old) != 1:
                    raise Fault(f"{PAGE}: {name} has these lines {source.count(old)} times, not once:\n{old}")
                (folder / name).write_text(source.replace(old, new))
                changed += 1
    if files < LEAST_FILES or changed < LEAST_EDITS:
        raise Fault(f"{PAGE}: only {files} files and {changed} edits were found")
    return files, changed


def check_kernel(folder):
    compile_it = ["c++", "-std=c++17", "-I.", "tests/shade/grey_test.cpp", "-lgtest_main", "-lgtest", "-pthread", "-o"]
    run([*compile_it, folder / "build/grey_test"], folder)
    run([folder / "build/grey_test"], folder)
    kernel = folder / "hls/shade/shade_grey.hpp"
    right = kernel.read_text()
    kernel.write_text(right.replace("150 *", "140 *"))
    run([*compile_it, folder / "build/wrong_test"], folder)
    run([folder / "build/wrong_test"], folder, fails=True)
    kernel.write_text(right)


def check_composition(folder):
    (folder / "build/composition.cpp").write_text(COMPOSITION)
    run(["c++", "-std=c++17", "-I.", "build/composition.cpp", "-o", folder / "build/composition"], folder)
    says = run([folder / "build/composition"], folder)
    if says != SAYS:
        raise Fault(f"the composition says\n{says}instead of\n{SAYS}")


def check_rtl(folder):
    files = run([sys.executable, "rtl/files.py", "--config", "low"], folder).split()
    if not any(name.endswith("hs_shade_grey.sv") for name in files):
        raise Fault("hs_pipeline does not have hs_shade_grey")
    for top in ("hs_shade_grey", "hs_pipeline"):
        files = run([sys.executable, "rtl/files.py", "--config", "low", "--top", top], folder).split()
        lanes = ["-GLanesX=2", "-GLanesY=2"]
        run(["verilator", "--lint-only", "-Wall", "--top-module", top, *lanes, "tb/lint.vlt", *files], folder)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    text = (root / PAGE).read_text()
    try:
        if "--apply" in sys.argv:
            print("%d files made, %d places changed" % apply(root, text))
            return 0
        with tempfile.NamedTemporaryFile() as nothing, copy_of(root, nothing.name) as folder:
            files, changed = apply(folder, text)
            for command in re.findall(r"^python3 rtl/files.py .*$", text, re.MULTILINE):
                run(["sh", "-c", command], folder)
            check_kernel(folder)
            check_composition(folder)
            check_rtl(folder)
            run([sys.executable, "tests/house/arrows_test.py", folder], folder)
    except Fault as fault:
        print(fault)
        return 1
    print(f"{PAGE}: {files} files and {changed} edits make a unit that passes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
