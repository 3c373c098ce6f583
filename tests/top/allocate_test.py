#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tops take no memory, throw nothing and call nobody: what their objects leave to be linked is in the list.
Usage: allocate_test.py NM OBJECTS …: lists with semicolons"""
import re
import subprocess
import sys

# Channels, which the caller of a top has; moving and clearing records; other tops, of which some are composed.
LINKED = re.compile(r"_ZNK?9halfspace9WordQueue|mem(cpy|set|move|cmp)$|__stack_chk_fail$|\w+_top$|"
                    r"_GLOBAL_OFFSET_TABLE_$")


def foreign(listing):
    names = [line.split()[-1] for line in listing.splitlines() if " U " in f" {line.strip()} "]
    return sorted({name for name in names if not LINKED.match(name)})


def main():
    if foreign("                 U _Znwm\n                 U memcpy\n") != ["_Znwm"]:
        sys.exit("the test itself is broken: it takes operator new for what a top may call")
    nm, *lists = sys.argv[1:]
    objects = [path for text in lists for path in text.split(";")]
    if not objects:
        sys.exit("no objects were given")
    wrong = 0
    for path in objects:
        names = foreign(subprocess.run([nm, "-u", path], check=True, capture_output=True, text=True).stdout)
        if names:
            print(f"{path}: needs {', '.join(names)}")
            wrong += 1
    print(f"{len(objects)} objects, {wrong} need more than channels")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
