#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Single faults in the C++ of hls/, all of them in one copy, chosen by a number at run time.

It reads the style of hls/: functions with declarations, assignments, calls, if, for, while and return. A mutant is
another text of one of these places: statements and returns stand beside each other,
`{ if (hs_mutant::is(3)) S3 else S }`; the value of a declaration and a condition become
`(hs_mutant::is(3) ? T(E3) : T(E))`, of one type T. So number 0 is what was read, and one program serves all. Functions
that are constexpr make tables while a program compiles, and are left out, but for those of arithmetic.hpp. Each mutant
has a line of the copy to itself: an error of the compiler names it."""
import re

HEADER = "mutant.hpp"
# Not in a constant expression, where no number is known.
SOURCE = """#pragma once
#include <cstdlib>
#include <type_traits>
namespace hs_mutant {
template <class T>
struct Chosen {
  static const int number;
};
template <class T>
const int Chosen<T>::number = std::getenv("HALFSPACE_MUTANT") ? std::atoi(std::getenv("HALFSPACE_MUTANT")) : 0;
constexpr bool is(int n) { return !__builtin_is_constant_evaluated() && Chosen<void>::number == n; }
}  // namespace hs_mutant
"""
SWAPS = {"&&": "||", "||": "&&", "==": "!=", "!=": "==", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "+": "-", "-": "+",
         "&": "|", "|": "&", "^": "|", "<<": ">>", ">>": "<<", "!": "", "+=": "-=", "-=": "+=", "|=": "&=", "&=": "|=",
         "++": "--", "true": "false", "false": "true"}
TOKEN = re.compile(r"[A-Za-z_]\w*|\d+|->|::|<<=|>>=|<<|>>|&&|\|\||\+\+|--|[-+*/|&^=!<>]=|\S")
MACRO = re.compile(r"HS_[A-Z_]+\b(\([^()]*\))?")
LABEL = re.compile(r"[A-Z]\w*\s*:(?!:)")


class Unknown(Exception):
    """A construct that is not read: a sentence."""


def blank(text):
    """Without comments, strings and lines of the preprocessor, at the same places."""
    def spaces(match):
        return re.sub(r"[^\n]", " ", match[0])
    text = re.sub(r'"(?:[^"\n\\]|\\.)*"|//[^\n]*|/\*.*?\*/', spaces, text, flags=re.DOTALL)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", spaces, text, flags=re.MULTILINE)


def closed(text, at):
    """The place behind the bracket that closes the one at `at`."""
    depth = 0
    for place in range(at, len(text)):
        depth += (text[place] in "([{") - (text[place] in ")]}")
        if depth == 0:
            return place + 1
    raise Unknown(f"nothing closes {text[at:at + 40]!r}")


def angles(text):
    """For each place, whether it is inside of <…> of a template. An operator has blanks around it."""
    inside, depth = [False] * len(text), 0
    for at, letter in enumerate(text):
        opens = letter == "<" and re.match(r"\w<[^ =<]", text[at - 1:at + 2]) is not None
        closes = letter == ">" and depth > 0 and text[at - 1] not in " -"
        inside[at] = depth > 0 or opens
        depth += opens - closes
    return inside


def pieces(text, separator):
    """The (begin, end) between separators outside of all brackets; one if there is none."""
    depth, begins, ends, inside = 0, [0], [], angles(text)
    for token in TOKEN.finditer(text):
        depth += (token[0] in "([{") - (token[0] in ")]}")
        if depth == 0 and token[0] == separator and not inside[token.start()]:
            ends.append(token.start())
            begins.append(token.end())
    return list(zip(begins, [*ends, len(text)]))


class Reader:
    """The places of a header that can be changed: (kind, begin, end, type); kind: value, condition, bound, return or
    statement."""

    def __init__(self, text, constexpr):
        self.text, self.constexpr, self.sites = text, constexpr, []

    def skip(self, at):
        return at + len(self.text[at:]) - len(self.text[at:].lstrip())

    def semicolon(self, at):
        while self.text[at] != ";":
            at = closed(self.text, at) if self.text[at] in "([{" else at + 1
        return at

    def declarations(self, at, end):
        """Of namespaces and classes."""
        header = at
        while at < end:
            letter = self.text[at]
            if letter == ";" or letter == "}":
                header = at + 1
            elif letter == "(":
                at = closed(self.text, at)
                continue
            elif letter == "{":
                words, close = self.text[header:at], closed(self.text, at)
                if re.search(r"\b(namespace|struct|class)\b[^()]*$", words) and "enum" not in words:
                    self.declarations(at + 1, close - 1)
                elif ")" in words and (self.constexpr or not re.search(r"\bconstexpr\b", words)):
                    self.block(at)
                at = header = close
                continue
            at += 1

    def block(self, at):
        end, at = closed(self.text, at) - 1, at + 1
        while (at := self.skip(at)) < end:
            at = self.statement(at)
        return end + 1

    def statement(self, at):
        at = self.skip(at)
        while match := LABEL.match(self.text, at) or MACRO.match(self.text, at):
            if match[0].startswith(("HS_UNROLL", "HS_PIPELINE", "HS_IN_TURN", "HS_STARTED")) or match[0].endswith(":"):
                at = self.skip(match.end())
            else:
                break
        word = (re.match(r"\w+", self.text[at:]) or [""])[0]
        if self.text[at] == "{":
            return self.block(at)
        if word in ("if", "while"):
            begin = self.text.index("(", at)
            end = closed(self.text, begin)
            self.sites.append(("condition", begin + 1, end - 1, "bool"))
            at = self.statement(end)
            behind = self.skip(at)
            if word == "if" and re.match(r"else\b", self.text[behind:]):
                return self.statement(behind + 4)
            return at
        if word == "for":
            begin = self.text.index("(", at)
            end = closed(self.text, begin)
            first = self.text.index(";", begin)
            if first < end:
                second = self.text.index(";", first + 1)
                if first > begin + 1:
                    self.declaration(begin + 1, first)
                if self.text[first + 1:second].strip():
                    self.sites.append(("bound", first + 1, second, "bool"))
            return self.statement(end)
        if word == "switch":
            return closed(self.text, self.text.index("{", at))
        if word in ("struct", "class"):
            return self.semicolon(at) + 1
        end = self.semicolon(at)
        if word == "return":
            if self.text[at + 6:end].strip():
                self.sites.append(("return", at + 6, end, ""))
        elif word not in ("using", "static_assert", "break", "continue", "assert", "") and \
                not re.search(r"constexpr|\]\s*\(", self.text[at:end]) and not self.declaration(at, end):
            self.sites.append(("statement", at, end, ""))
        return end + 1

    def declaration(self, at, end):
        """The values of a declaration. Whether it is one."""
        text = self.text[at:end]
        inside = angles(text)
        bare = "".join("\0" if hide else letter for letter, hide in zip(text, inside))
        match = re.match(r"((?:static |const )*)((?:typename )?[\w:\0]+?)(\s*[&*]\s*| )(\w+)((?:\[[^\]]*\])*)\s*"
                         r"(=|,|$|\{|\()", bare)
        if not match or match[2] in ("delete", "throw", "goto"):
            return False
        if match[3].strip() or match[6] != "=" or "[" in match[5]:
            return True
        kind = text[match.start(2):match.end(2)]
        parts = pieces(text, ",")
        for begin, stop in parts:
            part = bare[begin:stop]
            value = re.match(r".*?\w\s*=(?!=)\s*", part, re.DOTALL)
            if value and not part[value.end():].startswith("{"):
                self.sites.append(("value", at + begin + value.end(), at + stop, kind))
        return True


def changes(text, bound=False):
    """What an expression or a statement can become: (what, text)."""
    inside, brackets = angles(text), []
    for token in TOKEN.finditer(text):
        word, begin, end = token[0], token.start(), token.end()
        if word in "([{":
            brackets.append(word)
        elif word in ")]}" and brackets:
            brackets.pop()
        if inside[begin]:
            continue
        before, after = text[:begin], text[end:]
        if word == "select" or word == "round_to":
            yield from of_call(word, text, begin, end)
        new = SWAPS.get(word)
        alone = word in ("!", "++", "true", "false") or (before.endswith(" ") and after.startswith(" "))
        if bound and word in ("<", "<=", ">", ">=", "!="):
            new = None  # an array would be left
        if new is not None and alone:
            yield f"{word} to {new or 'nothing'}", before + new + after
        if word == "-" and not alone and re.search(r"[(,=?:]\s*$", before):
            yield "- to nothing", before + after
        if re.fullmatch(r"\d+", word) and not before.endswith((".", "'")):
            value = int(word)
            if brackets and brackets[-1] == "[":
                others = [1 if value == 0 else value - 1]
            elif bound:
                others = [value - 1]
            else:
                others = [value + 1] + ([value - 1] if value else [])
            for other in others:
                yield f"{word} to {other}", before + str(other) + after
        if bound and re.fullmatch(r"k[A-Z]\w*", word) and not after.startswith("("):
            yield f"{word} less 1", before + word + " - 1" + after
    # What stands behind an assignment.
    head = text[:pieces(text, "=")[-1][0]]
    value = text[len(head):]
    for operator, weaker, neutral in (("&&", ("||", "?"), " true "), ("||", ("?",), " false ")):
        parts = pieces(value, operator)
        if len(parts) > 1 and all(len(pieces(value, other)) == 1 for other in weaker):
            for begin, end in parts:
                yield f"without {value[begin:end].strip()}", head + value[:begin] + neutral + value[end:]
    parts = pieces(value, "?")
    if len(parts) == 2:
        behind = value[parts[1][0]:]
        choice = pieces(behind, ":")
        if len(choice) == 2:
            for begin, end in choice:
                yield f"always {behind[begin:end].strip()}", head + " " + behind[begin:end].strip()


def of_call(word, text, begin, end):
    """Of select(c, a, b): a, b, or the other; of round_to<T>(x): no rounding."""
    if word == "select" and text[end:end + 1] == "(":
        close = closed(text, end)
        args = [text[end + 1:close - 1][a:b].strip() for a, b in pieces(text[end + 1:close - 1], ",")]
        if len(args) == 3:
            # As a type of its own: what select() takes may have to be converted.
            yield "select first", text[:begin] + f"select(true, {args[1]}, {args[2]})" + text[close:]
            yield "select second", text[:begin] + f"select(false, {args[1]}, {args[2]})" + text[close:]
            yield "select other", text[:begin] + f"select(!({args[0]}), {args[1]}, {args[2]})" + text[close:]
    if word == "round_to" and text[end:end + 1] == "<":
        inside = angles(text)
        stop = next(at for at in range(end, len(text)) if not inside[at])
        yield "no rounding", text[:begin] + text[end + 1:stop - 1] + text[stop:]


def sites(code, constexpr=False):
    """The places of a header, without its comments, that can be changed."""
    reader = Reader(code, constexpr)
    reader.declarations(0, len(code))
    return reader.sites


def mutants(text, constexpr=False):
    """Of a header: (site, what, text), site being (kind, begin, end, type)."""
    code, found = blank(text), []
    for site in sites(code, constexpr):
        kind, begin, end, _ = site
        said = code[begin:end]
        news = {}
        for what, new in changes(said, kind == "bound"):
            if new.split() != said.split():
                news.setdefault(" ".join(new.split()), what)
        if kind == "statement":
            news[""] = "without " + " ".join(said.split())
        found += [(site, what, new) for new, what in news.items()]
    return found


def line_of(text, at):
    return text.count("\n", 0, at) + 1


def applied(text, chosen):
    """The header with these mutants in it, {number: (site, what, text)}; and the number of each line that is of one."""
    code, edits = blank(text), {}
    for number, (site, _, new) in chosen.items():
        edits.setdefault(site, []).append((number, new))
    changed = []
    for (kind, begin, end, of), some in edits.items():
        said = " ".join(code[begin:end].split())
        if kind in ("statement", "return"):
            word = "return " if kind == "return" else ""
            tries = "".join(f"\n@{number}@if (hs_mutant::is({number})) {{ {word}{new}; }} else "
                            for number, new in some)
            changed.append((begin - len(word.strip()), end + 1, f"{{ {tries}\n{{ {word}{said}; }} }}"))
        else:
            kept = f"std::decay_t<decltype({said})>" if of == "auto" else of
            tries = "".join(f"\n@{number}@hs_mutant::is({number}) ? {kept}({new}) :" for number, new in some)
            changed.append((begin, end, f"({tries}\n{kept}({said}))"))
    for begin, end, new in sorted(changed, reverse=True):
        text = text[:begin] + new + text[end:]
    lines = text.split("\n")
    of_line = {n: int(match[1]) for n, line in enumerate(lines, 1) if (match := re.match(r"@(\d+)@", line))}
    return "\n".join(re.sub(r"^@\d+@", "", line) for line in lines), of_line
