# SPDX-License-Identifier: Apache-2.0
"""From the RTL of a board to the file that it loads: Yosys, nextpnr-ice40, icepack, and what they report."""

import json
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # no __pycache__ between the sources
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from units import ordered  # noqa: E402


LEAST = (7, 8, 9, 11, 13, 17)  # bits of a factor that is worth a multiplier: all there are, if one can have them


class FlowError(Exception):
    """A sentence."""


def run(command, log, cwd=None):
    """Runs a program with its words in a file."""
    try:
        with log.open("w") as said:
            done = subprocess.run([str(word) for word in command], stdout=said, stderr=subprocess.STDOUT, cwd=cwd)
    except FileNotFoundError:
        raise FlowError(f"there is no program {command[0]}: `setup/install.sh test` installs it") from None
    if done.returncode:
        lines = [line for line in log.read_text(errors="replace").splitlines() if line.strip()]
        why = next((line for line in lines if "ERROR" in line or "Error" in line), lines[-1] if lines else "nothing")
        raise FlowError(f"{pathlib.Path(command[0]).name} says: {why.strip()} (see {log})")


def sources(board, package):
    """The files that a tool reads, the package first."""
    return [package, *ordered(["hs_board"]).values(), board.top]


def parameters(board, lists, background):
    return {"Entries": board.entries, "Background": background, "File": f'"{lists.name}"'}


def synthesis(board, package, lists, background, least):
    """Yosys' script: OUT/board.json for nextpnr, OUT/netlist.v for simulators. Factors of `least` bits and more go to
    multipliers, and it ends with an error where these are more than there are."""
    read = " ".join(f'"{path}"' for path in sources(board, package))
    chosen = " ".join(f"-set {name} {value}" for name, value in parameters(board, lists, background).items())
    script = [f"read_verilog -sv {read}", "read_verilog -lib +/ice40/cells_sim.v", f"chparam {chosen} {board.name}",
              f"hierarchy -check -top {board.name}", "proc", "chformal -remove", "flatten", "opt", "memory_dff",
              "wreduce", "opt_clean"]
    if board.memories:
        # The buffers of the frame, whatever a block RAM would cost.
        script.append('setattr -set ram_style "huge" m:*u_memory.words_q m:*u_depth_buffer.words_q')
    if board.multipliers:
        # As synth_ice40 -dsp does, but for what is worth a multiplier.
        script += ["techmap -map +/mul2dsp.v -map +/ice40/dsp_map.v -D DSP_A_MAXWIDTH=16 -D DSP_B_MAXWIDTH=16 "
                   f"-D DSP_A_MINWIDTH=4 -D DSP_B_MINWIDTH={least} -D DSP_Y_MINWIDTH=11 -D DSP_NAME=$__MUL16X16",
                   "setattr -unset mul2dsp a:mul2dsp", "opt_expr -fine", "opt_clean", "ice40_dsp",
                   f"select -assert-max {board.multipliers} t:SB_MAC16", "chtype -set $mul t:$__soft_mul"]
    spram = " -spram" if board.memories else ""
    script += [f"synth_ice40 -device {board.device}{spram} -top {board.name} -json board.json",
               "write_verilog -noattr netlist.v"]
    return script


def synthesize(board, package, lists, background, out, yosys="yosys"):
    """With as many products in multipliers as there are."""
    script = out / "board.ys"
    for least in LEAST:
        script.write_text("\n".join(synthesis(board, package, lists, background, least)) + "\n")
        try:
            return run([yosys, script.name], out / "yosys.log", cwd=out)
        except FlowError as error:
            if "ssertion failed" not in str(error) or least == LEAST[-1]:
                raise


def place(board, out, seed=1, nextpnr="nextpnr-ice40", icepack="icepack"):
    """OUT/board.bin, and the report."""
    log = out / "nextpnr.log"
    run([nextpnr, f"--{board.part}", "--package", board.package, "--json", "board.json", "--pcf", board.pins,
         "--asc", "board.asc", "--report", "board.report", "--seed", seed,
         "--timing-allow-fail"], log, cwd=out)
    run([icepack, "board.asc", "board.bin"], out / "icepack.log", cwd=out)
    return report(board, out)


def report(board, out):
    """{"cells": {name: (used, there are)}, "clocks": {name: (reached, needed)}, "delays": {path: (ns, at most)}}."""
    said = (out / "nextpnr.log").read_text(errors="replace")
    measured = json.loads((out / "board.report").read_text())
    cells = {name: (number["used"], number["available"]) for name, number in measured["utilization"].items()
             if name in ("ICESTORM_LC", "ICESTORM_RAM", "ICESTORM_DSP", "ICESTORM_SPRAM", "ICESTORM_PLL")}
    clocks = {}
    for name, needed in (("clk_pixel", board.pixel_mhz), ("clk_half", board.pixel_mhz / 2)):
        reached = [clock["achieved"] for net, clock in measured["fmax"].items() if name in net]
        if not reached:
            raise FlowError(f"{out / 'board.report'} has no clock {name}")
        clocks[name] = (min(reached), needed)
    # Between the two a path has one cycle of the faster at least: they have common edges.
    delays = {}
    for source, sink in (("clk_half", "clk_pixel"), ("clk_pixel", "clk_half")):
        found = re.findall(rf"Max delay posedge {source}\S*\s+-> posedge {sink}\S*\s*: ([\d.]+) ns", said)
        if not found:
            raise FlowError(f"{out / 'nextpnr.log'} has no path from {source} to {sink}")
        delays[f"{source} to {sink}"] = (float(found[-1]), 1000 / board.pixel_mhz)
    return {"cells": cells, "clocks": clocks, "delays": delays}


NAMES = {"ICESTORM_LC": "logic cells", "ICESTORM_RAM": "block RAMs", "ICESTORM_DSP": "multipliers",
         "ICESTORM_SPRAM": "single-port RAMs", "ICESTORM_PLL": "PLL"}


def text(found):
    lines = [f"{NAMES[name]:17} {used:5} of {there:5}  {100 * used // there:3} %"
             for name, (used, there) in found["cells"].items() if there]
    lines += [f"{name:17} {reached:6.2f} MHz, {needed:.4f} needed" for name, (reached, needed)
              in found["clocks"].items()]
    lines += [f"{path}: {ns:.2f} ns, {most:.2f} at most" for path, (ns, most) in found["delays"].items()]
    return "\n".join(lines)


def late(found):
    """What misses its constraint."""
    return [f"{name} reaches {reached:.2f} MHz of {needed:.2f}" for name, (reached, needed) in found["clocks"].items()
            if reached < needed] + [f"{path} takes {ns:.2f} ns of {most:.2f}" for path, (ns, most)
                                    in found["delays"].items() if ns > most]
