// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/passage.h"

#include <algorithm>
#include <array>
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

/// constant + 2 half t + square t^2 for t from one time to another.
struct Piece {
  Integer constant, half, square;
  Rational from{}, to{};

  Rational at(const Rational& t) const { return Rational(constant + t * (2 * half + t * square)); }
  Rational width() const { return Rational(to - from); }
  /// The t at which it is least.
  Rational lowest() const {
    if (sgn(square) == 0) return from;
    return std::clamp(quotient(Integer(-half), square), from, to);
  }
  /// Times something positive, for times from 0 to 1.
  Parabola parabola() const {
    const Rational start = at(from), slope((half + from * square) * width()), bend(square * width() * width());
    Integer unit(1);
    for (const Rational* x : {&start, &slope, &bend}) mpz_lcm(unit.get_mpz_t(), unit.get_mpz_t(), x->get_den_mpz_t());
    const auto integer = [&unit](const Rational& x) { return Integer(x.get_num() * (unit / x.get_den())); };
    return {integer(start), integer(slope), integer(bend)};
  }
};

Integer product_of(const std::vector<Integer>& x, const std::vector<Integer>& y) {
  Integer sum;
  for (std::size_t k = 0; k < x.size(); ++k) sum += x[k] * y[k];
  return sum;
}

/// A line and the axis of a capsule, as seen from an end of it. All f are times the axis's squared length, or 1.
struct LineAndAxis {
  std::vector<Integer> start, way, axis;
  Integer height, climb, length;  ///< along the axis
  std::array<Piece, 3> near_a_b_or_neither;
  bool ends;

  LineAndAxis(const Scaled& n, bool line_ends) : ends(line_ends) {
    std::vector<Integer> from_b;
    for (std::size_t k = 0; k < 3; ++k) {
      start.emplace_back(n.at(from, k) - n.at(least, k)), from_b.emplace_back(n.at(from, k) - n.at(greatest, k));
      way.push_back(n.at(displacement, k)), axis.emplace_back(n.at(greatest, k) - n.at(least, k));
    }
    height = product_of(start, axis), climb = product_of(way, axis), length = product_of(axis, axis);
    const Integer unit = factor(), reach(n.radius() * n.radius()), speed = product_of(way, way);
    const auto near = [&](const std::vector<Integer>& p) {
      return Piece{Integer(unit * (product_of(p, p) - reach)), Integer(unit * product_of(p, way)),
                   Integer(unit * speed)};
    };
    Piece beside = near(start);
    beside.constant -= height * height, beside.half -= height * climb, beside.square -= climb * climb;
    near_a_b_or_neither = {near(start), near(from_b), beside};
  }

  Integer factor() const { return sgn(length) == 0 ? Integer(1) : length; }

  /// Up to 1, or beyond all zeros and all changes.
  std::vector<Piece> pieces() const {
    std::vector<Rational> times{Rational(0), Rational(1)};
    if (!ends)
      for (const Piece& f : near_a_b_or_neither)
        if (sgn(f.square) > 0) times[1] = std::max(times[1], Rational(beyond_zeros({f.constant, f.half, f.square})));
    if (sgn(climb) != 0) {
      for (const Integer& end : {Integer(0), length}) {
        const Rational t = quotient(Integer(end - height), climb);
        if (!ends) times[1] = std::max(times[1], Rational(t + 1));
        if (sgn(t) > 0 && t < times[1]) times.push_back(t);
      }
    }
    std::sort(times.begin(), times.end());
    std::vector<Piece> found;
    for (std::size_t i = 1; i < times.size(); ++i) {
      const Rational doubled(2 * height + (times[i - 1] + times[i]) * climb);
      const std::size_t nearest = sgn(length) == 0 || sgn(doubled) < 0 ? 0 : doubled > 2 * length ? 1 : 2;
      found.push_back(near_a_b_or_neither[nearest]);
      found.back().from = times[i - 1], found.back().to = times[i];
    }
    return found;
  }

  /// From the nearest point of the axis to that of the line at t.
  std::vector<Rational> displacement_at(const Rational& t) const {
    const Rational along((height + t * climb) / factor()), share = std::clamp(along, Rational(0), Rational(1));
    std::vector<Rational> found;
    for (std::size_t k = 0; k < 3; ++k) found.emplace_back(start[k] + t * way[k] - share * axis[k]);
    return found;
  }
};

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

Truth<Passage<Surd>> passage_of_capsule(const Line& line, const std::vector<Rational>& a,
                                        const std::vector<Rational>& b, const Rational& radius) {
  const Scaled n({&line.from, &line.displacement, &a, &b}, radius);
  const LineAndAxis both(n, line.ends);
  const std::vector<Piece> pieces = both.pieces();
  const auto lower = [](const Piece& f, const Piece& g) { return f.at(f.lowest()) < g.at(g.lowest()); };
  const Piece lowest = *std::min_element(pieces.begin(), pieces.end(), lower);
  const Rational depth(lowest.at(lowest.lowest()) / both.factor());
  Truth<Passage<Surd>> truth{{PassageRelation::none, {}, {}}, n.actual(Rational(abs(depth)), 2)};
  auto& [relation, first, last] = truth.answer;
  for (const Piece& f : pieces)
    if (const auto t = f.parabola().contact().t; t && !first) first = Surd(f.from) + Surd(f.width()) * *t;
  if (!first) {
    truth.certificate = [normal = both.displacement_at(lowest.lowest())] {
      return Certificate{"separating_plane", {{"normal", normal}}};
    };
    return truth;
  }
  for (const Piece& f : pieces)
    if (const auto t = backwards(f.parabola()).contact().t) last = Surd(f.to) - Surd(f.width()) * *t;
  const bool moves = sgn(product_of(both.way, both.way)) != 0;
  relation = PassageRelation::hit;
  if (!moves) last = first;
  truth.certificate = [] { return Certificate{"passage", {}}; };
  return truth;
}

}  // namespace touchstone::oracle
