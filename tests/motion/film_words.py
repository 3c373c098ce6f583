#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random words for the units of a film, from what they are to do and not from the kernels: frames that show nothing,
frames without holes and with many, of one face or of one tile, edges that a tile ends at, or that it ends a pixel
before, the last index and behind it a triangle without one, a face whose upper bit alone is set. A vector set with no
more streams than these units have. Usage: film_words.py PACKAGE OUT LANES [SEED]"""
import json
import pathlib
import random
import re
import sys

sys.dont_write_bytecode = True  # no __pycache__ between the sources
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "rtl"))
from units import CONFIG, LANES, constants  # noqa: E402

SIZES, BACKGROUND, TILE = [(37, 22), (32, 24), (33, 17), (5, 3)], [16, 24, 40], 8


def layouts(text, c, lanes):
    """{stream: (from, to, [(field, bits, lanes)])}, most significant first."""
    head = [("last", 1, 1), ("x", c["XBits"], 1), ("y", c["YBits"], 1)]
    face, rgb = [("face", c["FaceBits"], 1)], [(channel, c["ColourBits"], 1) for channel in "rgb"]
    keys = c["MotionWordBits"] - 1 - c["XBits"] - c["YBits"] - c["FaceBits"]
    motion = head + face + [("key_0", keys // 2, 1), ("key_1", keys - keys // 2, 1)]
    scan = head + [("index", c["IndexBits"], lanes)]
    record = re.search(r"typedef struct packed \{([^}]*)\} triangle_t", text).group(1)
    triangle = [(name, int(top or 0) + 1, 1)
                for top, name in re.findall(r"logic (?:signed )?(?:\[(\d+):0\] )?(\w+);", record)]
    return {"triangle": ("geometry", "triangle_setup", triangle),
            "scan": ("scan_index", "hole_scan", scan), "masked": ("hole_scan", "shader", scan),
            "pixel": ("shader", "pixel_store", head + [(channel, c["ColourBits"], lanes) for channel in "rgb"]),
            "shown": ("pixel_store", "key_memory", head + [("shown", 1, 1)] + face + rgb),
            "motion": ("motion_field", "motion_order", motion),
            "ordered": ("motion_order", "motion_compensate", motion),
            "compensated": ("motion_compensate", "hole_find", head + rgb + [("keys", 2, 1)]),
            "asked": ("hole_find", "geometry", [("last", 1, 1)] + face), "film": ("film_scan", "frame", head + rgb)}


class Film:
    def __init__(self, text, lanes, seed):
        self.draw, self.numbers, (self.lanes_x, self.lanes_y) = random.Random(seed), constants(text), LANES[lanes]
        self.layouts = layouts(text, self.numbers, lanes)
        self.words = {name: [] for name in self.layouts}
        self.passes, self.counts, self.slots, self.keys = [], [], [{}, {}], 0
        self.width = self.height = 0

    def begin(self, kind):
        self.passes.append({"width": self.width, "height": self.height, "background": BACKGROUND,
                            "triangles": 1, "pass": kind, "interval": 0, "field": 1, "weight": 1})
        self.counts.append(dict.fromkeys(self.layouts, 0))

    def put(self, name, **values):
        word = 0
        for field, bits, lanes in self.layouts[name][2]:
            value = values.get(field, 0)
            word <<= bits * lanes
            for lane, part in enumerate(value if isinstance(value, list) else [value]):
                word |= (part & ((1 << bits) - 1)) << (bits * lane)
        self.words[name].append(word)
        self.counts[-1][name] += 1

    def colour(self):
        return [self.draw.randrange(1 << self.numbers["ColourBits"]) for _ in range(3)]

    def face(self):
        bits = self.numbers["FaceBits"]
        return self.draw.choice([*range(1, 6), *range(1, 6), 1 << (bits - 1), self.draw.randrange(1, 1 << bits)])

    def triangles(self, face=None):
        """{index: face}, the last index first."""
        indices = [self.numbers["Triangles"], *range(1, self.draw.randrange(2, 9))]
        faces = {index: face or self.face() for index in indices}
        self.again(faces)
        return faces

    def again(self, faces):
        for index, face in faces.items():
            self.put("triangle", last=index == len(faces) - 1, index=index, face=face)
            if index == self.numbers["Triangles"]:
                self.put("triangle", face=self.face())

    def picture(self, faces, share, places=lambda x, y: True):
        indices = sorted(faces)
        return {(x, y): self.draw.choice(indices) if self.draw.random() < share and places(x, y) else 0
                for x in range(self.width) for y in range(self.height)}

    def stamps(self, shows, holes=None):
        """[(last, x, y, [index of a lane])]; with holes, of these alone."""
        right, low, out = -(-self.width // self.lanes_x), -(-self.height // self.lanes_y), []
        for y in range(low):
            for x in range(right):
                places = self.places(x, y)
                last = y == low - 1 and x == right - 1
                if holes is None or last or any(place in holes for place in places):
                    out.append((last, x, y, [shows.get(place, 0) if holes is None or place in holes else 0
                                             for place in places]))
        return out

    def places(self, x, y):
        return [(x * self.lanes_x + lane % self.lanes_x, y * self.lanes_y + lane // self.lanes_x)
                for lane in range(self.lanes_x * self.lanes_y)]

    def scan(self, shows, holes=None):
        for last, x, y, index in self.stamps(shows):
            self.put("scan", last=last, x=x, y=y, index=index)
        stamps = self.stamps(shows, holes)
        for last, x, y, index in stamps:
            self.put("masked", last=last, x=x, y=y, index=index)
        return stamps

    def shade(self, stamps, faces):
        """{place: (index, colour)}"""
        seen = {}
        for last, x, y, index in stamps:
            colours = [self.colour() if shown else BACKGROUND for shown in index]
            self.put("pixel", last=last, x=x, y=y, **{c: [rgb[n] for rgb in colours] for n, c in enumerate("rgb")})
            inside = [(place, i, rgb) for place, i, rgb in zip(self.places(x, y), index, colours)
                      if place[0] < self.width and place[1] < self.height]
            for place, i, rgb in inside:
                self.put("shown", last=last and place == inside[-1][0], x=place[0], y=place[1], shown=i != 0,
                         face=faces[i] if i else 0, r=rgb[0], g=rgb[1], b=rgb[2])
                seen[place] = (i, rgb)
        return seen

    def show(self, seen):
        for y in range(self.height):
            for x in range(self.width):
                r, g, b = seen.get((x, y), BACKGROUND)
                self.put("film", last=x == self.width - 1 and y == self.height - 1, x=x, y=y, r=r, g=g, b=b)

    def key(self, shows):
        """`shows`: as the first one, whose frame nothing was before."""
        self.begin("key")
        faces = self.triangles()
        seen = self.shade(self.scan(self.picture(faces, 0.6)), faces)
        slot, self.keys = self.keys % 2, self.keys + 1
        self.slots[slot] = {place: rgb for place, (_, rgb) in seen.items()}
        if shows:
            self.show(self.slots[slot])

    def between(self, holes, share, ends=False, face=None, places=lambda x, y: True):
        """Of the pixels that show a face a share is holes. `ends`: the interval, and its second key is shown. `face`:
        of all triangles; `places`: that show some."""
        self.begin("between")
        draw, second = self.draw, (self.keys - 1) % 2 if ends else None
        faces = self.triangles(face)
        shows = self.picture(faces, share, places)
        words = [(x, y, faces[shows[x, y]], draw.getrandbits(999), draw.getrandbits(999))
                 for _, a, b, _ in self.scan(shows) for x, y in self.places(a, b) if shows.get((x, y))]
        stops = not words or draw.random() < 0.5
        for n, (x, y, face, key_0, key_1) in enumerate(words):
            self.put("motion", last=n == len(words) - 1 and not stops, x=x, y=y, face=face, key_0=key_0, key_1=key_1)
        if stops:
            self.put("motion", last=1, x=self.width - 1, y=self.height - 1, key_0=draw.getrandbits(999),
                     key_1=draw.getrandbits(999))
        words.sort(key=lambda word: (word[1] // TILE, word[0] // TILE, word[1], word[0]))
        words = words or [(0, 0, 0, 0, 0)]
        film, marked, asked = {}, set(), []
        for n, (x, y, face, key_0, key_1) in enumerate(words):
            last = n == len(words) - 1
            self.put("ordered", last=last, x=x, y=y, face=face, key_0=key_0, key_1=key_1)
            keys = 0 if face == 0 or draw.random() < holes else draw.randrange(1, 4)
            r, g, b = self.colour() if keys else (0, 0, 0)
            self.put("compensated", last=last, x=x, y=y, r=r, g=g, b=b, keys=keys)
            if keys:
                film[x, y] = (r, g, b)
            elif face:
                marked.add((x, y))
                if asked[-1:] != [face]:
                    asked.append(face)
        for n, face in enumerate(asked or [0]):
            self.put("asked", last=n == max(len(asked), 1) - 1, face=face)
        if asked:
            self.begin("fill")
            self.again(faces)
            for place, (index, rgb) in self.shade(self.scan(shows, marked), faces).items():
                if index:
                    film[place] = rgb
        self.show(film)
        if second is not None:
            self.show(self.slots[second])

    def write(self, folder, config, seed):
        folder.mkdir(parents=True, exist_ok=True)
        streams = []
        for name, (source, to, fields) in self.layouts.items():
            bits = at = sum(width * lanes for _, width, lanes in fields)
            told = []
            for field, width, lanes in fields:
                at -= width * lanes
                # A field has 64 bits at most.
                for part in range(0, width, 64) if lanes == 1 else [0]:
                    told.append({"name": field + (f"_{part}" if part else ""), "lsb": at + part,
                                 "width": min(width - part, 64), "count": lanes, "signed": False, "fraction": 0})
            streams.append({"name": name, "from": source, "to": to, "file": f"{name}.hex", "bits": bits,
                            "words": len(self.words[name]), "frame_words": [count[name] for count in self.counts],
                            "fields": told})
            (folder / f"{name}.hex").write_text("".join(f"{word:x}\n" for word in self.words[name]))
        (folder / "manifest.json").write_text(json.dumps(
            {"format": "halfspace-vectors 1", "scene": "random", "config": config, "lanes_x": self.lanes_x,
             "lanes_y": self.lanes_y, "seed": seed, "frames": self.passes, "streams": streams}))


def main():
    text = pathlib.Path(sys.argv[1]).read_text()
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    film = Film(text, int(sys.argv[3]), seed)
    for width, height in SIZES:
        film.width, film.height = width, height
        last_tile = lambda x, y: x // TILE == (width - 1) // TILE and y // TILE == (height - 1) // TILE  # noqa: E731
        first_tile = lambda x, y: x < TILE and y < TILE  # noqa: E731
        film.key(True)
        for covered in (0, 0.3, 0.3) if width == SIZES[0][0] else (0.3,):
            film.key(False)
            film.between(0.2, 0.6)
            film.between(0, 0.5)
            film.between(0.3, 0.1, places=last_tile)
            film.between(0.3, 0.5, places=first_tile)
            film.between(0.5, covered, ends=True)
    # The same face at the end of a frame and at the begin of the next one.
    film.key(False)
    for _ in range(8):
        film.between(1, 0.7, face=3)
    film.write(pathlib.Path(sys.argv[2]), CONFIG.search(text).group(1), seed)
    return 0


if __name__ == "__main__":
    sys.exit(main())
