// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/kdop_kdop.h"

#include "proptests/space_laws.h"
#include "robust/volumes/aabb_aabb.h"
#include "robust/volumes/kdop_kdop.h"
#include "robust/volumes/point_in_kdop.h"

namespace touchstone::proptests::kdop_kdop_tests {
namespace {

using Row = rows::kdop_kdop;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;
const std::vector<Vector3d> x_and_sum{{1, 0, 0}, {1, 1, 1}};

Row::Question of_slabs(const std::vector<Slabd>& a, const std::vector<Slabd>& b) {
  const std::vector<Vector3d> normals(x_and_sum.begin(), x_and_sum.begin() + static_cast<std::ptrdiff_t>(a.size()));
  return {{normals, a}, {normals, b}};
}

constexpr Worked<Row> worked;

bool any_flat(const Kdop3d& kdop) {
  return std::any_of(kdop.slabs.begin(), kdop.slabs.end(), [](const Slabd& s) { return s.min == s.max; });
}

}  // namespace

LAW("kdop_kdop: the contact is the least of those of the slabs alone, which are those of boxes", a, b) {
  Contact least = overlapping;
  for (std::size_t i = 0; i < a.slabs.size(); ++i) {
    const Slabd &s = a.slabs[i], &t = b.slabs[i];
    const Contact alone = ask(std::tuple(Kdop3d{{a.normals[i]}, {s}}, Kdop3d{{b.normals[i]}, {t}}));
    if (alone != robust::aabb_aabb(Aabb2d{{s.min, 0}, {s.max, 1}}, Aabb2d{{t.min, 0}, {t.max, 1}})) return false;
    least = std::min<Contact>(least, alone);
  }
  return ask(asked) == least;
}

LAW("kdop_kdop: the order of the slabs does not matter, nor what the normals are") {
  auto [a, b] = asked;
  for (Kdop3d* kdop : {&a, &b}) {
    std::reverse(kdop->normals.begin(), kdop->normals.end()), std::reverse(kdop->slabs.begin(), kdop->slabs.end());
    for (Vector3d& n : kdop->normals) n = {1, n.y, n.x};
  }
  return ask(std::tuple(a, b)) == ask(asked);
}

LAW("kdop_kdop: slabs may be written with opposite normals") {
  auto [a, b] = asked;
  for (Kdop3d* kdop : {&a, &b}) {
    for (Vector3d& n : kdop->normals) n = {-n.x, -n.y, -n.z};
    for (Slabd& s : kdop->slabs) s = {-s.max, -s.min};
  }
  return ask(std::tuple(a, b)) == ask(asked);
}

LAW("kdop_kdop: a k-DOP overlaps itself, unless a slab is flat: then it touches itself, and whatever it meets", a, b) {
  if (ask(std::tuple(a, a)) != (any_flat(a) ? touching : overlapping)) return false;
  return ask(asked) != overlapping || (!any_flat(a) && !any_flat(b));
}

LAW("kdop_kdop: slabs that grow never lose contact") {
  auto [a, b] = asked;
  for (Slabd& s : a.slabs) s = {catalogue::moved_by_ulps(s.min, -1), catalogue::moved_by_ulps(s.max, 1)};
  return ask(std::tuple(a, b)) >= ask(asked);
}

ROBUST_LAW("kdop_kdop: k-DOPs that are disjoint have no point in common; those that have one are not", a, b) {
  const double x = a.slabs[0].min;
  for (const Point3d& p : {Point3d{0, 0, 0}, Point3d{x, 0, 0}, Point3d{x, x, x}, Point3d{1, 1, 1}}) {
    const Location in_a = robust::point_in_kdop(a, p), in_b = robust::point_in_kdop(b, p);
    if (in_a != Location::outside && in_b != Location::outside && ask(asked) == disjoint) return false;
    if (in_a == Location::inside && in_b == Location::inside && ask(asked) != overlapping) return false;
  }
  return true;
}

TEST_CASE("kdop_kdop: p. 43's slabs worked by hand") {
  worked(of_slabs({{0, 4}, {0, 8}}, {{3, 9}, {-5, 1}}), overlapping, 1);  // 4 - 3 and 1 - 0
  worked(of_slabs({{0, 4}, {0, 8}}, {{4, 9}, {-5, 1}}), touching, 0);     // x: 4 - 4
  worked(of_slabs({{0, 4}, {0, 8}}, {{4, 9}, {-5, -1}}), disjoint, 1);    // sum: -1 - 0, although x touches
  worked(of_slabs({{0, 4}, {0, 8}}, {{7, 9}, {10, 12}}), disjoint, 3);    // x: 4 - 7, sum: 8 - 10
  worked(of_slabs({{0, 9}, {0, 9}}, {{3, 5}, {4, 8}}), overlapping, 2);   // within: the width of x
  worked(of_slabs({{0, 4}}, {{0, 4}}), overlapping, 4);
  worked(of_slabs({{4, 5}}, {{0, 4}}), touching, 0);
}

TEST_CASE("kdop_kdop: a flat slab only touches; the test with <= sees an overlap within the other") {
  worked(of_slabs({{0, 4}}, {{2, 2}}), touching, 0, "algorithm");
  worked(of_slabs({{0, 4}, {1, 1}}, {{1, 3}, {0, 2}}), touching, 0, "algorithm");
  worked(of_slabs({{2, 2}}, {{2, 2}}), touching, 0);
  worked(of_slabs({{0, 4}}, {{4, 4}}), touching, 0);
  worked(of_slabs({{0, 4}}, {{5, 5}}), disjoint, 1);
  worked(of_slabs({{2, 2}}, {{3, 3}}), disjoint, 1);
}

TEST_CASE("kdop_kdop: slabs may meet where the solids do not") {
  // x + (x + y) <= 2, so that b has no point at all.
  const std::vector<Vector3d> normals{{1, 0, 0}, {1, 1, 0}, {2, 1, 0}};
  worked({{normals, {{0, 1}, {0, 1}, {0, 9}}}, {normals, {{0, 1}, {0, 1}, {3, 9}}}}, overlapping, 1);
}

TEST_CASE("kdop_kdop: both have the same normals, and as many slabs as normals") {
  const Kdop3d a{x_and_sum, {{0, 4}, {0, 8}}};
  refused<Row>({a, {x_and_sum, {{0, 4}}}}, "b.slabs", "as many slabs as normals");
  refused<Row>({a, {{{1, 0, tiny}, {1, 1, 1}}, {{9, 9}, {0, 8}}}}, "b.normals[0]", "the same normal as in a");
}

CONTRACT("kdop_kdop: the formula in double keeps its contract", a, b) {
  const bool flat = any_flat(a) || any_flat(b);
  return answer == truth.answer || (flat && answer == overlapping && truth.answer == touching);
}

}  // namespace touchstone::proptests::kdop_kdop_tests
