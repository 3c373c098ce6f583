# SPDX-License-Identifier: Apache-2.0
"""The text files of the project, which tests of the house read."""
import pathlib

CPP = {".cpp", ".hpp", ".h"}
SV = {".sv", ".svh"}
SUFFIXES = CPP | SV | {".py", ".cmake", ".sh", ".md", ".txt", ".toml", ".yaml", ".yml", ".vlt", ".inc", ".html", ".js"}
LISTS = {".toml", ".txt", ".yaml", ".yml"}  # an entry a line
UNREAD = {"__pycache__", "build"}
NAMES = {"Makefile", "Makefile.sim", "Snakefile", "CMakeLists.txt"}


def sources(root):
    """All of them, build folders and hidden ones apart, in order."""
    found = []
    for path in sorted(root.iterdir()):
        if path.is_dir():
            hidden = path.name.startswith(".") or path.name in UNREAD or (path / "CMakeCache.txt").exists()
            found += [] if hidden or path.is_symlink() else sources(path)
        elif path.suffix in SUFFIXES or path.name in NAMES:
            found.append(path)
    return found


def is_package(path):
    """Whether the file is one of the packages that `halfspace package` prints."""
    return path.name == "hs_formats_pkg.sv"


def is_list(path):
    """Whether a line of the file is an entry, however long."""
    return path.suffix in LISTS and path.name not in NAMES
