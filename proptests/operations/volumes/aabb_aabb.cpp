// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/aabb_aabb.h"

#include "proptests/forward_error.h"
#include "proptests/space_laws.h"

namespace touchstone::proptests::aabb_aabb_tests {
namespace {

using Row = rows::aabb_aabb;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;
constexpr Aabb2d square{{0, 0}, {4, 4}};
constexpr Aabb3d cube{{0, 0, 0}, {4, 4, 4}};

template <class Box>
bool flat(const Box& box) {
  bool any = box.min.x == box.max.x || box.min.y == box.max.y;
  if constexpr (requires { box.min.z; }) any = any || box.min.z == box.max.z;
  return any;
}

std::size_t sides_of(const Aabb2d&) { return 4; }
std::size_t sides_of(const Aabb3d&) { return 6; }

/// One side of the box moved outwards by an ulp.
template <class Box>
Box grown(Box box, std::size_t side) {
  const std::size_t half = sides_of(box) / 2;
  std::size_t i = 0;
  catalogue::for_each_number(box, [&](double& number) {
    if (i == side) number = catalogue::moved_by_ulps(number, i < half ? -1 : 1);
    ++i;
  });
  return box;
}

/// The least box that holds both.
Aabb2d hull(const Aabb2d& a, const Aabb2d& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}
Aabb3d hull(const Aabb3d& a, const Aabb3d& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

Aabb3d extruded(const Aabb2d& box, double height) {
  return {{box.min.x, box.min.y, 0}, {box.max.x, box.max.y, height}};
}

/// What the intervals of one axis say: boxes of the plane that agree along the other.
auto on_axis(const auto& ask, double a_min, double a_max, double b_min, double b_max) {
  return ask(InPlane{{{a_min, 0}, {a_max, 1}}, {{b_min, 0}, {b_max, 1}}});
}

constexpr Worked<Row> worked;

}  // namespace

LAW("aabb_aabb: a box overlaps itself, unless it is flat: then it touches itself", a) {
  return ask(std::tuple(a, a)) == (flat(a) ? touching : overlapping);
}

LAW("aabb_aabb: a flat box overlaps nothing", a, b) {
  return ask(std::tuple(a, b)) != overlapping || (!flat(a) && !flat(b));
}

LAW("aabb_aabb: lattice vectors keep the answer") {
  if (!on_lattice(asked)) return true;
  auto moved = asked;
  catalogue::for_each_number(moved, [](double& number) { number += 0x1p44 + 3; });
  return ask(moved) == ask(asked);
}

LAW("aabb_aabb: a box that grows never loses contact", a, b) {
  const Contact contact = ask(std::tuple(a, b));
  for (std::size_t side = 0; side < sides_of(a); ++side)
    if (ask(std::tuple(grown(a, side), b)) < contact) return false;
  return ask(std::tuple(hull(a, b), b)) >= std::max<Contact>(contact, touching);
}

LAW("aabb_aabb: boxes that touch side by side are disjoint once one of them has moved off by an ulp", a, b) {
  auto beside = b;
  beside.min.x = a.max.x, beside.max.x = std::max(a.max.x, b.max.x);
  auto off = beside;
  off.min.x = catalogue::moved_by_ulps(off.min.x, 1), off.max.x = catalogue::moved_by_ulps(off.max.x, 1);
  return ask(std::tuple(a, beside)) != overlapping && (off.min.x == a.max.x || ask(std::tuple(a, off)) == disjoint);
}

LAW("aabb_aabb: p. 45-47's intervals: the contact of boxes is the least of those on their axes", a, b) {
  Contact least = std::min<Contact>(on_axis(ask, a.min.x, a.max.x, b.min.x, b.max.x),
                                    on_axis(ask, a.min.y, a.max.y, b.min.y, b.max.y));
  if constexpr (requires { a.min.z; })
    least = std::min<Contact>(least, on_axis(ask, a.min.z, a.max.z, b.min.z, b.max.z));
  return ask(std::tuple(a, b)) == least;
}

LAW("aabb_aabb: boxes of the plane made one high have the answer of the plane; made flat they touch at most", a, b) {
  if constexpr (requires { a.min.z; }) return true;
  else {
    const Contact contact = ask(std::tuple(a, b));
    return ask(InSpace{extruded(a, 1), extruded(b, 1)}) == contact &&
           ask(InSpace{extruded(a, 0), extruded(b, 0)}) == std::min<Contact>(contact, touching);
  }
}

TEST_CASE("aabb_aabb: p. 45-47's boxes in the plane, apart, side by side and one over the other, worked by hand") {
  worked(InPlane{square, {{6, 1}, {9, 3}}}, disjoint, 2);     // x: 6 - 4
  worked(InPlane{square, {{4, 1}, {9, 3}}}, touching, 0);     // x: 4 - 4
  worked(InPlane{square, {{3, 1}, {9, 3}}}, overlapping, 1);  // x: 4 - 3; y: 3 - 1
  worked(InPlane{square, {{4, 4}, {5, 5}}}, touching, 0);     // a corner
  worked(InPlane{square, {{1, 2}, {2, 4}}}, overlapping, 1);  // within, x: 2 - 1; y: 4 - 2
  worked(InPlane{square, {{5, 7}, {6, 9}}}, disjoint, 3);     // both axes separate: the greater gap is y's, 7 - 4
  worked(InPlane{square, {{4, -3}, {6, -1}}}, disjoint, 1);   // x touches, y: 0 - -1
}

TEST_CASE("aabb_aabb: p. 45-47's boxes in space worked by hand") {
  worked(InSpace{cube, {{4, 4, 4}, {9, 9, 9}}}, touching, 0);
  worked(InSpace{cube, {{1, 1, -3}, {2, 2, -1}}}, disjoint, 1);   // z: 0 - -1
  worked(InSpace{cube, {{3, 2, 1}, {9, 9, 9}}}, overlapping, 1);  // x: 4 - 3
  worked(InSpace{cube, {{-2, 4, 1}, {9, 5, 3}}}, touching, 0);    // y: 4 - 4
  worked(InSpace{{{2, 2, 2}, {2, 2, 2}}, {{2, 2, 2}, {2, 2, 2}}}, touching, 0);
  worked(InSpace{{{2, 2, 2}, {2, 2, 2}}, {{2, 2, 5}, {2, 2, 5}}}, disjoint, 3);
}

TEST_CASE("aabb_aabb: a flat box inside of another only touches it; the test for overlap sees an overlap") {
  worked(InPlane{square, {{1, 2}, {3, 2}}}, touching, 0, "algorithm");  // y: 0 < 2 < 4
  worked(InPlane{square, {{2, 2}, {2, 2}}}, touching, 0, "algorithm");
  worked(InSpace{cube, {{1, 1, 2}, {3, 3, 2}}}, touching, 0, "algorithm");
  worked(InPlane{square, {{1, 4}, {3, 4}}}, touching, 0);                         // on the upper side: 4 <= 4
  worked(InPlane{square, {{4, 2}, {6, 2}}}, touching, 0);                         // from the right side outwards
  worked(InPlane{square, {{1, 5}, {3, 5}}}, disjoint, 1);                         // above
  worked(InPlane{{{0, 2}, {4, 2}}, {{1, 2}, {5, 2}}}, touching, 0);               // both flat, on one line: 2 <= 2
  worked(InPlane{{{0, 2}, {4, 2}}, {{1, 0}, {1, 4}}}, touching, 0, "algorithm");  // a cross
}

TEST_CASE("aabb_aabb: as typed they touch, as doubles they need not") {
  // 1/10 + 2/10 is 3/10 as typed; 0.1 + 0.2 is the next double above 0.3, 2^-54 more.
  worked(InPlane{{{0, 0}, {0.1 + 0.2, 1}}, {{0.3, 0}, {2, 1}}}, overlapping, power_of_two(-54));
}

CONTRACT("aabb_aabb: the formula in double keeps its contract", a, b) {
  const bool interiors = !flat(a) && !flat(b);
  if (interiors || *truth.margin > 0) return answer == truth.answer;
  return answer == truth.answer || (answer == overlapping && truth.answer == touching);
}

TEST_CASE("aabb_aabb: the formula has no rounding: in double it answers as in exact arithmetic") {
  const auto& operation = catalogue::operation_of_row<Row>();
  never(
      operation, "no rounding",
      [&](const Question& question) -> std::string {
        try {
          operation.row().solve(question);
        } catch (const InvalidInput&) {
          return "";
        }
        const auto in_double = operation.row().reference(question);
        const auto exactly = operation.row().reference_exactly(question);
        return in_double.words == exactly.words ? "" : "rounding changed the answer";
      },
      3);
}

}  // namespace touchstone::proptests::aabb_aabb_tests
