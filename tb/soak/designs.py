# SPDX-License-Identifier: Apache-2.0
"""Designs of configurations that nobody named: what `halfspace config --random` draws, its modules, the scenes that
these are tried on, and how a bench judges them."""
import json
import pathlib
import re
import subprocess
import sys

TB = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TB), str(TB.parent / "rtl")]
from model import Broken, build  # noqa: E402,F401
from units import FILM, OBJECTS, RTL, constants  # noqa: E402

FILMS = ("cube_slow", "cube_fast", "cube_zoom")  # few triangles: any configuration takes them


class Refused(Exception):
    """What a program said before it gave up."""


def run(command, seconds=600):
    """(exit status, what it said); 124: it did not end."""
    try:
        said = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return 124, f"no end in {seconds} s: {' '.join(map(str, command))}"
    return said.returncode, said.stdout + said.stderr


def demand(command):
    status, said = run(command)
    if status:
        raise Refused(f"{' '.join(map(str, command))}: {said.strip()}")
    return said


class Design:
    """A configuration in a folder: its file, its package, its numbers, and modules that stand for all of it."""

    def __init__(self, halfspace, folder, toml):
        self.halfspace, self.folder, self.toml = halfspace, pathlib.Path(folder), toml
        self.package = self.folder / "hs_formats_pkg.sv"
        demand([halfspace, "package", "--config", toml, "-o", self.package])
        self.numbers = constants(self.package.read_text())
        text = pathlib.Path(toml).read_text()
        self.name = re.search(r'^name = "(.*)"', text, re.MULTILINE)[1]
        self.lanes = int(re.search(r"^lanes = (\d+)", text, re.MULTILINE)[1])
        # A film's design stands in the place of the pipeline; with objects the pipeline is in one more.
        self.tops = ["hs_up_convert"] if FILM(self.numbers) else ["hs_pipeline"]
        if OBJECTS(self.numbers):
            self.tops.append("hs_static_frames")

    def build(self, top, libraries, rtl=RTL, **options):
        return build(self.package, self.lanes, top, self.folder / top, libraries, rtl=rtl, **options)

    def scene(self, top, draw, frames=4):
        """A random set for a module: what stands behind `halfspace vectors`; None where there is no set."""
        width, height = self.numbers["MaxWidth"], self.numbers["MaxHeight"]
        seed = draw.randrange(1, 1 << 31)
        if top == "hs_up_convert":
            size = f"{draw.randint(1, width)}x{draw.randint(1, height)}"
            return [draw.choice(FILMS), "--size", size, "--first", draw.randrange(60), "--intervals", frames]
        if top == "hs_static_frames":
            objects = min(draw.randint(1, 8), (1 << self.numbers["ObjectBits"]) - 2)
            if objects < 1:
                return None
            size = f"{draw.randint(1, min(width, 48))}x{draw.randint(1, min(height, 40))}"
            return ["static_frames", "--size", size, "--objects", objects, "--frames", frames,
                    "--buffers", draw.randint(1, 3), "--seed", seed, draw.choice(("--query", "--no-query"))]
        return ["standard", "--random", frames, "--random-triangles", draw.randint(1, 400), "--seed", seed]

    def vectors(self, scene, out):
        demand([self.halfspace, "vectors", *scene, "--config", self.toml, "--lanes", self.lanes, "--out", out])


def drawn(halfspace, folder, seed, small):
    """The design that a seed draws, in a folder that is made."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    toml = folder / "config.toml"
    demand([halfspace, "config", "--random", seed, *(["--small"] if small else []), "--toml", toml])
    return Design(halfspace, folder, toml)


def judge(bench, vectors, stall, seed, report):
    """(run of the report, what is wrong or ''). A stream without words is a fault of the set, which this lets pass."""
    report = pathlib.Path(report)
    report.unlink(missing_ok=True)
    status, said = run([bench, vectors, "--stall", stall, "--seed", seed, "--json", report])
    if not report.exists():
        return {}, f"exit status {status}: {said.strip()[-2000:]}"
    runs = json.loads(report.read_text())["runs"]
    failures = [failure for one in runs for failure in one["failures"] if not failure.startswith("empty: ")]
    if not runs or not runs[0]["words"]:
        failures.append("nothing was compared")
    if failures or any(one["mismatches"] for one in runs):
        return runs[0] if runs else {}, said.strip()[:4000] or "\n".join(failures)
    return runs[0], ""


def stalls(draw):
    """Percent: none, few, many."""
    return draw.choice((0, draw.randint(1, 40), draw.randint(41, 90)))
