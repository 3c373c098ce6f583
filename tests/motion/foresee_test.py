#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the motion foresees of the frames between keys, against what comes out: the ranks agree, and `--keys auto` has
fewer keys for less. Usage: foresee_test.py HALFSPACE"""
import json
import pathlib
import subprocess
import sys
import tempfile

HALFSPACE = sys.argv[1]
LEAST = 0.9  # of the rank correlation over all intervals of the ten animations


def run(folder, *words):
    figures = folder / "figures.json"
    done = subprocess.run([HALFSPACE, *words, "--json", figures], capture_output=True, text=True)
    return done, json.loads(figures.read_text()) if done.returncode == 0 else None


def ranks(values):
    order = sorted(values)
    return [(order.index(v) + len(order) - 1 - order[::-1].index(v)) / 2 for v in values]


def rank_correlation(a, b):
    a, b = ranks(a), ranks(b)
    mean = (len(a) - 1) / 2
    both = sum((x - mean) * (y - mean) for x, y in zip(a, b))
    return both / (sum((x - mean) ** 2 for x in a) * sum((y - mean) ** 2 for y in b)) ** 0.5


def faults(folder):
    _, figures = run(folder, "foresee")
    rows = figures["intervals"]
    rank = rank_correlation([row["foreseen_db"] for row in rows], [row["measured_db"] for row in rows])
    if len(rows) < 100 or rank < LEAST:
        yield f"foresee: {len(rows)} intervals, rank correlation {rank:.3f}, at least {LEAST} is wanted"
    if abs(rank - figures["rank_correlation"]) > 1e-6:
        yield f"foresee: says a rank correlation of {figures['rank_correlation']}, and it is {rank:.6f}"
    if rank_correlation([row["key"] for row in rows], [row["measured_db"] for row in rows]) > LEAST:
        yield "the number of a key foresees as well as the motion does: the test shows nothing"
    keys = [len(run(folder, "quality", "jet", "--size", "160x120", "--keys", "auto", "--psnr", str(psnr))[1]["keys"])
            for psnr in (40, 46, 50)]
    if not keys[0] <= keys[1] <= keys[2] or keys[0] == keys[2]:
        yield f"--keys auto: {keys} keys for 40, 46, 50 dB"
    nine = run(folder, "quality", "cube_slow", "--size", "80x60", "--keys", "1:9")[1]["keys"]
    if nine[:3] != [0, 10, 20]:
        yield f"--keys 1:9: {nine}"
    for words in (("--texture", "bilinear"), ("--samples", "4"), ("--method", "straight")):
        done, _ = run(folder, "quality", "jet", "--size", "80x60", "--keys", "auto", *words)
        if done.returncode == 0 or "--keys measured" not in done.stderr:
            yield f"--keys auto {' '.join(words)}: was not refused: {done.stderr}"


with tempfile.TemporaryDirectory() as name:
    found = list(faults(pathlib.Path(name)))
print("\n".join(found) or "foresee: ranks agree")
sys.exit(1 if found else 0)
