#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The figures of the pages are what the program prints.

- A table between `<!-- prints: COMMAND -->` and `<!-- end -->` is the output of the command.
- docs/figures.md has a row for each single figure that is cheap to print: a page, the words there, a command, and a
  regular expression for its output. The groups of the expression are the numbers of the words, one after the other; a
  page may round them.

Usage: figures_test.py HALFSPACE ROOT"""
import pathlib
import re
import sys

from pasting import copy_of, paste

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


def tables(text):
    """(command, table) between marks."""
    return re.findall(r"^<!-- prints: (.*?) -->\n(.*?)^<!-- end -->", text, re.DOTALL | re.MULTILINE)


def faults_of_tables(name, text, printer):
    for command, table in tables(text):
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


def main():
    halfspace, root = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    faults, found = list(self_test()), 0
    table = list(rows((root / "docs/figures.md").read_text()))
    if len(table) < LEAST_ROWS:
        faults.append(f"docs/figures.md: only {len(table)} rows")
    with copy_of(root, halfspace) as folder:
        printer = Printer(folder)
        for path in sorted((root / "docs").glob("*.md")):
            found += len(tables(path.read_text()))
            faults += faults_of_tables(path.name, path.read_text(), printer)
        faults += filter(None, (fault_of_row(root, *row, printer) for row in table))
    if found < LEAST_TABLES:
        faults.append(f"only {found} tables between marks")
    print("\n".join(faults) or f"figures: {len(table)} single ones and {found} tables are as printed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
