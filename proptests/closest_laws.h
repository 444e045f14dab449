// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proptests/forward_error.h"

/// Laws and bounds of nearest points and distances.
namespace touchstone::proptests {

/// Of an answer of the plane or of space.
template <class Answer>
auto distance_of(const Answer& answer) {
  if constexpr (requires { answer.distance; }) return answer.distance;
  else return std::visit([](const auto& found) { return found.distance; }, answer);
}
template <class Answer>
auto square_of(const Answer& answer) {
  if constexpr (requires { answer.distance; }) return answer.squared_distance;
  else return std::visit([](const auto& found) { return found.squared_distance; }, answer);
}

inline double rounded(double number) { return number; }
inline double rounded(const catalogue::TrueNumber& number) { return catalogue::nearest(number); }
inline bool is_zero(double number) { return number == 0; }
inline bool is_zero(const catalogue::TrueNumber& number) { return sgn(number) == 0; }

inline Point3<Rational> exact_point(const Point3d& p) { return {exact(p.x), exact(p.y), exact(p.z)}; }

/// All numbers times 2^k, where that is exact: so are points and distance, and the square is times 2^(2 k).
template <class Row>
inline constexpr auto distances_scale = [](const auto& ask, const auto& asked) {
  const auto times = [](auto question, int k) {
    catalogue::for_each_number(question, [k](double& number) { number = std::ldexp(number, k); });
    return question;
  };
  const auto answer = ask(asked);
  for (const int k : {1, -29, 300, -300}) {
    const auto larger = times(asked, k);
    if (numbers_of(times(larger, -k)) != numbers_of(asked)) continue;
    const auto found = ask(larger);
    if (!scaled_number(distance_of(answer), distance_of(found), k)) return false;
    if (!scaled_number(square_of(answer), square_of(found), 2 * k)) return false;
  }
  return true;
};

template <class Point>
std::vector<Rational> exact_coordinates(const Point& p) {
  std::vector<Rational> all{exact(p.x), exact(p.y)};
  if constexpr (requires { p.z; }) all.push_back(exact(p.z));
  return all;
}

/// The scalar product of two displacements, exactly, and the sum of the magnitudes of its products.
struct ExactProducts {
  Rational sum, sizes;

  ExactProducts(const std::vector<Rational>& v, const std::vector<Rational>& w) {
    for (std::size_t k = 0; k < v.size(); ++k) sum += v[k] * w[k], sizes += abs(v[k] * w[k]);
  }
};
inline std::vector<Rational> exact_between(const Point3d& p, const Point3d& q) {
  std::vector<Rational> from = exact_coordinates(p), to = exact_coordinates(q);
  for (std::size_t k = 0; k < 3; ++k) to[k] -= from[k];
  return to;
}

/// What the contract of closest_point_on_segment promises of a nearest point, axis by axis, and the sum e.
struct SegmentBound {
  bool defined = false;
  std::vector<Rational> exactly, of_coordinate;
  Rational sum;

  template <class Point>
  SegmentBound(const Point& p, const Point& a, const Point& b, const Point& answered) {
    const auto v = b - a;
    const double length = dot(v, v);
    defined = length >= 0x1p-960 && finite(length, dot(p - a, v), dot(p - answered, p - answered));
    if (!defined) return;
    const std::vector<Rational> from = exact_coordinates(p), start = exact_coordinates(a), end = exact_coordinates(b),
                                x = exact_coordinates(answered);
    Rational products, foot, square;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Rational along(end[k] - start[k]), displacement(from[k] - start[k]);
      foot += displacement * along, products += abs(displacement * along), square += along * along;
    }
    const Rational u = unit(), t = std::clamp(Rational(foot / square), Rational(0), Rational(1));
    const Rational of_t(((5 + 11 * u) * u * products + power_of_two(-1073)) / square + 7 * u);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Rational along(end[k] - start[k]);
      exactly.push_back(Rational(start[k] + t * along));
      of_coordinate.push_back(
          Rational((of_t * (1 + 3 * u) + 3 * u) * abs(along) + u * abs(x[k]) + power_of_two(-1074)));
      sum += of_coordinate.back();
    }
  }

  template <class Point>
  bool keeps(const Point& answered) const {
    const std::vector<Rational> x = exact_coordinates(answered);
    for (std::size_t k = 0; k < x.size(); ++k)
      if (abs(x[k] - exactly[k]) > of_coordinate[k]) return false;
    return true;
  }
};

/// 2 D* e + e^2 + 6u (D* + e)^2 + 2^-1072, with a D* that is not less than the root.
inline Rational of_square(const Rational& square, const Rational& e) {
  const Rational root = exact(std::nextafter(std::sqrt(catalogue::nearest(square)), infinity)) + power_of_two(-1022);
  return 2 * root * e + e * e + 6 * unit() * (root + e) * (root + e) + power_of_two(-1072);
}

/// By the contract of capsule_capsule: whether the distance D, of that square, is certain to exceed R in the formula.
/// D > e + (1 + 8u) R + 2^-535 is enough for (1 - 6u) (D - e)^2 - 2^-1072 > (1 + 4u) R^2 + 2^-1072.
inline bool certainly_apart(const Rational& square, const Rational& e, const Rational& reach) {
  const Rational least(e + (1 + 8 * unit()) * reach + power_of_two(-535));
  return square > least * least;
}

/// By the contract of convex_distance: how far off its point is, at most, on all axes together, where every coordinate
/// is below 2^200.
inline bool below_2_to_200(const Meshd& mesh) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Point3d& p) {
    return size(p.x) < power_of_two(200) && size(p.y) < power_of_two(200) && size(p.z) < power_of_two(200);
  });
}
inline Rational off_by(const Meshd& mesh) {
  Rational sum;
  for (const auto coordinate : {&Point3d::x, &Point3d::y, &Point3d::z}) {
    Rational low = exact(mesh.vertices[0].*coordinate), high = low;
    for (const Point3d& p : mesh.vertices)
      low = std::min(low, exact(p.*coordinate)), high = std::max(high, exact(p.*coordinate));
    sum += 16 * unit() * (high - low + std::max(abs(low), abs(high))) + power_of_two(-1070);
  }
  return sum;
}

/// Distance and square of the formula, by the contract of closest_point_on_segment; `square`: the true one.
inline bool keeps_distance(double distance, double squared, const Rational& square, const Rational& e) {
  const Rational u = unit();
  // |D - D*| <= r, by squares: D* is a root.
  const Rational d = exact(distance);
  const auto at_most_root = [&square](const Rational& x) { return sgn(x) <= 0 || x * x <= square; };
  const Rational low((d - power_of_two(-536) - e - 4 * u * e) / (1 + 4 * u)),
      high((d + power_of_two(-536) + e + 4 * u * e) / (1 - 4 * u));
  if (!at_most_root(low) || high * high < square) return false;
  return abs(exact(squared) - square) <= of_square(square, e);
}

/// The numbers of robust's answer: `constexpr RoundsTo<Row> rounds_to;`
template <class Row>
struct RoundsTo {
  void operator()(const typename Row::Question& question, const std::vector<double>& numbers) const {
    CHECK(numbers_of(catalogue::ask_robust<Row>(question)) == numbers);
  }
};

/// The test case of distances_scale, in the types of the file's `Row`; NORMAL_LAW and others are alike.
#define LENGTHS_LAW(operation)                                         \
  TEST_CASE(operation ": all lengths times a power of two") {          \
    robust_law<Row>("points and distances too", distances_scale<Row>); \
  }

}  // namespace touchstone::proptests
