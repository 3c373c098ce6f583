#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The page of `halfspace inspect` in Chromium: a click on a pixel reads its words, a triangle tells why it is seen, and
what is wrong of a co-simulation is a place to jump to. Status 77 where there is no Chromium.
Usage: inspect_test.py HALFSPACE PROGRAM FOLDER"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from browser import Browser, program

HALFSPACE, BENCH, FOLDER = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
SIZE = (64, 48)


def words_of(folder, stream):
    """Words as integers, and where each field lies."""
    manifest = json.loads((folder / "manifest.json").read_text())
    entry = next(s for s in manifest["streams"] if s["name"] == stream)
    lines = (folder / entry["file"]).read_text().splitlines()
    return [int(line, 16) for line in lines if not line.startswith("//")], {f["name"]: f for f in entry["fields"]}


def field(word, f, lane=0):
    return word >> f["lsb"] + lane * f["width"] & (1 << f["width"]) - 1


class Inspect(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        subprocess.run([HALFSPACE, "vectors", "teapot", "--config", "low", "--lanes", "4", "--size",
                        f"{SIZE[0]}x{SIZE[1]}", "--no-corners", "--out", FOLDER], check=True, capture_output=True)
        # A bit of a stamp's depth is not what the RTL sends.
        cls.words, cls.stamp = words_of(FOLDER, "stamp")
        cls.wrong = next(n for n in range(len(cls.words) // 2, len(cls.words))
                         if field(cls.words[n], cls.stamp["mask"], 0))
        text = (FOLDER / "stamp.hex").read_text()
        line = f"{cls.words[cls.wrong]:025x}"
        cls.words[cls.wrong] ^= 1
        right, wrong = text, text.replace(line, f"{cls.words[cls.wrong]:025x}", 1)
        assert right != wrong
        (FOLDER / "stamp.hex").write_text(wrong)
        subprocess.run([BENCH, FOLDER, "--json", FOLDER / "cosim.json", "--pictures", FOLDER], check=False,
                       capture_output=True)
        subprocess.run([HALFSPACE, "inspect", FOLDER, "-o", FOLDER / "report.html"], check=True, capture_output=True)
        cls.page = Browser(FOLDER / "report.html").__enter__()
        cls.page.wait("document.body && document.body.dataset.ready === 'yes'")

    @classmethod
    def tearDownClass(cls):
        cls.page.__exit__()

    def text(self, name):
        return self.page.value(f"document.getElementById('{name}').innerText")

    def at(self, view, x, y, click=True):
        left, top, width, height = self.page.value(
            f"(() => {{ const r = document.getElementById('over-{view}').getBoundingClientRect();"
            "return [r.left, r.top, r.width, r.height]; })()")
        self.page.mouse(left + (x + 0.5) * width / SIZE[0], top + (y + 0.5) * height / SIZE[1], click)

    def test_a_click_on_a_pixel_reads_its_words(self):
        scan, of = words_of(FOLDER, "scan")
        n, word = next((n, w) for n, w in enumerate(scan) if field(w, of["index"], 3))
        index, x, y = field(word, of["index"], 3), 2 * field(word, of["x"]) + 1, 2 * field(word, of["y"]) + 1
        for view in ("ref", "hls", "rtl"):
            self.at(view, x, y)
            self.assertIn(f"Pixel ({x}, {y}), ", self.text("pixel-title"))
            words = self.text("words")
            self.assertRegex(words, rf"scan word {n} \(scan_index → shade_gouraud\)[^\n]*\n.*index\[3\] {index}\b")
            for stream in ("triangle", "setup", "attributes", "planes", "stamp", "update", "visible", "pixel"):
                self.assertIn(f"\n{stream} word " if stream != "triangle" else "triangle word ", words)
            self.assertIn(f"triangle {index}", self.text("pixel"))
            self.page.call("Input.dispatchKeyEvent", type="keyDown", key="Escape")
        self.at("hls", 0, 0, click=False)
        self.assertIn("Pixel (0, 0), ", self.text("pixel-title"))

    def test_a_triangle_tells_why_it_is_seen(self):
        self.page.value("showTriangle(0)")
        seen, of = words_of(FOLDER, "visible")
        told = {}
        for word in seen:
            index = field(word, of["index"])
            if index % 40 == 0:
                self.page.value(f"showTriangle({index})")
                told[self.text("why").split(":")[0]] = field(word, of["visible"])
                self.assertIn(f"visible {field(word, of['visible'])}", self.text("of-triangle"))
        self.assertEqual(told.get("Visible"), 1)
        self.assertEqual(told.get("Not visible"), 0)

    def test_what_is_wrong_is_a_place_to_jump_to(self):
        wrong = self.text("wrong")
        self.assertIn("First wrong in flow order: raster_pineda", wrong)
        self.assertRegex(wrong, rf"stamp word {self.wrong}, cycle \d+, triangle \d+\n.*depth\[0\] expected 0x\w+ got")
        self.page.value("document.querySelector('#wrong .jump').click()")
        word = self.words[self.wrong]
        place = [2 * field(word, self.stamp[name]) for name in ("x", "y")]
        self.assertIn("Pixel ({}, {}), ".format(*place), self.text("pixel-title"))
        self.assertEqual(self.text("wrong-pixels").split()[0], "0")

    def test_the_time_line(self):
        self.assertRegex(self.text("bound"), r"bound of a frame: \d+ cycles \(\w+\); measured \d+: \d\.\d+ ×")
        left, top, width, height = self.page.value(
            "(() => { const c = document.getElementById('time'); c.scrollIntoView();"
            "const r = c.getBoundingClientRect(); return [r.left, r.top, r.width, r.height]; })()")
        self.page.mouse(left + width / 2, top + height / 3, click=False)
        told = re.fullmatch(r"\w+, cycles (\d+) to (\d+): (\d+) words, (\d+) waiting .*, (\d+) for the taker",
                            self.text("time-told"))
        first, last, *counts = map(int, told.groups())
        self.assertEqual(sum(counts), last - first + 1)
        self.page.value("scrollTo(0, 0)")

    def test_a_set_alone_and_no_set(self):
        (FOLDER / "alone").mkdir()
        subprocess.run([HALFSPACE, "vectors", "cube", "--config", "low", "--size", "32x24", "--out",
                        FOLDER / "alone/vectors", "--random", "1"], check=True, capture_output=True)
        subprocess.run([HALFSPACE, "inspect", FOLDER / "alone", "-o", FOLDER / "alone.html", "--frame", "3"],
                       check=True, capture_output=True)
        with Browser(FOLDER / "alone.html") as page:
            page.wait("document.body && document.body.dataset.ready === 'yes'")
            self.assertIn("Nothing of the RTL was compared", page.value("document.getElementById('wrong').innerText"))
        none = subprocess.run([HALFSPACE, "inspect", FOLDER / "none", "-o", FOLDER / "none.html"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(none.returncode, 1)
        self.assertIn("there is no vector set", none.stderr)


if __name__ == "__main__":
    if not program():
        print("inspect: not run, as there is no chromium: setup/install.sh test installs it")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0]])
