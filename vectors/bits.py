#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every bit of every vector set, as one hash a stream.

    vectors/bits.py build/cli/halfspace > vectors/standard/bits.sha256         what there is
    vectors/bits.py build/cli/halfspace --held vectors/standard/bits.sha256    fails where it is not what there was

The named configurations and all of tests/configs: `standard` and `rare`, with motion also `compensation` and `between`,
with objects also `merge` and `static_frames`, the extremes of each of these and of light and texture; of one that makes
films the set `film` alone; and the package of formats of each.
A line is: configuration, set, stream, SHA-256.
"""

import argparse
import hashlib
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def sets_of(text):
    if "frames_between" in text and "frames_between = 0" not in text:
        yield "film"
        return
    yield "standard"
    yield "rare"
    moves = 'shading = "motion"' in text
    has_objects = "object_bits" in text and "object_bits = 0" not in text
    if moves:
        yield from ("compensation", "between", "compensation_extremes")
    if has_objects:
        yield from ("merge", "merge_extremes", "static_frames")
    if moves or has_objects or "lights = " in text or "texture = " in text:
        yield "extremes"


def configurations(root):
    """(name, what names it to the program, its text) of each."""
    files = sorted((root / "tests/configs").rglob("*.toml"), key=lambda path: path.stem)
    return [(name, name, "") for name in ("low", "middle", "high")] + [(p.stem, str(p), p.read_text()) for p in files]


def lines_of(halfspace, lanes, name, config, text):
    """The lines of one configuration. Throws CalledProcessError."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder)
        runs = [("package", ["package", "--config", config, "-o", out / "package.sv"])]
        runs += [(kind, ["vectors", kind, "--config", config, "--lanes", lanes, "--out", out / kind])
                 for kind in sets_of(text)]
        for kind, command in runs:
            subprocess.run([halfspace, *command], capture_output=True, text=True, check=True)
            for path in sorted((out / kind).glob("*.hex")):
                yield f"{name} {kind} {path.stem} {hashlib.sha256(path.read_bytes()).hexdigest()}"
        # The words of the package, without its comments, which name files.
        words = [line for line in (out / "package.sv").read_text().splitlines() if not line.lstrip().startswith("//")]
        yield f"{name} package words {hashlib.sha256(chr(10).join(words).encode()).hexdigest()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("halfspace", type=pathlib.Path, help="the program")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="of the sources (default: this tree)")
    parser.add_argument("--lanes", default="4", help="default: %(default)s")
    parser.add_argument("--only", default="", help="configurations whose name contains this")
    parser.add_argument("--held", type=pathlib.Path, help="a file of such lines to compare with, instead of printing")
    args = parser.parse_args()
    chosen = [each for each in configurations(args.root) if args.only in each[0]]
    found = []
    try:
        for each in chosen:
            found += sorted(lines_of(args.halfspace, args.lanes, *each))
    except subprocess.CalledProcessError as failure:
        print(f"bits: {' '.join(map(str, failure.cmd))}: {failure.stderr.strip()}", file=sys.stderr)
        return 1
    if not args.held:
        print("\n".join(found))
        return 0 if found else 1
    names = {name for name, _, _ in chosen}
    held = [line for line in args.held.read_text().splitlines() if line.split()[0] in names or not args.only]
    wrong = sorted(set(found) ^ set(held))
    for line in wrong:
        print("now" if line in set(found) else "was", line)
    print(f"bits: {len(found)} streams and packages, {len(wrong)} lines differ from {args.held}")
    return 1 if wrong or not found else 0


if __name__ == "__main__":
    sys.exit(main())
