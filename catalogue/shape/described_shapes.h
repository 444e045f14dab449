// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described.h"
#include "geometry/polyhedra.h"
#include "geometry/space.h"
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"

namespace touchstone::catalogue {

template <class R>
struct Described<Point2<R>> {
  static constexpr Form form = Form::list;
  static constexpr Meaning meaning = Meaning::place;
  static constexpr auto members = std::tuple{member("x", &Point2<R>::x), member("y", &Point2<R>::y)};
};
template <class R>
struct Described<Vector2<R>> {
  static constexpr Form form = Form::list;
  static constexpr Meaning meaning = Meaning::direction;
  static constexpr auto members = std::tuple{member("x", &Vector2<R>::x), member("y", &Vector2<R>::y)};
};
template <class R>
struct Described<Segment2<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members = std::tuple{member("a", &Segment2<R>::a), member("b", &Segment2<R>::b)};
};
template <class R>
struct Described<Line2<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members = std::tuple{member("p", &Line2<R>::p), member("q", &Line2<R>::q)};
};
template <class R>
struct Described<ParametricLine2<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("origin", &ParametricLine2<R>::origin), member("direction", &ParametricLine2<R>::direction)};
};
template <class R>
struct Described<Ray2<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("origin", &Ray2<R>::origin), member("direction", &Ray2<R>::direction)};
};
template <class R>
struct Described<Circle2<R>> {
  static constexpr Form form = Form::record;
  static constexpr Meaning meaning = Meaning::length;  // of the radius
  static constexpr auto members =
      std::tuple{member("center", &Circle2<R>::center), member("radius", &Circle2<R>::radius)};
};
template <class R>
struct Described<Polygon2<R>> {
  static constexpr Form form = Form::bare;
  static constexpr auto members = std::tuple{member("vertices", &Polygon2<R>::vertices)};
};
template <class R>
struct Described<Point3<R>> {
  static constexpr Form form = Form::list;
  static constexpr Meaning meaning = Meaning::place;
  static constexpr auto members =
      std::tuple{member("x", &Point3<R>::x), member("y", &Point3<R>::y), member("z", &Point3<R>::z)};
};
template <class R>
struct Described<Vector3<R>> {
  static constexpr Form form = Form::list;
  static constexpr Meaning meaning = Meaning::direction;
  static constexpr auto members =
      std::tuple{member("x", &Vector3<R>::x), member("y", &Vector3<R>::y), member("z", &Vector3<R>::z)};
};
template <class R>
struct Described<Plane<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("normal", &Plane<R>::normal), member("offset", &Plane<R>::offset)};
};
template <class R>
struct Described<Polygon3<R>> {
  static constexpr Form form = Form::bare;
  static constexpr auto members = std::tuple{member("vertices", &Polygon3<R>::vertices)};
};
template <class R>
struct Described<Aabb2<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("min", &Aabb2<R>::min), member("max", &Aabb2<R>::max)};
};
template <class R>
struct Described<Aabb3<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("min", &Aabb3<R>::min), member("max", &Aabb3<R>::max)};
};
template <class R>
struct Described<Sphere3<R>> {
  static constexpr Form form = Form::record;
  static constexpr Meaning meaning = Meaning::length;  // of the radius
  static constexpr auto members =
      std::tuple{member("center", &Sphere3<R>::center), member("radius", &Sphere3<R>::radius)};
};
template <class R>
struct Described<HalfAxes<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members =
      std::tuple{member("u", &HalfAxes<R>::u), member("v", &HalfAxes<R>::v), member("w", &HalfAxes<R>::w)};
};
template <class R>
struct Described<Obb3<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("center", &Obb3<R>::center), member("half_axes", &Obb3<R>::half_axes)};
};
template <class R>
struct Described<Slab<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members = std::tuple{member("min", &Slab<R>::min), member("max", &Slab<R>::max)};
};
template <class R>
struct Described<Kdop3<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("normals", &Kdop3<R>::normals), member("slabs", &Kdop3<R>::slabs)};
};
template <>
struct Described<Face> {
  static constexpr Form form = Form::list;
  static constexpr auto members = std::tuple{member("a", &Face::a), member("b", &Face::b), member("c", &Face::c)};
};
template <class R>
struct Described<Mesh<R>> {
  static constexpr Form form = Form::mesh;
  static constexpr auto members = std::tuple{member("vertices", &Mesh<R>::vertices), member("faces", &Mesh<R>::faces),
                                             member("polygons", &Mesh<R>::polygons)};
};
template <>
struct Described<IndexPair> {
  static constexpr Form form = Form::list;
  static constexpr auto members = std::tuple{member("i", &IndexPair::i), member("j", &IndexPair::j)};
};

}  // namespace touchstone::catalogue
