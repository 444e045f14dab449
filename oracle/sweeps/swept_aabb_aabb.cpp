// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_aabb_aabb.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

/// Five numbers for each axis, in the form of AxisMotion.
template <class Number>
CommonScale<Number, 10> scale_of(const Aabb2<Number>& a, const Aabb2<Number>& b, const Vector2<Number>& v) {
  return CommonScale<Number, 10>({a.min.x, a.max.x, b.min.x, b.max.x, v.x, a.min.y, a.max.y, b.min.y, b.max.y, v.y});
}
template <class Number>
CommonScale<Number, 15> scale_of(const Aabb3<Number>& a, const Aabb3<Number>& b, const Vector3<Number>& v) {
  return CommonScale<Number, 15>({a.min.x, a.max.x, b.min.x, b.max.x, v.x, a.min.y, a.max.y, b.min.y, b.max.y, v.y,
                                  a.min.z, a.max.z, b.min.z, b.max.z, v.z});
}

template <class Value>
struct AxisMotion {
  Value a_min, a_max, b_min, b_max, velocity;
};

/// The axes of valid boxes; refuses others.
template <class Value, class Number, std::size_t N, class Box, class Vector>
std::array<AxisMotion<Value>, N / 5> validated(const CommonScale<Number, N>& n, const Box& a, const Box& b,
                                               const Vector& v) {
  const auto validate = [&] { validation::validate_all("a", a, "b", b, "velocity", v); };
  if (!n.finite()) validate();
  std::array<AxisMotion<Value>, N / 5> axes;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto at = [&](std::size_t i) { return integer<Value>(n, 5 * k + i); };
    axes[k] = {at(0), at(1), at(2), at(3), at(4)};
    if (axes[k].a_max < axes[k].a_min || axes[k].b_max < axes[k].b_min) validate();
  }
  return axes;
}

/// Variable 0 is t, variable 1 + k the common point's coordinate k less b_min.
template <class Value>
class SweptAabbAabbProgram {
 public:
  template <class Axes>
  explicit SweptAabbAabbProgram(const Axes& axes)
      : program_(static_cast<int>(1 + axes.size()), std::vector(1 + 3 * axes.size(), Linear::Row::at_most)) {
    program_.set_coefficient(0, 0, Value(1)), program_.set_right_side(0, Value(1));
    int row = 1, variable = 1;
    for (const auto& m : axes) {
      program_.set_coefficient(row, variable, Value(1));
      program_.set_right_side(row++, Value(m.b_max - m.b_min));
      program_.set_coefficient(row, variable, Value(-1)), program_.set_coefficient(row, 0, m.velocity);
      program_.set_right_side(row++, Value(m.b_min - m.a_min));
      program_.set_coefficient(row, variable++, Value(1)), program_.set_coefficient(row, 0, Value(-m.velocity));
      program_.set_right_side(row++, Value(m.a_max - m.b_min));
    }
    hits_ = program_.feasible();
    if (!hits_) return;
    std::vector<Value> cost(1 + axes.size(), Value(0));
    cost[0] = 1;
    program_.minimise(cost);
  }

  bool hits() const { return hits_; }
  Rational variable(std::size_t i) const {
    return quotient(program_.numerator(static_cast<int>(i)), program_.denominator());
  }
  /// For a contradictory program: the coefficient in the sum of the rows of p - t velocity being in a.
  Rational normal(std::size_t axis) const {
    const auto& y = program_.farkas();
    return rational(Value(y[3 * axis + 3] - y[3 * axis + 2]));
  }

 private:
  using Linear = LinearProgram<Value>;
  Linear program_;
  bool hits_;
};

/// Requires height + t slope <= 0 on one axis.
struct Line {
  Integer height, slope;
  std::size_t axis;
};

template <class Axes>
Rational margin_in_units(const Axes& axes) {
  std::vector<Line> lines;
  for (const auto& m : axes) {
    lines.push_back({Integer(m.b_min - m.a_max), Integer(-m.velocity), lines.size() / 2});
    lines.push_back({Integer(m.a_min - m.b_max), m.velocity, lines.size() / 2});
  }
  Rational greatest(lines[0].height + std::min(lines[0].slope, Integer(0)));
  const auto note = [&greatest](const Rational& value) { greatest = std::max(greatest, value); };
  for (const Line& line : lines) {
    note(Rational(line.height + std::min(line.slope, Integer(0))));
    for (const Line& other : lines) {
      if (other.axis == line.axis || sgn(line.slope) >= 0 || sgn(other.slope) <= 0) continue;
      note(quotient(Integer(line.height * other.slope - other.height * line.slope), Integer(other.slope - line.slope)));
    }
  }
  return Rational(abs(greatest));
}

/// The axis on which a reaches b at t.
template <class Axes>
std::vector<Rational> touching_normal_swept_aabb_aabb(const Axes& axes, const Rational& t) {
  std::vector<Rational> normal(axes.size());
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto& m = axes[k];
    const int direction = sgn(m.velocity);
    const Rational displacement(direction > 0 ? Integer(m.b_min - m.a_max) : Integer(m.b_max - m.a_min));
    if (direction == 0 || displacement != t * m.velocity) continue;
    normal[k] = direction;
    return normal;
  }
  throw std::logic_error("boxes that first meet on the way do so at an entry");
}

template <class Value, class Scale, class Axes>
Certificate certificate(const Scale& n, const Axes& axes, const SweptAabbAabbProgram<Value>& program) {
  if (!program.hits()) {
    std::vector<Rational> normal;
    for (std::size_t k = 0; k < axes.size(); ++k) normal.push_back(program.normal(k));
    return {"separating_axis", {{"normal", std::move(normal)}}};
  }
  const Rational t = program.variable(0);
  std::vector<Rational> point;
  for (std::size_t k = 0; k < axes.size(); ++k)
    point.push_back(n.actual(Rational(axes[k].b_min + program.variable(1 + k)), 1));
  if (sgn(t) == 0) return {"start", {{"point", std::move(point)}}};
  return {"first_contact", {{"point", std::move(point)}, {"normal", touching_normal_swept_aabb_aabb(axes, t)}}};
}

/// The axes in integers; the program in any numbers.
template <class Value, class Scale, class Axes>
Truth<FirstContact<Rational>> truth_swept_aabb_aabb(const Scale& n, Axes axes, SweptAabbAabbProgram<Value> program) {
  Truth<FirstContact<Rational>> found{{HitRelation::never, std::nullopt}, n.actual(margin_in_units(axes), 1)};
  if (program.hits()) found.answer = {HitRelation::hit, program.variable(0)};
  found.certificate = [n, axes = std::move(axes), program = std::move(program)] {
    return certificate(n, axes, program);
  };
  return found;
}

/// Every minor of the program takes at most one number of t's column and one of the right side, which is a difference,
/// and adds fewer than 2^7 such products: coordinates have columns of 1 and -1.
constexpr int most_bits = 58;

template <class Box, class Vector>
Truth<FirstContact<Rational>> truth_of(const Box& a, const Box& b, const Vector& velocity) {
  const auto n = scale_of(a, b, velocity);
  auto axes = validated<Integer>(n, a, b, velocity);
  if (n.bits() <= most_bits)
    return truth_swept_aabb_aabb(n, std::move(axes),
                                 SweptAabbAabbProgram<Int128>(validated<Int128>(n, a, b, velocity)));
  SweptAabbAabbProgram<Integer> program(axes);
  return truth_swept_aabb_aabb(n, std::move(axes), std::move(program));
}

}  // namespace

template <Exact Number>
Truth<FirstContact<Rational>> swept_aabb_aabb(const Aabb2<Number>& a, const Aabb2<Number>& b,
                                              const Vector2<Number>& velocity) {
  return truth_of(a, b, velocity);
}
template <Exact Number>
Truth<FirstContact<Rational>> swept_aabb_aabb(const Aabb3<Number>& a, const Aabb3<Number>& b,
                                              const Vector3<Number>& velocity) {
  return truth_of(a, b, velocity);
}
template Truth<FirstContact<Rational>> swept_aabb_aabb(const Aabb2d&, const Aabb2d&, const Vector2d&);
template Truth<FirstContact<Rational>> swept_aabb_aabb(const Aabb3d&, const Aabb3d&, const Vector3d&);
template Truth<FirstContact<Rational>> swept_aabb_aabb(const Aabb2<Rational>&, const Aabb2<Rational>&,
                                                       const Vector2<Rational>&);
template Truth<FirstContact<Rational>> swept_aabb_aabb(const Aabb3<Rational>&, const Aabb3<Rational>&,
                                                       const Vector3<Rational>&);

}  // namespace touchstone::oracle
