# SPDX-License-Identifier: Apache-2.0
"""Every operation, one question at a time."""
from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Optional, Union

from . import _touchstone
from ._errors import InvalidInput

_rational = re.compile(r"-?\d+(/\d+)?")
_root = re.compile(r"(?P<p>-?\d+(?:/\d+)?)??(?P<sign>[+-]?)(?:(?P<q>\d+(?:/\d+)?)\*)?sqrt\((?P<r>\d+(?:/\d+)?)\)")
_not_finite = {"nan": float("nan"), "inf": float("inf"), "-inf": float("-inf")}


@dataclass(frozen=True)
class Surd:
    """The exact number rational + coefficient * sqrt(radicand), which is not rational."""

    rational: Fraction
    coefficient: Fraction
    radicand: Fraction


Exact = Union[Fraction, Surd]


@dataclass(frozen=True)
class Truth:
    """The exact answer to a question.

    answer       what the operation's JSON holds: enumerators are texts, exact numbers Fraction or Surd, indices int
    rounded      a right answer in floats
    margin       how far the question is from one with another answer: 0 where it is degenerate; None where nothing is
                 decided. A length to a power that the contract names
    touch        whether the answer for open sets would be another
    certificate  what proves the answer: the kind, and named lists of Fractions or of certificates; None if not asked for
    claim        question, answer and certificate as a line of JSON, which certify() checks
    """

    operation: str
    input: dict[str, Any]
    answer: dict[str, Any]
    rounded: dict[str, Any]
    margin: Optional[Fraction]
    touch: bool
    certificate: Optional[dict[str, Any]]
    claim: str


@dataclass(frozen=True)
class Question(Truth):
    """A drawn question with its truth; its certificate is not made."""

    family: str
    index: int


def answer(operation: str, question: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the answer of robust: right, with every number rounded once."""
    answered: dict[str, Any] = _floats(json.loads(_touchstone.answer(operation, _text(question))))
    return answered


def truth(operation: str, question: Mapping[str, Any]) -> Truth:
    """The exact answer, with the certificate that proves it."""
    line = _touchstone.truth(operation, _text(question))
    return Truth(**_truth_in(json.loads(line), line))


def certify(claim: Union[str, Mapping[str, Any], Truth]) -> None:
    """Checks a claim, such as truth(...).claim, a line of the test vectors or what `touchstone ask` prints.

    Raises CertificateRefused, which says why, unless its certificate proves that its truth is the answer. The checker
    multiplies, adds and compares fractions; it shares no code with what made the certificate.
    """
    if isinstance(claim, Truth):
        claim = claim.claim
    _touchstone.certify(claim if isinstance(claim, str) else json.dumps(claim, default=_number))


def draw(operation: str, cases: int = 100, seed: int = 1, families: Union[str, Iterable[str]] = ()) -> list[Question]:
    """Questions within the contract, degenerate on purpose, dealt out over the families in turn.

    The same seed gives the same questions on every machine. `families`: some of operations()[name]["families"]; if left
    out, all.
    """
    if cases < 0 or not 0 <= seed < 2**64:
        raise InvalidInput("cases" if cases < 0 else "seed", "an integer from 0 to 2^64 - 1")
    names = families if isinstance(families, str) else ",".join(families)
    drawn = []
    for line in _touchstone.draw(operation, names, cases, seed).splitlines():
        read = json.loads(line)
        drawn.append(Question(family=read["family"], index=read["index"], **_truth_in(read, line)))
    return drawn


def operations() -> dict[str, dict[str, Any]]:
    """Lists the operations: for each the question, fields, answer, enumerators ("words") and families."""
    return {operation["name"]: operation for operation in json.loads(_touchstone.operations())}


def _truth_in(read: dict[str, Any], line: str) -> dict[str, Any]:
    margin, certificate = read.get("margin"), read.get("certificate")
    return {"operation": read["op"], "input": _floats(read["input"]), "answer": _exact(read["truth"]),
            "rounded": _floats(read["rounded"]), "margin": None if margin is None else Fraction(margin),
            "touch": read["touch"], "certificate": None if certificate is None else _exact(certificate), "claim": line}


def _text(question: Mapping[str, Any]) -> str:
    if not isinstance(question, Mapping):
        raise InvalidInput("question", f"expected a mapping from fields to values, found {type(question).__name__}")
    return json.dumps(question, default=_number)


def _number(value: Any) -> Any:
    """Converts what JSON has no form for: arrays and numbers of numpy, and fractions that are doubles."""
    if isinstance(value, Fraction):
        if Fraction(float(value)) != value:
            raise InvalidInput("question", f"numbers that are doubles, found {value}")
        return float(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise InvalidInput("question", f"numbers, texts, lists and mappings, found {type(value).__name__}")


def _floats(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _floats(held) for name, held in value.items()}
    if isinstance(value, list):
        return [_floats(held) for held in value]
    return _not_finite.get(value, value) if isinstance(value, str) else value


def _exact(value: Any) -> Any:
    """Texts of exact numbers become numbers; enumerators stay."""
    if isinstance(value, dict):
        return {name: _exact(held) for name, held in value.items()}
    if isinstance(value, list):
        return [_exact(held) for held in value]
    if not isinstance(value, str):
        return value
    if _rational.fullmatch(value):
        return Fraction(value)
    root = _root.fullmatch(value)
    if root is None:
        return value
    coefficient = Fraction(root["q"] or 1) * (-1 if root["sign"] == "-" else 1)
    return Surd(Fraction(root["p"] or 0), coefficient, Fraction(root["r"]))
