#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The documentation says what the program says: the tables of widths and of streams, and every path that a
document names. Usage: docs_test.py HALFSPACE ROOT"""
import pathlib
import re
import subprocess
import sys


def main():
    halfspace, root = sys.argv[1], pathlib.Path(sys.argv[2])
    faults = []
    table = subprocess.run([halfspace, "config", "low", "middle", "high", "--markdown"],
                           capture_output=True, text=True, check=True).stdout
    text = (root / "docs/configurations.md").read_text()
    found = re.search(r"<!-- widths -->\n(.*?)<!-- /widths -->", text, re.DOTALL)
    if not found or found.group(1) != table or len(table.splitlines()) < 30:
        faults.append("docs/configurations.md: its widths are not what `halfspace config --markdown` prints: "
                      "put that between the marks")
    streams = subprocess.run([halfspace, "streams", "--markdown"], capture_output=True, text=True, check=True).stdout
    architecture = (root / "docs/architecture.md").read_text()
    found = re.search(r"<!-- streams -->\n(.*?)<!-- /streams -->", architecture, re.DOTALL)
    if not found or found.group(1) != streams or len(streams.splitlines()) < 30:
        faults.append("docs/architecture.md: its streams are not what `halfspace streams --markdown` prints: "
                      "put that between the marks")
    if (root / "hls/formats/configs/middle.toml").read_text() not in text:
        faults.append("docs/configurations.md: its example is not hls/formats/configs/middle.toml")
    links = 0
    for document in [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").glob("*.md"))]:
        prose = re.sub(r"^```.*?^```|`[^`\n]*`", "", document.read_text(), flags=re.DOTALL | re.MULTILINE)
        for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", prose):
            if "://" in target:
                continue
            links += 1
            if not (document.parent / target).exists():
                faults.append(f"{document.relative_to(root)}: links to {target}, which is not there")
    if links < 10:
        faults.append(f"only {links} links were found: is {root} the project?")
    print("\n".join(faults) or f"docs: widths and streams as printed, {links} links lead somewhere")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
