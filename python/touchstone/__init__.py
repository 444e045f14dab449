# SPDX-License-Identifier: Apache-2.0
"""Right answers to questions of collision detection, and the exact truth.

    touchstone.segment_segment_intersects(a, b)    a mask: one bool for each row of two arrays of float64
    touchstone.segment_segment(a, b)               an enumerator for each row; help(touchstone.arrays) lists all of both
    touchstone.answer("segment_segment", {...})    what robust answers, numbers rounded once
    touchstone.truth("segment_segment", {...})     the exact answer with fractions, margin and certificate
    touchstone.certify(truth.claim)                whether the certificate proves the answer
    touchstone.draw("segment_segment", 100)        questions that are degenerate on purpose, with their truth
    touchstone.operations()                        what there is
    touchstone.record                              records the calls of your own functions (docs/own_inputs.md)

Input outside the contract raises InvalidInput, a ValueError that names the field and the rule.
"""
from typing import Any

from ._errors import CertificateRefused, InvalidInput
from ._operations import Exact, Question, Surd, Truth, answer, certify, draw, operations, truth
from ._version import __version__

__all__ = [
    "CertificateRefused", "Exact", "InvalidInput", "Question", "Surd", "Truth", "__version__", "answer", "certify", "draw",
    "operations", "truth"
]
try:
    from . import _decisions, arrays
    from ._answers import Answers
    from ._columns import use_threads
    from ._decisions import *  # noqa: F403
    from ._prepared import ConvexPolygon, ConvexSolid, Polygon, Solid, Surface
    __all__ += ["Answers", "ConvexPolygon", "ConvexSolid", "Polygon", "Solid", "Surface", "arrays", "use_threads", *_decisions.__all__]
except ModuleNotFoundError as missing:
    if missing.name != "numpy":
        raise

    def __getattr__(name: str) -> Any:
        raise AttributeError(f"touchstone.{name}: there is none, or it is of the decisions over arrays, which need numpy")
