# SPDX-License-Identifier: Apache-2.0
"""Where C++ leaves the order of two draws open, so that compilers make different questions of one seed: as arguments of
one call, or as operands of one operator. Lists in braces, `,`, `;`, `&&`, `||` and `?:` have an order."""
import re

COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
DECLARED = re.compile(r"\bDrawStream& *(\w+)")
LAMBDA = re.compile(r"\bauto (\w+) = (\[[^\[\]]*\])")
CALLED = re.compile(r"(\w+|[>\])])\s*$")
STATEMENTS = {"if", "for", "while", "switch", "return", "catch", "co_return", "case"}
PAIRS = {"(": ")", "[": "]", "{": "}"}
TOKEN = re.compile(r"->|<<=|>>=|<=>|<<|>>|&&|\|\||[<>=!]=|[-+*/%&|^]=|\+\+|--|::|[-+*/%<>&|^?:,;=(){}\[\]]")
# Assignments have an order since C++17, as shifts do.
ORDERED = {"&&", "||", "?", ":", ",", ";", "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
UNORDERED = {"+", "-", "*", "/", "%", "<", ">", "<=", ">=", "==", "!=", "<=>", "&", "|", "^"}


def unordered_draws(source):
    """Yields (line, what) of each pair of draws in unspecified order."""
    code = COMMENT_OR_TEXT.sub(lambda found: re.sub(r"[^\n]", " ", found.group(0)), source)
    names = set(DECLARED.findall(code))
    if not names:
        return
    closes = closing(code)
    streams = rf"(?:{'|'.join(sorted(names))})"
    draw = rf"[(,{{]\s*{streams}\s*[),}}]|\b{streams}\.\w+\("
    # A local function that has a stream within draws where it is called.
    within = [found.group(1) for found in LAMBDA.finditer(code)
              if re.search(rf"\b{streams}\b", found.group(2)) or
              (re.match(r"\[&", found.group(2)) and re.search(draw, body_of(code, closes, found.end())))]
    if within:
        draw += rf"|(?<![\w.])(?:{'|'.join(sorted(set(within)))})\("
    yield from walk(code, closes, re.compile(draw), 0, len(code), False)


def closing(code):
    """Returns where each opening bracket closes."""
    waiting, closes = [], {}
    for found in re.finditer(r"[(){}\[\]]", code):
        if found.group(0) in PAIRS:
            waiting.append(found.start())
        elif waiting:
            closes[waiting.pop()] = found.start()
    return closes


def body_of(code, closes, start):
    opening = code.find("{", start)
    return code[opening:closes.get(opening, opening)]


def walk(code, closes, draw, start, end, call):
    """The text of one pair of brackets; call: it holds the arguments of a call."""
    operand, operands, arguments = start, 0, 0  # operands and arguments so far that draw
    draws_in_argument = False
    at = start
    while at <= end:
        found = TOKEN.search(code, at, end)
        token, place = (found.group(0), found.start()) if found else (";", end)
        if token in PAIRS:
            last = closes.get(place, end)
            before = CALLED.search(code, max(start, place - 80), place)
            is_call = token == "(" and bool(before) and before.group(1) not in STATEMENTS | {"]"}
            yield from walk(code, closes, draw, place + 1, last, is_call)
            at = last + 1
            # A statement ends with the condition before it, and with its braces, unless an operator follows.
            if (before and before.group(1) in STATEMENTS and token == "(") or (
                    token == "{" and not re.match(r"\s*[-+*/%<>=!&|^?:,;)}\].\[(]", code[at:at + 200])):
                operand, operands = at, 0
            continue
        at = place + max(len(token), 1)
        if token not in ORDERED and token not in UNORDERED:
            continue
        if draws(code, closes, draw, operand, place):
            operands += 1
            if operands == 2:
                yield line_of(code, place), "two draws in one expression, in unspecified order"
            if not draws_in_argument:
                draws_in_argument, arguments = True, arguments + 1
                if call and arguments == 2:
                    yield line_of(code, place), "two draws in one call, in unspecified order"
        operand = at
        if token in ORDERED:
            operands = 0
        if token == ",":
            draws_in_argument = False


def draws(code, closes, draw, start, end):
    """Says whether an operand draws; the body of a lambda in it does not, for it runs when it is called."""
    return any(not in_lambda(code, closes, start, found.start()) for found in draw.finditer(code, start, end))


def in_lambda(code, closes, start, place):
    for opening, last in closes.items():
        if code[opening] == "[" and start <= opening < place and not CALLED.search(code, max(start, opening - 80), opening):
            body = code.find("{", last)
            if body != -1 and place <= closes.get(body, last):
                return True
    return False


def line_of(code, place):
    return code.count("\n", 0, place) + 1
