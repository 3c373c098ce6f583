#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The file that a board loads, with scenes in it: their triangle lists in block RAM, the pipeline, video output.

Before it is made the board's RTL is simulated, and the pictures of its video pins are compared with those of the
kernels, to the bit; after synthesis the same is done with the netlist. It ends with the part's utilisation and its
clocks. A scene is SCENE, or SCENE:FRAMES, so many frames of its animation, 30 a second; the button of the board goes
to the next one.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # no __pycache__ between the sources
import flow
import lists
import simulate
from boards import BOARDS
from units import CONFIG, constants  # flow.py makes the folder known

FRAMES = 3  # of video that are looked at: black while buffers are cleared, then the first picture


def package_of(halfspace, config, out):
    path = out / "hs_formats_pkg.sv"
    done = subprocess.run([halfspace, "package", "--config", config, "-o", path], capture_output=True, text=True)
    if done.returncode:
        raise flow.FlowError(done.stderr.strip().splitlines()[-1])
    return path


class Job:
    """What is built of a board with scenes, in a folder."""

    def __init__(self, board, halfspace, scenes, out, config=None):
        self.board, self.out, self.config = board, out, config or board.config
        out.mkdir(parents=True, exist_ok=True)
        self.package = package_of(halfspace, self.config, out)
        self.numbers = constants(self.package.read_text())
        bits, entries, self.pictures, colour = lists.lists(halfspace, str(self.config), scenes)
        self.triangles, self.firsts = len(entries), []
        for _, frames in scenes:
            self.firsts.append(sum(count for _, count in scenes[:len(self.firsts)]))
        self.background = lists.number_of(colour, self.numbers["ColourBits"])
        self.lists = out / "lists.hex"
        self.lists.write_text(lists.memory(entries, bits, board.entries))

    def title(self):
        return CONFIG.search(self.package.read_text()).group(1)

    def simulate(self, pressed=(), frames=FRAMES, netlist=None, cells=None, optimize="-O1"):
        """Which picture each frame of video is."""
        program = simulate.build(self.board, self.package, self.lists, self.background, self.out, netlist, cells,
                                 optimize=optimize)
        return simulate.shown(program, self.out, frames, self.pictures, self.numbers["ColourBits"], pressed)


def cells_of(yosys):
    """Yosys' models of the cells of iCE40."""
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder) / "log"
        flow.run([yosys, "-p", "read_verilog -lib +/ice40/cells_sim.v"], log)
        for line in log.read_text().splitlines():
            if "cells_sim.v" in line and "from `" in line:
                return pathlib.Path(line.split("from `")[1].split("'")[0])
    raise flow.FlowError("Yosys does not say where its ice40/cells_sim.v is")


def judge(frames, what):
    """At least one picture of the first scene, and none but black before it."""
    if 0 not in frames or any(number != -1 for number in frames[:frames.index(0)]):
        raise flow.FlowError(f"{what}: the video pins show {frames}, where −1 is black, and not picture 0")
    return f"{what}: {sum(number >= 0 for number in frames)} frames of the video pins equal the kernels' pictures"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", type=lists.scene, metavar="SCENE[:FRAMES]")
    parser.add_argument("--board", choices=sorted(BOARDS), required=True,
                        help=", ".join(f"{board.name}: {board.title}" for board in BOARDS.values()))
    parser.add_argument("--config", type=pathlib.Path, help="a configuration (default: the board's)")
    parser.add_argument("--halfspace", type=pathlib.Path, required=True, help="the program")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for all that is made")
    parser.add_argument("--seed", type=int, default=1, help="of nextpnr (default: %(default)s)")
    parser.add_argument("--netlist", action=argparse.BooleanOptionalAction, default=True,
                        help="simulate the netlist too")
    args = parser.parse_args()
    board, out = BOARDS[args.board], args.out.resolve()
    try:
        job = Job(board, args.halfspace.resolve(), args.scenes, out, args.config and args.config.resolve())
        print(f"{board.title}, {job.title()}: {len(job.pictures)} frames, {job.triangles} triangles of {board.entries}",
              flush=True)
        print(judge(job.simulate(), "RTL"), flush=True)
        flow.synthesize(board, job.package, job.lists, job.background, out)
        if args.netlist:
            print(judge(job.simulate(netlist=out / "netlist.v", cells=cells_of("yosys"), optimize="-O0"), "netlist"),
                  flush=True)
        found = flow.place(board, out, args.seed)
        print(flow.text(found))
        if missed := flow.late(found):
            raise flow.FlowError("; ".join(missed))
        print(f"{out / 'board.bin'}: {(out / 'board.bin').stat().st_size} bytes")
    except (flow.FlowError, lists.ListError, OSError) as error:
        print(f"bitstream: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
