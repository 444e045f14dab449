// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/passage.h"

#include <algorithm>
#include <optional>

#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/numbers/parabola.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using Program = LinearProgram<Integer>;

/// Up to three coordinates of up to four places, and perhaps a radius, as integers on one unit.
class Scaled {
 public:
  Scaled(std::initializer_list<const std::vector<Rational>*> places, const Rational& radius = 0)
      : axes_((*places.begin())->size()), scale_(in_a_row(places, radius)) {}

  std::size_t axes() const { return axes_; }
  const Integer& at(std::size_t place, std::size_t k) const { return scale_.integer(3 * place + k); }
  const Integer& radius() const { return scale_.integer(12); }
  Rational actual(const Rational& value, int degree) const { return scale_.actual(value, degree); }

 private:
  static std::array<Rational, 13> in_a_row(std::initializer_list<const std::vector<Rational>*> places,
                                           const Rational& radius) {
    std::array<Rational, 13> numbers;
    auto at = numbers.begin();
    for (const auto* place : places) std::copy(place->begin(), place->end(), at), at += 3;
    numbers[12] = radius;
    return numbers;
  }

  std::size_t axes_;
  CommonScale<Rational, 13> scale_;
};

/// The positions of a line and a box, or a center.
constexpr std::size_t from = 0, displacement = 1, least = 2, greatest = 3, middle = 2;

/// t way <= max - from and -t way <= from - min on each axis; t <= 1 if the line ends.
Program program_of(const Scaled& n, bool ends) {
  std::vector<Program::Row> rows(2 * n.axes() + (ends ? 1 : 0), Program::Row::at_most);
  Program program(1, rows);
  int row = 0;
  for (std::size_t k = 0; k < n.axes(); ++k) {
    program.set_coefficient(row, 0, n.at(displacement, k));
    program.set_right_side(row++, Integer(n.at(greatest, k) - n.at(from, k)));
    program.set_coefficient(row, 0, Integer(-n.at(displacement, k)));
    program.set_right_side(row++, Integer(n.at(from, k) - n.at(least, k)));
  }
  if (ends) program.set_coefficient(row, 0, 1), program.set_right_side(row, 1);
  return program;
}

/// The upper sides' part of Farkas' sum of the rows minus that of the lower sides.
std::vector<Rational> separating_normal(const Program& program, std::size_t axes) {
  std::vector<Rational> normal;
  for (std::size_t k = 0; k < axes; ++k)
    normal.emplace_back(Integer(program.farkas()[2 * k] - program.farkas()[2 * k + 1]));
  return normal;
}

/// Requires height + t slope <= 0 on one axis.
struct Want {
  Integer height, slope;
  std::size_t axis;
};

/// The distance by which the line has to be moved, in the maximum norm, until the relation changes.
Rational displacement_to_change(const Scaled& n, bool ends) {
  std::vector<Want> wants;
  for (std::size_t k = 0; k < n.axes(); ++k) {
    wants.push_back({Integer(n.at(least, k) - n.at(from, k)), Integer(-n.at(displacement, k)), k});
    wants.push_back({Integer(n.at(from, k) - n.at(greatest, k)), n.at(displacement, k), k});
  }
  std::optional<Rational> highest;
  const auto note = [&highest](const Rational& value) { highest = highest ? std::max(*highest, value) : value; };
  for (const Want& want : wants) {
    if (ends) note(Rational(want.height + std::min(want.slope, Integer(0))));
    else if (sgn(want.slope) >= 0) note(Rational(want.height));
    for (const Want& other : wants) {
      if (other.axis == want.axis || sgn(want.slope) >= 0 || sgn(other.slope) <= 0) continue;
      note(quotient(Integer(want.height * other.slope - other.height * want.slope), Integer(other.slope - want.slope)));
    }
  }
  return Rational(abs(*highest));
}

/// A t beyond all zeros of f (Cauchy's bound), where f is positive and grows.
Integer beyond_zeros(const Parabola& f) { return Integer(2 + (2 * abs(f.half) + abs(f.start)) / f.square); }

/// f(1 - t)
Parabola backwards(const Parabola& f) { return {f.end(), Integer(-f.half_slope_at_end()), f.square}; }

}  // namespace

Truth<Passage<Rational>> passage_of_box(const Line& line, const std::vector<Rational>& min,
                                        const std::vector<Rational>& max) {
  const Scaled n({&line.from, &line.displacement, &min, &max});
  Program program = program_of(n, line.ends);
  Truth<Passage<Rational>> truth{{PassageRelation::none, {}, {}}, n.actual(displacement_to_change(n, line.ends), 1)};
  if (!program.feasible()) {
    truth.certificate = [normal = separating_normal(program, n.axes())] {
      return Certificate{"separating_plane", {{"normal", normal}}};
    };
    return truth;
  }
  const auto optimum = [&program](int cost) {
    program.minimise({Integer(cost)});
    return quotient(program.numerator(0), program.denominator());
  };
  const Rational first = optimum(1);
  const bool moves =
      std::any_of(line.displacement.begin(), line.displacement.end(), [](const Rational& v) { return sgn(v) != 0; });
  truth.answer = {PassageRelation::hit, first, moves ? optimum(-1) : first};
  truth.certificate = [] { return Certificate{"passage", {}}; };
  return truth;
}

Truth<Passage<Surd>> passage_of_ball(const Line& line, const std::vector<Rational>& center, const Rational& radius) {
  const Scaled n({&line.from, &line.displacement, &center}, radius);
  Parabola f{Integer(-n.radius() * n.radius()), 0, 0};
  for (std::size_t k = 0; k < n.axes(); ++k) {
    const Integer p(n.at(from, k) - n.at(middle, k)), v = n.at(displacement, k);
    f.start += p * p, f.half += p * v, f.square += v * v;
  }
  Integer until(1);
  if (!line.ends) {
    until = beyond_zeros(f);
    f = {f.start, Integer(until * f.half), Integer(until * until * f.square)};
  }
  Truth<Passage<Surd>> truth{{PassageRelation::none, {}, {}}, n.actual(Rational(abs(f.least())), 2)};
  const FirstContact<Surd> first = f.contact(), last = backwards(f).contact();
  if (!first.t) {
    truth.certificate = [f] { return Certificate{f.kind(), {}}; };
    return truth;
  }
  const Surd whole{Rational(until)};
  truth.answer = {PassageRelation::hit, whole * *first.t, sgn(f.square) == 0 ? *first.t : whole - whole * *last.t};
  truth.certificate = [] { return Certificate{"passage", {}}; };
  return truth;
}

}  // namespace touchstone::oracle
