#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What each unit of the RTL costs on an FPGA, by Yosys: LUTs, flip-flops, DSPs, block RAMs, carry cells, logic depth.

hs_pipeline is elaborated for each package and number of lanes and taken apart into its units and `composition`, all
that is between them (queues, frame control, the multiplexers of the I-buffer). Each part is flattened and mapped
alone; `pipeline` is their sum, and its depth that of the parts joined. With objects ztest_merge and static_run, which
stand beside hs_pipeline, are two of them. The memories of the frame (Z-buffer, I-buffer, TdbS, the table of objects)
are left out of every part and told in bits under `buffers`.
"""

import argparse
import json
import pathlib
import sys

sys.dont_write_bytecode = True  # no __pycache__ between the sources
import report
from design import COMPOSITION, LANES, UNITS, elaborate, elaborate_alone
from jobs import Runner
from rows import PIPELINE, buffers, measured
from targets import TARGETS
from tools import AreaError, write_file

HERE = pathlib.Path(__file__).resolve().parent


def point(text):
    """FILE or FILE@1,4,16."""
    path, _, lanes = text.partition("@")
    return pathlib.Path(path), [lane_number(word) for word in lanes.split(",")] if lanes else None


def alone(text):
    """FILE:UNIT,… or FILE@1,4:UNIT,…"""
    file, _, units = text.rpartition(":")
    path, lanes = point(file)
    return path, lanes, names_of(UNITS)(units)


def lane_number(text):
    if text not in map(str, LANES):
        raise argparse.ArgumentTypeError(f"lanes are {', '.join(map(str, LANES))}, not {text}")
    return int(text)


def names_of(known):
    def convert(text):
        names = known if text == "all" else text.split(",")
        for name in names:
            if name not in known:
                raise argparse.ArgumentTypeError(f"there is no {name}: {', '.join(known)}")
        return list(dict.fromkeys(names))
    return convert


class Parser(argparse.ArgumentParser):
    def error(self, message):
        """A sentence, without the usage."""
        self.exit(2, f"area: {message}\n")


def arguments():
    sums = "\n".join(f"  {name:7} {target.title}: {target.explained}." for name, target in TARGETS.items())
    parser = Parser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog=f"What is summed up, by target:\n{sums}\n\nDepth: the cells on the longest path between registers or "
               "ports, carry cells included.\nMemory bits: of the memories declared, whatever they become.")
    root = HERE.parent.parent
    every = [*UNITS, COMPOSITION, PIPELINE]
    parser.add_argument("--package", type=point, action="append", metavar="FILE[@LANES,…]",
                        help="formats package, of `halfspace package`; may be repeated (default: low, middle, high)")
    parser.add_argument("--alone", type=alone, action="append", default=[], metavar="FILE[@LANES,…]:UNIT,…",
                        help=f"these units of another package, without its pipeline: {', '.join(UNITS)}; may be "
                        "repeated")
    parser.add_argument("--lanes", type=lane_number, default=1, help="of packages that name none (default: 1)")
    parser.add_argument("--targets", type=names_of(list(TARGETS)), default="all", help=f"{','.join(TARGETS)} or all")
    parser.add_argument("--alone-targets", type=names_of(list(TARGETS)),
                        help="of the units of --alone (default: --targets)")
    parser.add_argument("--units", type=names_of(every), default="all", help=f"{','.join(every)} or all")
    parser.add_argument("--clock", action="store_true", help="place and route units on an iCE40 HX8K (target ice40)")
    parser.add_argument("--seed", type=int, default=1, help="of nextpnr (default: %(default)s)")
    parser.add_argument("--tries", type=int, default=4, help="the cells go to LUTs in so many orders, and the smallest "
                        "netlist counts; one order alone is up to a third larger than another (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=1, help="programs at a time (default: %(default)s)")
    parser.add_argument("--cache", type=pathlib.Path, default=root / "build" / "area",
                        help="folder (default: %(default)s)")
    parser.add_argument("--json", type=pathlib.Path, help="write the rows to this file; - is standard output")
    parser.add_argument("--markdown", type=pathlib.Path, help="write the tables between the markers of this file")
    parser.add_argument("--rtl", type=pathlib.Path, default=root / "rtl", help="folder (default: %(default)s)")
    parser.add_argument("--yosys", default="yosys", help="the program (default: %(default)s)")
    parser.add_argument("--nextpnr", default="nextpnr-ice40", help="the program (default: %(default)s)")
    args = parser.parse_args()
    if args.clock and "ice40" not in args.targets:
        parser.error("--clock is of target ice40: add it to --targets")
    if args.jobs < 1 or args.tries < 1:
        parser.error("--jobs and --tries are 1 or more")
    args.alone_targets = [name for name in args.alone_targets or args.targets if name in args.targets]
    if not args.package and not args.alone:
        args.package = [(root / "rtl" / "formats" / name / "hs_formats_pkg.sv", None)
                        for name in ("low", "middle", "high")]
    return args


def main():
    args = arguments()
    try:
        if args.markdown:
            report.between_markers(args.markdown, "")  # found wanting now rather than at the end
        runner, designs = Runner(args), []
        needed = [unit for unit in UNITS if unit in args.units or PIPELINE in args.units]
        for path, lanes in args.package or []:
            for number in lanes or [args.lanes]:
                designs.append(elaborate(args.yosys, args.rtl, path, number, needed))
        for path, lanes, units in args.alone:
            designs += [elaborate_alone(args.yosys, args.rtl, path, number, units) for number in lanes or [args.lanes]]
        rows = measured(designs, runner)
        result = {"format": "halfspace-area 1", "yosys": runner.yosys.removeprefix("Yosys "), "tries": args.tries,
                  "rows": rows,
                  "buffers": [line for design in designs for line in buffers(design)],
                  "bram_bits": {name: TARGETS[name].bram_bits for name in args.targets}}
        if args.markdown:
            write_file(args.markdown, report.between_markers(args.markdown, report.markdown(result)))
        to_output = args.json == pathlib.Path("-")
        if to_output:
            print(json.dumps(result, indent=1))
        elif args.json:
            write_file(args.json, json.dumps(result, indent=1) + "\n")
        print(report.text(result), file=sys.stderr if to_output else sys.stdout)
    except AreaError as error:
        print(f"area: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("area: stopped; what is done is in the cache", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
