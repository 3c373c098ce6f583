# SPDX-License-Identifier: Apache-2.0
"""A clock for a part on an iCE40 HX8K: placed and routed by nextpnr, in a frame of flip-flops.

A unit has more ports than the chip has pins. So a shift register drives its inputs, and each output goes to a
flip-flop and from there into a register that adds up (exclusive or) and shifts: four pins, nothing can be optimised
away, and every path of the unit is between two flip-flops. The frame is of cells already mapped, around the very
netlist that was counted.
"""

import json

from rtlil import TOP
from tools import AreaError, run

DEVICE, PACKAGE = "hx8k", "ct256"
LUTS, BLOCKS = 7680, 32
GOAL_MHZ = 100


def frame(ports):
    """The Verilog of the frame: module `clocked` around the part with these ports."""
    pins = ("clk_i", "rst_ni")
    inputs = [(name, width) for name, width, direction in ports if direction == "input" and name not in pins]
    outputs = [(name, width) for name, width, direction in ports if direction == "output"]
    cells, connections = [], [f".{name}({name})" for name, _, _ in ports if name in pins]
    size = {}
    for vector, group in (("in", inputs), ("out", outputs)):
        lsb = 0
        for name, width in group:
            connections.append(f".{name}({vector}[{lsb + width - 1}:{lsb}])")
            lsb += width
        size[vector] = lsb
    before = "serial_i"
    for bit in range(size["in"]):
        cells.append(f"SB_DFF in_{bit} (.C(clk_i), .D({before}), .Q(in[{bit}]));")
        before = f"in[{bit}]"
    before = "1'b0"
    for bit in range(size["out"]):
        cells.append(f"SB_DFF held_{bit} (.C(clk_i), .D(out[{bit}]), .Q(held[{bit}]));")
        cells.append(f"SB_LUT4 #(.LUT_INIT(16'h6666)) add_{bit} "
                     f"(.I0(held[{bit}]), .I1({before}), .I2(1'b0), .I3(1'b0), .O(next[{bit}]));")
        cells.append(f"SB_DFF sum_{bit} (.C(clk_i), .D(next[{bit}]), .Q(sum[{bit}]));")
        before = f"sum[{bit}]"
    lines = ["module clocked (input clk_i, input rst_ni, input serial_i, output serial_o);",
             f"wire [{size['in'] - 1}:0] in;", f"wire [{size['out'] - 1}:0] out, held, next, sum;",
             f"{TOP} u_{TOP} ({', '.join(connections)});", *cells, f"assign serial_o = {before};", "endmodule"]
    return "\n".join(lines) + "\n"


def why_not(lut, bram):
    """Why a netlist of this size cannot be placed, as far as its numbers tell; '' if they do not."""
    short = [f"{number} {what} of {there}" for number, what, there in
             ((lut, "LUTs", LUTS), (bram, "block RAMs", BLOCKS)) if number > there]
    return f"does not fit on {DEVICE}: " + ", ".join(short) if short else ""


def place_and_route(nextpnr, netlist, seed, lut, bram):
    """{"clock_mhz", "why"} of a frame with its part, in Yosys' JSON."""
    report = netlist.with_suffix(".report")
    if why := why_not(lut, bram):
        return {"clock_mhz": None, "why": why}
    try:
        run([nextpnr, f"--{DEVICE}", "--package", PACKAGE, "--json", netlist, "--seed", seed, "--freq", GOAL_MHZ,
             "--timing-allow-fail", "--report", report, "--quiet"], "clock")
    except AreaError as error:
        if "no BELs remaining" in str(error) or "Unable to place" in str(error) or "ailed to expand" in str(error):
            return {"clock_mhz": None, "why": f"does not fit on {DEVICE} with the flip-flops that drive its ports"}
        raise
    clocks = [clock["achieved"] for clock in json.loads(report.read_text())["fmax"].values()]
    return {"clock_mhz": round(min(clocks), 2), "why": ""}
