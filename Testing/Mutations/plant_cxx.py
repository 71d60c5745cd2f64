# SPDX-License-Identifier: BSD-3-Clause
"""Where a file of C++ can be broken, and how: by its tokens, as clang-format lays them out. The compiler decides
whether a fault compiles.
"""

import re

SKIPPED = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"\w*\(.*?\)\w*"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])*'"""
    r"""|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*""",
    re.DOTALL | re.MULTILINE)  # fmt: skip
NO_FUNCTION = re.compile(r"\s*(?:template\s*<[^{]*>\s*)?(?:namespace|class|struct|enum|union|extern|using)\b")
COMPARISONS = {
    "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",),
}  # fmt: skip
OTHERS = {
    "&&": ("||", "and or or"), "||": ("&&", "and or or"), "+": ("-", "operator changed"),
    "-": ("+", "operator changed"), "*": ("+", "operator changed"), "/": ("*", "operator changed"),
    "%": ("+", "operator changed"), "+=": ("-=", "operator changed"), "-=": ("+=", "operator changed"),
    "|=": ("=", "operator changed"), "&=": ("=", "operator changed"),
}  # fmt: skip
OPERATOR = re.compile(r"(?<=[\w)\]]) (<=|>=|==|!=|<|>|&&|\|\||\+=|-=|\|=|&=|\+|-|\*|/|%)(?=[ \n])")
WORDS = {"true": "false", "false": "true", "break": "continue", "continue": "break"}
WORD = re.compile(r"\b(true|false|break|continue)\b")
NUMBER = re.compile(r"(?<![\w.\"'])(\d+)(\.\d+)?(?![\w.xX'])")
CONDITION = re.compile(r"\b(?:if|while) (?:constexpr )?\(")
CALL = re.compile(r"\w\(")
NOTHING_MORE = ("return", "return {}", "return nullptr", "return false", "return 0")  # is what {} gives
LOCKS = re.compile(r"\b(?:lock_guard|unique_lock|scoped_lock)\b|\block\(\)")


def sites(text):
    """(begin, end, replacement, kind, function) of each way to break it."""
    code = SKIPPED.sub(blank, text)
    found = []
    for begin, end, function in bodies(code):
        for site in [*expressions(text, code, begin, end), *statements(text, code, begin, end)]:
            found.append((*site, function))
    return found


def blank(match):
    """As many characters, without code in them; of a string something that is still an expression."""
    text = match.group()
    if text[0] in "\"'R" and len(text) > 1:
        return '"' + re.sub(r"[^\n]", "_", text[1:-1]) + '"'
    return re.sub(r"[^\n]", " ", text)


def bodies(code):
    """(begin, end, name) of the bodies of functions, lambdas within them included."""
    head, depth, inside = 0, 0, None  # where the declaration begins; braces within a body; the body
    for match in re.finditer(r"[{};]", code):
        sign, at = match.group(), match.start()
        if inside is not None:
            depth += {"{": 1, "}": -1, ";": 0}[sign]
            if depth == 0:
                yield inside[0], at, inside[1]
                inside, head = None, at + 1
            continue
        declared = code[head:at]
        if sign == "{" and "(" in declared and not NO_FUNCTION.match(declared):
            named = re.search(r"([\w:~]+|operator\S+)\s*\(", declared)
            inside, depth = (at + 1, named.group(1) if named else ""), 1
        head = at + 1


def closing(code, opened):
    """Where the bracket closes that is opened there; -1 if it does not."""
    depth = 0
    for k in range(opened, len(code)):
        depth += (code[k] in "([{") - (code[k] in ")]}")
        if depth == 0:
            return k
    return -1


def expressions(text, code, begin, end):
    for match in OPERATOR.finditer(code, begin, end):
        sign, span = match.group(1), match.span(1)
        others = COMPARISONS.get(sign)
        for k, other in enumerate(others or ()):
            yield (*span, other, "off by one" if k == 0 and len(others) == 2 else "comparison flipped")
        if not others:
            yield (*span, *OTHERS[sign])
    for match in WORD.finditer(code, begin, end):
        yield (*match.span(), WORDS[match.group()], "constant changed" if "e" == match.group()[-1] else "loop left")
    for match in NUMBER.finditer(code, begin, end):
        whole, part = match.groups()
        yield (*match.span(), str(int(whole) + 1) + (part or ""), "constant changed")
        if not part and int(whole) > 0:
            yield (*match.span(), str(int(whole) - 1), "constant changed")
    for match in CONDITION.finditer(code, begin, end):
        last = closing(code, match.end() - 1)
        if ";" not in code[match.end() : last]:
            yield (match.end(), last, "!(%s)" % text[match.end() : last], "condition negated")
    yield from swapped(text, code, begin, end)


def swapped(text, code, begin, end):
    """The first two arguments of each call."""
    for match in CALL.finditer(code, begin, end):
        last = closing(code, match.end() - 1)
        commas, depth = [], 0
        for k in range(match.end(), last):
            depth += (code[k] in "([{") - (code[k] in ")]}")
            if code[k] == "," and depth == 0:
                commas.append(k)
        if not commas:
            continue
        comma, stop = commas[0], (commas + [last])[1]
        first, second = text[match.end() : comma], text[comma + 1 : stop]
        if "<" in code[match.end() : comma]:  # of a template, more likely than not
            continue
        gap = len(second) - len(second.lstrip())
        yield (match.end(), stop, second.strip() + "," + second[:gap] + first, "arguments swapped")


def statements(text, code, begin, end):
    """Each whole statement that ends in a semicolon."""
    start = begin
    for match in re.finditer(r"[{};]|\b(?:case [\w:]+|default):(?!:)", code[begin:end]):
        at = begin + match.start()
        first = start + len(code[start:at]) - len(code[start:at].lstrip())
        part = code[first:at]
        start = begin + match.end()
        if match.group() != ";" or not part.strip() or part.count("(") != part.count(")"):
            continue
        # the statement of a condition without braces
        if (head := CONDITION.match(part)) or part.startswith("for ("):
            opened = part.index("(") if not head else head.end() - 1
            first += closing(part, opened) + 1
            first += len(code[first:at]) - len(code[first:at].lstrip())
            part = code[first:at]
        if part.startswith("else "):
            first, part = first + 5, part[5:]
        span = (first, at + 1)
        if part.startswith("return"):
            if part not in NOTHING_MORE:
                yield (*span, "return {};", "early return")
            continue
        yield (*span, ";", removed(part))
        yield (*span, "return {};", "early return")
        yield (*span, "return;", "early return")


def removed(part):
    if LOCKS.search(part):
        return "lock removed"
    if part.startswith("throw"):
        return "exception swallowed"
    if re.match(r"this->[\w.>-]+(?:\[[^]]*\])? [-+|&]?= ", part):
        return "assignment to a member removed"
    return "statement removed"
