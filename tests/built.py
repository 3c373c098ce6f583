#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs a test whose programs are built; otherwise says which target builds them.
Usage: built.py BUILD TARGET=PROGRAM … -- COMMAND …"""
import os
import pathlib
import sys


def main():
    at = sys.argv.index("--")
    build, needs, command = sys.argv[1], sys.argv[2:at], sys.argv[at + 1:]
    missing = []
    for need in needs:
        target, _, program = need.partition("=")
        if not pathlib.Path(program).exists():
            missing.append(target)
    if missing:
        print(f"not built: {', '.join(missing)}. Build it by: cmake --build '{build}' --target {' '.join(missing)}")
        return 1
    os.execv(command[0], command)


if __name__ == "__main__":
    sys.exit(main())
