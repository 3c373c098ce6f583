#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns one module of the RTL, with the modules below it, into C++ with names that a build can know beforehand.

Verilator names its files by the hash of what is in them. This runs it with the prefix Vmodel and leaves in --out:
  Vmodel.h   the class
  ports.inc  HS_PORT(name, bits, is_input) for every port, with the width in bits, which sizeof does not tell,
             HS_WATCH(stream, path, bits) for every hs_stream inside, path being its C++ name without its wires, and
             HS_CONSTANT(name, value) for every number of the package
  title.inc  what the model is: HS_TOP, HS_CONFIG, HS_LANES_X, HS_LANES_Y; HS_TRACED of one that writes waves, and of
             others HS_TRACED_BUILD, the command that builds one
  fast.cpp   includes what runs every cycle
  slow.cpp   includes constructors and reset
  model.cpp  includes both and their binding to the harness: of a unit the headers cost more than the model
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

TB = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(TB.parent / "rtl"))
from units import CONFIG, LANES, RTL, below, constants, parameters, yosys_elaborate  # noqa: E402

PORT = re.compile(r"^\s*VL_(IN|OUT)(?:8|16|64|W)?\(&?(\w+),(\d+),(\d+)")
# The instance u_stream_<name>, inside of generate blocks, too, which a netlist has in its name: `.` is 02e there.
WATCH = re.compile(r"^\s*[\w<>]+/\*(\d+):0\*/ (\w*u_stream_(\w+?))__DOT__word_i;$", re.MULTILINE)
# Random starting values cost nothing while the model runs, and show what depends on a reset that is not there.
FLAGS = ["-O3", "--x-assign", "fast", "--x-initial", "unique", "--noassert", "-Wno-fatal"]


class Broken(Exception):
    """It could not be built: a sentence."""


def run(command, what):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if result.returncode:
        raise Broken(f"{what} failed: {(result.stdout + result.stderr).strip()[:2000]}")
    return result.stdout


def ports(header):
    found = []
    for line in header.read_text().splitlines():
        if match := PORT.match(line):
            direction, name, msb, lsb = match.groups()
            found.append(f"HS_PORT({name}, {int(msb) - int(lsb) + 1}, {int(direction == 'IN')})\n")
    if not found:
        raise Broken(f"{header}: no port found; this Verilator prints them in another way")
    return found


def watches(header, of_ports):
    found = {}
    for msb, path, stream in WATCH.findall(header.read_text()):
        if stream in found or any(port.startswith(f"HS_PORT({stream}_valid_") for port in of_ports):
            raise Broken(f"u_stream_{stream} is the name of two streams, of an hs_stream and another or a port")
        found[stream] = f"HS_WATCH({stream}, {path}, {int(msb) + 1})\n"
    return list(found.values())


def netlist_of(read, top, given, out, yosys):
    """What Yosys understands of the sources, written out as Verilog. The memories of the pipeline have to be
    memories."""
    memories = "select -assert-min 6 */t:$mem_v2; " if top == "hs_pipeline" else ""
    run([yosys, "-q", "-p", f"{yosys_elaborate(top, read, given)}; memory_collect; check -assert; {memories}"
         f'chformal -remove; opt_clean; write_verilog -noattr "{out}"'], "yosys")


def traced_build(package, top, lanes, rtl, verilator, yosys, libraries, cxx, chosen):
    """The words of the command that builds the same model with waves, but for its folder."""
    folder = [pathlib.Path(libraries).resolve() / f"lib{name}.a"
              for name in ("halfspace_tb", "halfspace_verilated")] if libraries else []
    words = ["python3", TB / "model.py", "--trace", "--top", top, "--lanes", lanes, "--package", package.resolve(),
             "--rtl", pathlib.Path(rtl).resolve(), "--verilator", verilator, "--cxx", cxx]
    words += [f"--parameter={name}={value}" for name, value in chosen.items()]
    return [*map(str, words), *(["--yosys", yosys] if yosys else []),
            *(word for library in folder for word in ("--library", str(library)))]


def verilate(package, top, lanes, out, rtl=RTL, verilator="verilator", yosys=None, trace=False, libraries=None,
             cxx="c++", chosen=None):
    """Fills the folder `out`; the sources that were read. With `yosys`: of the netlist that it makes. `trace`: so that
    it writes waves. `libraries`: the folder with those that a bench is linked with, for the build of one that does.
    `chosen`: {name: value} of parameters of the module, which are constants of the model as well."""
    name = CONFIG.search(package.read_text()) if package.exists() else None
    if not name:
        raise Broken(f"{package}: no package of formats: print one with `halfspace package --config C -o {package}`")
    sources = below(top, rtl)
    if not sources:
        raise Broken(f"there is no module {top} in {rtl}")
    numbers = constants(package.read_text())
    out.mkdir(parents=True, exist_ok=True)
    for old in out.glob("Vmodel*"):
        old.unlink()
    chosen = chosen or {}
    given = {**parameters(sources[top].read_text(), lanes, numbers), **chosen}
    numbers = {**numbers, **chosen}
    read = [package, *sources.values()]
    inputs = [*(f"-G{name}={value}" for name, value in given.items()), *read]
    if yosys:
        netlist_of(read, top, given, out / "netlist.v", yosys)
        inputs = [out / "netlist.v"]  # which has no parameters any more
    waves = ["--trace-fst", "--trace-structs"] if trace else []
    run([verilator, "--cc", "--prefix", "Vmodel", "--Mdir", out, "--top-module", top, *FLAGS, *waves,
         TB / "lint.vlt", TB / "watch.vlt", *inputs], verilator)
    found = ports(out / "Vmodel.h")
    found += watches(out / "Vmodel___024root.h", found)
    found += [f"HS_CONSTANT({name}, {value})\n" for name, value in numbers.items()]
    if (out / "Vmodel_hs_mutant.h").exists():  # RTL that tb/mutation.py has written
        found.append("HS_VARIABLE(mutant_i, __PVT__hs_mutant->number)\n")
    (out / "ports.inc").write_text("".join(found))
    lanes_x, lanes_y = LANES[lanes]
    again = traced_build(package, top, lanes, rtl, verilator, yosys, libraries, cxx, chosen)
    how = "#define HS_TRACED\n" if trace else f"#define HS_TRACED_BUILD {', '.join(map(json.dumps, again))}\n"
    (out / "title.inc").write_text(f'#define HS_TOP "{top}"\n#define HS_CONFIG "{name.group(1)}"\n'
                                   f"#define HS_LANES_X {lanes_x}\n#define HS_LANES_Y {lanes_y}\n" + how)
    files = sorted(path.name for path in out.glob("Vmodel*.cpp"))
    is_slow = [name.endswith("__Slow.cpp") or name == "Vmodel__Syms.cpp" for name in files]
    for target, slow in (("fast.cpp", False), ("slow.cpp", True)):
        chosen = [name for name, s in zip(files, is_slow) if s == slow]
        (out / target).write_text("".join(f'#include "{name}"\n' for name in chosen))
    (out / "model.cpp").write_text('#include "fast.cpp"\n#include "slow.cpp"\n#include "tb/harness/binding.cpp"\n')
    return read


def parameter(text):
    """(name, number) of NAME=VALUE."""
    name, value = text.split("=")
    return name, int(value)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--verilator", default="verilator", help="the program (default: %(default)s)")
    parser.add_argument("--top", required=True, help="the module")
    parser.add_argument("--lanes", type=int, required=True, choices=sorted(LANES))
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the C++")
    parser.add_argument("--package", type=pathlib.Path, required=True, help="hs_formats_pkg.sv of the configuration")
    parser.add_argument("--yosys", help="this program, to take the netlist that it makes of the module")
    parser.add_argument("--parameter", type=parameter, action="append", default=[], metavar="NAME=VALUE",
                        help="a parameter of the module")
    parser.add_argument("--libraries", type=pathlib.Path, help="folder of the libraries of a bench, for --wave")
    parser.add_argument("--cxx", default="c++", help="compiler of a bench, for --wave (default: %(default)s)")
    parser.add_argument("--depfile", type=pathlib.Path, help="write the sources that were read here, for the build")
    args = parser.parse_args()
    try:
        read = verilate(args.package, args.top, args.lanes, args.out, verilator=args.verilator, yosys=args.yosys,
                        libraries=args.libraries, cxx=args.cxx, chosen=dict(args.parameter))
    except Broken as e:
        print(f"verilate: {e}", file=sys.stderr)
        return 1
    if args.depfile:
        names = " ".join(str(path).replace(" ", "\\ ") for path in read)
        args.depfile.write_text(f"{args.out / 'model.cpp'}: {names}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
