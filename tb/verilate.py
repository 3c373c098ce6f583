#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns one top module into C++ with names that a build can know beforehand.

Verilator names its files by the hash of what is in them. This runs it with the prefix Vmodel and leaves in --out:
  Vmodel.h   the class
  ports.inc  HS_PORT(name, bits, is_input) for every port, with the width in bits, which sizeof does not tell,
             HS_WATCH(stream, path, bits) for every hs_stream inside, path being its C++ name without its wires, and
             HS_CONSTANT(name, value) for every number of the package
  fast.cpp   includes what runs every cycle
  slow.cpp   includes constructors and reset
"""

import argparse
import pathlib
import re
import subprocess
import sys

CONSTANT = re.compile(r"^\s*localparam\s+int(?:\s+unsigned)?\s+(\w+)\s*=\s*(\d+);", re.MULTILINE)
PORT = re.compile(r"^\s*VL_(IN|OUT)(?:8|16|64|W)?\(&?(\w+),(\d+),(\d+)")
# The instance u_stream_<name>, inside of generate blocks, too, which a netlist has in its name: `.` is 02e there.
WATCH = re.compile(r"^\s*[\w<>]+/\*(\d+):0\*/ (\w*u_stream_(\w+?))__DOT__word_i;$", re.MULTILINE)
HERE = pathlib.Path(__file__).resolve().parent


def verilate(args):
    out = pathlib.Path(args.out)
    out.mkdir(parents=True, exist_ok=True)
    for old in out.glob("Vmodel*"):
        old.unlink()
    command = [args.verilator, "--cc", "--prefix", "Vmodel", "--Mdir", str(out), "--top-module", args.top, *args.flag,
               str(HERE / "watch.vlt")]
    if not args.netlist:  # which has no parameters any more
        command += [f"-GLanesX={args.lanes_x}", f"-GLanesY={args.lanes_y}", args.package]
    command += args.sources
    result = subprocess.run(command, capture_output=True, text=True)
    sys.stderr.write(result.stdout + result.stderr)
    return result.returncode


def write_sources(out, package):
    ports = []
    for line in (out / "Vmodel.h").read_text().splitlines():
        if match := PORT.match(line):
            direction, name, msb, lsb = match.groups()
            ports.append(f"HS_PORT({name}, {int(msb) - int(lsb) + 1}, {int(direction == 'IN')})\n")
    if not ports:
        return f"{out}/Vmodel.h: no port found; this Verilator prints them in another way"
    watches = {}
    for msb, path, stream in WATCH.findall((out / "Vmodel___024root.h").read_text()):
        if stream in watches or any(port.startswith(f"HS_PORT({stream}_valid_") for port in ports):
            return f"u_stream_{stream} is the name of two streams, of an hs_stream and another or a port"
        watches[stream] = f"HS_WATCH({stream}, {path}, {int(msb) + 1})\n"
    constants = [f"HS_CONSTANT({name}, {value})\n" for name, value in CONSTANT.findall(package.read_text())]
    (out / "ports.inc").write_text("".join([*ports, *watches.values(), *constants]))
    files = sorted(path.name for path in out.glob("Vmodel*.cpp"))
    is_slow = [name.endswith("__Slow.cpp") or name == "Vmodel__Syms.cpp" for name in files]
    for target, slow in (("fast.cpp", False), ("slow.cpp", True)):
        chosen = [name for name, s in zip(files, is_slow) if s == slow]
        (out / target).write_text("".join(f'#include "{name}"\n' for name in chosen))
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--verilator", default="verilator", help="the program (default: %(default)s)")
    parser.add_argument("--top", required=True, help="top module")
    parser.add_argument("--lanes-x", type=int, required=True)
    parser.add_argument("--lanes-y", type=int, required=True)
    parser.add_argument("--out", required=True, help="folder for the C++")
    parser.add_argument("--flag", action="append", default=[], help="a further flag of Verilator: --flag=-O3")
    parser.add_argument("--package", required=True, help="hs_formats_pkg.sv of the configuration")
    parser.add_argument("--netlist", action="store_true", help="the source is a netlist: no parameters, no package")
    parser.add_argument("sources", nargs="+", help="waivers and SystemVerilog files")
    args = parser.parse_args()
    if code := verilate(args):
        return code
    if sentence := write_sources(pathlib.Path(args.out), pathlib.Path(args.package)):
        print(f"verilate: {sentence}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
