#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A picture of small pictures of all scene files of a folder, to be looked at, and a list beside it: the place of each,
what was said of it, and why it was refused. Usage: contact_sheet.py HALFSPACE FOLDER SHEET.png [SUFFIX ...]"""
import pathlib
import subprocess
import sys
import tempfile

COLUMNS, WIDTH, HEIGHT = 10, 160, 120


def main():
    halfspace, folder, sheet, *suffixes = sys.argv[1:]
    suffixes = suffixes or [".gltf", ".glb"]
    files = sorted(path for path in pathlib.Path(folder).rglob("*") if path.suffix.lower() in suffixes)
    if not files:
        print(f"contact_sheet: {folder}: no file that ends in {' or '.join(suffixes)}: name another folder",
              file=sys.stderr)
        return 2
    lines, drawn = [], 0
    with tempfile.TemporaryDirectory() as pictures:
        for path in files:
            out = pathlib.Path(pictures) / f"{drawn:05}.png"
            done = subprocess.run([halfspace, "render", path, "--engine", "ref", "--texture", "bilinear", "--size",
                                   f"{WIDTH}x{HEIGHT}", "-o", out], capture_output=True, text=True, check=False)
            said = " ".join(line for line in done.stderr.splitlines())
            if done.returncode == 0:
                place = f"row {drawn // COLUMNS + 1}, column {drawn % COLUMNS + 1}"
                drawn += 1
            else:
                place = "refused"
            lines.append(f"{path.relative_to(folder)}: {place}{'; ' + said if said else ''}")
            print(f"\r{len(lines)} of {len(files)}", end="", file=sys.stderr, flush=True)
        print(file=sys.stderr)
        if drawn:
            rows = -(-drawn // COLUMNS)
            subprocess.run(["ffmpeg", "-v", "error", "-y", "-i", f"{pictures}/%05d.png", "-frames:v", "1", "-vf",
                            f"tile={COLUMNS}x{rows}", sheet], check=True)
    pathlib.Path(sheet).with_suffix(".txt").write_text("\n".join(lines) + "\n")
    print(f"{sheet}: {drawn} of {len(files)} files drawn; {pathlib.Path(sheet).with_suffix('.txt')} tells of each")
    return 0


if __name__ == "__main__":
    sys.exit(main())
