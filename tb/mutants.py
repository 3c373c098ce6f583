#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Single faults in SystemVerilog, all of them in one copy, chosen by a number at run time.

It reads the style of rtl/: continuous assignments, always_ff and always_comb with if, for, case and assignments, and
the inputs of instances. A mutant changes one expression or leaves one assignment out; E with mutants 3 and 7 becomes
(hs_mutant::number == 3 ? (E3) : hs_mutant::number == 7 ? (E7) : (E)), so that number 0 is what was read. A mutant has
the width and the sign of what it takes the place of, or nearly: the run of number 0 tells if that is not so."""
import re

PACKAGE = "hs_mutant"
NUMBER = f"{PACKAGE}::number"
SOURCE = f"package {PACKAGE};\n  int unsigned number /*verilator public_flat_rw*/;\nendpackage\n"
SWAPS = {"&&": "||", "||": "&&", "==": "!=", "!=": "==", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "+": "-", "-": "+",
         "&": "|", "|": "&", "^": "|", "<<": ">>", ">>": "<<", "!": "", "~": "", "1'b0": "1'b1", "1'b1": "1'b0",
         "'0": "'1", "'1": "'0"}
# How often something is repeated, and the size of a cast: a change would be one of the width, in the run of number 0 as
# well.
COUNT = re.compile(r"\{\s*([^{},]*[^{},\s])\s*\{|(\((?:[^()]|\([^()]*\))*\))(?=')")
SLICE = re.compile(r"\[([^\[\]:]*[^\[\]:+-]):\s*([^\[\]:]+)\]")
TOKEN = re.compile(r"\d*'[bdh]?[0-9a-fA-F]+|[A-Za-z_$]\w*|\d+|<<<|>>>|<<|>>|&&|\|\||[=!<>]=|\+:|-:|\S")


class Unknown(Exception):
    """A construct that is not read: a sentence."""


def blank(text):
    """Without comments and strings, at the same places."""
    return re.sub(r'"[^"\n]*"|//[^\n]*|/\*.*?\*/', lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.DOTALL)


def closed(text, at, opens="(", closes=")"):
    """The place behind the bracket that closes the one at `at`."""
    depth = 0
    for place in range(at, len(text)):
        depth += (text[place] == opens) - (text[place] == closes)
        if depth == 0:
            return place + 1
    raise Unknown(f"no {closes} for {text[at:at + 40]!r}")


class Reader:
    """The places of a module that can be changed: (kind, begin, end); kind: assign, condition, input or statement."""

    def __init__(self, text):
        self.text, self.sites = text, []

    def skip(self, at):
        return at + len(self.text[at:]) - len(self.text[at:].lstrip())

    def word(self, at):
        match = re.match(r"\w+", self.text[at:])
        return match[0] if match else ""

    def value(self, at, semicolon):
        """An assignment's right side."""
        begin = self.skip(at)
        self.sites.append(("assign", begin, semicolon))

    def assignment(self, at, clocked):
        end, depth = self.text.index(";", at), 0
        for token in TOKEN.finditer(self.text, at, end):
            depth += (token[0] in "([{") - (token[0] in ")]}")
            if depth == 0 and token[0] in ("=", "<="):
                self.value(token.end(), end)
                if clocked and token[0] == "<=":
                    self.sites.append(("statement", at, end + 1))
                return end + 1
        raise Unknown(f"no assignment: {self.text[at:end]!r}")

    def statement(self, at, clocked):
        at = self.skip(at)
        word = self.word(at)
        if word == "begin":
            at = self.skip(at + 5)
            if self.text[at] == ":":
                at += re.match(r":\s*\w+", self.text[at:]).end()
            while self.word(at := self.skip(at)) != "end":
                at = self.statement(at, clocked)
            return at + 3
        if word in ("if", "for"):
            begin = self.text.index("(", at)
            end = closed(self.text, begin)
            if word == "if" and self.text[begin + 1:end - 1].strip() not in ("!rst_ni", "rst_ni"):
                self.sites.append(("condition", begin + 1, end - 1))
            at = self.statement(end, clocked)
            behind = self.skip(at)
            return self.statement(behind + 4, clocked) if word == "if" and self.word(behind) == "else" else at
        if word == "unique":
            return self.statement(at + 6, clocked)
        if word == "case":
            at = closed(self.text, self.text.index("(", at))
            while self.word(at := self.skip(at)) != "endcase":
                label = re.compile(r"(?<![:+-]):(?!:)").search(self.text, at)  # not that of a package or a slice
                at = self.statement(label.end(), clocked)
            return at + 7
        if word == "assert":
            return self.text.index(";", at) + 1
        if self.text[at] == ";":
            return at + 1
        return self.assignment(at, clocked)

    def read(self):
        for match in re.finditer(r"\balways_(ff|comb)\b|\bassign\b|\.\w+_i\s*\(", self.text):
            if match[0] == "assign":
                if not re.match(r"\s*unused_", self.text[match.end():]):  # which nothing takes
                    self.assignment(match.end(), False)
            elif match[1]:
                at = closed(self.text, self.text.index("(", match.end())) if match[1] == "ff" else match.end()
                self.statement(at, match[1] == "ff")
            else:
                name = match[0].split("(")[0].strip(" .")
                end = closed(self.text, match.end() - 1) - 1
                if name not in ("clk_i", "rst_ni") and self.text[match.end():end].strip():
                    self.sites.append(("input", match.end(), end))
        return self.sites


def split(text, operator):
    """The operands between operators of this kind outside of brackets; nothing if there is one that binds less."""
    weaker = {"&&": ("||", "?"), "||": ("?",)}[operator]
    depth, begins, ends = 0, [0], []
    for token in TOKEN.finditer(text):
        depth += (token[0] in "([{") - (token[0] in ")]}")
        if depth:
            continue
        if token[0] in weaker:
            return []
        if token[0] == operator:
            ends.append(token.start())
            begins.append(token.end())
    return list(zip(begins, [*ends, len(text)])) if ends else []


def branches(text):
    """One of the two of a choice that is the whole expression."""
    depth, ask, other = 0, None, None
    for token in TOKEN.finditer(text):
        depth += (token[0] in "([{") - (token[0] in ")]}")
        if depth == 0 and token[0] == "?" and ask is None:
            ask = token
        elif depth == 0 and token[0] == ":" and ask and other is None:
            other = token
    if ask and other and "?" not in text[ask.end():other.start()]:
        condition = " ".join(text[:ask.start()].split())
        yield f"{condition}: always", text[ask.end():other.start()]
        yield f"{condition}: never", text[other.end():]


def changes(text, whole):
    """What an expression can become: (what, text)."""
    names = set(re.findall(r"\b\w+_q\d*\b", whole))
    counts = [match.span(match.lastindex) for match in COUNT.finditer(text)]
    depth = 0
    for token in TOKEN.finditer(text):
        word, begin, end = token[0], token.start(), token.end()
        if any(first <= begin < last for first, last in counts):
            continue
        depth += (word == "[") - (word == "]")
        before = text[:begin].rstrip()
        if depth:
            # A slice a bit lower. Other indices are generated: their change would leave the vector.
            if word == "1" and before.endswith("-") and re.match(r"\s*-:", text[end:]):
                yield "slice", text[:begin] + "2" + text[end:]
            continue
        new = SWAPS.get(word)
        if new is not None and not (word in "<>" and text[end:end + 1] == "("):
            yield f"{word} to {new or 'nothing'}", text[:begin] + new + text[end:]
        if match := re.fullmatch(r"(\d+)'d(\d+)", word):
            value = int(match[2])
            yield "number", text[:begin] + f"{match[1]}'d{value - 1 if value else 1}" + text[end:]
        if re.fullmatch(r"\w+'", word + text[end:end + 1]) and word[0].isalpha():
            inner = re.match(r"'\((\d+)\)", text[end:])
            if inner:
                at = end + inner.start(1)
                yield "number", text[:at] + str(int(inner[1]) + 1) + text[end + inner.end(1):]
        if match := re.fullmatch(r"(\w+_q)(\d*)", word):
            stage = int(match[2] or 1)
            for other in (stage - 1, stage + 1):
                name = match[1] + (str(other) if other > 1 else "")
                if other > 0 and name in names:
                    yield "stage", text[:begin] + name + text[end:]
    for match in SLICE.finditer(text):
        if (low := match[2].strip()) != "0":
            yield "slice", f"{text[:match.start()]}[{match[1]} - 1:{low} - 1]{text[match.end():]}"
    yield from branches(text)
    for operator in ("&&", "||"):
        for begin, end in split(text, operator):
            neutral = " 1 " if operator == "&&" else " 0 "
            yield f"without {' '.join(text[begin:end].split())}", text[:begin] + neutral + text[end:]


def mutants(text):
    """Of a module: (site, what, text), site being (kind, begin, end)."""
    code = blank(text)
    found = []
    for site in Reader(code).read():
        kind, begin, end = site
        if kind == "statement":
            found.append((site, "left out", None))
            continue
        expression = code[begin:end]
        found += [(site, what, new) for what, new in changes(expression, code)]
        if kind == "condition":
            found += [(site, "always", "1'b1"), (site, "never", "1'b0")]
    return found


def line_of(text, at):
    return text.count("\n", 0, at) + 1


def applied(text, chosen):
    """The module with these mutants in it, {number: (site, what, text)}."""
    code, edits = blank(text), {}
    for number, (site, _, new) in chosen.items():
        edits.setdefault(site, []).append((number, new))
    pieces = []
    for (kind, begin, end), some in edits.items():
        if kind == "statement":
            alive = " && ".join(f"{NUMBER} != {number}" for number, _ in some)
            pieces += [(begin, begin, f"begin if ({alive}) "), (end, end, " end")]
        else:
            tries = "".join(f"{NUMBER} == {number} ? ({' '.join(new.split())}) : " for number, new in some)
            pieces.append((begin, end, f"({tries}({code[begin:end].strip()}))"))
    # From the end; of an insertion and a change at one place the change is the inner one.
    for begin, end, new in sorted(pieces, key=lambda piece: (piece[0], piece[1]), reverse=True):
        text = text[:begin] + new + text[end:]
    return text
