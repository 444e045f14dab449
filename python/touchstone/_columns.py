# SPDX-License-Identifier: Apache-2.0
"""Operands over arrays as columns of float64, without copying them."""
from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, Optional, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _touchstone
from ._answers import Answers, Enumeration
from ._errors import InvalidInput

Operand = Union[ArrayLike, tuple[Any, ...], Mapping[str, Any], "Prepared"]
Out = Optional[NDArray[numpy.uint8]]
Located = tuple[NDArray[Any], int]
_float64 = numpy.dtype(numpy.float64)
_whole = -1  # instead of a number of axes: one array for all rows, a polygon or a part of a mesh


def use_threads(count: int) -> None:
    """Lets each later call of a decision over many rows use so many threads; 0 stands for as many as the machine runs at
    once. The answers are the same. At first it is 1. InvalidInput: `count` is no whole number, or less than 0."""
    if isinstance(count, bool) or not isinstance(count, (int, numpy.integer)) or count < 0:
        raise InvalidInput("count", f"a whole number, 0 or more, found {count!r}")
    _touchstone.use_threads(int(count))


class Prepared:
    """A shape that is validated once and asked many times. It never changes; it cannot be pickled."""

    made: Any  # of the extension
    taken_by: str  # the decision


class Shape:
    """The parts of an operand, by name: columns (None) and other shapes."""

    def __init__(self, **members: Optional[Shape]) -> None:
        self.members = members
        self.numbers: int = sum(1 if member is None else member.numbers for member in members.values())
        first, *others = [() if member is None else member.axes for member in members.values()]
        self.axes: Optional[tuple[int, ...]] = None
        """The axes of an array that holds one operand, where its members are alike."""
        if first is not None and all(other == first for other in others):
            self.axes = (len(members), *first)

    def expected(self) -> str:
        shapes = [(self.numbers,)] + ([self.axes] if self.axes and len(self.axes) > 1 else [])
        arrays = " or ".join(f"(n, {', '.join(map(str, shape))})" for shape in reversed(shapes))
        return f"an array of the shape {arrays}, or ({', '.join(self.members)})"

    def axes_of(self, shape: tuple[int, ...]) -> Optional[int]:
        """Returns how many axes of an array of that shape are not of rows; None if it is no array of such operands."""
        for axes in (self.axes, (self.numbers,)):
            if axes is not None and shape[-len(axes):] == axes and len(shape) <= len(axes) + 1:
                return len(axes)
        return None

    def arrays(self, value: Any, field: str) -> Iterator[Located]:
        """Arrays that hold its numbers in order, each with the number of its axes beside that of the rows."""
        if isinstance(value, tuple):
            if len(value) != len(self.members):
                raise InvalidInput(field, f"expected {self.expected()}, found a tuple of {len(value)}")
            value = dict(zip(self.members, value))
        if isinstance(value, Mapping):
            if value.keys() != self.members.keys():
                raise InvalidInput(field, f"expected {self.expected()}, found the names {', '.join(map(str, value))}")
            for name, member in self.members.items():
                if member is None:
                    yield _column(value[name], f"{field}.{name}"), 0
                else:
                    yield from member.arrays(value[name], f"{field}.{name}")
            return
        array = _array(value, field)
        axes_of_one = self.axes_of(array.shape)
        if axes_of_one is None:
            raise InvalidInput(field, f"expected {self.expected()}, found the shape {array.shape}")
        yield array, axes_of_one


def _array(value: Any, field: str) -> NDArray[numpy.float64]:
    """The same array; of a list, one that holds its numbers."""
    if isinstance(value, Prepared):
        raise InvalidInput(field, f"an array of float64, found a {type(value).__name__}")
    if isinstance(value, (list, float, int)):
        try:
            value = numpy.array(value, dtype=numpy.float64)
        except (TypeError, ValueError, OverflowError) as error:
            raise InvalidInput(field, f"numbers: {error}") from None
    if isinstance(value, numpy.ma.MaskedArray):
        raise InvalidInput(field, "an array without a mask, whose hidden numbers would be asked")
    array = value if isinstance(value, numpy.ndarray) else numpy.asarray(value)
    if array.dtype != _float64:
        raise InvalidInput(field, f"an array of float64, found {array.dtype}; astype(float) makes a copy that is one")
    if not array.flags.aligned or any(stride % 8 for stride in array.strides):
        raise InvalidInput(field, f"an array whose strides are multiples of 8 bytes, found {array.strides}")
    return array


def _column(value: Any, field: str) -> NDArray[numpy.float64]:
    array = _array(value, field)
    if array.ndim > 1:
        raise InvalidInput(field, f"expected a number or an array of the shape (n,), found the shape {array.shape}")
    return array


class _Polygon2:
    """One polygon: its vertices, or a shape that was validated once."""

    def expected(self) -> str:
        return "vertices of the shape (m, 2)"

    def arrays(self, value: Any, field: str) -> Iterator[Located]:
        if isinstance(value, Prepared):
            yield value.made, _whole
            return
        yield _vertices(value, field, 2), _whole


class _Mesh:
    """One mesh: vertices, and three or more places of vertices for each face."""

    def expected(self) -> str:
        return "(vertices, faces)"

    def arrays(self, value: Any, field: str) -> Iterator[Located]:
        if isinstance(value, Prepared):
            yield value.made, _whole
            return
        if isinstance(value, Mapping) and value.keys() == {"vertices", "faces"}:
            value = value["vertices"], value["faces"]
        if not isinstance(value, tuple) or len(value) != 2:
            raise InvalidInput(field, f"expected {self.expected()}")
        vertices = _vertices(value[0], f"{field}.vertices", 3)
        yield vertices, _whole
        corners, sizes = _corners(value[1], f"{field}.faces")
        if (sizes == 3).all():
            yield corners.reshape(-1, 3), _whole
        else:
            yield _touchstone.cut(vertices, corners, sizes), _whole

    def as_given(self, value: Any, field: str, refused: InvalidInput) -> InvalidInput:
        """A refusal that names a triangle of the cut names the face of which it is a part."""
        found = re.fullmatch(re.escape(field) + r"\.faces\[(\d+)\](.*)", refused.field)
        if found is None:
            return refused
        faces = value["faces"] if isinstance(value, Mapping) else value[1]
        sizes = _corners(faces, field)[1]
        face = numpy.searchsorted(numpy.cumsum(sizes - 2), int(found[1]), side="right")
        return InvalidInput(f"{field}.faces[{face}]{found[2]}", refused.rule)


def _corners(faces: Any, field: str) -> tuple[NDArray[numpy.uint32], NDArray[numpy.int64]]:
    """The corners of all faces, one face after the other, and how many each has. Lists may have different lengths."""
    if isinstance(faces, numpy.ndarray):
        sizes = numpy.full(len(faces) if faces.ndim == 2 else 0, faces.shape[-1] if faces.ndim == 2 else 0)
        corners = faces.ravel()
    else:
        try:
            sizes = numpy.array([len(face) for face in faces], dtype=numpy.int64)
            corners = numpy.array([corner for face in faces for corner in face])
        except (TypeError, ValueError):
            raise InvalidInput(field, "a list of three or more places of vertices for each face") from None
    if corners.size == 0 and len(sizes) == 0:
        return numpy.zeros(0, dtype=numpy.uint32), numpy.zeros(0, dtype=numpy.int64)
    if corners.dtype.kind not in "iu" or len(sizes) == 0:
        shape = f" of {faces.shape}" if isinstance(faces, numpy.ndarray) else ""
        raise InvalidInput(field, f"integers, three or more for each face, found {corners.dtype}{shape}")
    if corners.size > 0 and (corners.min() < 0 or corners.max() > 0xFFFFFFFF):
        raise InvalidInput(field, "places of vertices, counted from 0")
    return numpy.ascontiguousarray(corners, dtype=numpy.uint32), sizes


def _vertices(value: Any, field: str, dimensions: int) -> NDArray[numpy.float64]:
    vertices = _array(value, field)
    if vertices.size == 0:
        vertices = numpy.zeros((0, dimensions))
    if vertices.ndim != 2 or vertices.shape[1] != dimensions:
        raise InvalidInput(field, f"expected vertices of the shape (m, {dimensions}), found the shape {vertices.shape}")
    return numpy.ascontiguousarray(vertices)


POLYGON2 = _Polygon2()
MESH = _Mesh()
AnyShape = Union[Shape, _Polygon2, _Mesh]


class Form:
    """One decision over arrays: its name in the extension, and its operands."""

    def __init__(self, name: str, **operands: AnyShape) -> None:
        self.name, self.operands = name, operands

    def fits(self, values: tuple[Any, ...]) -> bool:
        """Returns whether each operand that is an array has a shape for it."""
        return all(not isinstance(shape, Shape) or not isinstance(value, numpy.ndarray) or shape.axes_of(value.shape) is not None
                   for shape, value in zip(self.operands.values(), values))

    def arrays(self, values: tuple[Any, ...]) -> list[Located]:
        for (field, shape), value in zip(self.operands.items(), values):
            if isinstance(value, Prepared) and self.name != value.taken_by:
                raise InvalidInput(field, f"a {type(value).__name__} is for {value.taken_by}; expected {shape.expected()}, or its own shape")
        return [located for (field, shape), value in zip(self.operands.items(), values)
                for located in shape.arrays(value, field)]

    def as_given(self, values: tuple[Any, ...], refused: InvalidInput) -> InvalidInput:
        for (field, shape), value in zip(self.operands.items(), values):
            if isinstance(shape, _Mesh):
                refused = shape.as_given(value, field, refused)
        return refused


def decide(forms: tuple[Form, ...], enumeration: type[Enumeration], out: Out, *values: Any) -> Answers:
    """The answers by the first of the forms, in the plane or in space, whose operands these are."""
    if len(forms) > 1:
        forms = tuple(form for form in forms if form.fits(values)) or forms
    complaints = []
    for form in forms:
        try:
            located = form.arrays(values)
            break
        except InvalidInput as refused:
            complaints.append(refused)
    else:
        first, last = complaints[0], complaints[-1]
        if first.field != last.field or first.rule == last.rule:
            raise last
        raise InvalidInput(last.field, f"in the plane {first.rule}; in space {last.rule}")
    count = _count(form, located)
    if out is None:
        out = numpy.empty(count, dtype=numpy.uint8)
    elif not isinstance(out, numpy.ndarray) or out.dtype != numpy.uint8 or out.shape != (count,):
        found = f"{out.dtype} of the shape {out.shape}" if isinstance(out, numpy.ndarray) else type(out).__name__
        raise InvalidInput("out", f"an array of uint8 of the shape ({count},), found {found}")
    elif not out.flags.c_contiguous or not out.flags.writeable:
        raise InvalidInput("out", "an array that is contiguous and can be written")
    try:
        _touchstone.decide(form.name, [part for pair in located for part in pair], out)
    except InvalidInput as refused:
        raise form.as_given(values, refused) from None
    return Answers(enumeration, out)


def _count(form: Form, located: list[Located]) -> int:
    """Returns the number of rows, which is 1 if all operands are shared."""
    rows = {array.shape[0] for array, axes in located if axes != _whole and array.ndim > axes}
    if len(rows) > 1:
        rows.discard(1)
    if len(rows) > 1:
        lengths = ", ".join(map(str, sorted(rows)))
        raise InvalidInput(", ".join(form.operands), f"as many rows in each array of these, or one, found {lengths}")
    return rows.pop() if rows else 1
