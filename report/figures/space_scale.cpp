// SPDX-License-Identifier: Apache-2.0
#include "report/figures/space_scale.h"

#include <algorithm>
#include <cmath>

#include "catalogue/numbers/ulps.h"

namespace touchstone::report {
namespace {

using SpaceKind = SpaceFigure::Kind;

constexpr int extents_far_apart = 12;

/// The least box around the points added.
struct ExactBox {
  ExactPlace low, high;
  bool empty = true;

  void put(const ExactPlace& place, const mpq_class& room = 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      const mpq_class least = place[i] - room, most = place[i] + room;
      if (empty || least < low[i]) low[i] = least;
      if (empty || most > high[i]) high[i] = most;
    }
    empty = false;
  }
  ExactPlace middle() const {
    ExactPlace place;
    for (std::size_t i = 0; i < 3; ++i) place[i] = (low[i] + high[i]) / 2;
    return place;
  }
};

int nearest_integer(const mpq_class& value) {
  const mpq_class half_up = value + mpq_class(1, 2);
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), half_up.get_num_mpz_t(), half_up.get_den_mpz_t());
  return static_cast<int>(result.get_si());
}

}  // namespace

bool drawable(const SpaceFigure& figure) {
  const std::vector<double>& n = figure.numbers;
  if (!std::all_of(n.begin(), n.end(), [](double x) { return std::isfinite(x); })) return false;
  switch (figure.kind) {
    case SpaceKind::point: return n.size() == 3;
    case SpaceKind::segment:
    case SpaceKind::arrow:
    case SpaceKind::box: return n.size() == 6;
    case SpaceKind::plane: return n.size() == 4 && (n[0] != 0 || n[1] != 0 || n[2] != 0);
    case SpaceKind::sphere: return n.size() == 4;
    case SpaceKind::polygon:
    case SpaceKind::mesh: return !n.empty() && n.size() % 3 == 0;
  }
  return false;
}

const char* whose(const SpaceFigure& figure) { return figure.said ? "answer" : figure.answer ? "truth" : "question"; }

std::vector<ExactPlace> places_of(const SpaceFigure& figure) {
  std::vector<ExactPlace> places;
  if (figure.kind == SpaceKind::plane) return places;
  const std::size_t numbers = figure.kind == SpaceKind::sphere ? 3 : figure.numbers.size();
  for (std::size_t i = 0; i + 2 < numbers; i += 3) {
    places.push_back(
        {exact_value(figure.numbers[i]), exact_value(figure.numbers[i + 1]), exact_value(figure.numbers[i + 2])});
  }
  return places;
}

mpq_class radius_of(const SpaceFigure& sphere) { return exact_value(std::fabs(sphere.numbers[3])); }

SpaceScale SpaceScale::of(const std::vector<SpaceFigure>& figures) {
  SpaceScale scale;
  ExactBox box;
  bool one_scale = false;
  for (const SpaceFigure& figure : figures) {
    const mpq_class room = figure.kind == SpaceKind::sphere ? radius_of(figure) : mpq_class(0);
    for (const ExactPlace& place : places_of(figure)) box.put(place, room);
    one_scale = one_scale || figure.kind == SpaceKind::sphere || figure.kind == SpaceKind::plane;
  }
  if (!box.empty) scale.middle_but_planes = box.middle();
  for (const SpaceFigure& figure : figures) {
    if (figure.kind == SpaceKind::plane) box.put(scale.foot(figure));
  }
  scale.middle = box.middle();
  scale.low = box.low;
  scale.high = box.high;
  mpq_class longest = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, mpq_class(box.high[i] - box.low[i]));
    size = std::max(size, std::max(mpq_class(abs(box.low[i])), mpq_class(abs(box.high[i]))));
  }
  // A single point has the size of its coordinates, or 1 at the origin.
  if (sgn(longest) == 0) longest = sgn(size) == 0 ? mpq_class(2) : mpq_class(2 * size);
  for (std::size_t i = 0; i < 3; ++i) {
    const mpq_class extent = box.high[i] - box.low[i];
    const bool thin = !one_scale && sgn(extent) != 0 && extents_far_apart * extent < longest;
    scale.steps_per_unit[i] = thin ? mpq_class(steps_of_box / extent) : mpq_class(2 * steps_of_box / longest);
  }
  return scale;
}

SpacePoint SpaceScale::at(const ExactPlace& place) const {
  SpacePoint steps;
  for (std::size_t i = 0; i < 3; ++i) steps[i] = nearest_integer(mpq_class((place[i] - middle[i]) * steps_per_unit[i]));
  return steps;
}

int SpaceScale::radius_in_steps(const SpaceFigure& sphere) const {
  return nearest_integer(mpq_class(radius_of(sphere) * steps_per_unit[0]));
}

std::optional<SpacePoint> SpaceScale::steps(const std::array<double, 3>& displacement) const {
  constexpr int far = 10 * steps_of_box;
  SpacePoint result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(displacement[i])) return std::nullopt;
    const mpq_class steps_along = exact_value(displacement[i]) * steps_per_unit[i];
    if (abs(steps_along) > far) return std::nullopt;
    result[i] = nearest_integer(steps_along);
  }
  return result;
}

ExactPlace SpaceScale::foot(const SpaceFigure& plane) const {
  const ExactPlace& from = middle_but_planes;
  ExactPlace normal, result;
  mpq_class height = exact_value(plane.numbers[3]), square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    normal[i] = exact_value(plane.numbers[i]);
    height += normal[i] * from[i];
    square += normal[i] * normal[i];
  }
  for (std::size_t i = 0; i < 3; ++i) result[i] = from[i] - height / square * normal[i];
  return result;
}

}  // namespace touchstone::report
