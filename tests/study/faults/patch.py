#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A copy of the one kernel that a fault of the list is in, with it, below FOLDER.
Usage: patch.py LIST FAULT HLS FOLDER"""
import pathlib
import sys

KEYS = ["fault", "why", "file", "find", "with", "config", "model", "row", "run"]


def read_faults(path):
    faults = []
    for line in pathlib.Path(path).read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        key, _, value = line.partition(" ")
        if key == "fault":
            faults.append({})
        faults[-1][key] = value.strip()
    for fault in faults:
        if list(fault) != KEYS:
            sys.exit(f"{path}: fault {fault.get('fault')} has other fields than {', '.join(KEYS)}")
    return faults


def main():
    path, name, hls, folder = sys.argv[1:]
    fault = next(fault for fault in read_faults(path) if fault["fault"] == name)
    text = (pathlib.Path(hls) / fault["file"]).read_text()
    if (count := text.count(fault["find"])) != 1:
        sys.exit(f"{path}: the text of {name} stands {count} times in hls/{fault['file']}, not once")
    out = pathlib.Path(folder) / "hls" / fault["file"]
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(text.replace(fault["find"], fault["with"]))


if __name__ == "__main__":
    main()
