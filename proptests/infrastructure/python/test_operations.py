# SPDX-License-Identifier: Apache-2.0
"""Every operation from Python: answers, truths with their certificates, and what is refused."""
import copy
import json
import math
import pathlib
import pickle
import re
from fractions import Fraction

import numpy
import pytest
import touchstone
from hypothesis import given, settings, strategies

OPERATIONS = touchstone.operations()
ASKED = sorted(name for name, operation in OPERATIONS.items() if "implementation_of" not in operation)


def leaves(value):
    if isinstance(value, dict):
        value = list(value.values())
    return [leaf for held in value for leaf in leaves(held)] if isinstance(value, list) else [value]


@pytest.mark.parametrize("name", ASKED)
def test_every_operation(name):
    """Robust's answer has the truth's enumerators and indices; every other text of a truth has become a number; and the
    certificate proves it."""
    drawn = touchstone.draw(name, 12, seed=3)
    assert len(drawn) == 12
    for question in drawn:
        assert question.operation == name
        answered, truth = touchstone.answer(name, question.input), touchstone.truth(name, question.input)
        assert truth.answer == question.answer and truth.margin == question.margin and truth.input == question.input
        words = {word for leaf in leaves(OPERATIONS[name]["answer"]) for word in leaf.split(" | ")}
        assert {leaf for leaf in leaves(truth.answer) if isinstance(leaf, str)} <= words
        if OPERATIONS[name]["kind"] != "checked":
            assert [leaf for leaf in leaves(answered) if isinstance(leaf, (str, bool))] == [
                leaf for leaf in leaves(truth.answer) if isinstance(leaf, (str, bool))], question.claim
        assert {type(leaf) for leaf in leaves(truth.answer)} <= {str, bool, int, Fraction, touchstone.Surd}
        assert {type(leaf) for leaf in leaves(answered)} <= {str, bool, int, float}
        if truth.margin is not None:
            assert truth.margin >= 0
        touchstone.certify(truth)


def test_a_segment_pair():
    question = {"a": [[0, 0], [3, 3]], "b": [[0, 1], [1, 0]]}
    assert touchstone.answer("segment_segment", question) == {"relation": "point", "ta": 1 / 6, "tb": 0.5, "point": [0.5, 0.5]}
    truth = touchstone.truth("segment_segment", question)
    assert truth.answer == {"relation": "point", "ta": Fraction(1, 6), "tb": Fraction(1, 2), "point": [Fraction(1, 2)] * 2}
    assert truth.rounded == touchstone.answer("segment_segment", question)
    assert not truth.touch
    touchstone.certify(truth)
    touchstone.certify(truth.claim)
    touchstone.certify(json.loads(truth.claim))


def test_a_number_that_is_a_root():
    """Two balls whose distance is sqrt(2) meet when each has moved: t solves a quadratic with an irrational root."""
    [question] = [question for question in touchstone.draw("swept_sphere_sphere", 200) if
                  isinstance(question.answer.get("t"), touchstone.Surd)][:1]
    t = question.answer["t"]
    assert math.isqrt(t.radicand.numerator) ** 2 != t.radicand.numerator or math.isqrt(t.radicand.denominator) ** 2 != t.radicand.denominator
    assert question.rounded["t"] == pytest.approx(float(t.rational) + float(t.coefficient) * math.sqrt(t.radicand), rel=1e-6)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(strategies.sampled_from(touchstone.draw("segment_segment", 300, seed=4)), strategies.integers(-3, 3))
def test_a_false_claim_is_refused(question, wrong):
    touchstone.certify(touchstone.truth("segment_segment", question.input))
    claim = json.loads(touchstone.truth("segment_segment", question.input).claim)
    claim["truth"] = {"relation": "point", "ta": "0", "tb": "0", "point": ["1/3", str(wrong)]}
    with pytest.raises(touchstone.CertificateRefused, match="."):
        touchstone.certify(claim)


def test_questions_hold_what_python_has():
    exact = touchstone.truth("orientation", {"p0": [0, 0], "p1": [1.0, 1.0], "p": [Fraction(1, 2), Fraction(1, 4)]})
    numpys = touchstone.truth("orientation", {"p0": numpy.zeros(2), "p1": numpy.ones(2), "p": [numpy.float64(0.5), 0.25]})
    assert exact == numpys and exact.answer == {"side": "right"}
    for number in (0.1, 5e-324, -0.0, 1.7976931348623157e308, 2.0**53 + 2, 1 / 3):
        drawn = touchstone.truth("orientation", {"p0": [number, 0], "p1": [0, 0], "p": [0, 0]}).input["p0"][0]
        assert drawn == number and math.copysign(1, drawn) == math.copysign(1, number) and isinstance(drawn, float)


def refusal(call, *arguments, **named):
    with pytest.raises(touchstone.InvalidInput) as refused:
        call(*arguments, **named)
    copied = pickle.loads(pickle.dumps(refused.value))
    assert (copied.field, copied.rule) == (refused.value.field, refused.value.rule)
    return refused.value.field, refused.value.rule


@pytest.mark.parametrize("call", [touchstone.answer, touchstone.truth])
def test_what_is_refused(call):
    right = {"a": [[0, 0], [1, 0]], "b": [[0, 0], [0, 1]]}

    def changed(value):
        question = copy.deepcopy(right)
        question["a"][0][1] = value
        return question

    field, rule = refusal(call, "segment_segmnt", right)
    assert field == "operation" and 'did you mean "segment_segment"' in rule
    for number in (math.nan, math.inf, 10**400):
        field, rule = refusal(call, "segment_segment", changed(number))
        assert field == "a[0][1]" and rule == "finite number"
    assert refusal(call, "segment_segment", changed("x"))[0] == "a[0][1]"
    assert refusal(call, "segment_segment", {"a": right["a"]}) == ("b", "missing")
    assert refusal(call, "segment_segment", right | {"c": 1})[0] == "c"
    assert refusal(call, "segment_segment", [right])[0] == "question"
    assert refusal(call, "segment_segment", changed({1})) == ("question", "numbers, texts, lists and mappings, found set")
    assert refusal(call, "segment_segment", changed(Fraction(1, 3))) == ("question", "numbers that are doubles, found 1/3")
    field, rule = refusal(call, "sphere_sphere", {"a": {"center": [0, 0], "radius": -1}, "b": {"center": [0, 0], "radius": 1}})
    assert field == "a.radius"


def test_what_draw_refuses_and_certify():
    field, rule = refusal(touchstone.draw, "segment_segment", families=["collinar"])
    assert field == "families" and "no such family" in rule
    assert refusal(touchstone.draw, "segment_segment", -1)[0] == "cases"
    assert refusal(touchstone.draw, "segment_segment", seed=2**64)[0] == "seed"
    assert refusal(touchstone.draw, "no_such_operation")[0] == "operation"
    with pytest.raises(touchstone.CertificateRefused):
        touchstone.certify("not JSON")
    with pytest.raises(touchstone.CertificateRefused):
        touchstone.certify({"op": "orientation"})


def test_drawing():
    chosen = OPERATIONS["segment_segment"]["families"][:2]
    drawn = touchstone.draw("segment_segment", 20, families=chosen)
    assert {question.family for question in drawn} == set(chosen)
    assert drawn == touchstone.draw("segment_segment", 20, families=",".join(chosen))
    assert all(question.certificate is None for question in drawn)
    assert touchstone.draw("segment_segment", 0) == []
    assert touchstone.draw("segment_segment", 20, seed=5) != touchstone.draw("segment_segment", 20, seed=6)


def test_operations():
    assert OPERATIONS["segment_segment"]["fields"] == ["a", "b"]
    assert OPERATIONS["segment_segment"]["words"] == ["disjoint", "point", "overlap"]


def test_the_version_is_that_of_the_project():
    project = (pathlib.Path(__file__).resolve().parents[3] / "CMakeLists.txt").read_text(encoding="utf-8")
    assert re.search(r"project\(touchstone VERSION (\S+)", project)[1] == touchstone.__version__
