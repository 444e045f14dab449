# SPDX-License-Identifier: Apache-2.0
"""Decisions over numpy's arrays: equal to robust's answer and to the truth, question by question, wherever the numbers stand."""
import pydoc
import threading

import numpy
import pytest
import touchstone
from hypothesis import given, settings, strategies
from touchstone import arrays
from touchstone._answers import Enumeration

NAMES = touchstone._decisions.__all__
ENUMERATIONS = [made for made in map(vars(arrays).get, NAMES) if isinstance(made, type) and issubclass(made, Enumeration)]
MASKS = [name for name in NAMES if name.endswith(("_contains", "_intersects"))]
DECISIONS = [name for name in NAMES if name not in MASKS and name not in [made.__name__ for made in ENUMERATIONS]]
OPERATIONS = touchstone.operations()


def enumeration_of(name):
    """The one that the docstring names."""
    words = getattr(arrays, name).__doc__.replace("\n", " ").split()
    [found] = [made for made in ENUMERATIONS if f"{made.__name__}:" in words]
    return found


def word_in(answer, enumeration):
    """The enumerator in an answer, of which it is the only text that the enumeration has."""
    [word] = [value for value in answer.values() if isinstance(value, str) and value in enumeration.__members__]
    return enumeration[word]


def numbers_in(value):
    if isinstance(value, dict):
        return [number for held in value.values() for number in numbers_in(held)]
    return [number for held in value for number in numbers_in(held)] if isinstance(value, list) else [float(value)]


def kinds_of(questions):
    """Questions that can stand in one array: in the plane, in space. A polygon and a mesh are one for all rows."""
    kinds = {}
    for question in questions:
        key = []
        for value in question.input.values():
            if isinstance(value, dict) and "faces" in value:
                key.append(repr(value))
            elif isinstance(value, list) and value and isinstance(value[0], list) and len(value) > 2:
                key.append(repr(value))
            else:
                key.append(len(numbers_in(value)))
        kinds.setdefault(tuple(key), []).append(question)
    return list(kinds.values())


def operands_of(name, questions):
    """For each argument an array with a row for each question, the numbers of a row side by side."""
    operands = []
    for field, value in questions[0].input.items():
        if isinstance(value, dict) and "faces" in value:
            triangles = value.get("cut", value["faces"])
            operands.append((numpy.array(value["vertices"], dtype=float).reshape(-1, 3), numpy.array(triangles, dtype=int)))
        elif field == "polygon":
            operands.append(numpy.array(value, dtype=float).reshape(-1, 2))
        else:
            operands.append(numpy.array([numbers_in(question.input[field]) for question in questions]))
    return operands


def test_there_are_decisions_over_arrays():
    assert {"orientation", "segment_segment", "point_in_polygon", "ray_aabb"} <= set(DECISIONS)
    assert set(DECISIONS) <= set(OPERATIONS)


@pytest.mark.parametrize("name", DECISIONS)
def test_enumerators_are_those_of_the_operation(name):
    assert [member.name for member in enumeration_of(name)] == OPERATIONS[name]["words"]
    assert [member.value for member in enumeration_of(name)] == list(range(len(OPERATIONS[name]["words"])))


@pytest.mark.parametrize("name", DECISIONS)
def test_arrays_equal_answers_equal_truth(name):
    decide, enumeration = getattr(touchstone, name), enumeration_of(name)
    seen = set()
    for questions in kinds_of(touchstone.draw(name, 400)):
        answers = decide(*operands_of(name, questions))
        assert answers.numbers.dtype == numpy.uint8 and answers.numbers.shape == (len(questions),)
        for answer, question in zip(answers, questions):
            assert answer is word_in(question.answer, enumeration), question.claim
            assert answer is word_in(touchstone.answer(name, question.input), enumeration), question.claim
            seen.add(int(answer))
    assert seen == set(map(int, enumeration))


SQUARE = numpy.array([[0.0, 0], [4, 0], [4, 4], [0, 4]])
AT_SQUARE = numpy.array([[9.0, 9], [2, 2], [4, 1]])  # outside, inside, on the boundary


def test_masks_choose_rows():
    assert AT_SQUARE[touchstone.polygon_contains(SQUARE, AT_SQUARE)].tolist() == [[2, 2], [4, 1]]
    assert AT_SQUARE[touchstone.polygon_contains(SQUARE, AT_SQUARE, boundary=False)].tolist() == [[2, 2]]
    spheres = numpy.array([[4.0, 0, 0, 2], [3, 0, 0, 2], [5, 0, 0, 2]])
    assert touchstone.sphere_sphere_intersects(spheres, [0.0, 0, 0, 2]).tolist() == [True, True, False]
    assert touchstone.sphere_sphere_intersects(spheres, [0.0, 0, 0, 2], touching=False).tolist() == [False, True, False]
    assert touchstone.segment_contains([0.0, 0, 2, 2], numpy.array([[1.0, 1], [3, 3], [1, 0]])).tolist() == [True, False, False]


@pytest.mark.parametrize("name", MASKS)
def test_a_mask_is_that_of_its_decision(name):
    """The decision's enumerator that says `nothing in common` is False, all others are True."""
    decision = getattr(arrays, name).__doc__.split("`")[1]
    nothing = {"outside", "off", "disjoint", "none"}
    for questions in kinds_of(touchstone.draw(decision, 100)):
        operands = operands_of(decision, questions)
        expected = [word_in(question.answer, enumeration_of(decision)).name not in nothing for question in questions]
        mask = getattr(touchstone, name)(*(operands[::-1] if decision.startswith("point_on") else operands))
        assert mask.dtype == bool and mask.tolist() == expected


def test_answers_are_no_masks():
    answers = touchstone.point_in_polygon(SQUARE, AT_SQUARE)
    assert list(answers) == [touchstone.Location.outside, touchstone.Location.inside, touchstone.Location.boundary]
    for use in (lambda: AT_SQUARE[answers], lambda: numpy.where(answers, 1, 0), lambda: numpy.array(answers), lambda: bool(answers),
                lambda: numpy.bincount(answers), lambda: numpy.logical_not(answers), lambda: "" if answers[0] else ""):
        with pytest.raises(TypeError):
            use()
    with pytest.raises(TypeError, match="write answers == Location.inside for a mask, answers.numbers for numbers"):
        AT_SQUARE[answers]
    with pytest.raises(TypeError, match="is no condition, compare it: answer == Location.inside"):
        print("inside" if answers[1] else "not inside")
    assert AT_SQUARE[answers == touchstone.Location.inside].tolist() == [[2, 2]]
    assert AT_SQUARE[touchstone.Location.inside != answers].tolist() == [[9, 9], [4, 1]]
    assert answers.isin(touchstone.Location.inside, touchstone.Location.boundary).tolist() == [False, True, True]
    assert answers[answers != touchstone.Location.outside].numbers.tolist() == [0, 1]
    for other in (touchstone.Contact.disjoint, 0, "inside", touchstone.orientation((0.0, 0), (1.0, 0), AT_SQUARE)):
        with pytest.raises(TypeError, match="answers of Location are compared with its enumerators"):
            answers == other


CUBE = numpy.array([[x, y, z] for x in (0.0, 2) for y in (0.0, 2) for z in (0.0, 2)])
SIDES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def test_faces_have_any_number_of_corners():
    points = numpy.array([[1.0, 1, 1], [2, 1, 1], [2, 2, 2], [3, 1, 1]])
    expected = ["inside", "boundary", "boundary", "outside"]
    mixed = [SIDES[0][:3], [0, 3, 2], *SIDES[1:]]
    for faces in (SIDES, numpy.array(SIDES), tuple(map(tuple, SIDES)), mixed):
        assert [answer.name for answer in touchstone.point_in_polyhedron((CUBE, faces), points)] == expected
        assert touchstone.polyhedron_contains({"vertices": CUBE, "faces": faces}, points).tolist() == [True, True, True, False]


@pytest.mark.parametrize("faces", [SIDES[1:], [*SIDES[:5], [1, 5, 7]], [*SIDES[:5], [1, 5, 7, 2]], [*SIDES[:5], [1, 5, 7, 9]],
                                   [*SIDES[:5], [1, 7, 5, 3]], [*SIDES[:5], [1, 5]]])
def test_faces_that_are_refused_are_named_as_they_are_given(faces):
    """As a single question is refused, which also says how far corners are from a plane."""
    with pytest.raises(touchstone.InvalidInput) as single:
        touchstone.answer("point_in_polyhedron", {"mesh": {"vertices": CUBE, "faces": faces}, "point": [1, 1, 1]})
    field, rule = refusal(touchstone.point_in_polyhedron, (CUBE, faces), numpy.ones(3))
    assert field == single.value.field and f"{single.value.rule}: ".startswith(f"{rule}: ")


@pytest.mark.parametrize("faces", [5, [1, 2, 3], [[0.5, 1, 2]], ["abc"], [[0, 1, -1]], numpy.zeros((4, 3)), numpy.zeros(6, dtype=int)])
def test_faces_that_are_none(faces):
    assert refusal(touchstone.point_in_polyhedron, (CUBE, faces), numpy.ones(3))[0] == "mesh.faces"


PREPARED = {"point_in_polygon": touchstone.Polygon, "point_in_convex_polygon": touchstone.ConvexPolygon,
            "point_in_polyhedron": touchstone.Solid, "point_in_convex_polyhedron": touchstone.ConvexSolid,
            "ray_mesh": touchstone.Surface}


@pytest.mark.parametrize("name", PREPARED)
def test_shapes_that_are_validated_once_answer_the_same(name):
    for questions in kinds_of(touchstone.draw(name, 300)):
        raw, out = operands_of(name, questions), numpy.empty(len(questions), dtype=numpy.uint8)
        place = 1 if name == "ray_mesh" else 0
        once = [PREPARED[name](operand) if i == place else operand for i, operand in enumerate(raw)]
        first = [operand if i == place else operand[:1] for i, operand in enumerate(once)]
        expected = getattr(touchstone, name)(*raw).numbers.tolist()
        assert getattr(touchstone, name)(*once, out=out).numbers is out and out.tolist() == expected
        assert getattr(touchstone, name)(*first).numbers.tolist() == expected[:1]
        asked_of = name.removeprefix("point_in_")
        mask = getattr(touchstone, f"{name}_intersects" if asked_of == name else f"{asked_of}_contains")
        assert mask(*once).tolist() == mask(*raw).tolist()


def test_shapes_that_are_validated_once_keep_what_they_were_made_of():
    square, points = SQUARE.copy(), numpy.array([[2.0, 2], [9, 9]])
    polygon = touchstone.ConvexPolygon(square)
    square[:] = 7
    assert [answer.name for answer in touchstone.point_in_convex_polygon(polygon, points)] == ["inside", "outside"]


def test_shapes_that_are_validated_once_are_refused():
    assert refusal(touchstone.Polygon, numpy.zeros((2, 2)))[0] == "polygon"
    assert refusal(touchstone.Polygon, numpy.zeros((3, 3)))[0] == "polygon"
    assert refusal(touchstone.Polygon, [(0, 0), (1, 0), (numpy.inf, 1)]) == ("polygon[2][0]", "finite number")
    dented = [(0, 0), (4, 0), (1, 1), (0, 4)]
    assert refusal(touchstone.ConvexPolygon, dented) == refusal(touchstone.point_in_convex_polygon, dented, numpy.zeros(2))
    for faces in (SIDES[1:], [*SIDES[:5], [1, 5, 7, 9]], [*SIDES[:5], [1, 7, 5, 3]]):
        assert refusal(touchstone.Solid, (CUBE, faces)) == refusal(touchstone.point_in_polyhedron, (CUBE, faces), numpy.ones(3))
    solid, polygon = touchstone.Solid((CUBE, SIDES)), touchstone.Polygon(SQUARE)
    assert refusal(touchstone.point_in_convex_polyhedron, solid, numpy.ones(3)) == (
        "mesh", "a Solid is for point_in_polyhedron; expected (vertices, faces), or its own shape")
    assert refusal(touchstone.point_in_polygon, solid, numpy.ones(2)) == (
        "polygon", "a Solid is for point_in_polyhedron; expected vertices of the shape (m, 2), or its own shape")
    assert refusal(touchstone.Polygon, polygon) == ("polygon", "expected vertices of the shape (m, 2), found a Polygon")
    assert refusal(touchstone.Solid, CUBE, SIDES) == ("mesh", "expected one tuple, (vertices, faces)")
    assert refusal(touchstone.point_in_polygon, AT_SQUARE, polygon) == ("points", "an array of float64, found a Polygon")
    assert refusal(touchstone.point_in_polyhedron, solid, numpy.array([[1.0, 1, 1], [1, numpy.nan, 1]])) == (
        "questions[1].point[1]", "finite number")
    assert refusal(touchstone.point_in_polygon, polygon, numpy.zeros((4, 3)))[0] == "points"
    with pytest.raises(AttributeError):
        polygon.made.vertices


def test_help_is_a_page():
    page = pydoc.plain(pydoc.render_doc(arrays))
    assert page.count("\n") < 80
    assert all(f"  {name}(" in page for name in DECISIONS + MASKS)
    assert all(f"  {made.__name__}: {', '.join(made.__members__)}\n" in page for made in ENUMERATIONS)


SEGMENTS = touchstone.draw("segment_segment", 300, seed=2)


def segment_pairs(questions):
    a = numpy.array([question.input["a"] for question in questions])
    b = numpy.array([question.input["b"] for question in questions])
    expected = numpy.array([touchstone.SegmentRelation[question.answer["relation"]] for question in questions], dtype=numpy.uint8)
    return a, b, touchstone.Answers(touchstone.SegmentRelation, expected)


@settings(max_examples=100, deadline=None, derandomize=True)
@given(strategies.lists(strategies.sampled_from(SEGMENTS), min_size=1, max_size=70), strategies.integers(1, 3),
       strategies.integers(0, 3), strategies.booleans(), strategies.booleans())
def test_where_the_numbers_stand_changes_nothing(questions, step, shift, backwards, by_columns):
    a, b, expected = segment_pairs(questions)
    count = len(questions)
    spread = numpy.full((shift + step * count, 2, 2), numpy.nan)  # what is not asked about would be refused
    spread[shift::step] = a
    a = spread[shift::step]
    if by_columns:
        b = numpy.asfortranarray(b)
    if backwards:
        a, b, expected = a[::-1], b[::-1], expected[::-1]
    a.flags.writeable = False
    assert (touchstone.segment_segment(a, b) == expected).all()
    assert (touchstone.segment_segment((a[:, 0], a[:, 1]), {"a": b[:, 0], "b": b[:, 1]}) == expected).all()
    out = numpy.full(count, 255, dtype=numpy.uint8)
    assert touchstone.segment_segment(a, b, out=out).numbers is out
    assert (out == expected.numbers).all()


def test_one_operand_is_shared_by_all():
    a, b, _ = segment_pairs(SEGMENTS)
    expected = touchstone.segment_segment(numpy.repeat(a[:1], len(b), axis=0), b)
    for shared in (a[0], a[:1], a[0].tolist(), (a[0, 0], a[0, 1]), numpy.broadcast_to(a[0], b.shape), a[0].ravel()):
        assert (touchstone.segment_segment(shared, b) == expected).all()
    assert list(touchstone.segment_segment(a[0], b[0])) == list(expected[:1])
    x, y = numpy.array([1.0, 0.0, -1.0]), 0.0
    assert list(touchstone.orientation((0, -1), (0.0, 1.0), (x, y))) == [touchstone.Side.right, touchstone.Side.on, touchstone.Side.left]


def test_members_that_are_not_alike():
    centers, radii = numpy.array([[0.0, 0, 0], [4, 0, 0], [5, 0, 0]]), numpy.array([1.0, 2, 2])
    expected = [touchstone.Contact.overlapping, touchstone.Contact.touching, touchstone.Contact.disjoint]
    unit = numpy.array([0.0, 0, 0, 2])
    assert list(touchstone.sphere_sphere((centers, radii), unit)) == expected
    assert list(touchstone.sphere_sphere(numpy.column_stack([centers, radii]), ((0, 0, 0), 2))) == expected
    assert list(touchstone.sphere_sphere((centers[:, :2], radii), unit[1:])) == expected


def test_no_rows():
    assert touchstone.orientation(numpy.zeros((0, 2)), numpy.zeros(2), numpy.zeros((0, 2))).numbers.shape == (0,)
    assert touchstone.orientation(numpy.zeros((0, 2)), numpy.zeros((1, 2)), numpy.zeros(2)).numbers.shape == (0,)


def refusal(decide, *operands, **out):
    with pytest.raises(touchstone.InvalidInput) as refused:
        decide(*operands, **out)
    assert isinstance(refused.value, ValueError)
    assert str(refused.value) == f"{refused.value.field}: {refused.value.rule}"
    return refused.value.field, refused.value.rule


def test_the_first_question_that_is_refused_is_named():
    p = numpy.zeros((40, 2))
    wrong = p.copy()
    wrong[17, 0] = numpy.inf
    wrong[23, 1] = numpy.nan
    assert refusal(touchstone.orientation, p, wrong, p) == ("questions[17].p1[0]", "finite number")
    assert refusal(touchstone.orientation, p, wrong[23], p) == ("questions[0].p1[1]", "finite number")


@pytest.mark.parametrize("operand, rule", [
    (numpy.zeros((4, 2), dtype=numpy.float32), "an array of float64, found float32"),
    (numpy.zeros((4, 2), dtype=int), "an array of float64, found int64"),
    (numpy.zeros((4, 2), dtype=">f8"), "an array of float64, found >f8"),
    (numpy.zeros((4, 3)), "expected an array of the shape (n, 2), or (x, y), found the shape (4, 3)"),
    (numpy.zeros((2, 4, 2)), "expected an array of the shape (n, 2), or (x, y), found the shape (2, 4, 2)"),
    (numpy.float64(1), "expected an array of the shape (n, 2), or (x, y), found the shape ()"),
    ((0.0, 1.0, 2.0), "expected an array of the shape (n, 2), or (x, y), found a tuple of 3"),
    ({"x": 0.0, "z": 1.0}, "expected an array of the shape (n, 2), or (x, y), found the names x, z"),
    (["a", "b"], "numbers: could not convert string to float: 'a'"),
    ("ab", "an array of float64, found <U2"),
    (None, "an array of float64, found object"),
])
def test_operands_that_are_refused(operand, rule):
    field, found = refusal(touchstone.orientation, numpy.zeros(2), operand, numpy.zeros((4, 2)))
    assert field == "p1" and found.startswith(rule)


def test_strides_and_rows_that_are_refused():
    packed = numpy.zeros(4, dtype=[("id", "i4"), ("point", "f8", 2)])
    assert refusal(touchstone.orientation, packed["point"], numpy.zeros(2), numpy.zeros(2)) == (
        "p0", "an array whose strides are multiples of 8 bytes, found (20, 8)")
    unaligned = numpy.zeros(8 * 9, dtype=numpy.uint8)[4:-4].view(numpy.float64).reshape(4, 2)
    assert refusal(touchstone.orientation, unaligned, numpy.zeros(2), numpy.zeros(2))[0] == "p0"
    assert refusal(touchstone.orientation, numpy.zeros((3, 2)), numpy.zeros((4, 2)), numpy.zeros(2)) == (
        "p0, p1, p", "as many rows in each array of these, or one, found 3, 4")
    masked = numpy.ma.masked_array(numpy.zeros((4, 2)), True)
    assert refusal(touchstone.orientation, numpy.zeros(2), numpy.zeros(2), masked) == (
        "p", "an array without a mask, whose hidden numbers would be asked")
    assert refusal(touchstone.ray_aabb, (numpy.zeros(2), numpy.zeros(2)), numpy.zeros((4, 2, 3)))[0] == "rays.origin"
    assert refusal(touchstone.point_in_polygon, numpy.zeros((3, 3)), numpy.zeros((4, 2)))[0] == "polygon"
    assert refusal(touchstone.point_in_polygon, numpy.zeros((2, 2)), numpy.zeros((4, 2)))[0] == "polygon"
    assert refusal(touchstone.point_in_polygon, [(0, 0), (1, 0), (0, -0.0)], numpy.zeros((4, 2)))[0] == "polygon"
    assert refusal(touchstone.point_in_polyhedron, (numpy.zeros((3, 3)), [[0, 1, -1]]), numpy.zeros(3))[0] == "mesh.faces"
    assert refusal(touchstone.point_in_polyhedron, numpy.zeros((3, 3)), numpy.zeros(3))[0] == "mesh"


@pytest.mark.parametrize("out", [
    numpy.zeros(3, dtype=numpy.uint8), numpy.zeros(4, dtype=numpy.int8), numpy.zeros(8, dtype=numpy.uint8)[::2], bytearray(4),
    numpy.frombuffer(bytes(4), dtype=numpy.uint8), numpy.zeros((4, 1), dtype=numpy.uint8)])
def test_places_for_answers_that_are_refused(out):
    p = numpy.zeros((4, 2))
    assert refusal(touchstone.orientation, p, p, p, out=out)[0] == "out"


def test_threads():
    """Several threads at once, refusals among them."""
    a, b, expected = segment_pairs(SEGMENTS)
    a, b = numpy.concatenate([a] * 40), numpy.concatenate([b] * 40)
    expected = touchstone.Answers(expected.enumeration, numpy.concatenate([expected.numbers] * 40))
    wrong = a.copy()
    wrong[-1, 0, 0] = numpy.nan
    complaints = []

    def ask(number):
        for _ in range(10):
            if not (touchstone.segment_segment(a, b) == expected).all():
                complaints.append("another answer")
            try:
                touchstone.segment_segment(wrong, b)
                complaints.append("nothing was refused")
            except touchstone.InvalidInput as refused:
                if refused.field != f"questions[{len(a) - 1}].a[0][0]":
                    complaints.append(refused.field)

    threads = [threading.Thread(target=ask, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert complaints == []


def test_others_run_while_it_decides():
    """The GIL is released: a thread counts while one call decides."""
    a, b, _ = segment_pairs(SEGMENTS)
    a, b = numpy.concatenate([a] * 3000), numpy.concatenate([b] * 3000)
    counted, ended = [0], threading.Event()

    def count():
        while not ended.is_set():
            counted[0] += 1

    counter = threading.Thread(target=count)
    counter.start()
    before = counted[0]
    touchstone._touchstone.decide("segment_segment", [a, 2, b, 2], numpy.empty(len(a), numpy.uint8))
    after = counted[0]
    ended.set()
    counter.join()
    assert after - before > 1000


def test_the_extension_refuses_what_only_a_wrong_caller_hands_over():
    decide, out = touchstone._touchstone.decide, numpy.zeros(4, numpy.uint8)
    right = [numpy.zeros((4, 2)), 1, numpy.zeros(2), 1, numpy.zeros(4), 0, numpy.zeros(()), 0]
    decide("orientation", right, out)
    for wrong in (right[:6], right + right[:2], right[:6] + [numpy.zeros(5), 0], right[:6] + [numpy.zeros(4, numpy.float32), 0],
                  right[:6] + [numpy.zeros((4, 1)), 0], right[:6] + [numpy.zeros((4, 2)), 1], right + [numpy.zeros((4, 2)), -1]):
        with pytest.raises(ValueError):
            decide("orientation", wrong, out)
    with pytest.raises(ValueError):
        decide("point_in_polygon", [numpy.zeros((6, 2))[::2], -1, numpy.zeros((4, 2)), 1], out)
    with pytest.raises(IndexError):
        decide("no_such_operation", right, out)
