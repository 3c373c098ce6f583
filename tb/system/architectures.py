#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The bytes that a scene moves to and from the memories of a frame, by architecture, as the reference counts them: what
the port of hs_system moved stands above. Usage: architectures.py HALFSPACE SCENE CONFIG FOLDER [options of `halfspace
render` …]"""
import json
import pathlib
import subprocess
import sys

ARCHITECTURES = {"alpha": "traditional", "beta": "deferred shading", "gamma": "index rendering, no Z-buffer",
                 "delta": "index rendering, Z-buffer"}


def bytes_of(halfspace, scene, config, folder, options, architecture):
    """Read and written, over all buffers."""
    report = pathlib.Path(folder) / f"{architecture}.json"
    subprocess.run([halfspace, "render", scene, "--config", config, "--engine", "ref", "--architecture", architecture,
                    "--json", str(report), "-o", str(report.with_suffix(".png")), *options], check=True,
                   stdout=subprocess.DEVNULL)
    buffers = json.loads(report.read_text())["buffers"].values()
    return sum(use["bytes_read"] for use in buffers), sum(use["bytes_written"] for use in buffers)


def main():
    halfspace, scene, config, folder, *options = sys.argv[1:]
    print(f"{'by architecture, bytes a frame':36} {'read':>12} {'written':>12} {'all':>12}")
    for name, what in ARCHITECTURES.items():
        read, written = bytes_of(halfspace, scene, config, folder, options, name)
        print(f"  {name:5} {what:28} {read:12,} {written:12,} {read + written:12,}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
