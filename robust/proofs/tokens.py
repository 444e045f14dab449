# SPDX-License-Identifier: Apache-2.0
"""A text of C++ as its tokens, one taken after another: what the readers of filters have in common."""


class Tokens:
    """A reader adds expression()."""

    def __init__(self, pattern, text):
        self.tokens, self.at, at = [], 0, 0
        text = text.rstrip()
        while at < len(text):
            found = pattern.match(text, at)
            if not found:
                raise SystemExit(f"not understood: {text[at:at + 40]!r}")
            self.tokens.append(found[found.lastindex])
            at = found.end()

    def peek(self, ahead=0):
        return self.tokens[self.at + ahead] if self.at + ahead < len(self.tokens) else None

    def take(self, token=None):
        found = self.peek()
        if found is None or (token is not None and found != token):
            raise SystemExit(f"{token!r} expected at {' '.join(self.tokens[max(0, self.at - 5):self.at + 5])}")
        self.at += 1
        return found

    def arguments(self):
        self.take("(")
        values = []
        while self.peek() != ")":
            values.append(self.expression())
            if self.peek() == ",":
                self.take()
        self.take(")")
        return values
