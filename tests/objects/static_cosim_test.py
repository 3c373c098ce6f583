#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A random sequence of the static objects buffer on the RTL: its passes through the bench of hs_pipeline, its runs
through that of ztest_merge. What is merged is word by word what the pipeline gave. Judges by what the reports count:
every stream has words, none mismatches, and all kinds of runs were there.
Usage: static_cosim_test.py HALFSPACE PIPELINE MERGE FOLDER CONFIG LANES [--stall P] [--seed N] [-- options of
`halfspace vectors static`]"""
import argparse
import json
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "pipeline"))
from cosim_test import run, run_bench  # noqa: E402


def words(folder, name):
    """The words of each frame as integers, and how many bits below `last` of a stream that begins with it there are."""
    manifest = json.loads((folder / "manifest.json").read_text())
    stream = next(s for s in manifest["streams"] if s["name"] == name)
    lines = [line for line in (folder / stream["file"]).read_text().splitlines() if not line.startswith("//")]
    frames, at = [], 0
    for count in stream["frame_words"]:
        frames.append([int(line, 16) for line in lines[at:at + count]])
        at += count
    return frames, next(f["lsb"] for f in stream["fields"] if f["name"] == "last")


def chain(folder):
    """Counts the runs of each kind, and the words that came from a pass."""
    passes, below = words(folder / "pipeline", "entry")
    drawn, same_below = words(folder / "merge", "entry")
    if below != same_below:
        raise SystemExit("the entries of the two sets have different fields")
    mask = (1 << below) - 1
    given = [{word & mask for word in frame} for frame in passes]
    kinds, followed, used = {}, 0, set()
    for n, frame in enumerate(json.loads((folder / "merge" / "manifest.json").read_text())["frames"]):
        kind, number = re.fullmatch(r"frame \d+, (\w+)(?:, pass (\d+))?", frame["note"]).groups()
        kinds[kind] = kinds.get(kind, 0) + 1
        if number is None:
            continue
        strange = [word for word in drawn[n] if word & mask not in given[int(number)]]
        if strange or not drawn[n]:
            raise SystemExit(f"run {n}: {len(strange)} of {len(drawn[n])} words of `entry` are not of pass {number}")
        followed += len(drawn[n])
        used.add(int(number))
    return kinds, followed, len(used), len(passes)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("halfspace", "pipeline", "merge", "folder", "config", "lanes"):
        parser.add_argument(name)
    parser.add_argument("--stall", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    own = sys.argv[1:]
    at = own.index("--") if "--" in own else len(own)
    args = parser.parse_args(own[:at])
    folder = pathlib.Path(args.folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    code, text = run([args.halfspace, "vectors", "static", "--config", args.config, "--lanes", args.lanes, "--out",
                      str(folder),
                      "--seed", str(args.seed), *own[at + 1:]])
    print(text, end="")
    if code:
        return code
    kinds, followed, used, passes = chain(folder)
    print(f"runs: {kinds}; {followed} words of {used} passes of {passes} are merged")
    wanted = {"add", "erase", "frame"} | ({"query"} if "--no-query" not in own else set())
    wanted |= {"compose"} if "--buffers" in own else set()
    if set(kinds) != wanted:
        print(f"and not {wanted}")
        return 1
    for program, part in ((args.pipeline, "pipeline"), (args.merge, "merge")):
        text, _ = run_bench(program, folder / part, args.stall, args.seed)
        print(text.strip().splitlines()[-1])
    shutil.rmtree(folder, ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
