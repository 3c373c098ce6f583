#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A project that uses the kernels builds and runs against what `cmake --install` leaves: found by find_package, by
pkg-config, and installed from a run of CMake in which every other package is hidden.
Usage: consumer_test.py CMAKE SOURCE BUILD"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

CMAKE, SOURCE, BUILD = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
CONSUMER = pathlib.Path(__file__).resolve().parent / "consumer"
COMPILERS = [name for name in ("g++", "clang++") if shutil.which(name)]
# What a macro of the user's asks for (docs/types.md), and the headers that do so.
CHOSEN = ("systemc", "ap_fixed.h", "ac_fixed.h", "ap_int.h", "ac_int.h", "hls_stream.h", "ac_channel.h")
BACK_ENDS = ("stream_bounded.hpp", "stream_words.hpp", "memory_words.hpp", "fixed_systemc.hpp", "fixed_ap.hpp",
             "fixed_ac.hpp")
# With streams of words, and templates that a program with tops calls.
OF_TOPS = "hls/top/"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)', re.MULTILINE)
EXPECTED = "2016 green pixels\n"


def run(*command, **options):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if result.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}: {result.stdout}{result.stderr}")
    return result.stdout


def packages_looked_for():
    """Every package that a build file of the project asks for."""
    names = set()
    for path in [SOURCE / "CMakeLists.txt", *SOURCE.glob("*/CMakeLists.txt"), *SOURCE.glob("tests/**/*.cmake")]:
        names.update(re.findall(r"^\s*find_package\((\w+)", path.read_text(), re.MULTILINE))
    return sorted(names)


class Consumer(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="halfspace package ")  # paths with spaces, and none of the sources
        self.addCleanup(folder.cleanup)
        self.work = pathlib.Path(folder.name)
        self.prefix = self.work / "prefix"
        self.consumer = shutil.copytree(CONSUMER, self.work / "consumer")

    def build_by_cmake(self, compiler, standard):
        build = self.work / f"by cmake {compiler} {standard}"
        run(CMAKE, "-S", self.consumer, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}",
            f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_STANDARD={standard}", "-DCMAKE_CXX_EXTENSIONS=OFF",
            "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
        run(CMAKE, "--build", build)
        self.assertEqual(run(build / "consumer"), EXPECTED)
        target = (build / "CMakeCache.txt").read_text()
        self.assertIn(f"halfspace_DIR:PATH={self.prefix}", target, "another halfspace was found")

    def test_found_by_find_package(self):
        run(CMAKE, "--install", BUILD, "--prefix", self.prefix, "--component", "kernels")
        for compiler in COMPILERS:
            self.build_by_cmake(compiler, 14)

    def test_found_by_pkg_config(self):
        run(CMAKE, "--install", BUILD, "--prefix", self.prefix, "--component", "kernels")
        moved = self.prefix.rename(self.work / "moved")  # a prefix can be moved
        path = {**os.environ, "PKG_CONFIG_PATH": str(moved / "share/pkgconfig")}
        flags = run("pkg-config", "--cflags", "halfspace", env=path).strip()
        for compiler in COMPILERS:
            program = self.work / f"by_pkg_config_{compiler}"
            run("sh", "-c", f'{compiler} -std=c++14 {flags} "{self.consumer}/main.cpp" -o "{program}"')
            self.assertEqual(run(program), EXPECTED)

    def test_kernels_alone_need_no_other_package(self):
        hidden = packages_looked_for()
        self.assertGreater(len(hidden), 8, f"only these packages are hidden: {hidden}")
        options = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in hidden]
        build = self.work / "kernels"
        run(CMAKE, "-S", SOURCE, "-B", build, "-DHALFSPACE_KERNELS_ONLY=ON", *options)
        run(CMAKE, "--install", build, "--prefix", self.prefix)
        self.assertFalse((self.prefix / "bin").exists())
        for standard in (14, 17, 20):
            self.build_by_cmake(COMPILERS[0], standard)

    def test_headers_include_each_other_and_the_standard_library(self):
        run(CMAKE, "--install", BUILD, "--prefix", self.prefix, "--component", "kernels")
        root = self.prefix / "include/halfspace"
        headers = sorted(path.relative_to(root) for path in root.rglob("*.hpp"))
        self.assertEqual({str(path) for path in headers},
                         {str(path.relative_to(SOURCE)) for path in SOURCE.glob("hls/**/*.hpp")})
        for header in headers:
            for opens, name in INCLUDE.findall((root / header).read_text()):
                if opens == '"':
                    self.assertIn(pathlib.Path(name), headers, header)
                elif name not in CHOSEN:
                    self.assertRegex(name, "^[a-z_]+$", f"{header}: that is no header of the standard library")
        together = self.work / "all.cpp"
        of_tops = [path for path in headers if str(path).startswith(OF_TOPS)]
        self.assertTrue(of_tops)
        for paths, macros in (([path for path in headers if path not in of_tops], ()),
                              (of_tops, ("-DHALFSPACE_STREAM_WORDS",))):
            together.write_text("".join(f'#include "{path}"\n' for path in paths if path.name not in BACK_ENDS))
            for compiler in COMPILERS:
                run(compiler, "-std=c++14", "-Wall", "-Wextra", "-Werror", "-Wno-unused-label", "-fno-exceptions",
                    *macros, "-fsyntax-only", f"-I{root}", together)

    def test_part_of_another_project(self):
        """add_subdirectory, as FetchContent does it, takes the kernels alone."""
        text = (self.consumer / "CMakeLists.txt").read_text()
        line = next(line for line in text.splitlines() if line.startswith("find_package"))
        (self.consumer / "CMakeLists.txt").write_text(text.replace(line, f'add_subdirectory("{SOURCE}" halfspace)'))
        build = self.work / "within"
        run(CMAKE, "-S", self.consumer, "-B", build)
        run(CMAKE, "--build", build)
        self.assertEqual(run(build / "consumer"), EXPECTED)

    def test_another_version_is_refused(self):
        run(CMAKE, "--install", BUILD, "--prefix", self.prefix, "--component", "kernels")
        text = (self.consumer / "CMakeLists.txt").read_text()
        text = re.sub(r"find_package\(halfspace \S+", "find_package(halfspace 9", text)
        (self.consumer / "CMakeLists.txt").write_text(text)
        with self.assertRaisesRegex(AssertionError, "halfspaceConfig.cmake, version: "):
            run(CMAKE, "-S", self.consumer, "-B", self.work / "other", f"-DCMAKE_PREFIX_PATH={self.prefix}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
