#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`halfspace stability` writes its numbers and pictures, and the numbers alone where gnuplot is missing.
Usage: stability_test.py HALFSPACE"""
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile


def run(folder, *options, path=None):
    command = [sys.argv[1], "stability", "--triangles", "4", "--out", str(folder), *options]
    environment = dict(os.environ, PATH=path) if path else None
    return subprocess.run(command, capture_output=True, text=True, check=False, env=environment)


def check(condition, what):
    if not condition:
        sys.exit(f"stability_test: {what}")


def main():
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary) / "it's here"
        result = run(folder, "--config", "low", "--json", str(folder) + ".json")
        check(result.returncode == 0, result.stderr)
        for name in ("stability_aspect.png", "stability_size.png"):
            picture = (folder / name).read_bytes()
            check(picture[:8] == b"\x89PNG\r\n\x1a\n" and len(picture) > 10000, f"{name} is no picture")
        with open(folder / "stability.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        numbers = json.loads((folder / "stability.json").read_text())
        copy = json.loads(pathlib.Path(str(folder) + ".json").read_text())
        check(numbers == copy, "--json differs from stability.json")
        check(len(rows) == 8 * (len(numbers["aspect"]) + len(numbers["size"])), f"{len(rows)} rows in stability.csv")
        check(numbers["reachable_aspect_log2"] == 29 and "beyond 2^29 the grid of low" in result.stdout, result.stdout)
        for point in numbers["aspect"] + numbers["size"]:
            error = point["depth"]["kernels"]["largest_lsb"]
            check(error <= numbers["bound_lsb"]["depth"], f"{error} is beyond the bound")
        check(sorted(p.name for p in folder.iterdir()) == ["stability.csv", "stability.json", "stability_aspect.png",
                                                           "stability_size.png"], "other files were left")

        folder = pathlib.Path(temporary) / "numbers"
        result = run(folder, "--aspect", "3", path="/nowhere")
        check(result.returncode == 1 and "install gnuplot-nox" in result.stderr, f"without gnuplot: {result.stderr}")
        names = sorted(p.name for p in folder.iterdir())
        check(names == ["stability.csv", "stability.json"], f"without gnuplot: {names}")
        check(run(folder, "--config", "none").returncode == 1, "a configuration that there is not")
    print("stability: numbers and pictures")


if __name__ == "__main__":
    main()
