// SPDX-License-Identifier: Apache-2.0
#include "report/words/hints.h"

#include <algorithm>
#include <cmath>

#include "catalogue/rows/broad_phase/broad_phase.h"
#include "catalogue/rows/lines/orientation.h"
#include "catalogue/rows/lines/parametric_circle.h"
#include "catalogue/rows/mixed/ray_aabb.h"
#include "catalogue/rows/mixed/sphere_plane.h"
#include "catalogue/rows/planes/point_ground_plane.h"
#include "catalogue/rows/polygons/interior_angles.h"
#include "catalogue/rows/response/momentum.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/foreign_formulas.h"
#include "reference/lines/orientation.h"
#include "reference/mixed/ray_aabb.h"
#include "reference/mixed/sphere_plane.h"

/// Each hint is given for the bug that it names, and not for another bug or for none.
namespace touchstone::proptests::hints_tests {
namespace {

namespace rows = catalogue::rows;
using report::hints;

template <class Row, class Formula>
std::string said(const Formula& formula) {
  const Tally tally = audited<Row>(formula);
  std::string text;
  for (const std::string& hint : hints(tally.operations[0], tally.declaration)) text += hint + "\n";
  return text;
}
template <class Row, class Right>
void says_nothing_of(const Right& right) {
  CHECK(said<Row>(right) == "");
}

/// A hint in these words is given for the bug, not for another one, and none at all where all is right.
template <class Row, class Right, class Bug, class Other>
void names_bug(const char* words, const Right& right, const Bug& bug, const Other& other) {
  says_nothing_of<Row>(right);
  CHECK_THAT(said<Row>(bug), ContainsSubstring(words));
  CHECK_THAT(said<Row>(other), !ContainsSubstring(words));
}

using Bodies = std::vector<Bodyd>;
using Boxes = std::vector<Aabb3d>;
using Commands = std::vector<Commandd>;

Vector3d of(const Vector3d& v, double (*change)(double)) { return {change(v.x), change(v.y), change(v.z)}; }
Point2d y_down(const Point2d& p) { return {p.x, -p.y}; }

}  // namespace

TEST_CASE("hints: touches answered as open sets do") {
  const auto right = [](const Sphere3d& s, const Plane3d& p) { return robust::sphere_plane(s, p); };
  const auto open = [&](const Sphere3d& s, const Plane3d& p) {
    const Contact contact = right(s, p);
    return contact == Contact::touching ? Contact::disjoint : contact;
  };
  const auto always = [](const Sphere3d&, const Plane3d&) { return Contact::disjoint; };
  names_bug<rows::sphere_plane>("`<` where `<=` belongs", right, open, always);
}

TEST_CASE("hints: numbers in single precision") {
  const auto right = [](const Bodies& bodies) { return robust::momentum(bodies); };
  const auto single = [](const Bodies& bodies) {
    return of(robust::momentum(bodies), [](double x) { return static_cast<double>(static_cast<float>(x)); });
  };
  const auto half_more = [](const Bodies& bodies) {
    return of(robust::momentum(bodies), [](double x) { return 1.5 * x; });
  };
  names_bug<rows::momentum>("single precision", right, single, half_more);
}

TEST_CASE("hints: arguments exchanged, and a mirrored frame") {
  const auto right = [](const Point2d& a, const Point2d& b, const Point2d& p) { return robust::orientation(a, b, p); };
  const auto exchanged = [&](const Point2d& a, const Point2d& b, const Point2d& p) { return right(b, a, p); };
  const auto mirrored = [&](const Point2d& a, const Point2d& b, const Point2d& p) {
    return right(y_down(a), y_down(b), y_down(p));
  };
  const auto never_on = [&](const Point2d& a, const Point2d& b, const Point2d& p) {
    const Side side = right(a, b, p);
    return side == Side::on ? Side::left : side;
  };
  const auto of_arguments = ContainsSubstring("if `p0` and `p1`"), of_frame = ContainsSubstring("is y down");
  says_nothing_of<rows::orientation>(right);
  CHECK_THAT(said<rows::orientation>(exchanged), of_arguments);
  CHECK_THAT(said<rows::orientation>(mirrored), of_frame);
  CHECK_THAT(said<rows::orientation>(never_on), !of_arguments && !of_frame);
}

TEST_CASE("hints: another axis is up") {
  const auto right = [](const Point3d& p) { return robust::point_ground_plane(p); };
  const auto z_up = [&](const Point3d& p) { return right({p.x, p.z, p.y}); };
  const auto x_up = [&](const Point3d& p) { return right({p.y, p.x, p.z}); };
  names_bug<rows::point_ground_plane>("is z up", right, z_up, x_up);
}

TEST_CASE("hints: an angle in degrees") {
  const auto right = [](const Circle2d& c, double u) { return robust::parametric_circle(c, u); };
  const auto degrees = [&](const Circle2d& c, double u) { return right(c, u * (3.14159265358979323846 / 180)); };
  const auto backwards = [&](const Circle2d& c, double u) { return right(c, -u); };
  names_bug<rows::parametric_circle>("in degrees", right, degrees, backwards);
}

TEST_CASE("hints: angles answered in degrees") {
  const auto right = [](const Polygon2d& polygon) { return robust::interior_angles(polygon); };
  const auto times = [&](double factor) {
    return [&right, factor](const Polygon2d& polygon) {
      std::vector<double> angles = right(polygon);
      for (double& angle : angles) angle *= factor;
      return angles;
    };
  };
  names_bug<rows::interior_angles>("are they in degrees?", right, times(180 / 3.14159265358979323846),
                                   times(200 / 3.14159265358979323846));
}

TEST_CASE("hints: wrong where a component of the direction is 0") {
  const auto right = [](const auto& ray, const auto& box) { return robust::ray_aabb(ray, box); };
  // Along an axis that the direction does not change, the ray is taken to be between the sides.
  const auto ignores_axis = [&](const auto& ray, auto box) {
    const auto widen = [&](double from, double displacement, double& min, double& max) {
      if (displacement == 0) min = std::min(min, from), max = std::max(max, from);
    };
    widen(ray.origin.x, ray.direction.x, box.min.x, box.max.x);
    widen(ray.origin.y, ray.direction.y, box.min.y, box.max.y);
    return right(ray, box);
  };
  const auto misses_corners = [&](const auto& ray, const auto& box) {
    const auto passage = right(ray, box);
    const bool grazes = passage.first && *passage.first == *passage.last;
    return grazes ? Passage<double>{PassageRelation::none, {}, {}} : passage;
  };
  names_bug<rows::ray_aabb>("a component is 0", right, ignores_axis, misses_corners);
}

TEST_CASE("hints: wrong after a move alone") {
  const auto right = [](const Boxes& boxes, const Commands& commands) { return robust::broad_phase(boxes, commands); };
  const auto unmoved = [&](const Boxes& boxes, Commands commands) {
    commands.erase(std::remove_if(commands.begin(), commands.end(),
                                  [](const Commandd& c) { return std::holds_alternative<Move<double>>(c); }),
                   commands.end());
    return right(boxes, commands);
  };
  const auto without_pairs = [&](const Boxes& boxes, const Commands& commands) {
    auto replies = right(boxes, commands);
    for (auto& reply : replies)
      if (auto* pairs = std::get_if<PairsReply>(&reply)) pairs->pairs.clear();
    return replies;
  };
  names_bug<rows::broad_phase>("without a `move`", right, unmoved, without_pairs);
}

TEST_CASE("hints: wrong in long lists alone") {
  const auto first_eight = [](Bodies bodies) {
    bodies.resize(std::min<std::size_t>(bodies.size(), 8));
    return robust::momentum(bodies);
  };
  const auto first_two = [](Bodies bodies) {
    bodies.resize(std::min<std::size_t>(bodies.size(), 2));
    return robust::momentum(bodies);
  };
  const auto is_said = ContainsSubstring("has something room for fewer");
  CHECK_THAT(said<rows::momentum>(first_eight), is_said);
  CHECK_THAT(said<rows::momentum>(first_two), !is_said);
}

TEST_CASE("hints: formulas in double have wrong answers by rounding, too, and these hide no bug") {
  const auto sides = [](const Point2d& a, const Point2d& b, const Point2d& p) {
    return reference::orientation(a, b, p);
  };
  const auto mirrored = [&](const Point2d& a, const Point2d& b, const Point2d& p) {
    return sides(y_down(a), y_down(b), y_down(p));
  };
  says_nothing_of<rows::orientation>(sides);
  CHECK_THAT(said<rows::orientation>(mirrored), ContainsSubstring("is y down"));

  const auto reaches = [](const Sphere3d& s, const Plane3d& p) { return reference::sphere_plane(s, p); };
  const auto open = [&](const Sphere3d& s, const Plane3d& p) { return reaches(s, p) == Contact::overlapping; };
  says_nothing_of<rows::sphere_plane>(reaches);
  CHECK_THAT(said<rows::sphere_plane>(open), ContainsSubstring("`<` where `<=` belongs"));

  const auto slabs = [](const auto& ray, const auto& box) { return reference::ray_aabb(ray, box); };
  const auto divides = [&](const auto& ray, const auto& box) {  // on a side, and along it: 0/0
    const auto undefined = [](double from, double displacement, double min, double max) {
      return displacement == 0 && (from == min || from == max);
    };
    const bool none = undefined(ray.origin.x, ray.direction.x, box.min.x, box.max.x) ||
                      undefined(ray.origin.y, ray.direction.y, box.min.y, box.max.y);
    return none ? Passage<double>{PassageRelation::none, {}, {}} : slabs(ray, box);
  };
  says_nothing_of<rows::ray_aabb>(slabs);
  CHECK_THAT(said<rows::ray_aabb>(divides), ContainsSubstring("a component is 0") && !ContainsSubstring("`<=`"));
}

TEST_CASE("hints: none for the textbook formulas, whose findings are explained otherwise") {
  Tally tally = audited<rows::orientation>(
      [](const Point2d& a, const Point2d& b, const Point2d& p) { return robust::orientation(b, a, p); });
  CHECK_FALSE(hints(tally.operations[0], tally.declaration).empty());
  tally.declaration.engine = "reference";
  CHECK(hints(tally.operations[0], tally.declaration).empty());
}

}  // namespace touchstone::proptests::hints_tests
