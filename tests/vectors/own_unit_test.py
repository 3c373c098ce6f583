#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""examples/own_unit with Icarus and Verilator: it passes, units that are broken fail, and vectors.svh says what the
manifest does. Usage: own_unit_test.py HALFSPACE ROOT FOLDER"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

HALFSPACE, ROOT, FOLDER = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
EXAMPLE = ROOT / "examples/own_unit"
PASSED = "2588 and 2321 of 2588 and 2321 words, 0 wrong\nPASS\n"
BROKEN = [("|| tested_i[VisibleLastLsb]", ""), ("if (visible_ready_i) visible_valid_o", "visible_valid_o"),
          ("!tested_i[VisibleVisibleLsb];", "1'b0;"), ("(!passed_valid_o || passed_ready_i)", "1'b1"),
          ("attributes_ready_o = take", "attributes_ready_o = free && attributes_valid_i")]


def run(*words):
    return subprocess.run(words, cwd=FOLDER, capture_output=True, text=True, check=False)


def icarus(unit):
    built = run("iverilog", "-g2012", "-I", ".", "-o", "bench", EXAMPLE / "bench.v", unit)
    return run("vvp", "bench").stdout if built.returncode == 0 else built.stderr


def verilator(unit):
    built = run("verilator", "--binary", "--timing", "-Wno-fatal", "-I.", "--top-module", "bench", EXAMPLE / "bench.v",
                unit)
    return run(FOLDER / "obj_dir/Vbench").stdout if built.returncode == 0 else built.stderr


def faults_of_constants():
    manifest = json.loads((FOLDER / "manifest.json").read_text())
    text = (FOLDER / "vectors.svh").read_text()
    constants = dict(re.findall(r"(\w+) = (\d+)[,;]", text))
    for stream in manifest["streams"]:
        prefix = "".join(word.capitalize() for word in stream["name"].split("_"))
        said = [constants.get(f"{prefix}Bits"), constants.get(f"{prefix}Words")]
        if said != [str(stream["bits"]), str(stream["words"])]:
            yield f"{prefix}: {said}, and the manifest says {stream['bits']}, {stream['words']}"
        for field in stream["fields"]:
            if constants.get(f"{prefix}{field['name'].capitalize()}Lsb") is None:
                continue  # of a name with more than one word
            if constants[f"{prefix}{field['name'].capitalize()}Lsb"] != str(field["lsb"]):
                yield f"{prefix}: {field['name']} is not where the manifest says"
        begins = re.findall(rf"\d+: {stream['name']}_begin = (\d+);", text)
        if [int(begin) for begin in begins] != [sum(stream["frame_words"][:n]) for n in range(len(begins))]:
            yield f"{stream['name']}: frames do not begin where the manifest says"
        if len(begins) != len(manifest["frames"]):
            yield f"{stream['name']}: {len(begins)} frames"


def faults():
    unit = EXAMPLE / "own_select.v"
    for simulator in (icarus, verilator):
        output = simulator(unit)
        if not output.startswith(PASSED):
            yield f"{simulator.__name__}: {output}"
    text = unit.read_text()
    for old, new in BROKEN:
        if text.count(old) != 1:
            yield f"{unit.name}: \"{old}\" is not there once"
        (FOLDER / "broken.v").write_text(text.replace(old, new))
        output = icarus("broken.v")
        if "FAIL" not in output or "PASS" in output:
            yield f"\"{new}\" in the place of \"{old}\" was not noticed: {output}"


shutil.rmtree(FOLDER, ignore_errors=True)
subprocess.run([HALFSPACE, "vectors", "standard", "--config", ROOT / "tests/configs/lit/lit_low.toml", "--lanes", "4",
                "--out", FOLDER, "--sv"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
found = [*faults_of_constants(), *faults()]
print("\n".join(found) or f"own_unit: two simulators, {len(BROKEN)} broken units")
sys.exit(1 if found else 0)
