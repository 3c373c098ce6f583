#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A stream is said once, in hls/formats/streams.hpp: its name stands in few files besides. Names of two words and more
are counted, wherever they stand, as part of a port's name too; a name of one word, as scan or pixel, is a word of the
language as well and cannot be. ref/ is not looked at, as it knows no streams, nor the depths of the same streams, nor
the bench of the tops and the cases of pixels, which are tests.
Usage: streams_test.py HALFSPACE ROOT"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

WORLDS = ("hls", "rtl", "model", "vectors", "study", "cli", "tb")
MOST = 14  # of a port of hs_pipeline five are the tops that it stands in, and what those are made of
APART = ("hls/formats/stream_depths.hpp", "hls/top/bench", "hls/top/pixel")


def files_with(root, name):
    """A plural, as key_weights, is another name."""
    found = re.compile(rf"(?<![a-zA-Z0-9]){name}(?![a-zA-Z0-9])")
    for world in WORLDS:
        for path in sorted((root / world).rglob("*")):
            if any(part in str(path) for part in APART) or path.suffix not in (".hpp", ".cpp", ".sv", ".py", ".vlt"):
                continue
            if found.search(path.read_text()):
                yield str(path.relative_to(root))


def main():
    halfspace, root = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "streams.json"
        subprocess.run([halfspace, "streams", "--json", table], capture_output=True, check=True)
        names = [row["name"] for row in json.loads(table.read_text())]
    faults, counted = [], sorted({name for name in names if "_" in name})
    for name in counted:
        files = list(files_with(root, name))
        if "hls/formats/streams.hpp" not in files:
            faults.append(f"{name} is a stream, and hls/formats/streams.hpp has no such name")
        if len(files) > MOST:
            faults.append(f"{name} stands in {len(files)} files, and {MOST} are enough: {', '.join(files)}")
    if len(names) < 30 or len(counted) < 8:
        faults.append(f"only {len(names)} streams, {len(counted)} of them with two words: is that the table?")
    print("\n".join(faults) or f"streams: {len(names)}, none of the {len(counted)} counted in more than {MOST} files")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
