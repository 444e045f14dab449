# SPDX-License-Identifier: Apache-2.0
"""Shapes that are validated once and asked many times."""
from __future__ import annotations

from typing import Any

from . import _touchstone
from ._columns import MESH, POLYGON2, Prepared
from ._errors import InvalidInput

__all__ = ["ConvexPolygon", "ConvexSolid", "Polygon", "Solid"]


class Polygon(Prepared):
    """A polygon for many calls of point_in_polygon: vertices of the shape (m, 2), any closed ring.

    It is copied, validated and gets a tree: a point costs about log m afterwards. InvalidInput names the rule it breaks."""

    taken_by: tuple[str, ...] = ("point_in_polygon",)
    _type: Any = _touchstone.Polygon

    def __init__(self, vertices: Any) -> None:
        (array, _), = POLYGON2.arrays(vertices, "polygon")
        self.made = self._type(array)


class ConvexPolygon(Polygon):
    """A polygon that is convex, for point_in_convex_polygon too."""

    taken_by = ("point_in_polygon", "point_in_convex_polygon")
    _type = _touchstone.ConvexPolygon


class Solid(Prepared):
    """The solid within a closed mesh, (vertices, faces), for many calls of point_in_polyhedron.

    It is copied, validated and gets a tree: a point costs about log n of n faces afterwards. InvalidInput names the rule
    it breaks."""

    taken_by: tuple[str, ...] = ("point_in_polyhedron",)
    _type: Any = _touchstone.Solid

    def __init__(self, mesh: Any) -> None:
        (vertices, _), (faces, _) = MESH.arrays(mesh, "mesh")
        try:
            self.made = self._type(vertices, faces)
        except InvalidInput as refused:
            raise MESH.as_given(mesh, "mesh", refused) from None


class ConvexSolid(Solid):
    """A solid that is convex, for point_in_convex_polyhedron too."""

    taken_by = ("point_in_polyhedron", "point_in_convex_polyhedron")
    _type = _touchstone.ConvexSolid
