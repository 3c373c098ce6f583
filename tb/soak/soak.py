#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random scenes on random configurations under random stalls and resets, round after round, until time is over.

A round is a configuration that `halfspace config --random --small` draws, with random sets of vectors for each of its
designs, each under several stalls and seeds. All of it follows from --seed and the number of the round. A round that
is done leaves OUT/rounds/N.json and is not run again: where it was cut off it goes on. What is wrong is shrunk and
stays in OUT/failures/N, with the command that repeats it in repeat.sh. Status 1 if anything is.

tb/soak/Snakefile makes each round a job, on this machine or on others."""

import argparse
import json
import pathlib
import random
import re
import resource
import shlex
import shutil
import sys
import threading
import time

from designs import RTL, Broken, Design, Refused, drawn, judge, run, stalls


def fragments_of(vectors):
    """Covered pixels of triangles in a set of vectors."""
    manifest = json.loads((vectors / "manifest.json").read_text())
    for stream in manifest["streams"]:
        mask = next((field for field in stream["fields"] if field["name"] == "mask"), None)
        if stream["name"] == "stamp" and mask:
            low, ones = mask["lsb"], (1 << mask["width"] * mask["count"]) - 1
            text = re.sub(r"//.*", "", (vectors / stream["file"]).read_text())
            return sum(bin(int(word, 16) >> low & ones).count("1") for word in text.split())
    return 0


class Round:
    def __init__(self, args, number):
        self.args, self.number = args, number
        self.draw = random.Random(f"{args.seed}/{number}")
        self.folder = args.out / "work" / str(number)
        self.result = {"seed": args.seed, "round": number, "fragments": 0, "words": 0, "runs": 0, "failures": []}

    def run(self):
        """What is known of it, as a dictionary."""
        begin = time.monotonic()
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        seed = self.draw.randrange(1 << 31)
        self.result["configuration"] = str(self.args.config or f"--random {seed} --small")
        try:
            if self.args.config:
                self.design = Design(self.args.halfspace, self.folder, self.args.config)
            else:
                self.design = drawn(self.args.halfspace, self.folder, seed, small=True)
            for top in self.design.tops:
                bench = self.design.build(top, self.args.library, rtl=self.args.rtl, verilator=self.args.verilator,
                                          cxx=self.args.cxx, optimize=self.args.optimize)
                for _ in range(self.args.sets):
                    if not self.try_set(top, bench):
                        break  # the rest would tell the same
        except (Broken, Refused) as failure:
            self.keep(str(failure), [sys.executable, pathlib.Path(__file__).resolve(), *sys.argv[1:], "--round",
                                     self.number])
        self.result["seconds"] = round(time.monotonic() - begin, 1)
        shutil.rmtree(self.folder, ignore_errors=True)
        return self.result

    def try_set(self, top, bench):
        vectors = self.folder / "vectors"
        scene = self.design.scene(top, self.draw, self.args.frames)
        if not scene:
            return True
        self.design.vectors(scene, vectors)
        fragments = fragments_of(vectors)
        for _ in range(self.args.runs):
            stall, seed = stalls(self.draw), self.draw.randint(1, 1 << 30)
            one, wrong = judge(bench, vectors, stall, seed, self.folder / "cosim.json")
            if wrong:
                self.shrink(top, bench, scene, stall, seed, wrong)
                return False
            self.result["fragments"] += fragments
            self.result["words"] += one["words"]
            self.result["runs"] += 1
        return True

    def keep(self, wrong, command, files=()):
        """A folder with what was wrong, the configuration and the command."""
        kept = self.args.out / "failures" / f"{self.number}_{len(self.result['failures'])}"
        shutil.rmtree(kept, ignore_errors=True)
        kept.mkdir(parents=True)
        for file in files:
            (shutil.copytree if file.is_dir() else shutil.copy)(file, kept / file.name)
        (kept / "wrong.txt").write_text(wrong + "\n")
        (kept / "repeat.sh").write_text(shlex.join(map(str, command)) + "\n")
        self.result["failures"].append(str(kept))
        print(f"soak: round {self.number}: {wrong.splitlines()[0] if wrong else ''}\n  {kept}/repeat.sh", flush=True)
        return kept

    def shrink(self, top, bench, scene, stall, seed, wrong):
        """Of a pipeline `halfspace shrink` looks for the fewest frames and triangles; of the other designs fewer frames
        and no stalls are tried here."""
        kept = self.keep(wrong, [], [self.design.toml, self.design.package, bench.parent])
        bench, toml = kept / top / "bench", kept / pathlib.Path(self.design.toml).name
        command = [bench, kept / "vectors", "--stall", stall, "--seed", seed]
        if top == "hs_pipeline":
            options = [word.replace("--seed", "--frame-seed") if isinstance(word, str) else word for word in scene]
            status, said = run([self.args.halfspace, "shrink", *options, "--config", toml, "--lanes", self.design.lanes,
                                "--bench", bench, "--stall", stall, "--seed", seed, "--out", kept])
            (kept / "shrink.txt").write_text(said)
            if not status:
                print(f"  {said.splitlines()[0]}", flush=True)
                return  # it leaves repeat.sh
        else:
            scene, stall = self.fewer(bench, kept, scene, stall, seed)
            command = [bench, kept / "vectors", "--stall", stall, "--seed", seed]
        shutil.rmtree(kept / "vectors", ignore_errors=True)
        Design(self.args.halfspace, kept, toml).vectors(scene, kept / "vectors")
        (kept / "repeat.sh").write_text(shlex.join(map(str, command)) + "\n")

    def fewer(self, bench, kept, scene, stall, seed):
        """(scene, stall) that still fail."""
        def fails(scene, stall):
            self.design.vectors(scene, kept / "vectors")
            return bool(judge(bench, kept / "vectors", stall, seed, kept / "cosim.json")[1])

        at = scene.index("--intervals" if "--intervals" in scene else "--frames") + 1
        while scene[at] > 1 and fails([*scene[:at], scene[at] // 2, *scene[at + 1:]], stall):
            scene = [*scene[:at], scene[at] // 2, *scene[at + 1:]]
        return (scene, 0) if stall and fails(scene, 0) else (scene, stall)


def finish(args, number):
    """A round, whose file appears whole or not at all."""
    result = Round(args, number).run()
    path = args.out / "rounds" / f"{number}.json"
    part = path.with_suffix(".part")
    part.write_text(json.dumps(result) + "\n")
    part.replace(path)
    return result


def processor_hours():
    """Of the programs that were run, in this process."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (used.ru_utime + used.ru_stime) / 3600


def told(results, hours):
    total = {key: sum(one[key] for one in results) for key in ("fragments", "words", "runs")}
    failures = sum(len(one["failures"]) for one in results)
    pace = f", {total['fragments'] / hours:.3g} fragments an hour of a processor" if hours else ""
    print(f"soak: {len(results)} rounds, {total['runs']} runs, {total['fragments']} fragments and {total['words']} "
          f"words compared{pace}; {failures} failures", flush=True)
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--halfspace", required=True, help="the program")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder; give it again to go on")
    parser.add_argument("--library", action="append", required=True,
                        help="the harness and Verilator's library, in this order: --library A.a --library B.a")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--hours", type=float, help="no round begins after so long")
    parser.add_argument("--rounds", type=int, help="rounds 0 … N − 1, whatever the time")
    parser.add_argument("--round", type=int, help="this one alone")
    parser.add_argument("--told", action="store_true", help="run nothing, sum up what is there")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--config", type=pathlib.Path, help="this configuration, and no random ones")
    parser.add_argument("--sets", type=int, default=8, help="of vectors for a design (default: %(default)s)")
    parser.add_argument("--frames", type=int, default=200, help="random frames of a set (default: %(default)s)")
    parser.add_argument("--runs", type=int, default=3, help="stalls and seeds for a set (default: %(default)s)")
    parser.add_argument("--rtl", type=pathlib.Path, default=RTL)
    parser.add_argument("--optimize", default="-O1", help="of the compiler (default: %(default)s)")
    parser.add_argument("--verilator", default="verilator")
    parser.add_argument("--cxx", default="c++")
    args = parser.parse_args()
    args.out = args.out.resolve()
    (args.out / "rounds").mkdir(parents=True, exist_ok=True)
    if args.round is not None:
        return 1 if finish(args, args.round)["failures"] else 0
    stamp = args.out / "seed"
    if stamp.exists() and stamp.read_text().strip() != str(args.seed):
        print(f"soak: {args.out} is of seed {stamp.read_text().strip()}: take another folder, or that seed",
              file=sys.stderr)
        return 2
    stamp.write_text(f"{args.seed}\n")
    print(f"soak: seed {args.seed}, {args.out}", flush=True)
    begin, lock, next_round, mine = time.monotonic(), threading.Lock(), [0], []

    def work():
        while True:
            with lock:
                while (args.out / "rounds" / f"{next_round[0]}.json").exists():
                    next_round[0] += 1
                number = next_round[0]
                next_round[0] += 1
            late = args.hours is not None and time.monotonic() - begin > args.hours * 3600
            if late or args.told or (args.rounds is not None and number >= args.rounds):
                return
            mine.append(finish(args, number))
            if len(mine) % 20 == 0:
                told(mine, processor_hours())

    workers = [threading.Thread(target=work) for _ in range(args.jobs)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    if mine:
        told(mine, processor_hours())
    every = [json.loads(path.read_text()) for path in sorted((args.out / "rounds").glob("*.json"))]
    print("all that is there, ", end="")
    return 1 if told(every, 0) or not every else 0


if __name__ == "__main__":
    sys.exit(main())
