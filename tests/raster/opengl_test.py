#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every fragment of lists of all shapes by the OpenGL of this machine: that of exact arithmetic. Usage: opengl_test.py
OPENGL_COMPARE"""
import json
import pathlib
import subprocess
import sys
import tempfile


def main():
    compare = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for config, triangles in (("middle", "200"), ("high", "20")):
            figures = folder / f"{config}.json"
            result = subprocess.run([compare, "--config", config, "--triangles", triangles, "--json", figures])
            lists = json.loads(figures.read_text())["lists"]
            fragments = sum(row["fragments"] for row in lists)
            differ = sum(row["coverage_differs"] + row["kernels_index_differs"] for row in lists)
            of_constant = sum(row["gpu_index_differs"] for row in lists if "constant" in row["name"])
            print(f"{config}: {len(lists)} lists, {fragments} fragments, {differ} pixels differ, "
                  f"{of_constant} where depths are constant")
            if result.returncode or differ or fragments < 100000:
                return 1
        # Vertices one unit off, as a snapping of its own would leave them.
        if subprocess.run([compare, "--triangles", "50", "--nudge"], stdout=subprocess.DEVNULL).returncode == 0:
            print("vertices that were moved were not noticed")
            return 1
        # No grid of 8 bits: refused, with a sentence.
        refused = subprocess.run([compare, "--config", "low"], capture_output=True, text=True)
        if refused.returncode == 0 or "sub-pixel bits" not in refused.stderr:
            print("low was not refused")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
