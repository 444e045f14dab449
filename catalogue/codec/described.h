// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/answers.h"
#include "geometry/polygons.h"
#include "geometry/space.h"

/// What the machine must know of a vocabulary type to convert, print, parse, compare, nudge and draw it: its members by
/// name, or the words of an enumeration. A new type needs its lines here and nothing elsewhere.
namespace touchstone::audit {

template <class Class, class Type>
struct Member {
  const char* name;
  Type Class::*pointer;
};

template <class Class, class Type>
constexpr Member<Class, Type> member(const char* name, Type Class::*pointer) {
  return {name, pointer};
}

/// A list is a JSON array in the order of its members; a record is a JSON object; what is bare is written as its only member.
enum class Form { list, record, bare };

template <class T>
struct Described;

template <class R>
struct Described<Point2<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members = std::tuple{member("x", &Point2<R>::x), member("y", &Point2<R>::y)};
};
template <class R>
struct Described<Vector2<R>> {
  static constexpr Form form = Form::list;
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
  static constexpr auto members =
      std::tuple{member("x", &Point3<R>::x), member("y", &Point3<R>::y), member("z", &Point3<R>::z)};
};
template <class R>
struct Described<Vector3<R>> {
  static constexpr Form form = Form::list;
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
struct Described<PointPlaneToi<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("option_1", &PointPlaneToi<R>::option_1), member("option_2", &PointPlaneToi<R>::option_2)};
};

/// The words of an enumeration, in the order of its enumerators, and the words that mean "no common point" /
/// "not in the closed shape": a plain false. An enumeration without `no` has no yes-or-no reading.
template <class E>
struct Words;

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

template <class T>
concept Enumeration = std::is_enum_v<T>;

template <class T>
concept Composite = requires {
  Described<T>::members;
};

template <class T>
inline constexpr bool is_bare = false;
template <Composite T>
inline constexpr bool is_bare<T> = Described<T>::form == Form::bare;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// Whether a value may be left out where it is read: it is optional, or all that it is made of.
template <class T>
inline constexpr bool may_be_left_out = is_optional<T>;
template <Composite T>
inline constexpr bool may_be_left_out<T> = std::apply(
    [](const auto&... member) {
      return (may_be_left_out<std::remove_cvref_t<decltype(std::declval<T>().*member.pointer)>> && ...);
    },
    Described<T>::members);

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

/// Neither a number that is rounded nor a word: true or false, a place in a list. The same over every number type.
template <class T>
concept Plain = std::same_as<T, bool> || std::same_as<T, Index>;

/// Whatever is neither described nor an enumeration nor a container nor plain is a number.
template <class T>
concept Number = !Enumeration<T> && !Composite<T> && !Plain<T> && !is_optional<T> && !is_vector<T>;

/// The same shape over another number type.
template <class T, class To>
struct Rebound {
  using type = To;
};
template <class T, class To>
requires(Enumeration<T> || Plain<T> || Composite<T>) struct Rebound<T, To> {
  using type = T;
};
template <template <class> class Shape, class From, class To>
requires Composite<Shape<From>>
struct Rebound<Shape<From>, To> {
  using type = Shape<To>;
};
template <class T, class To>
struct Rebound<std::optional<T>, To> {
  using type = std::optional<typename Rebound<T, To>::type>;
};
template <class T, class To>
struct Rebound<std::vector<T>, To> {
  using type = std::vector<typename Rebound<T, To>::type>;
};
template <class... Ts, class To>
struct Rebound<std::tuple<Ts...>, To> {
  using type = std::tuple<typename Rebound<Ts, To>::type...>;
};
template <class T, class To>
using rebound_t = typename Rebound<T, To>::type;

template <class T, class Visit>
void for_each_member(Visit&& visit) {
  std::apply([&](const auto&... member) { (visit(member), ...); }, Described<T>::members);
}

}  // namespace touchstone::audit
