# SPDX-License-Identifier: Apache-2.0
"""The boards: what a picture on one takes. A board is a folder with its top, its pins and its configuration."""

import dataclasses
import pathlib

HERE = pathlib.Path(__file__).resolve().parent


@dataclasses.dataclass(frozen=True)
class Board:
    name: str
    title: str
    part: str           # of nextpnr-ice40
    package: str
    device: str         # of synth_ice40
    pixel_mhz: float    # clk_pixel; clk_half is half of it
    entries: int        # triangles of the lists
    multipliers: int    # SB_MAC16
    memories: bool      # there are single-port RAMs: the buffers of the frame lie in them

    @property
    def folder(self):
        return HERE / self.name

    @property
    def top(self):
        return self.folder / f"{self.name}.sv"

    @property
    def pins(self):
        return self.folder / f"{self.name}.pcf"

    @property
    def config(self):
        return self.folder / f"{self.name}.toml"


BOARDS = {board.name: board for board in (
    Board("icebreaker", "iCEBreaker, iCE40 UP5K, DVI PMOD of 12 bits", "up5k", "sg48", "u", 12 * 67 / 32, 256, 8,
          True),
    Board("hx8k", "iCE40-HX8K breakout board, video at a header", "hx8k", "ct256", "hx", 12 * 67 / 32, 256, 0,
          False),
)}
