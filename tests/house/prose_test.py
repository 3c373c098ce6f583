#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pages can be read: lines within 120 columns, links to headings and terms that are there, paths and tests that are
there, and each special word in the glossary. It shows first, on small pages, that it finds what is wrong.
Usage: prose_test.py ROOT"""
import pathlib
import re
import sys
import tempfile

COLUMNS = 120
# Words that nobody knows from elsewhere, and where the glossary has them: a page that has one links to the glossary.
SPECIAL = {r"\b([A-Z]-buffer)s?\b": None, r"\b(Tdb[A-Z])\b": None, r"\btypes? ([αβγδ])\b": "type-α-β-γ-δ"}
# What the README has to explain by a link where it says it.
OF_README = ["I-buffer", "Z-buffer", "TdbS", "stamp", "lane", "index rendering", "deferred", "type γ"]
REQUIRED = """i-buffer z-buffer s-buffer d-buffer tdbs tdbv type-α-β-γ-δ index-rendering stamp lane deferred kernel
co-simulation vector-set key-frame reach guard-band top-left-rule f c b r g lsb unit stream record configuration stall
seeded-fault room snap plane""".split()
FOLDERS = "hls|rtl|ref|model|vectors|study|cli|tb|tests|docs|setup"
# Of the unit that docs/add_a_unit.md adds.
NEW_FILES = re.compile("grey")
FUNCTIONS = {"halfspace_test"}  # of CMake, named as tests are


def pages(root):
    return [root / name for name in ("README.md", "CONTRIBUTING.md", "tb/README.md") if (root / name).exists()] + \
        sorted((root / "docs").glob("*.md"))


def without_code(text):
    return re.sub(r"^```.*?^```\n?|`[^`\n]*`", "", text, flags=re.DOTALL | re.MULTILINE)


def slug(heading):
    """As GitHub makes it."""
    heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").replace("*", "")
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def anchors(text):
    bare = re.sub(r"^```.*?^```\n?", "", text, flags=re.DOTALL | re.MULTILINE)
    headings = {slug(heading) for heading in re.findall(r"^#+ (.*)$", bare, re.MULTILINE)}
    return headings | set(re.findall(r'<a id="([^"]+)">', text))


def line_faults(name, text):
    """A configuration stands on a page as it is in its file."""
    copied = False
    for number, line in enumerate(text.splitlines(), 1):
        copied = line == "```toml" or copied and line != "```"
        if len(line) > COLUMNS and not copied and not line.startswith(("|", "<!--", "![")):
            yield f"{name}:{number}: {len(line)} columns, {COLUMNS} are allowed"


def link_faults(name, path, text):
    for target, anchor in re.findall(r"\]\(([^)#\s]*)#([^)\s]+)\)", text):
        if "://" not in target:
            other = (path.parent / target).resolve() if target else path
            if other.exists() and anchor not in anchors(other.read_text()):
                yield f"{name}: links to {target}#{anchor}, but there is no such heading or term"


def path_faults(root, name, text):
    for path in re.findall(rf"`((?:{FOLDERS})/[\w./-]+)`", text):
        if not (root / path).exists() and not NEW_FILES.search(path):
            yield f"{name}: names {path}, which is not there"


def test_faults(root, name, text):
    there = {path.stem for path in (root / "tests").rglob("*_test.*")} | FUNCTIONS
    for test in set(re.findall(r"`(\w+_test)`", text)) - there:
        if not NEW_FILES.search(test):
            yield f"{name}: names {test}, and there is no such file below tests/"


def term_faults(name, text, terms):
    prose = without_code(text)
    used = False
    for expression, anchor in SPECIAL.items():
        for word in set(re.findall(expression, prose)):
            used = True
            if (anchor or word.lower()) not in terms:
                yield f"{name}: says {word}, which docs/glossary.md does not explain"
    if used and "glossary.md" not in text and name != "docs/glossary.md":
        yield f"{name}: has words of docs/glossary.md and no link to it"


def readme_faults(text):
    labels = " ".join(re.findall(r"\[([^\]]+)\]\((?:[^)]*)\)", text)).lower()
    for term in OF_README:
        if term in text and term.lower() not in labels:
            yield f"README.md: says {term} and does not link to what it is"


def faults(root):
    glossary = root / "docs/glossary.md"
    terms = anchors(glossary.read_text())
    found = [f"docs/glossary.md: has no {term}" for term in REQUIRED if term not in terms]
    ids = re.findall(r'<a id="([^"]+)">', glossary.read_text())
    found += [f"docs/glossary.md: has {term} twice" for term in set(ids) if ids.count(term) > 1]
    looked = 0
    for path in pages(root):
        name, text = str(path.relative_to(root)), path.read_text()
        looked += len(text.splitlines())
        found += [*line_faults(name, text), *link_faults(name, path, text), *term_faults(name, text, terms)]
        found += [*path_faults(root, name, text), *test_faults(root, name, text)]
        if name == "README.md":
            found += readme_faults(text)
    return found, looked


WRONG = {"README.md": ("A stamp. [x](docs/glossary.md#gone) " + "long " * 30, ["does not link", "#gone", "columns"]),
         "docs/a.md": ("The Q-buffer and TdbS in `hls/no/such.hpp`, by `no_test`\n",
                       ["Q-buffer", "no link", "hls/no/such.hpp", "no_test"])}


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "docs").mkdir()
        terms = [f'<a id="{term}"></a>\n' for term in REQUIRED if term != "reach"]
        (root / "docs/glossary.md").write_text("".join(terms))
        for name, (text, _) in WRONG.items():
            (root / name).write_text(text)
        found, _ = faults(root)
    for name, (_, says) in {**WRONG, "docs/glossary.md": ("", ["has no reach"])}.items():
        yield from (f"self-test: '{word}' of {name} is not found" for word in says
                    if not any(fault.startswith(name) and word in fault for fault in found))


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found, looked = faults(root)
    found += self_test()
    if looked < 1000:
        found.append(f"only {looked} lines were found: is {root} the project?")
    print("\n".join(found) or f"prose: {looked} lines of {len(pages(root))} pages")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
