#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`halfspace static` on scenes of all kinds: it holds each frame to that of drawing everything itself; here its figures
are held to each other, and what it cannot do is refused with a sentence. Usage: static_command_test.py HALFSPACE ROOT
MODELS"""
import json
import pathlib
import subprocess
import sys
import tempfile

HALFSPACE, ROOT, MODELS = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
TEXTURED = str(ROOT / "tests/configs/objects/objects_phong.toml")
SIZE = ("--size", "80x60")
COURT = ("court", "--frames", "20:26")


def static(*words):
    with tempfile.TemporaryDirectory() as folder:
        figures = pathlib.Path(folder) / "figures.json"
        done = subprocess.run([HALFSPACE, "static", *words, *SIZE, "--json", figures], capture_output=True, text=True)
        return done, json.loads(figures.read_text()) if done.returncode == 0 else None


def faults_of(words, spares):
    done, figures = static(*words)
    if not figures:
        yield done.stderr
        return
    rows = figures["frames"]
    for which in ("cycles", "all_cycles"):
        mean = sum(row[which] for row in rows[1:]) / (len(rows) - 1)
        if abs(mean - figures[which]) > 1e-6 * mean:
            yield f"{which} are {figures[which]} in the mean, and those of the frames {mean}"
    if spares and not figures["cycles"] < figures["all_cycles"]:
        yield "what stands still spares nothing"
    if any(row["skipped"] > row["queries"] or row["queries"] > row["started"] for row in rows):
        yield "more was skipped than asked, or asked than began to move"
    if "--no-query" in words and any(row["queries"] for row in rows):
        yield "asked without a query"


def faults():
    for words, spares in [(COURT, True), ((*COURT, "--buffers", "3"), True), ((*COURT, "--no-query"), True),
                          (("drone", "--frames", "0:4", "--config", "high"), False),
                          ((str(MODELS / "ASE/anim2.ASE"), "--frames", "0:6"), False)]:
        yield from (f"{' '.join(words)}: {fault}" for fault in faults_of(words, spares))
    fast, slow = static(*COURT)[1], static(*COURT, "--clock", "50")[1]
    if abs(fast["frames_a_second"] - 2 * slow["frames_a_second"]) > 1e-6 * fast["frames_a_second"]:
        yield "half the clock is not half the frames a second"
    for words, says in [(("teapot",), "animated"), (("court", "--frames", "0:1"), "more --frames"),
                        ((*COURT, "--config", str(ROOT / "tests/configs/base/gouraud_only.toml")), "with depth"),
                        ((*COURT, "--config", TEXTURED), "")]:
        done, figures = static(*words)
        if figures or says not in done.stderr or done.stderr.count("\n") != 1:
            yield f"{' '.join(words)}: ended with {done.returncode}: {done.stderr}"


found = list(faults())
print("\n".join(found) or "static: scenes of all kinds, and what is refused")
sys.exit(1 if found else 0)
