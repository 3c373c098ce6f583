#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`halfspace compare` of vector sets: a digit is seen and told as the bench tells it, a stream alone, words in another
order, fields that do not count, words that lack. Usage: compare_test.py HALFSPACE FOLDER CONFIG"""
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

HALFSPACE, FOLDER, CONFIG = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]


class Set:
    """Words of a folder as integers, by the manifest."""

    def __init__(self, folder):
        self.folder = folder
        self.streams = {s["name"]: s for s in json.loads((folder / "manifest.json").read_text())["streams"]}

    def words(self, stream):
        lines = (self.folder / f"{stream}.hex").read_text().splitlines()
        return [int(line, 16) for line in lines if not line.startswith("//")]

    def write(self, stream, words, folder):
        digits = (self.streams[stream]["bits"] + 3) // 4
        (folder / f"{stream}.hex").write_text("".join(f"{word:0{digits}x}\n" for word in words))

    def field(self, stream, name):
        return next(f for f in self.streams[stream]["fields"] if f["name"] == name)

    def get(self, stream, name, word, lane=0):
        f = self.field(stream, name)
        return word >> (f["lsb"] + lane * f["width"]) & ((1 << f["width"]) - 1)

    def put(self, stream, name, word, value, lane=0):
        f = self.field(stream, name)
        at, ones = f["lsb"] + lane * f["width"], (1 << f["width"]) - 1
        return word & ~(ones << at) | (value & ones) << at


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        cls.a = FOLDER / "a"
        subprocess.run([HALFSPACE, "vectors", "standard", "--config", CONFIG, "--lanes", "4", "--out", cls.a],
                       check=True, capture_output=True)
        cls.set = Set(cls.a)

    def compare(self, stream, words, *options):
        """Status and text for these words in the place of a stream's."""
        b = FOLDER / "b"
        shutil.rmtree(b, ignore_errors=True)
        b.mkdir()
        self.set.write(stream, words, b)
        result = subprocess.run([HALFSPACE, "compare", self.a, b, "--stream", stream, *options], capture_output=True,
                                text=True, check=False)
        self.assertEqual(result.stderr, "")
        return result.returncode, result.stdout

    def test_equal_sets_and_a_digit(self):
        b = FOLDER / "copy"
        shutil.copytree(self.a, b)
        command = [HALFSPACE, "compare", self.a, b, "--json", FOLDER / "c.json"]
        self.assertEqual(subprocess.run(command, capture_output=True, check=False).returncode, 0)
        parts = json.loads((FOLDER / "c.json").read_text())["parts"]
        self.assertEqual([p["part"] for p in parts], list(self.set.streams))
        self.assertTrue(all(p["values"] > 0 and p["different"] == 0 for p in parts))
        words = self.set.words("stamp")
        words[-1] ^= 1
        self.set.write("stamp", words, b)
        self.assertEqual(subprocess.run(command, capture_output=True, check=False).returncode, 1)
        parts = {p["part"]: p for p in json.loads((FOLDER / "c.json").read_text())["parts"]}
        self.assertEqual([n for n, p in parts.items() if p["different"]], ["stamp"])
        self.assertIn(f"stamp word {len(words) - 1} (raster_pineda → ztest_", parts["stamp"]["first"])
        self.assertRegex(parts["stamp"]["first"], r"frame \d+, triangle \d+, pixel.*: depth\[0\] expected 0x")

    def test_the_manifest_explains(self):
        stamp = self.set.streams["stamp"]
        self.assertEqual((stamp["any_order_within"], self.set.field("stamp", "x")["unit"]), ("index", "stamps"))
        self.assertEqual(self.set.field("stamp", "depth")["valid_if"], "mask")
        self.assertEqual(self.set.field("setup", "e0")["valid_if"], "!empty")
        for stream in self.set.streams.values():
            self.assertTrue(stream["order"] and stream["what"], stream["name"])
            self.assertTrue(all(field["meaning"] for field in stream["fields"]), stream["name"])

    def test_another_order_within_a_triangle(self):
        words, s = self.set.words("stamp"), self.set
        group = []
        for n, word in enumerate(words):
            group.append(n)
            if s.get("stamp", "triangle_last", word):
                if len(group) > 2:
                    break
                group = []
        ends = [(s.get("stamp", "last", words[n]), s.get("stamp", "triangle_last", words[n])) for n in group]
        turned = [words[n] for n in reversed(group)]
        for n, word, (last, triangle_last) in zip(group, turned, ends):
            words[n] = s.put("stamp", "triangle_last", s.put("stamp", "last", word, last), triangle_last)
        self.assertEqual(self.compare("stamp", words)[0], 1)
        self.assertEqual(self.compare("stamp", words, "--any-order")[0], 0)
        # A wrong stamp among them is told by where it is; the end at the wrong word; triangles in another order.
        wrong = list(words)
        wrong[group[0]] ^= 1 << s.field("stamp", "mask")["lsb"]
        status, text = self.compare("stamp", wrong, "--any-order")
        self.assertEqual(status, 1)
        self.assertRegex(text, rf"1 different; first stamp word {group[-1]} .*mask\[0\] expected")
        early = list(words)
        early[group[0]] = s.put("stamp", "triangle_last", early[group[0]], 1)
        self.assertEqual(self.compare("stamp", early, "--any-order")[0], 1)
        lacks = [word for n, word in enumerate(words) if n != group[1]]
        status, text = self.compare("stamp", lacks, "--any-order")
        self.assertIn("0 different, 1 missing; first missing: word", text)
        scan = self.set.words("scan")
        scan[0], scan[1] = scan[1], scan[0]
        self.assertEqual(self.compare("scan", scan, "--any-order")[0], 1)

    def test_fields_that_do_not_count(self):
        words, s = self.set.words("stamp"), self.set
        where = next((n, lane) for n, word in enumerate(words) for lane in range(4)
                     if not s.get("stamp", "mask", word, lane) and any(s.get("stamp", "mask", word, k)
                                                                       for k in range(4)))
        other = next((n, lane) for n, word in enumerate(words) for lane in range(4)
                     if s.get("stamp", "mask", word, lane))
        for (n, lane), counts in ((where, 0), (other, 1)):
            changed = list(words)
            changed[n] = s.put("stamp", "depth", words[n], ~s.get("stamp", "depth", words[n], lane), lane)
            self.assertEqual(self.compare("stamp", changed)[0], 1)
            for options in (("--masked",), ("--masked", "--any-order")):
                status, text = self.compare("stamp", changed, *options)
                self.assertEqual(status, counts)
            if counts:
                self.assertIn(f"depth[{lane}] expected", text)
        setup = s.words("setup")
        empty = next(n for n, word in enumerate(setup) if s.get("setup", "empty", word))
        setup[empty] ^= 1 << s.field("setup", "e1")["lsb"]
        self.assertEqual([self.compare("setup", setup, *o)[0] for o in ((), ("--masked",))], [1, 0])
        setup[empty] ^= 1 << s.field("setup", "index")["lsb"]
        status, text = self.compare("setup", setup, "--masked")
        self.assertEqual(status, 1)
        self.assertNotIn("e1 expected", text)

    def test_words_that_lack_are_missing(self):
        words = self.set.words("visible")
        status, text = self.compare("visible", words[:-3])
        self.assertEqual(status, 1)
        self.assertIn("0 different, 3 missing; first missing: word", text)
        self.assertIn("0 different, 1 too many; first surplus: word", self.compare("visible", words + [0])[1])

    def test_what_cannot_be_compared(self):
        for arguments, says in (([self.a, self.a, "--stream", "none"], "--stream none: the set has triangle, "),
                                ([self.a, FOLDER], "name one stream"),
                                ([self.a, FOLDER / "none.hex", "--stream", "stamp"], "cannot be opened")):
            result = subprocess.run([HALFSPACE, "compare", *arguments], capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, 1)
            self.assertIn(says, result.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
