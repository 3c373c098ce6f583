# SPDX-License-Identifier: Apache-2.0
"""The FPGA families: how Yosys maps a part for each, and what the cells of the result are counted as."""

import collections
import dataclasses
import re

from rtlil import TOP


@dataclasses.dataclass(frozen=True)
class Target:
    title: str
    library: str        # what the synthesis needs before it begins
    synthesis: str      # Yosys' command, which ends with -run FROM:TO
    begin: str          # the label that it begins with
    lut: dict           # cell type -> how many LUTs it takes
    ff: str             # a pattern of cell types
    dsp: str
    carry: str
    bram: dict          # cell type -> how many blocks it takes
    bram_bits: int      # bits of a block
    explained: str      # for --help and the documentation

    @property
    def to_gates(self):
        """Commands from a part to gates, flip-flops, carry cells and blocks."""
        return f"{self.library}{self.synthesis} -run {self.begin}:map_luts"

    @property
    def to_luts(self):
        """Commands from there to cells of the target alone."""
        return f"{self.synthesis} -run map_luts:check"


# Of each synthesis, what follows the mapping (names for people, statistics) is left out: a quarter of the time on
# iCE40.
TARGETS = {
    "xilinx": Target(
        "7-series",
        # Only the models that the mapped cells come from are read; -noiopad, -noclkbuf: a part is not a chip.
        f"read_verilog -lib -specify +/xilinx/cells_sim.v; hierarchy -check -top {TOP}; ",
        "synth_xilinx -family xc7 -noiopad -noclkbuf", "prepare",
        {"LUT1": 1, "LUT2": 1, "LUT3": 1, "LUT4": 1, "LUT5": 1, "LUT6": 1, "INV": 1, "SRL16E": 1, "SRLC32E": 1,
         "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1D": 4, "RAM32M": 4, "RAM64M": 4},
        r"FD\w+", r"DSP48E1", r"CARRY4", {"RAMB18E1": 1, "RAMB36E1": 2}, 18432,
        "LUT1 … LUT6, inverters and shift registers (SRL) one each, a RAM32M or RAM64M four, a RAM32X1D or RAM64X1D "
        "two; MUXF7 and MUXF8 are not counted; carry is CARRY4, of four bits; DSP is DSP48E1; block RAM in "
        "18-kbit halves"),
    "ecp5": Target(
        "ECP5",
        # -nowidelut: with PFUMX and L6MUX21, Yosys 0.23 takes up to five times the LUTs.
        "", f"synth_ecp5 -nowidelut -top {TOP}", "begin",
        {"LUT4": 1, "CCU2C": 2, "TRELLIS_DPR16X4": 6},
        r"TRELLIS_FF", r"MULT18X18D", r"CCU2C", {"DP16KD": 1}, 18432,
        "LUT4 one each, a carry cell CCU2C, of two bits, the two it stands in, a TRELLIS_DPR16X4 six (four that store, "
        "two that address); -nowidelut; DSP is MULT18X18D; block RAM is DP16KD, of 18 kbit"),
    "ice40": Target(
        "iCE40 HX",
        # No -dsp: HX devices, the larger and faster half of the family, have no multipliers.
        "", f"synth_ice40 -device hx -top {TOP}", "begin",
        {"SB_LUT4": 1},
        r"SB_DFF\w*", r"SB_MAC16", r"SB_CARRY", {"SB_RAM40_4K": 1}, 4096,
        "SB_LUT4 one each; carry is SB_CARRY, of one bit, which shares the cell of a LUT; without -dsp, as HX devices "
        "have no multipliers; there is no LUT-RAM, so small queues are flip-flops; block RAM is "
        "SB_RAM40_4K, of 4 kbit"),
}


def counts(target, cells):
    """The columns of a row from {cell type: number}."""
    target = TARGETS[target]

    def weighed(weights):
        return sum(weights.get(kind, 0) * number for kind, number in cells.items())

    def matching(pattern):
        return sum(number for kind, number in cells.items() if re.fullmatch(pattern, kind))

    return {"lut": weighed(target.lut), "ff": matching(target.ff), "dsp": matching(target.dsp),
            "bram": weighed(target.bram), "carry": matching(target.carry)}


def add(cell_counts):
    return dict(sorted(sum((collections.Counter(cells) for cells in cell_counts), collections.Counter()).items()))
