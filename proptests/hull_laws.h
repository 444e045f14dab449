// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "catalogue/operation/probes/explained.h"
#include "oracle/certificates/check.h"
#include "proptests/forward_error.h"

/// What the tests of convex hulls share.
namespace touchstone::proptests {

/// The points that an answer names, as points: of equal ones it may name any.
template <class Points, class Hull>
auto corners_of(const Points& points, const Hull& hull) {
  using Point = typename Points::value_type;
  const auto before = [](const Point& p, const Point& q) {
    if (p.x != q.x) return p.x < q.x;
    if constexpr (requires { p.z; }) {
      if (p.y == q.y) return p.z < q.z;
    }
    return p.y < q.y;
  };
  std::set<Point, decltype(before)> corners(before);
  const auto add = [&](Index i) { corners.insert(points[i]); };
  if (hull.point) add(*hull.point);
  if (hull.segment) add(hull.segment->i), add(hull.segment->j);
  for (const Index i : hull.polygon.value_or(std::vector<Index>())) add(i);
  if constexpr (requires { hull.faces; }) {
    for (const Face& f : hull.faces.value_or(std::vector<Face>())) add(f.a), add(f.b), add(f.c);
  }
  return corners;
}

template <class Points>
Points scaled_points(Points points, double factor) {
  for (auto& p : points) {
    p.x *= factor, p.y *= factor;
    if constexpr (requires { p.z; }) p.z *= factor;
  }
  return points;
}

template <class Set>
bool same_points(const Set& a, const Set& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

/// Laws of every hull: the order of the list and points said again change nothing; the corners alone have the same
/// hull; every corner is needed; what is in between is none.
template <class Row>
void hulls_are_hulls() {
  const auto corners = [](const auto& ask, const auto& points) {
    return corners_of(points, ask(typename Row::Question{points}));
  };
  law<Row>("the list turned round, and every point said again", [&](const auto& ask, const auto& asked) {
    auto points = std::get<0>(asked);
    const auto before = corners(ask, points);
    std::reverse(points.begin(), points.end());
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2), points.end());
    const bool turned = same_points(before, corners(ask, points));
    const auto again = points;
    points.insert(points.end(), again.begin(), again.end());
    return turned && same_points(before, corners(ask, points));
  });
  law<Row>("the corners alone have the same hull, and without one of them it is another",
           [&](const auto& ask, const auto& asked) {
             const auto found = corners(ask, std::get<0>(asked));
             auto points = std::get<0>(asked);
             points.assign(found.begin(), found.end());
             if (!same_points(found, corners(ask, points))) return false;
             if (points.size() < 2) return true;
             points.erase(points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2));
             return corners(ask, points).size() == found.size() - 1;
           });
}

/// A worked example: robust, the oracle and, unless told otherwise, the formula in double name these points, and the
/// checker accepts what they say.
template <class Row, class Points>
void hull_is(const Points& points, Index dimension, std::set<Index> places, bool by_reference = true) {
  const typename Row::Question question{points};
  INFO(catalogue::one_line(catalogue::operation_of_row<Row>().print(catalogue::packed(question))));
  const auto right = [&](const auto& hull) {
    std::set<Index> named;
    for (const auto& corner : corners_of(points, hull)) {
      const auto same = [&](Index i) { return points[i] == corner; };
      const auto place = std::find_if(places.begin(), places.end(), same);
      if (place == places.end()) return false;
      named.insert(*place);
    }
    return hull.dimension == dimension && named == places && Row::defect(question, hull).empty();
  };
  CHECK(right(catalogue::ask_robust<Row>(question)));
  CHECK(right(catalogue::ask_oracle<Row>(question).answer));
  CHECK(right(catalogue::ask_reference<Row>(question)) == by_reference);
}

/// Whether the checker of the row and the one of certificates, written apart, say the same of altered answers.
template <class Row, class Alter>
void hull_checkers_agree(const Alter& alter) {
  const catalogue::Operation& operation = catalogue::operation_of_row<Row>();
  int right = 0, wrong = 0, different = 0;
  for (std::uint64_t i = 0; i < 2500; ++i) {
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(i, "altered hulls", 0));
    const Question question = operation.draw(draws, draws.below(operation.families().size()));
    const auto asked = typed<Row>(question);
    if (std::get<0>(asked).empty() || std::get<0>(asked).size() > 12) continue;
    auto hull = catalogue::ask_robust<Row>(asked);
    for (std::uint64_t more = draws.below(3); more > 0; --more)
      alter(draws, hull, static_cast<Index>(std::get<0>(asked).size()));
    auto claim = catalogue::claim_of(*operation.examine(question));
    claim["truth"] = nlohmann::json::parse(operation.answer_json(catalogue::packed(hull)).dump());
    std::set<Index> named;
    const auto name = [&](const nlohmann::json& value, const auto& self) -> void {
      if (value.is_number_unsigned()) named.insert(value.get<Index>());
      else
        for (const auto& part : value) self(part, self);
    };
    for (const auto& [key, value] : claim["truth"].items())
      if (key != "dimension") name(value, name);
    claim["certificate"]["extreme"] = nlohmann::json::array();
    for (const Index k : named) claim["certificate"]["extreme"].push_back(std::to_string(k));
    const bool accepted = Row::defect(asked, hull).empty();
    if (accepted == certify::refuse(claim).has_value()) {
      ++different;
      WARN(claim.dump());
    }
    ++(accepted ? right : wrong);
  }
  CHECK(different == 0);
  CHECK(right > 300);
  CHECK(wrong > 300);
}

}  // namespace touchstone::proptests
