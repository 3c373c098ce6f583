#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves that a unit keeps the handshake: a word that it offers stays, valid and unchanged, until it is taken; or, with
--harness FILE, what this file says of a module; from reset on for so many cycles, if it has a line `// cycles N`.

Of every input, at any time, for ever: Yosys makes an and-inverter graph of the unit in a harness that is written from
its ports, and ABC's property-directed reachability looks for an invariant. Assumed is what the contract grants: a word
that is offered to the unit stays as well, registers of a frame do not change, and what a memory has read stays until
the next read. A reset may come at any time. --broken FILE has faults as in tb/faults, and each has to be found."""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "rtl"))
from units import LANES, RTL, below, constants, parameters, yosys_elaborate  # noqa: E402

# What a memory has read, and the enable that lets it change.
READ = {"read_index_i": "read_en_o", "read_depth_i": "read_en_o", "read_planes_i": "read_en_o",
        "read_object_i": "read_en_o", "fetch_plane_i": "fetch_en_o"}
PORT = re.compile(r"^\s*(input|output) (?:wire |reg |logic |signed )*(?:\[(\d+):0\] )?(\w+);", re.MULTILINE)
# Latches start at 0 in an AIGER. The first cycle is a reset, and may last as long as it likes: inputs are free, so that
# what it does not reach holds anything when it ends.
TO_AIGER = ("hierarchy -top harness; proc; flatten; opt -full; memory; opt -full; async2sync; dffunmap; opt -full; "
            "setundef -undriven -anyseq; setundef -zero; techmap; opt; simplemap; dfflegalize -cell $_DFF_P_ 01; "
            "setundef -zero; aigmap; opt_clean; write_aiger -zinit")


class Broken(Exception):
    """It could not be tried: a sentence."""


def run(command, seconds=600):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=seconds)
    if result.returncode:
        raise Broken(f"{command[0]} failed: {(result.stdout + result.stderr).strip()[-1500:]}")
    return result.stdout


def elaborated(args, top, given, rtl, out):
    """The unit as one Verilog module without parameters, and its ports {name: (is_input, bits)}."""
    sources = below(top, rtl)
    if given is None:
        given = parameters(sources[top].read_text(), args.lanes, constants(args.package.read_text()))
    netlist = out / f"{top}.v"
    run([args.yosys, "-q", "-p", f"{yosys_elaborate(top, [args.package, *sources.values()], given)}; flatten; opt; "
         f'chformal -remove; memory_collect; rename -top unit; opt_clean; write_verilog -noattr "{netlist}"'])
    text = netlist.read_text()
    body = text[text.index("module unit("):]
    return netlist, {name: (kind == "input", int(msb or 0) + 1) for kind, msb, name in PORT.findall(body)}


def harness(ports):
    """A module with one output, which is 1 where the unit breaks the contract and nobody else has before."""
    inputs = {name: bits for name, (is_input, bits) in ports.items() if is_input and name not in ("clk_i", "rst_ni")}
    outputs = {name: bits for name, (is_input, bits) in ports.items() if not is_input}
    lines = ["module harness(input clk, input rst_free, output bad,"]
    lines.append(",\n".join(f"  input [{bits - 1}:0] {name}_free" for name, bits in inputs.items()) + ");")
    lines += ["  reg began = 0, before = 0, illegal = 0;", "  wire rst_ni = began && rst_free;"]
    lines += [f"  wire [{bits - 1}:0] {name};" for name, bits in {**inputs, **outputs}.items()]
    legal, good, kept = [], [], []

    def keep(name, bits, condition):
        """The word of the cycle before, and that it is the same where the condition held then."""
        kept.append(f"    {name}_was <= {name}; {name}_stays <= {condition};")
        lines.append(f"  reg [{bits - 1}:0] {name}_was = 0; reg {name}_stays = 0;")
        return f"(!{name}_stays || {name} == {name}_was)"

    streams = []
    for name, bits in inputs.items():
        stem = name[:-2]
        if name.endswith("_ready_i") or name.endswith("_valid_i") or f"{stem}_valid_i" in inputs:
            lines.append(f"  assign {name} = {name}_free;")
        elif name in READ and READ[name] in outputs:
            lines.append(f"  assign {name} = {name}_free;")
            legal.append(keep(name, bits, f"!{READ[name]}"))
        else:
            # A register of a frame, or what goes with a stream without a handshake of its own: any value, for good.
            lines.append(f"  reg [{bits - 1}:0] {name}_const = 0; assign {name} = {name}_const;")
            lines.append(f"  always @(posedge clk) if (!began) {name}_const <= {name}_free;")
        if name.endswith("_valid_i") and f"{name[:-8]}_ready_o" in outputs:
            stem = name[:-8]
            waits = f"{name} && !{stem}_ready_o"
            legal.append(keep(name, 1, waits))
            if f"{stem}_i" in inputs:
                legal.append(keep(f"{stem}_i", inputs[f"{stem}_i"], waits))
    for name in outputs:
        stem = name[:-8]
        if name.endswith("_valid_o") and f"{stem}_ready_i" in inputs:
            streams.append(stem)
            waits = f"{name} && !{stem}_ready_i"
            good.append(keep(name, 1, waits))
            if f"{stem}_o" in outputs:
                good.append(keep(f"{stem}_o", outputs[f"{stem}_o"], waits))
    if not good:
        raise Broken("the unit has no output with a handshake")
    connections = ", ".join(f".{name}({name})" for name in [*inputs, *outputs])
    lines.append(f"  unit u_unit (.clk_i(clk), .rst_ni(rst_ni), {connections});")
    lines.append(f"  wire legal = !rst_ni || !before || ({' && '.join(legal) or '1'});")
    lines.append(f"  wire good = {' && '.join(good)};")
    lines.append("  assign bad = rst_ni && before && legal && !illegal && !good;")
    lines.append("  always @(posedge clk) begin\n    began <= 1; before <= rst_ni;\n"
                 "    illegal <= rst_ni && (illegal || !legal);")
    return "\n".join([*lines, *kept, "  end", "endmodule", ""]), streams


def judge(args, text, netlist, out, engine):
    """'proved', 'fails' or 'unknown', of the harness in `text`."""
    (out / "harness.v").write_text(text)
    files = f'"{out}/harness.v"' + (f' "{netlist}"' if netlist else "")
    run([args.yosys, "-q", "-p", f'read_verilog -sv {files}; {TO_AIGER} "{out}/unit.aig"'])
    said = run([args.abc, "-c", f"read_aiger {out}/unit.aig; {engine}; print_status"])
    (out / "abc.txt").write_text(said)
    if re.search(r"was asserted in frame|Property was disproved|disproved|Status = 0", said, re.I):
        return "fails"
    if bound := re.search(r"No output asserted in (\d+) frames", said):
        return f"holds for {bound[1]} cycles"
    return "proved" if re.search(r"Property proved|Status = 1", said) else "unknown"


def engine_of(seconds, cycles, broken):
    """Latches that are equal are merged first. Then a fault is looked for along short ways, an invariant otherwise."""
    short, invariant = f"bmc3 -F {cycles or 16} -T {min(seconds, 30)}", f"pdr -T {seconds}"
    search = short if cycles else f"{short}; {invariant}" if broken else invariant
    return f"strash; scorr; dc2; {search}"


def read_faults(path):
    faults = []
    for line in path.read_text().splitlines():
        key, _, value = line.partition(" ")
        if key == "fault":
            faults.append({"name": value.strip()})
        elif faults and value:
            faults[-1][key] = value.strip()
    return faults


def seed(fault, rtl):
    path = next(rtl.glob(f"*/{fault['file']}"))
    text = path.read_text()
    if text.count(fault["find"]) != 1:
        raise Broken(f"fault {fault['name']}: its text stands {text.count(fault['find'])} times in {fault['file']}")
    path.write_text(text.replace(fault["find"], fault["with"]))


def prove(args, unit, given, rtl, out, broken):
    """What was found, and of what."""
    out.mkdir(parents=True, exist_ok=True)
    top = unit if args.harness else f"hs_{unit}"
    netlist, ports = elaborated(args, top, given, rtl, out)
    cycles = 0
    if args.harness:
        cycles = int((re.findall(r"^// cycles (\d+)$", args.harness.read_text(), re.MULTILINE) or [0])[0])
        text, about = args.harness.read_text(), " ".join(f"{name}={value}" for name, value in given.items())
    else:
        text, streams = harness(ports)
        about = "offers stay: " + ", ".join(streams)
    return judge(args, text, netlist, out, engine_of(args.seconds, cycles, broken)), about


def cases_of(args):
    """(unit, parameters, fault or None) of each."""
    if args.harness:
        found = re.findall(r"^// unit (\w+)(.*)$", args.harness.read_text(), re.MULTILINE)
        cases = [(unit, dict(each.split("=") for each in given.split()), None) for unit, given in found]
    else:
        cases = [(unit, None, None) for unit in args.units]
    last = {unit: given for unit, given, _ in cases}
    faults = [fault for fault in read_faults(args.broken) if fault["unit"] in last] if args.broken else []
    if args.broken and (lacks := set(last) - {fault["unit"] for fault in faults}):
        raise Broken(f"{args.broken} has no fault of {', '.join(sorted(lacks))}")
    return cases + [(fault["unit"], last[fault["unit"]], fault) for fault in faults]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--package", type=pathlib.Path, required=True, help="of a small configuration")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--units", nargs="+", help="that keep the handshake")
    what.add_argument("--harness", type=pathlib.Path, help="a module `harness` around one called `unit`")
    parser.add_argument("--lanes", type=int, default=1, choices=sorted(LANES))
    parser.add_argument("--broken", type=pathlib.Path, help="faults that have to be found")
    parser.add_argument("--rtl", type=pathlib.Path, default=RTL)
    parser.add_argument("--seconds", type=int, default=120, help="of the solver, for a unit (default: %(default)s)")
    parser.add_argument("--yosys", default="yosys")
    parser.add_argument("--abc", default="berkeley-abc")
    args = parser.parse_args()
    failed = tried = 0
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        for unit, given, fault in cases_of(args):
            tried += 1
            try:
                rtl = args.rtl
                if fault:
                    rtl = work / f"rtl{tried}"
                    shutil.copytree(args.rtl, rtl)
                    seed(fault, rtl)
                found, about = prove(args, unit, given, rtl, work / f"proof{tried}", bool(fault))
            except (Broken, subprocess.TimeoutExpired) as e:
                found, about = str(e), ""
            wrong = not (found == "fails" if fault else found == "proved" or found.startswith("holds for"))
            failed += wrong
            about = f"with the fault {fault['name']}" if fault else about
            print(f"{'FAIL' if wrong else 'pass'}  {unit:16} {about}: {found}", flush=True)
    print(f"proofs: {tried - failed} as they should be, {failed} not")
    return 0 if tried and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
