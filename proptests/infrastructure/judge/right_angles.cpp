// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "audit/counting/easy_questions.h"
#include "audit/engines/protocol.h"
#include "catalogue/families/obb_draws.h"
#include "catalogue/rows/volumes/obb_obb.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/foreign_formulas.h"

/// Engines that do not say they take skew boxes are asked boxes at right angles.
namespace touchstone::proptests::right_angles_tests {
namespace {

namespace rows = catalogue::rows;

double length(const Vector3d& v) { return std::sqrt(dot(v, v)); }
std::array<Vector3d, 3> axes_of(const Obb3d& box) { return {box.half_axes.u, box.half_axes.v, box.half_axes.w}; }
/// The greatest cosine between two half axes.
double skewness(const HalfAxes<double>& h) {
  const auto cosine = [](const Vector3d& a, const Vector3d& b) { return std::fabs(dot(a, b)) / length(a) / length(b); };
  return std::max({cosine(h.u, h.v), cosine(h.v, h.w), cosine(h.w, h.u)});
}

/// Separating axes of boxes at right angles (Gottschalk): the faces' normals are taken to be the half axes.
Contact by_unit_axes(const Obb3d& a, const Obb3d& b) {
  std::vector<Vector3d> candidates;
  for (const Obb3d* box : {&a, &b})
    for (const Vector3d& axis : axes_of(*box)) candidates.push_back(1 / length(axis) * axis);
  for (const Vector3d& v : axes_of(a))
    for (const Vector3d& w : axes_of(b)) candidates.push_back(cross(v, w));
  Contact contact = Contact::overlapping;
  for (const Vector3d& n : candidates) {
    double reach = 0;
    for (const Obb3d* box : {&a, &b})
      for (const Vector3d& axis : axes_of(*box)) reach += std::fabs(dot(n, axis));
    const double apart = std::fabs(dot(n, b.center - a.center));
    if (apart > reach) return Contact::disjoint;
    if (apart == reach && reach > 0) contact = Contact::touching;
  }
  return contact;
}

/// Answers on questions that are far from any other answer: how many are wrong, of how many.
std::pair<std::uint64_t, std::uint64_t> wrong_of_clear(bool skew_boxes) {
  std::uint64_t wrong = 0, clear = 0;
  audited<rows::obb_obb>(by_unit_axes, {.each = 100, .skew_boxes = skew_boxes},
                         [&](const Examination& question, const Judgement& judgement) {
                           if (*question.margin() < mpq_class(1, 4)) return;
                           ++clear, wrong += is_finding(judgement.verdict);
                         });
  return {wrong, clear};
}

}  // namespace

TEST_CASE("right angles: the half axes of a box are made square, and those that are stay what they are") {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    DrawStream draws = DrawStream::seeded(seed_of(1, "right angles", i));
    const HalfAxes<double> drawn = catalogue::lattice_half_axes(draws), turned = at_right_angles(drawn);
    const auto& [u, v, w] = drawn;
    INFO(i << ": " << u.x << ' ' << u.y << ' ' << u.z << ", " << v.x << ' ' << v.y << ' ' << v.z << ", " << w.x << ' '
           << w.y << ' ' << w.z);
    if (catalogue::volume_of(drawn) == 0) continue;
    REQUIRE(skewness(turned) <= 0x1p-45);
    REQUIRE(catalogue::volume_of(turned) != 0);
    REQUIRE(packed(turned.u) == packed(drawn.u));
    if (skewness(drawn) == 0) REQUIRE(packed(turned) == packed(drawn));
  }
  const HalfAxes<double> dependent{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}};
  CHECK(packed(at_right_angles(dependent)) == packed(dependent));
  const HalfAxes<double> long_ones{{1e300, 0, 0}, {1e300, 1e-300, 0}, {0, 1e300, 1e300}};
  CHECK(skewness(at_right_angles({{1, 0, 0}, {1, 1, 0}, {0, 1, 1}})) == 0);
  CHECK(std::isfinite(at_right_angles(long_ones).w.z));
}

TEST_CASE("right angles: who is right of boxes at right angles is not accused of skew ones unless it takes them") {
  const auto [wrong, clear] = wrong_of_clear(false);
  CHECK(clear > 300);
  CHECK(wrong == 0);
  CHECK(wrong_of_clear(true).first > 10);
}

TEST_CASE("right angles: engines say in their first line that they take skew boxes; easy questions follow it") {
  const auto declared = [](const char* field) {
    return read_hello(std::string(R"({"engine":"e","ops":[])") + field + "}").declaration.skew_boxes;
  };
  CHECK_FALSE(declared(""));
  CHECK_FALSE(declared(R"(,"skew_boxes":false)"));
  CHECK(declared(R"(,"skew_boxes":true)"));
  CHECK_THROWS_WITH(declared(R"(,"skew_boxes":1)"), ContainsSubstring("skew_boxes: expected true or false"));
  Hello hello;
  hello.declaration.skew_boxes = true;
  hello.declaration.pairs = Declaration::Pairs::exact;
  const Declaration again = read_hello(written_hello(hello)).declaration;
  CHECK(again.skew_boxes);
  CHECK(again.pairs == Declaration::Pairs::exact);
  for (const EasyQuestion& easy : easy_questions(*find_operation("obb_obb"))) {
    const auto [a, b] = unpacked<rows::obb_obb::Question>(easy.question);
    CHECK(std::max(skewness(a.half_axes), skewness(b.half_axes)) <= 0x1p-45);
  }
}

}  // namespace touchstone::proptests::right_angles_tests
