#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Broken files of every kind that the program reads, made of good ones by a seed: none may crash it, hang it or make it
grow, and what it draws it draws whole. A file is read as its user would, in a process of the program.
Usage: fuzz_test.py HALFSPACE MODELS [--files N | --seconds N] [--seed N] [--keep FOLDER]
       [--kinds KIND ...]
KIND: scene (a file of each format of MODELS in turn), tri, toml, set (a manifest, or a stream of a vector set);
without, all. --files: of each kind; --seconds: as many as that for each kind. --keep: where faulty files are copied."""
import argparse
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

MOST_SECONDS, MOST_MEGABYTES, LARGEST = 20, 2048, 200_000  # of the processor, resident; bytes of a good file
NUMBERS = (b"0", b"-1", b"1", b"255", b"65536", b"2147483647", b"4294967295", b"-2147483648", b"1e39", b"1e-39", b"nan",
           b"99999999999999999999", b"0.5", b"")


def mutated(data, rng):
    """Bytes turned, cut, doubled, exchanged, or a number of a text replaced."""
    data = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 4, 16))):
        if not data:
            break
        at, length = rng.randrange(len(data)), rng.choice((1, 4, 16, 256))
        way = rng.randrange(7)
        if way == 0:
            data[at] ^= 1 << rng.randrange(8)
        elif way == 1:
            data[at:at + 4] = rng.choice((b"\xff\xff\xff\xff", b"\0\0\0\0", b"\xff\xff\xff\x7f", b"\0\0\xc0\x7f"))
        elif way == 2:
            del data[at:at + length]
        elif way == 3:
            data[at:at] = data[at:at + length] * rng.choice((1, 2, 50))
        elif way == 4:
            del data[at:]
        elif way == 5:
            other = rng.randrange(len(data))
            data[at:at + length] = data[other:other + length]
        else:
            numbers = list(re.finditer(rb"-?\d+(\.\d+)?", data[at:at + 4096]))
            if numbers:
                one = rng.choice(numbers)
                data[at + one.start():at + one.end()] = rng.choice(NUMBERS)
    return bytes(data)


def scenes(models):
    """Good files, a list for each format."""
    by_format = {}
    for path in sorted(models.rglob("*")):
        if path.is_file() and 0 < path.stat().st_size < LARGEST and "invalid" not in path.parts:
            by_format.setdefault(path.suffix.lower(), []).append(path)
    for other in (".png", ".jpg", ".jpeg", ".tga", ".bmp", ".bin", ".txt", ".md", ".mtl", ".material", ".gif", ".dds",
                  ".source", ".license", "", ".pk3", ".zip", ".psd", ".html", ".bat", ".sh", ".py", ".h", ".cpp"):
        by_format.pop(other, None)
    return by_format


class Fuzz:
    def __init__(self, halfspace, models, folder):
        self.halfspace, self.folder = halfspace, folder
        self.formats = scenes(models)
        self.tri, self.set = folder / "good", folder / "set"
        low = ["cube", "--config", "low", "--size", "64x48"]
        self.run([halfspace, "render", *low, "--engine", "ref", "--dump", self.tri])
        self.run([halfspace, "vectors", *low, "--lanes", "4", "--out", self.set])
        self.toml = folder / "good.toml"
        self.toml.write_text(subprocess.run([halfspace, "config", "middle"], capture_output=True, text=True,
                                            check=True).stdout)

    @staticmethod
    def run(command):
        subprocess.run(command, check=True, capture_output=True)

    def scene(self, number, rng):
        names = sorted(self.formats)
        good = rng.choice(self.formats[names[number % len(names)]])
        # Beside copies of its neighbours, so that what it names is there.
        here = self.folder / "scene"
        shutil.rmtree(here, ignore_errors=True)
        here.mkdir()
        for neighbour in good.parent.iterdir():
            if neighbour.is_file() and neighbour != good:
                (here / neighbour.name).symlink_to(neighbour)
        bad = here / good.name
        bad.write_bytes(mutated(good.read_bytes(), rng))
        textured = ["--texture", "nearest"] if rng.randrange(2) else []
        picture = ["-o", self.folder / "out.png"]
        return bad, good, ["render", bad, "--engine", "ref", "--size", "64x48", *picture, *textured]

    def tri_file(self, _, rng):
        bad = self.folder / "bad.tri"
        bad.write_bytes(mutated((self.tri / "triangles.tri").read_bytes(), rng))
        return bad, "triangles.tri", ["render", bad, "--engine", "ref", "-o", self.folder / "out.png"]

    def toml_file(self, _, rng):
        bad = self.folder / "bad.toml"
        bad.write_bytes(mutated(self.toml.read_bytes(), rng))
        return bad, "middle.toml", ["config", bad]

    def set_file(self, _, rng):
        here = self.folder / "broken_set"
        shutil.rmtree(here, ignore_errors=True)
        shutil.copytree(self.set, here)
        bad = rng.choice(sorted(p for p in here.rglob("*") if p.is_file()))
        bad.write_bytes(mutated(bad.read_bytes(), rng))
        return bad, bad.name, ["compare", self.set, here]

    def fault(self, command):
        """What is wrong with how a command ends, or ''."""
        picture = self.folder / "out.png"
        picture.unlink(missing_ok=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = subprocess.run([self.halfspace, *map(str, command)], capture_output=True, timeout=10 * MOST_SECONDS,
                                  check=False)
        except subprocess.TimeoutExpired:
            return "does not end"
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        said = done.stderr.decode(errors="replace").strip()
        if done.returncode < 0 or done.returncode > 2 or "Sanitizer" in said or "runtime error" in said:
            return f"status {done.returncode}: {said[:2000]}"
        if seconds > MOST_SECONDS:
            return f"{seconds:.0f} seconds"
        if after.ru_maxrss > MOST_MEGABYTES * 1024:
            return f"{after.ru_maxrss // 1024} MB"
        if done.returncode == 0 and command[0] == "render" and not picture.is_file():
            return "status 0, and no picture"
        if done.returncode != 0 and not said and command[0] != "compare":
            return "a status, and no sentence"
        lines = [line for line in said.splitlines() if line]
        unframed = [line for line in lines if not re.match(r"halfspace: |warning: ", line)]
        if command[0] != "compare" and unframed:
            return f"words that are not its own: {unframed[0][:200]}"
        return ""


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("halfspace")
    parser.add_argument("models", type=pathlib.Path)
    parser.add_argument("--kinds", nargs="+")
    parser.add_argument("--files", type=int, default=40)
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    faults, total, drawn = [], 0, 0
    with tempfile.TemporaryDirectory() as folder:
        fuzz = Fuzz(options.halfspace, options.models, pathlib.Path(folder))
        makers = {"scene": fuzz.scene, "tri": fuzz.tri_file, "toml": fuzz.toml_file, "set": fuzz.set_file}
        for kind in options.kinds or makers:
            start, number = time.monotonic(), 0
            while (time.monotonic() - start < options.seconds) if options.seconds else number < options.files:
                bad, good, command = makers[kind](number, random.Random(f"{options.seed} {kind} {number}"))
                fault = fuzz.fault(command)
                drawn += (fuzz.folder / "out.png").is_file()
                if fault:
                    faults.append(f"seed {options.seed}, {kind} {number}, from {good}: {fault}")
                    if options.keep:
                        options.keep.mkdir(parents=True, exist_ok=True)
                        shutil.copy(bad, options.keep / f"{kind}_{number}_{bad.name}")
                number += 1
            total += number
            print(f"{kind}: {number} files, {len(faults)} at fault so far", flush=True)
    print("\n".join(faults))
    print(f"fuzz: seed {options.seed}, {total} files, {drawn} drawn, {len(faults)} at fault")
    return 1 if faults or total == 0 else 0


if __name__ == "__main__":
    os.environ.setdefault("ASAN_OPTIONS", "detect_leaks=0:allocator_may_return_null=1:hard_rss_limit_mb=1900")
    sys.exit(main())
