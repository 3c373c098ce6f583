#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests the tester: puts one fault at a time into a copy of the RTL and demands that the benches say so.

A fault passes when the bench of its unit, and no other, reports it in the words that faults.txt expects and ends with a
failure; and when every other unit that stands on the faulty file still agrees with the vectors on more than zero words.
Units that do not stand on it are not built: they are the same as without the fault. A control run of all without a
fault has to pass first. Judged by the text that is printed: an exit status alone also comes from a model that was not
built or a set that is not there.
"""

import argparse
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
TB = HERE.parent
sys.path.insert(0, str(TB))
from model import LANES, Broken, build, parameter, run  # noqa: E402
from units import below  # noqa: E402

KEYS = ["why", "file", "find", "with", "unit", "says"]
OPTION = "options"  # of the bench, besides: where a fault shows only under these
BENCH = re.compile(r"^(?:bench (\w+)|cosim) \S+ \w+: (\d+) words on \d+ streams compared, (\d+) mismatches, "
                   r"(?:(\d+) missing, )?\d+ cycles$", re.MULTILINE)
FAIL = re.compile(r"^FAIL (\w+): (.*)$", re.MULTILINE)


def read_faults(path):
    faults = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        key, _, value = line.partition(" ")
        if key == "fault":
            faults.append({"name": value.strip()})
        elif key in (*KEYS, OPTION) and faults:
            faults[-1][key] = value.strip()
        else:
            raise Broken(f"{path}:{number}: '{key}' is none of fault, {', '.join(KEYS)}")
    for fault in faults:
        if missing := [key for key in KEYS if key not in fault]:
            raise Broken(f"{path}: fault {fault['name']} lacks {', '.join(missing)}")
    return faults


def seed_fault(fault, rtl):
    path = next(rtl.glob(f"*/{fault['file']}"), rtl / fault["file"])
    text = path.read_text() if path.exists() else ""
    if (count := text.count(fault["find"])) != 1:
        raise Broken(f"its text stands {count} times in {fault['file']}, not once: bring faults.txt and rtl/ together")
    path.write_text(text.replace(fault["find"], fault["with"]))


def judge(unit, output, status, says):
    """What is wrong with the report of a unit, or ''. `says`: what it has to report; None: nothing. Of the pipeline no
    stream but the one that `says` names may report."""
    benches = BENCH.findall(output)
    if [name or "pipeline" for name, _, _, _ in benches] != [unit]:
        return f"{unit} does not end with its report"
    words, mismatches = int(benches[0][1]), int(benches[0][2]) + int(benches[0][3] or 0)
    reports = [text for _, text in FAIL.findall(output)]
    if says is None:
        wrong = words == 0 or mismatches or reports or status
        return f"{unit} reports what is not its fault: {(reports or ['no words'])[0]}" if wrong else ""
    if not reports or not status:  # of a word, or of a level that no stream carries
        return f"{unit} reports nothing"
    if not (all if unit == "pipeline" else any)(re.search(says, text) for text in reports):
        return f"{unit} does not say '{says}' but: {' | '.join(reports)}"
    return ""


def parameters_of(args, top):
    """Those of --parameter that the module has."""
    text = below(top, args.rtl)[top].read_text()
    return {name: value for name, value in args.parameter if f"parameter int unsigned {name} " in text}


def try_unit(args, unit, says, work, options):
    """What is wrong with the bench of the unit in a copy of the RTL, or ''; and what it reports."""
    package = args.package or work / "rtl" / "formats" / args.config / "hs_formats_pkg.sv"
    bench = build(package, args.lanes, f"hs_{unit}", work / unit, args.library, rtl=work / "rtl",
                  verilator=args.verilator, cxx=args.cxx, chosen=parameters_of(args, f"hs_{unit}"))
    command = [bench, args.vectors, "--stall", "30", "--seed", "1", *options]
    result = subprocess.run(command, capture_output=True, text=True, timeout=600)
    output = result.stdout + result.stderr
    (work / f"{unit}.txt").write_text(output)
    return judge(unit, output, result.returncode, says), [text for _, text in FAIL.findall(output)]


def try_fault(args, fault):
    """Whether it passed, and a line that tells. No fault: the control run."""
    name = fault["name"] if fault else "control"
    guilty = fault["unit"].split() if fault else []
    if fault:
        touched = [unit for unit in args.units if fault["file"].removesuffix(".sv") in below(f"hs_{unit}", args.rtl)]
    else:
        touched = [args.of] if args.of else args.units
    work = args.work / name
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(args.rtl, work / "rtl")
    start = time.monotonic()
    wrong, said = "", "no fault, no report"
    try:
        if strangers := set(guilty) - set(touched):
            raise Broken(f"{fault['file']} is no part of {', '.join(strangers)}, or --units leaves it out")
        if fault:
            seed_fault(fault, work / "rtl")
        for unit in touched:
            found, reports = try_unit(args, unit, fault["says"] if unit in guilty else None, work,
                                      fault.get(OPTION, "").split() if fault else [])
            wrong = wrong or found
            if unit in guilty and reports:
                said = reports[0]
    except Broken as e:
        wrong = str(e)
    except subprocess.TimeoutExpired:
        wrong = "the bench did not end"
    seconds = time.monotonic() - start
    if not wrong and not args.keep:
        shutil.rmtree(work, ignore_errors=True)
    where = " ".join(unit if unit in guilty else f"({unit})" for unit in touched) if fault else " ".join(touched)
    return not wrong, f"{'FAIL' if wrong else 'pass'}  {name:24} {where:27} {seconds:5.1f} s  {wrong or said}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    vectors = parser.add_mutually_exclusive_group(required=True)
    vectors.add_argument("--vectors", type=pathlib.Path, help="a vector set of --config and --lanes")
    vectors.add_argument("--words", type=pathlib.Path, help="a script that makes a set: SCRIPT PACKAGE OUT LANES")
    vectors.add_argument("--halfspace", type=pathlib.Path, help="the program, to make a set with")
    parser.add_argument("--work", type=pathlib.Path, required=True,
                        help="folder for the copies; what failed stays there")
    parser.add_argument("--library", type=pathlib.Path, action="append", required=True,
                        help="the harness and Verilator's library, in this order: --library A.a --library B.a")
    parser.add_argument("--rtl", type=pathlib.Path, default=TB.parent / "rtl")
    parser.add_argument("--faults", type=pathlib.Path, default=HERE / "faults.txt", help="default: %(default)s")
    parser.add_argument("--scene", default="standard", help="of the vectors (default: %(default)s)")
    parser.add_argument("--config", default="low", help="with --package: a .toml file")
    parser.add_argument("--units", nargs="+", required=True, help="units, or pipeline; those that the faults may reach")
    parser.add_argument("--of", metavar="UNIT", help="only faults of this unit: that `unit` names alone or first")
    parser.add_argument("--package", type=pathlib.Path, help="of a configuration that has none in rtl/")
    parser.add_argument("--parameter", type=parameter, action="append", default=[], metavar="NAME=VALUE",
                        help="of the modules that have it")
    parser.add_argument("--lanes", type=int, default=4, choices=sorted(LANES))
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", help="regular expression of the names to try")
    parser.add_argument("--keep", action="store_true", help="keep the copies of what passed, too")
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--cxx", default="c++")
    args = parser.parse_args()
    try:
        faults = read_faults(args.faults)
        if args.halfspace:
            args.vectors = args.work / "vectors"
            args.work.mkdir(parents=True, exist_ok=True)
            run([args.halfspace, "vectors", args.scene, "--config", args.config, "--lanes", args.lanes,
                 "--out", args.vectors], "halfspace vectors")
        if args.words:
            args.vectors = args.work / "vectors"
            run([sys.executable, args.words, args.package, args.vectors, args.lanes], args.words)
    except Broken as e:
        print(f"faults: {e}", file=sys.stderr)
        return 2
    chosen = [None] + [fault for fault in faults if re.search(args.only or "", fault["name"])
                       and args.of in (None, fault["unit"].split()[0])]
    passed = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for good, text in pool.map(lambda fault: try_fault(args, fault), chosen):
            passed += good
            print(text, flush=True)
    print(f"faults: {passed} passed, {len(chosen) - passed} failed")
    return 0 if passed == len(chosen) > 1 else 1


if __name__ == "__main__":
    sys.exit(main())
