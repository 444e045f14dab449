# SPDX-License-Identifier: Apache-2.0
"""Right answers to questions of collision detection, and the exact truth.

    touchstone.segment_segment(a, b)               a decision for each row of two arrays of float64
    touchstone.answer("segment_segment", {...})    what robust answers, numbers rounded once
    touchstone.truth("segment_segment", {...})     the exact answer with fractions, margin and certificate
    touchstone.certify(truth.claim)                whether the certificate proves the answer
    touchstone.draw("segment_segment", 100)        questions that are degenerate on purpose, with their truth
    touchstone.operations()                        what there is

Input outside the contract raises InvalidInput, a ValueError that names the field and the rule.
"""
from typing import Any

from ._errors import CertificateRefused, InvalidInput
from ._operations import Exact, Question, Surd, Truth, answer, certify, draw, operations, truth

__all__ = [
    "CertificateRefused", "Exact", "InvalidInput", "Question", "Surd", "Truth", "answer", "certify", "draw", "operations",
    "truth"
]
try:
    from . import arrays
    from .arrays import *  # noqa: F403
    __all__ += arrays.__all__
except ModuleNotFoundError as missing:
    if missing.name != "numpy":
        raise

    def __getattr__(name: str) -> Any:
        raise AttributeError(f"touchstone.{name}: there is none, or it is of the decisions over arrays, which need numpy")
