// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described.h"
#include "geometry/answers.h"

namespace touchstone::catalogue {

template <class R>
struct Described<PointOnSegment<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("relation", &PointOnSegment<R>::relation), member("t", &PointOnSegment<R>::t)};
};
template <class R>
struct Described<LineLine<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("relation", &LineLine<R>::relation), member("ta", &LineLine<R>::ta),
                                             member("tb", &LineLine<R>::tb), member("point", &LineLine<R>::point)};
};
template <class R>
struct Described<SegmentSegment<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("relation", &SegmentSegment<R>::relation), member("ta", &SegmentSegment<R>::ta),
                 member("tb", &SegmentSegment<R>::tb), member("point", &SegmentSegment<R>::point),
                 member("overlap", &SegmentSegment<R>::overlap)};
};
template <class R>
struct Described<RaySegment<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("relation", &RaySegment<R>::relation), member("t", &RaySegment<R>::t),
                 member("point", &RaySegment<R>::point), member("overlap", &RaySegment<R>::overlap)};
};

template <>
struct Described<PolygonConvexity> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("class", &PolygonConvexity::polygon_class), member("strict", &PolygonConvexity::strict),
                 member("orientation", &PolygonConvexity::orientation)};
};
template <class R>
struct Described<PointPlane<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("side", &PointPlane<R>::side), member("signed_distance", &PointPlane<R>::signed_distance)};
};
template <class R>
struct Described<PolygonNormal<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("class", &PolygonNormal<R>::normal_class), member("normal", &PolygonNormal<R>::normal),
                 member("unit", &PolygonNormal<R>::unit)};
};
template <>
struct Described<StepTest> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("relation", &StepTest::relation)};
};
template <class R>
struct Described<FirstHit<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("relation", &FirstHit<R>::relation), member("t", &FirstHit<R>::t),
                                             member("point", &FirstHit<R>::point)};
};
template <class R>
struct Described<FirstContact<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("relation", &FirstContact<R>::relation), member("t", &FirstContact<R>::t)};
};
template <>
struct Described<ConvexHull2> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("dimension", &ConvexHull2::dimension), member("point", &ConvexHull2::point),
                 member("segment", &ConvexHull2::segment), member("polygon", &ConvexHull2::polygon)};
};
template <>
struct Described<ConvexHull> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("dimension", &ConvexHull::dimension), member("point", &ConvexHull::point),
                 member("segment", &ConvexHull::segment), member("polygon", &ConvexHull::polygon),
                 member("faces", &ConvexHull::faces)};
};
template <class R>
struct Described<PointPlaneToi<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("option_1", &PointPlaneToi<R>::option_1), member("option_2", &PointPlaneToi<R>::option_2)};
};

template <>
struct Words<Side> {
  static constexpr std::array<const char*, 3> words{"left", "on", "right"};
};
template <>
struct Words<Height> {
  static constexpr std::array<const char*, 3> words{"above", "on", "below"};
};
template <>
struct Words<Location> {
  static constexpr std::array<const char*, 3> words{"inside", "boundary", "outside"};
  static constexpr Location no = Location::outside;
};
template <>
struct Words<Incidence> {
  static constexpr std::array<const char*, 2> words{"on", "off"};
  static constexpr Incidence no = Incidence::off;
};
template <>
struct Words<LineRelation> {
  static constexpr std::array<const char*, 3> words{"crossing", "parallel", "same"};
  static constexpr LineRelation no = LineRelation::parallel;
};
template <>
struct Words<SegmentRelation> {
  static constexpr std::array<const char*, 3> words{"disjoint", "point", "overlap"};
  static constexpr SegmentRelation no = SegmentRelation::disjoint;
};
template <>
struct Words<RayRelation> {
  static constexpr std::array<const char*, 3> words{"none", "point", "overlap"};
  static constexpr RayRelation no = RayRelation::none;
};

template <>
struct Words<PolygonClass> {
  static constexpr std::array<const char*, 4> words{"convex", "concave", "not_simple", "degenerate"};
};
template <>
struct Words<Winding> {
  static constexpr std::array<const char*, 3> words{"ccw", "cw", "none"};
};
template <>
struct Words<Contact> {
  static constexpr std::array<const char*, 3> words{"disjoint", "touching", "overlapping"};
  static constexpr Contact no = Contact::disjoint;
};
template <>
struct Words<PlaneSide> {
  static constexpr std::array<const char*, 3> words{"front", "on", "back"};
};
template <>
struct Words<NormalClass> {
  static constexpr std::array<const char*, 2> words{"proper", "degenerate"};
};
template <>
struct Words<HitRelation> {
  static constexpr std::array<const char*, 2> words{"hit", "never"};
  static constexpr HitRelation no = HitRelation::never;
};

template <>
struct Words<SphereMethod> {
  static constexpr std::array<const char*, 4> words{"box", "centroid", "ritter", "smallest"};
};
template <>
struct Words<Axis> {
  static constexpr std::array<const char*, 3> words{"x", "y", "z"};
};

}  // namespace touchstone::catalogue
