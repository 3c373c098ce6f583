# SPDX-License-Identifier: Apache-2.0
"""The triangle lists that hs_board_lists plays, and the pictures that have to come of them.

A scene is SCENE, or SCENE:FRAMES, so many frames of its animation, 30 a second. Lists and pictures are words of the
streams `triangle` and `pixel` that `halfspace vectors` writes of each frame. The lists have a word a triangle, for
$readmemh: {last of the frame, last of the scene, last of all, the triangle without last and index}.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # no __pycache__ between the sources
RATE = 30


class ListError(Exception):
    """A sentence."""


def scene(text):
    name, _, frames = text.partition(":")
    if frames and not (frames.isdigit() and int(frames) > 0):
        raise argparse.ArgumentTypeError(f"{text}: it is a scene, or a scene, a colon and a number of frames")
    return name, int(frames or 1)


def stream(folder, manifest, name):
    """The fields of a stream, its bits, and its words."""
    found = next(one for one in manifest["streams"] if one["name"] == name)
    lines = (folder / found["file"]).read_text().splitlines()
    return found, [int(line, 16) for line in lines if line and not line.startswith("//")]


def field(description, word, name):
    place = next(one for one in description["fields"] if one["name"] == name)
    return word >> place["lsb"] & ((1 << place["width"]) - 1)


def frame(halfspace, config, name, time):
    """(bits of a word, its triangles without last and index; the background; the rows of the picture, (r, g, b))."""
    with tempfile.TemporaryDirectory(prefix="halfspace-board-") as folder:
        folder = pathlib.Path(folder)
        done = subprocess.run([halfspace, "vectors", name, "--config", config, "--lanes", "1", "--time", str(time),
                               "--no-corners", "--out", folder], capture_output=True, text=True)
        if done.returncode:
            raise ListError(done.stderr.strip().splitlines()[-1])
        manifest = json.loads((folder / "manifest.json").read_text())
        triangles, words = stream(folder, manifest, "triangle")
        for number, word in enumerate(words, 1):
            # A frame without a triangle is one of index 0, which no pixel has.
            if field(triangles, word, "index") not in (number, 0):
                raise ListError(f"{name}: triangles are not numbered in order, as hs_board_lists numbers them")
        fields = triangles["bits"] - sum(one["width"] for one in triangles["fields"]
                                         if one["name"] in ("last", "index"))
        pixels, shown = stream(folder, manifest, "pixel")
        head = manifest["frames"][0]
        rows = [[(0, 0, 0)] * head["width"] for _ in range(head["height"])]
        for word in shown:
            rows[field(pixels, word, "y")][field(pixels, word, "x")] = tuple(field(pixels, word, c) for c in "rgb")
        return fields, [word & ((1 << fields) - 1) for word in words], head["background"], rows


def lists(halfspace, config, scenes):
    """(bits of an entry, entries, pictures of all frames in order, background)."""
    entries, pictures, bits, background = [], [], 0, None
    for name, frames in scenes:
        for number in range(frames):
            bits, words, behind, rows = frame(halfspace, config, name, number / RATE)
            if background not in (None, behind):
                raise ListError(f"{name} has another background than the scene before: a board has one")
            background = behind
            pictures.append(rows)
            ends = [len(words) - 1 == n for n in range(len(words))]
            for word, end in zip(words, ends):
                scene_end = end and number == frames - 1
                entries.append(((end << 2 | scene_end << 1) << bits) | word)
    entries[-1] |= 1 << bits
    return bits + 3, entries, pictures, background


def number_of(colour, bits):
    """{r, g, b} as one number."""
    number = 0
    for channel in colour:
        number = number << bits | channel
    return number


def memory(entries, bits, room):
    """The text of the file."""
    if len(entries) > room:
        raise ListError(f"{len(entries)} triangles, and there is room for {room}: take fewer frames")
    digits = (bits + 3) // 4
    return "".join(f"{word:0{digits}x}\n" for word in entries + [0] * (room - len(entries)))
