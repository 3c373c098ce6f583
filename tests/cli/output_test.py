#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the commands write is whole: where a disk is full, a file beyond a limit or a folder missing, one sentence, a
status that is not 0, the old file as it was and nothing else; devices, pipes and links are written to. Usage:
output_test.py HALFSPACE"""
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

HALFSPACE = str(pathlib.Path(sys.argv[1]).resolve())
CUBE = ("render", "cube", "--size", "64x48")
FILM = ("frames", "cube_fast", "--size", "96x64", "--frames", "8")
LIMIT = 2048  # bytes
OBJECTS = pathlib.Path(__file__).resolve().parent.parent / "configs/objects/objects_tiny.toml"


class Output(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def run_it(self, *args, limit=None, **more):
        def limited():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        return subprocess.run([HALFSPACE, *map(str, args)], cwd=self.folder, timeout=120, check=False,
                              **{"capture_output": True, "preexec_fn": limited if limit else None, **more})

    def all_files(self):
        return {path: path.read_bytes() if path.is_file() else None for path in self.folder.rglob("*")}

    def bad(self, *args, words=(), **more):
        """One sentence with the words, and every file as it was."""
        before = self.all_files()
        done = self.run_it(*args, **more)
        self.assertGreater(done.returncode, 0, f"{args}: {done.returncode}")
        lines = done.stderr.decode().splitlines()
        said = [line for line in lines if line.startswith("halfspace: ")]
        self.assertEqual(len(said), 1, lines)
        for word in words:
            self.assertIn(word, said[0])
        self.assertEqual(self.all_files(), before, args)

    def good(self, *args, **more):
        done = self.run_it(*args, **more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_a_limit_or_a_full_disk_leaves_the_old_file(self):
        calls = {"x.png": ("render", "castle", "-o", "x.png"), "x.jpg": ("render", "castle", "-o", "x.jpg"),
                 "x.json": (*CUBE, "--json", "x.json"), "x.toml": ("config", "middle", "--toml", "x.toml"),
                 "x.sv": ("package", "-o", "x.sv"), "d/index.u32": (*CUBE, "--dump", "d"),
                 "v/setup.hex": ("vectors", "cube", "--config", "low", "--out", "v"),
                 "b.png": ("quality", "cube_fast", "--size", "64x48", "--frames", "6", "--plot", "b.png")}
        if shutil.which("ffmpeg"):
            calls.update((f"x.{kind}", (*FILM, "-o", f"x.{kind}")) for kind in ("mp4", "mkv", "gif"))
        for name, call in calls.items():
            with self.subTest(name):
                path = self.folder / name
                limit = 512 if name in ("x.json", "x.toml", "x.mp4", "x.mkv") else LIMIT
                if path.parent == self.folder:
                    self.bad(*call, words=[name], limit=limit)
                path.parent.mkdir(exist_ok=True)
                path.write_text("old")
                self.bad(*call, words=[path.parent.name if path.parent != self.folder else name], limit=limit)
                path.unlink()
                self.good(*call)
                self.assertGreater(path.stat().st_size, limit)
        for call in ((*CUBE, "-o"), (*CUBE, "--json"), ("package", "-o")):
            self.bad(*call, "/dev/full", words=["/dev/full", "No space left"])
        with open("/dev/full", "wb") as full:
            for call in (("config", "low"), ("package",), ("--help",), (*CUBE, "--json", "-")):
                done = self.run_it(*call, capture_output=False, stdout=full, stderr=subprocess.PIPE)
                self.assertGreater(done.returncode, 0, call)
                self.assertIn(b"standard output", done.stderr)

    def test_a_signal_leaves_nothing(self):
        for kind in ("x%d.png", "x.mp4") if shutil.which("ffmpeg") else ("x%d.png",):
            for end in (signal.SIGINT, signal.SIGTERM):
                film = subprocess.Popen([HALFSPACE, "frames", "drone", "-o", kind], cwd=self.folder)
                while not list(self.folder.iterdir()) and film.poll() is None:
                    time.sleep(0.05)
                film.send_signal(end)
                self.assertEqual(film.wait(60), -end)
                time.sleep(0.5)  # ffmpeg ends with its input
                self.assertEqual(list(self.folder.iterdir()), [], (kind, end))

    def test_devices_pipes_and_links_are_written_to(self):
        png = self.folder / "x.png"
        self.good(*CUBE, "-o", png)
        picture = png.read_bytes()
        self.assertEqual(picture[-8:-4], b"IEND")
        self.good(*CUBE, "-o", "/dev/null", "--json", "/dev/null")
        self.assertTrue(pathlib.Path("/dev/null").is_char_device())
        for name in ("-", "/dev/stdout", "/dev/fd/1"):
            self.assertEqual(self.good(*CUBE, "-o", name), picture)
        appended = self.folder / "appended"
        appended.write_text("before")
        with appended.open("ab") as file:
            self.run_it(*CUBE, "-o", "/dev/stdout", capture_output=False, stdout=file, stderr=subprocess.DEVNULL)
        self.assertEqual(appended.read_bytes(), b"before" + picture)
        # A pipe with a name.
        pipe, got = self.folder / "pipe.png", []
        os.mkfifo(pipe)
        reader = threading.Thread(target=lambda: got.append(pipe.read_bytes()))
        reader.start()
        self.good(*CUBE, "-o", pipe)
        reader.join()
        self.assertEqual(got, [picture])
        self.assertTrue(pipe.is_fifo())
        # Links: to a file, to one that is not there, to a folder.
        other = self.folder / "other"
        other.mkdir()
        for target in ("other/a.png", "other/b.png"):
            link = self.folder / "link.png"
            link.unlink(missing_ok=True)
            link.symlink_to(target)
            if target.endswith("a.png"):
                (self.folder / target).write_text("old")
                os.chmod(self.folder / target, 0o640)
            self.good(*CUBE, "-o", link)
            self.assertEqual(os.readlink(link), target)
            self.assertEqual((self.folder / target).read_bytes(), picture)
        self.assertEqual((other / "a.png").stat().st_mode & 0o777, 0o640)
        (self.folder / "to_folder").symlink_to("other")
        self.good(*CUBE, "--dump", "to_folder")
        self.assertTrue((other / "index.u32").exists())
        self.assertEqual(sorted(p.name for p in other.iterdir()),
                         ["a.png", "b.png", "colour.rgba8", "depth.u32", "index.u32", "triangles.tri"])
        if shutil.which("ffmpeg"):
            self.assertEqual(self.good(*FILM, "-o", "-")[:4], b"\x1aE\xdf\xa3")  # Matroska

    def test_numbers_on_standard_output_stand_alone(self):
        small = ("--size", "32x24", "--frames", "3")
        (self.folder / "a").mkdir()
        self.good(*CUBE, "--dump", "a")
        calls = [CUBE, ("config", "low"), ("streams",), ("bounds", "--config", "low", "--triangles", "2"),
                 ("stability", "--config", "low", "--triangles", "1", "--aspect", "2"), ("compare", "a", "a"),
                 ("frames", "cube_fast", *small, "-o", "f%d.png"), ("quality", "cube_fast", *small),
                 ("cost", "cube_fast", "--size", "32x24"), ("report", "cube", "--size", "32x24", "--out", "r"),
                 ("vectors", "cube", "--config", "low", "--no-corners", "--out", "v"), ("repro", "B", "cube"),
                 ("fit", "cube", "--size", "32x24", "--no-cosim", "--area", "none", "--work", "w"),
                 ("repro", "E", "--objects", "30", "--moving", "2", "--frames", "2", "--full-frames", "1")]
        for call in calls:
            with self.subTest(call[0]):
                text = self.good(*call, "--json", "-")
                self.assertTrue(json.loads(text), call)
        self.assertFalse((self.folder / "-").exists())

    def test_a_folder_that_is_not_there_is_an_error(self):
        files = [("render", "cube", "-o"), ("render", "cube", "--json"), ("config", "low", "--toml"),
                 ("package", "-o"), ("fit", "cube", "--size", "32x24", "-o"), ("frames", "cube_fast", "-o"),
                 ("quality", "cube_fast", "--size", "32x24", "--frames", "3", "--plot")]
        for call in files:
            for place in ("/nodir/x.png", "none/x.png", "none/x%d.png"):
                self.bad(*call, place, words=["no folder", str(pathlib.Path(place).parent)])
        folders = [("render", "cube", "--dump"), ("vectors", "cube", "--config", "low", "--out"),
                   ("report", "cube", "--out"), ("bounds", "--config", "low", "--triangles", "0", "--gappa"),
                   ("stability", "--config", "low", "--triangles", "1", "--aspect", "1", "--out"),
                   ("sweep", "cube", "--size", "32x24", "--no-named", "--out"), ("repro", "B", "cube", "--out"),
                   ("vectors", "static", "--config", OBJECTS, "--frames", "2", "--out")]
        for call in folders:
            self.bad(*call, "none/d", words=["none/d"])
            self.bad(*call, "/nodir", words=["/nodir"])
            self.assertFalse(pathlib.Path("/nodir").exists())
        (self.folder / "file").write_text("")
        self.bad(*CUBE, "--dump", "file", words=["file"])
        self.bad(*CUBE, "-o", "file/x.png", words=["file", "not a folder"])
        self.bad(*CUBE, "-o", ".", words=["a folder"])
        for call in folders[:2]:
            self.good(*call, "made/")
            self.assertTrue(any((self.folder / "made").iterdir()))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
