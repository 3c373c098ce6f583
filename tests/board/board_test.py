#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A board simulated at its pins: each frame of video is a picture of the kernels, to the bit; the button goes to the
next scene; a picture that differs in one pixel is found. With --whole: the file that the board loads is made, and the
netlist after synthesis is simulated as well.
Usage: board_test.py SOURCE HALFSPACE VERILATOR BOARD OUT [CONFIG] [--whole]"""
import pathlib
import subprocess
import sys
import unittest

SOURCE, HALFSPACE, VERILATOR, BOARD, OUT = sys.argv[1:6]
CONFIG = pathlib.Path(sys.argv[6]).resolve() if len(sys.argv) > 6 and sys.argv[6] != "--whole" else None
sys.path.insert(0, str(pathlib.Path(SOURCE).resolve() / "rtl" / "board"))
import bitstream  # noqa: E402
import flow  # noqa: E402
import lists  # noqa: E402
import simulate  # noqa: E402
from boards import BOARDS  # noqa: E402

SCENES = [("cube", 1), ("cube_slow", 3)]


class Rtl(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.board = BOARDS[BOARD]
        cls.job = bitstream.Job(cls.board, pathlib.Path(HALFSPACE).resolve(), SCENES, pathlib.Path(OUT).resolve(),
                                CONFIG)
        cls.program = simulate.build(cls.board, cls.job.package, cls.job.lists, cls.job.background, cls.job.out,
                                     verilator=VERILATOR)

    def shown(self, frames, pressed=(), pictures=None):
        return simulate.shown(self.program, self.job.out, frames, pictures or self.job.pictures,
                              self.job.numbers["ColourBits"], pressed)

    def test_pins_show_the_pictures_and_the_button_goes_on(self):
        frames = self.shown(9, pressed=["2"])
        while frames[0] == -1:  # buffers are cleared
            frames.pop(0)
        self.assertGreaterEqual(len(frames), 7)
        scene = frames.index(1)
        self.assertEqual(set(frames[:scene]), {0})
        # Each frame of the animation twice, and from the first one again.
        self.assertEqual(frames[scene:], [1, 1, 2, 2, 3, 3, 1, 1][:len(frames) - scene])

    def test_one_wrong_pixel_is_found(self):
        wrong = [[list(row) for row in rows] for rows in self.job.pictures]
        red, green, blue = wrong[0][0][0]
        wrong[0][0][0] = (red, green, blue ^ 1)
        with self.assertRaisesRegex(flow.FlowError, "is no picture of the kernels"):
            self.shown(3, pictures=wrong)

    def test_lint_is_clean(self):
        given = flow.parameters(self.board, self.job.lists, self.job.background)
        board = [path for path in flow.sources(self.board, self.job.package) if path != self.board.top]
        command = [VERILATOR, "--lint-only", "-Wall", "-Wno-UNUSEDPARAM", "--top-module", "hs_board",
                   *(f"-G{name}={value}" for name, value in given.items()),
                   pathlib.Path(SOURCE).resolve() / "tb" / "lint.vlt", *board]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, cwd=self.job.out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_too_many_triangles_are_refused(self):
        with self.assertRaisesRegex(lists.ListError, "there is room for 2"):
            lists.memory([1, 2, 3], 8, 2)
        with self.assertRaisesRegex(lists.ListError, "do not fit configuration"):
            lists.frame(HALFSPACE, str(self.job.config), "wheel", 0)

    def test_a_clock_that_is_missed_is_told(self):
        found = {"cells": {}, "clocks": {"clk_pixel": (25.0, 25.125)},
                 "delays": {"clk_half to clk_pixel": (40.0, 39.8)}}
        self.assertEqual(len(flow.late(found)), 2)


class Whole(unittest.TestCase):
    def test_the_file_is_made(self):
        out = pathlib.Path(OUT).resolve()
        tool = pathlib.Path(SOURCE) / "rtl" / "board" / "bitstream.py"
        command = [sys.executable, tool, "--board", BOARD, "--halfspace", HALFSPACE, "--out", out, "cube"]
        done = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        for said in ("RTL: [23] frames of the video pins equal", "netlist: [23] frames of the video pins equal",
                     "MHz, 25.1250 needed", "board.bin: "):
            self.assertRegex(done.stdout, said)


if __name__ == "__main__":
    whole = "--whole" in sys.argv
    unittest.main(argv=sys.argv[:1], defaultTest="Whole" if whole else "Rtl")
