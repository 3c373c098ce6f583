#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every bit of every vector set, as one hash a stream: run it before and after a change and compare.

    vectors/bits.py build/cli/halfspace > after.txt && diff before.txt after.txt

The named configurations and all of tests/configs: the set `standard`, with motion also `compensation`, with objects
also `merge`; and the package of formats of each. A line is: configuration, set, stream, SHA-256.
"""

import argparse
import hashlib
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def sets_of(text):
    yield "standard"
    if 'shading = "motion"' in text:
        yield "compensation"
    if "object_bits" in text and "object_bits = 0" not in text:
        yield "merge"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("halfspace", type=pathlib.Path, help="the program")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="of the sources (default: this tree)")
    parser.add_argument("--lanes", default="4", help="default: %(default)s")
    parser.add_argument("--only", default="", help="configurations whose name contains this")
    args = parser.parse_args()
    configs = [(name, name, "") for name in ("low", "middle", "high")]
    configs += sorted((path.stem, str(path), path.read_text())
                      for path in (args.root / "tests/configs").rglob("*.toml"))
    for name, config, text in configs:
        if args.only not in name:
            continue
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder)
            runs = [("package", ["package", "--config", config, "-o", out / "package.sv"])]
            runs += [(kind, ["vectors", kind, "--config", config, "--lanes", args.lanes, "--out", out / kind])
                     for kind in sets_of(text)]
            for kind, command in runs:
                done = subprocess.run([args.halfspace, *command], capture_output=True, text=True)
                if done.returncode:
                    print(f"bits: {name}, {kind}: {done.stderr.strip()}", file=sys.stderr)
                    return 1
                # The words of a package, without its comments, which name files.
                if kind == "package":
                    lines = [line for line in (out / "package.sv").read_text().splitlines()
                             if not line.lstrip().startswith("//")]
                    print(name, kind, "words", hashlib.sha256("\n".join(lines).encode()).hexdigest(), flush=True)
                for path in sorted((out / kind).glob("*.hex")) if (out / kind).exists() else []:
                    print(name, kind, path.stem, digest(path), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
