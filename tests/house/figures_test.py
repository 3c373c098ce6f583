#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The figures of the pages are what the program prints.

- A table between `<!-- prints: COMMAND -->` and `<!-- end -->` is the output of the command; one after `<!-- prints in
  minutes: COMMAND -->` likewise, with `--long`.
- docs/figures.md has a row for each single figure that is cheap to print: a page, the words there, a command, and a
  regular expression for its output. The groups of the expression are the numbers of the words, one after the other; a
  page may round them.
- Each section of a page that has a measure beside these is in the second or the third table there.

Usage: figures_test.py HALFSPACE ROOT [--long]"""
import pathlib
import re
import sys

from pasting import copy_of, paste
from prose_test import slug

LEAST_ROWS, LEAST_TABLES = 15, 3
# 1,234.5 and 16.8 million, but not the 32 of float32, nor an exponent.
NUMBER = re.compile(r"(?<![\w.^/×])(\d[\d,]*(?:\.\d+)?)( million)?")


def numbers(words):
    """(value, size of the last place) of each number in the words; 25,600 is rounded to hundreds."""
    for digits, million in NUMBER.findall(words):
        digits = digits.replace(",", "").rstrip(".")
        scale = 1e6 if million else 1
        place = 100.0 if re.search(r"^\d{3,}00$", digits) else 10.0 ** -len(digits.partition(".")[2])
        yield float(digits) * scale, place * scale


def plain(text):
    """Without marks and line ends."""
    return re.sub(r"\s+", " ", text.replace("*", "").replace("`", ""))


def rows(text):
    """(page, words, command, expression) of the rows of the first table."""
    table = re.search(r"^\| page \|.*?\n\|[-|]+\n((?:\|.*\n)+)", text, re.MULTILINE)
    for row in table.group(1).splitlines() if table else []:
        cells = re.fullmatch(r"\| (\S+) \| (.*?) \| `(.*)` \| `(.*)` \|", row).groups()
        yield [cell.replace("\\|", "|") for cell in cells]


class Printer:
    """Runs each command once."""

    def __init__(self, folder):
        self.folder, self.outputs = folder, {}

    def output(self, command):
        if command not in self.outputs:
            done = paste(command, self.folder)
            failed = f"failed with {done.returncode}: {done.stderr}"
            self.outputs[command] = failed if done.returncode else done.stdout
        return self.outputs[command]


def tables(text, mark):
    """(command, table) between marks."""
    return re.findall(rf"^<!-- {mark}: (.*?) -->\n(.*?)^<!-- end -->", text, re.DOTALL | re.MULTILINE)


def faults_of_tables(name, text, mark, printer):
    for command, table in tables(text, mark):
        if printer.output(command).strip() != table.strip():
            yield f"{name}: the table is not what `{command}` prints: put that between the marks"


def disagreement(words, groups):
    """Why the numbers of the words are not those of the groups, which they may round, or ''."""
    said, printed = list(numbers(words)), [float(group.replace(",", "")) for group in groups]
    if len(said) != len(printed) or not said:
        return f"{len(said)} numbers, and the expression has {len(printed)} groups"
    for (value, place), number in zip(said, printed):
        if abs(value - number) > place / 2 * (1 + 1e-9):
            return f"{number:.10g} is printed"
    return ""


def self_test():
    page = "# One\n3 cycles\n## Two (2)\n1.5 dB of 4 dB\n```\n7 LSB\n```\n## Three\n5 pages\n"
    for in_list, words, count in [(set(), [], 2), ({("a.md", "one"), ("a.md", "two-2")}, [], 0),
                                  ({("a.md", "")}, [], 0), (set(), ["3 cycles"], 1), ({("a.md", "four")}, [], 3)]:
        if len(list(faults_of_sections("a.md", page, words, in_list))) != count:
            yield f"self-test: sections of a page beside {in_list} and {words}"
    for words, groups, agrees in [
            ("0.36 LSB", ["0.3583"], True), ("0.37 LSB", ["0.3583"], False), ("25,600", ["25603.2"], True),
            ("25,700", ["25603.2"], False), ("2,386 of 3,104", ["2386", "3104"], True), ("none", ["1"], False),
            ("2,386 of 3,104", ["2386", "3105"], False), ("float32: 16.8 million", ["16777215"], True),
            ("5", ["5", "6"], False)]:
        if (not disagreement(words, groups)) != agrees:
            yield f"self-test: \"{words}\" beside {groups}"


def fault_of_row(root, page, words, command, expression, printer):
    if plain(words) not in plain((root / page).read_text()):
        return f"{page}: does not say \"{words}\""
    found = re.search(expression, printer.output(command), re.MULTILINE | re.DOTALL)
    if not found:
        return f"{page}: \"{words}\": `{command}` does not print {expression}"
    why = disagreement(words, found.groups())
    return f"{page}: \"{words}\": {why}: `{command}`" if why else None


# What a number of these is a measure of.
MEASURE = re.compile(r"(?<![\w.^/×−])\d[\d,.]* ?(?:%|LSB|dB|cycles?|LUTs?|FF|DSP|ms|seconds?|minutes?|hours?|MHz|Mpx"
                     r"|Mtri|frames/s|[MG]B|pixels? (?:differ|wrong|of)|fragments|faults|mismatches)(?!\w)")
PRINTED = re.compile(r"<!-- prints: .*?<!-- end -->|<!-- (\w+) -->.*?<!-- /\1 -->|```.*?```", re.DOTALL)


def sections(text):
    """(anchor, text) of each, without what the program prints."""
    parts = re.split(r"^#+ (.*)$", PRINTED.sub("", text), flags=re.MULTILINE)
    return [(slug(heading), body) for heading, body in zip(parts[1::2], parts[2::2])]


def listed(text):
    """(page, anchor) of the links in the first cells of the second and third table; anchor "": all of the page."""
    tables = re.findall(r"^\| section \|.*?\n\|[-|]+\n((?:\|.*\n)+)", text, re.MULTILINE)
    return {link for table in tables for row in table.splitlines()
            for link in re.findall(r"\]\((?:\.\./)?([\w.]+)(?:#([^)]*))?\)", row.split("|")[1])}


def faults_of_sections(page, text, words_of_rows, in_list):
    text = plain_lines(text)
    for words in words_of_rows:
        text = text.replace(words, "")
    anchors = {anchor for anchor, _ in sections(text)}
    for anchor, body in sections(text):
        found = MEASURE.search(body)
        if found and (page, "") not in in_list and (page, anchor) not in in_list:
            yield f"{page}#{anchor}: \"{found[0]}\": docs/figures.md has no row for this section"
    for name, anchor in sorted(in_list):
        if name == page and anchor and anchor not in anchors:
            yield f"docs/figures.md: {page} has no section {anchor}"


def plain_lines(text):
    """Without marks, on the lines that it has."""
    return text.replace("*", "").replace("`", "")


def main():
    halfspace, root = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    is_long = "--long" in sys.argv[3:]
    mark = "prints in minutes" if is_long else "prints"
    faults, found = list(self_test()), 0
    table = list(rows((root / "docs/figures.md").read_text()))
    if len(table) < LEAST_ROWS:
        faults.append(f"docs/figures.md: only {len(table)} rows")
    in_list = listed((root / "docs/figures.md").read_text())
    for path in [root / "README.md", *sorted((root / "docs").glob("*.md"))]:
        if path.name != "figures.md":
            words = [plain(row[1]) for row in table if row[0].endswith(path.name)]
            faults += faults_of_sections(path.name, path.read_text(), words, in_list)
    with copy_of(root, halfspace) as folder:
        printer = Printer(folder)
        for path in sorted((root / "docs").glob("*.md")):
            found += len(tables(path.read_text(), mark))
            faults += faults_of_tables(path.name, path.read_text(), mark, printer)
        if not is_long:
            faults += filter(None, (fault_of_row(root, *row, printer) for row in table))
    if found < LEAST_TABLES:
        faults.append(f"only {found} tables between marks")
    print("\n".join(faults) or f"figures: {0 if is_long else len(table)} single ones and {found} tables are as printed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
