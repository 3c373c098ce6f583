#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a vector set and runs a Verilated program on it under several stall seeds. Judges by what the reports count:
every stream has words, none mismatches.
SCENE `layers` is one of its own.
Usage: cosim_test.py HALFSPACE PROGRAM FOLDER SCENE CONFIG LANES [--stall P] [--seeds N] [--bound X] [-- options of
`halfspace vectors`]"""
import argparse
import json
import pathlib
import random
import shutil
import subprocess
import sys


def run(command):
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    # A failure tells more on standard error; progress there is of no interest.
    return result.returncode, result.stdout + (result.stderr if result.returncode else "")


def layers(path):
    """Triangles behind each other, the farthest first: under each stamp there are others, so that the Z-test of type
    gamma sets the pace."""
    draw = random.Random(1)
    lines = ["size 160 120"]
    for k in range(300):
        x, y = draw.uniform(0, 160), draw.uniform(0, 120)
        corners = [(x + draw.uniform(-50, 50), y + draw.uniform(-50, 50)) for _ in range(3)]
        vertices = [f" {a:.3f} {b:.3f} {0.95 - k / 400 + draw.uniform(-0.05, 0.05):.4f} {k % 256} 90 {255 - k % 256}"
                    for a, b in corners]
        lines.append("t" + "".join(vertices))
    path.write_text("\n".join(lines) + "\n")


def run_bench(program, folder, stall, seed):
    """What the bench says of the vectors of a folder, and the runs of its report. Ends the test where it fails, where a
    stream has no words and where one mismatches."""
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    code, text = run([program, str(folder), "--seed", str(seed), "--stall", str(stall), "--json", str(report)])
    if code or not report.exists():
        raise SystemExit(f"{text}\nseed {seed}: {program} failed with status {code}")
    runs = json.loads(report.read_text())["runs"]
    for one in runs:
        bad = [s["name"] for s in one["streams"] if s["words"] == 0 or s["mismatches"] != 0]
        if bad or not one["streams"] or one["mismatches"] or one["failures"] or not one["passed"]:
            raise SystemExit(f"{text}\nseed {seed}, {one['unit']}: streams {bad or 'none'} without words or "
                             "with mismatches")
    if not runs:
        raise SystemExit(f"{text}\nseed {seed}: {program} reports no unit")
    return text, runs


COUNTED = ("triangles", "reduced_triangles", "culled", "fragments", "reduced_fragments", "visible_pixels")
ACCESSES = ("entry_bits", "read", "written", "bytes_read", "bytes_written")


def present(bits):
    return {name: number for name, number in bits.items() if number}


def counts(args, engine, options, architecture):
    """What the scene takes by the reference or by the kernels: data rates, and accesses of each buffer."""
    report = pathlib.Path(args.folder) / f"{engine}.json"
    by = ["--architecture", architecture] if engine == "ref" else []
    code, text = run([args.halfspace, "render", args.scene, "--config", args.config, "--engine", engine, "--lanes",
                      args.lanes, *by,
                      *options, "--json", str(report)])
    if code:
        raise SystemExit(text)
    return json.loads(report.read_text())


def difference(args, one, options):
    """Why the RTL's counters of a scene are not those of the kernels and of the reference, or its cycles without stalls
    not those of the model; nothing if they are."""
    buffers = one["buffers"]
    architecture = "gamma" if "visibility_database" in buffers else "delta"
    for engine in ("ref", "hls"):
        found = counts(args, engine, options, architecture)
        counted = [*COUNTED, *(name for name in ("lightings", "texture_fetches") if name in one["rates"])]
        rates = {name: found["rates"][name] for name in counted}
        if rates != one["rates"] or not rates["visible_pixels"]:
            return f"the rates differ: {engine} {rates}, RTL {one['rates']}"
        whole = engine == "hls"  # the reference has no memories, and so no words
        mine = buffers if whole else {name: {key: use[key] for key in ACCESSES} for name, use in buffers.items()}
        if found["buffers"] != mine or not all(use["read"] and use["written"] for use in mine.values()):
            return f"the accesses differ: {engine} {found['buffers']}, RTL {mine}"
        if whole and present(found["memory_bits"]) != one["memory_bits"]:
            return f"the memories differ: {engine} {found['memory_bits']}, RTL {one['memory_bits']}"
        if whole and found["modelled_cycles"] and found["modelled_cycles"]["triangle_setup"] != one["bound"]["setup"]:
            return f"the setup takes {one['bound']['setup']} cycles, by the model {found['modelled_cycles']}"
        if whole and args.stall == 0 and found["modelled_cycles"]:
            modelled, cycles = found["modelled_cycles"]["frame"], one["cycles"]
            print(f"{cycles} cycles a frame, {modelled} by the model: {modelled / cycles:.5f}")
            if abs(modelled - cycles) > 2 + args.model * cycles:
                return f"the model is off by more than 2 cycles and {args.model} of the frame"
    return ""


def compensation_difference(frames, one, without_stalls):
    """Why the tiles that the caches missed, or the cycles where nothing stalls, are not those of the kernel; nothing if
    they are."""
    frames = frames + [frames[n] for n in one["repeated"]]
    for key in (0, 1):
        fetched = next(s["words"] for s in one["streams"] if s["name"] == f"key_request_{key}")
        missed = sum(frame["misses"][key] for frame in frames)
        if fetched != missed:
            return f"key {key}: {fetched} tiles are fetched, {missed} in the kernel"
    cycles = sum(frame["cycles"] for frame in frames)
    if without_stalls and cycles != one["cycles"]:
        return f"{one['cycles']} cycles, and {cycles} are a word each, the tiles, and the latency of each frame"
    return ""


MERGE_LATENCY = 3  # from the last stamp of a run to its word of `found`


def merge_difference(frames, one, without_stalls):
    """Why the cycles of runs behind each other, where nothing stalls, are not those of the kernel; nothing if they
    are."""
    cycles = sum(frame["cycles"] for frame in frames) + MERGE_LATENCY
    if without_stalls and cycles != one["cycles"]:
        return f"{one['cycles']} cycles, and {cycles} are a word each, a command a run, and the latency of the last"
    return ""


STATIC_MODEL = 0.05  # passes overlap with runs, and runs with each other's latency


def static_difference(frames, one, without_stalls):
    """Why the cycles of a sequence, where nothing stalls, are not those of the model; nothing if they are."""
    modelled, cycles = sum(frame["cycles"] for frame in frames), one["cycles"]
    bound = one["bound"]["cycles"]
    print(f"{cycles / len(frames):.0f} cycles a frame, {modelled / cycles:.4f} of them by the model, bound "
          f"{bound / len(frames):.0f}")
    if without_stalls and abs(modelled - cycles) > STATIC_MODEL * cycles:
        return f"{cycles} cycles, and {modelled} by the model: off by more than {STATIC_MODEL}"
    return ""


UNIT_DIFFERENCES = {"motion_compensate": compensation_difference, "ztest_merge": merge_difference,
                    "static_frames": static_difference}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("halfspace", "program", "folder", "scene", "config", "lanes"):
        parser.add_argument(name)
    parser.add_argument("--stall", type=int, default=30)
    parser.add_argument("--seeds", type=int, default=1, help="run seeds 1 … N")
    parser.add_argument("--bound", type=float, default=0, help="cycles a frame at most, as a multiple of the bound")
    parser.add_argument("--model", type=float, default=0.001,
                        help="how far the cycles of the model may be off, as a share of a frame")
    own = sys.argv[1:]
    at = own.index("--") if "--" in own else len(own)
    args = parser.parse_args(own[:at])

    folder = pathlib.Path(args.folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    if args.scene == "layers":
        folder.mkdir()
        args.scene = str(folder / "layers.tri")
        layers(pathlib.Path(args.scene))
    code, text = run([args.halfspace, "vectors", args.scene, "--config", args.config, "--lanes", args.lanes, "--out",
                      str(folder), *own[at + 1:]])
    print(text, end="")
    if code:
        return code
    words = 0
    for seed in range(1, args.seeds + 1):
        text, runs = run_bench(args.program, folder, args.stall, seed)
        for one in runs:
            words += one["words"]
            # Counted at the RTL's streams, in the kernels and by the reference; of a scene alone.
            if seed == 1 and one["unit"] == "pipeline" and "--no-corners" in own:
                why = difference(args, one, [option for option in own[at + 1:] if option != "--no-corners"])
                if why:
                    print(why)
                    return 1
            frames = json.loads((folder / "manifest.json").read_text())["frames"]
            of_unit = UNIT_DIFFERENCES.get(one["unit"])
            if of_unit and "cycles" in frames[0]:  # not of a film
                why = of_unit(frames, one, args.stall == 0)
                if why:
                    print(why)
                    return 1
            bound = one.get("bound", {}).get("cycles", 0)
            if args.bound and not 0 < one["cycles"] <= args.bound * bound:
                print(f"{one['cycles']} cycles a frame, more than {args.bound} times the bound of {bound}")
                return 1
        print("".join(line + "\n" for line in text.splitlines() if line.startswith("film of ")), end="")
        print(text.strip().splitlines()[-1] + f" (seed {seed})")
    print(f"{words} words equal under {args.seeds} seeds")
    shutil.rmtree(folder, ignore_errors=True)
    return 0 if words else 1


if __name__ == "__main__":
    sys.exit(main())
