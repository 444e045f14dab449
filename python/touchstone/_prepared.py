# SPDX-License-Identifier: Apache-2.0
"""Shapes that are validated once and asked many times."""
from __future__ import annotations

from typing import Any

from . import _touchstone
from ._columns import MESH, POLYGON2, AnyShape, Prepared
from ._errors import InvalidInput

__all__ = ["ConvexPolygon", "ConvexSolid", "Polygon", "Solid", "Surface"]


def _parts(shape: AnyShape, value: Any, field: str) -> list[Any]:
    if isinstance(value, Prepared):
        raise InvalidInput(field, f"expected {shape.expected()}, found a {type(value).__name__}")
    return [part for located in shape.arrays(value, field) for part in located]


class Polygon(Prepared):
    """A polygon for many calls of point_in_polygon: vertices of the shape (m, 2), any closed ring.

    It is copied, validated and gets a tree: afterwards a point costs only the edges near a ray from it. InvalidInput names
    the rule it breaks."""

    taken_by = "point_in_polygon"

    def __init__(self, vertices: Any) -> None:
        self.made = _touchstone.Polygon(_parts(POLYGON2, vertices, "polygon"))


class ConvexPolygon(Prepared):
    """A convex polygon for many calls of point_in_convex_polygon, like Polygon."""

    taken_by = "point_in_convex_polygon"

    def __init__(self, vertices: Any) -> None:
        self.made = _touchstone.ConvexPolygon(_parts(POLYGON2, vertices, "polygon"))


class _OfMesh(Prepared):
    type_of_made: Any

    def __init__(self, mesh: Any, *others: Any) -> None:
        if others:
            raise InvalidInput("mesh", f"expected one tuple, {MESH.expected()}")
        parts = _parts(MESH, mesh, "mesh")
        try:
            self.made = self.type_of_made(parts)
        except InvalidInput as refused:
            raise MESH.as_given(mesh, "mesh", refused) from None


class Solid(_OfMesh):
    """The solid within a closed mesh, (vertices, faces), for many calls of point_in_polyhedron.

    It is copied, validated and gets a tree: afterwards a point costs only the faces near a ray from it. InvalidInput names
    the rule it breaks."""

    taken_by, type_of_made = "point_in_polyhedron", _touchstone.Solid


class ConvexSolid(_OfMesh):
    """A convex solid for many calls of point_in_convex_polyhedron, like Solid."""

    taken_by, type_of_made = "point_in_convex_polyhedron", _touchstone.ConvexSolid


class Surface(_OfMesh):
    """A mesh, closed or not, for many calls of ray_mesh, like Solid."""

    taken_by, type_of_made = "ray_mesh", _touchstone.Surface
