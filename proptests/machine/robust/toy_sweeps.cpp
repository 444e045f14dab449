// SPDX-License-Identifier: Apache-2.0
#include "proptests/machine/robust/toy_windows.h"
#include "robust/kernel/int192.h"
#include "robust/kernel/sweep_filter.h"

// What the filter of two moving balls is sure of: with ten bits where its bounds are nearly reached, and on windows of
// a toy format in every environment where numbers underflow. A certain sign is never wrong, and bounds that are too
// small are found out.
namespace touchstone::proptests {
namespace {

namespace filters = robust::filters;

/// Position and velocity of a as b sees them, and the sum of the radii.
template <class Number>
struct Motion {
  Vector3<Number> c, v;
  Number r;
};

enum Question { start, slope_at_start, slope_at_end, end, passage };
constexpr std::array<Question, 5> all{start, slope_at_start, slope_at_end, end, passage};

/// Of numbers that do not round.
template <class Number>
int truth(Question question, const Motion<Number>& m) {
  const auto& [c, v, r] = m;
  const Vector3<Number> w = c + v, x = cross(c, v);
  const Number radius = r * r;
  Number value;
  switch (question) {
    case start: value = dot(c, c) - radius; break;
    case slope_at_start: value = dot(c, v); break;
    case slope_at_end: value = dot(v, w); break;
    case end: value = dot(w, w) - radius; break;
    default: value = dot(x, x) - radius * dot(v, v);
  }
  return (value > 0) - (value < 0);
}

template <class To, class Convert>
Motion<To> converted(const Motion<double>& m, const Convert& convert) {
  return {
      {convert(m.c.x), convert(m.c.y), convert(m.c.z)}, {convert(m.v.x), convert(m.v.y), convert(m.v.z)}, convert(m.r)};
}

template <class Float, class Format>
filters::Sign said(Question question, const Motion<Float>& m) {
  const Float zero{};
  const auto& [c, v, r] = m;
  const filters::Sweep<Float, Format> sweep({{c.x, c.y, c.z}, r}, {{zero, zero, zero}, zero}, v, {zero, zero, zero});
  switch (question) {
    case start: return sweep.start();
    case slope_at_start: return sweep.slope_at_start();
    case slope_at_end: return sweep.slope_at_end();
    case end: return sweep.end();
    default: return sweep.passage();
  }
}

/// Ten bits, because at five the terms of higher order are larger than the first. Nothing is tabulated: there are too
/// many numbers. The input need not be of the format: b rests in the origin, and the difference rounds.
constexpr int bits = 10;
constexpr double ulp = 1.0 / (1 << (bits - 1));

template <int low, int high>
struct Short {
  inline static ToyMode mode;
  static void set(const ToyMode& to) { mode = to; }
  static Short rounded(double exact) { return {Toy<bits, low, high>::rounded(exact, mode)}; }
  static Short above(double c) { return {Toy<bits, low, high>::rounded(c, {2, false, false})}; }
  Short magnitude() const { return {std::fabs(value)}; }
  double read() const { return mode.zeros && std::fabs(value) < std::ldexp(1.0, low) ? 0 : value; }

  double value = 0;
  friend Short operator+(Short a, Short b) { return rounded(a.read() + b.read()); }
  friend Short operator-(Short a, Short b) { return rounded(a.read() - b.read()); }
  friend Short operator*(Short a, Short b) { return rounded(a.read() * b.read()); }
  friend bool operator>(Short a, Short b) { return a.read() > b.read(); }
  friend bool operator<=(Short a, Short b) { return a.read() <= b.read(); }
};

/// All exponents that a filter may meet where nothing underflows.
using Wide = Short<-200, 40>;
using WideFormat = ToyFormat<Wide, bits, -200, 40>;

/// Every number is a multiple of this, so that 64 bits hold its product with three others of them, and 128 their sums.
constexpr double grain = ulp / 32;

double on_grain(double x) { return std::round(x / grain) * grain; }
robust::kernel::Int128 in_grains(double x) { return static_cast<robust::kernel::Int128>(x / grain); }

/// Just beside `size` and halves of an ulp above it: rounding moves these as far as it can.
std::vector<double> beside(double size) {
  if (size == 0) return {0};
  std::vector<double> numbers;
  const double ulp_there = std::ldexp(ulp, std::ilogb(size));
  for (int halves = 0; halves <= 4; ++halves)
    for (const double hair : {-ulp_there / 16, ulp_there / 16})
      numbers.push_back(on_grain(size + std::copysign(halves * ulp_there / 2 + hair, size)));
  return numbers;
}
/// Numbers on both sides of a radius, an eighth of an ulp from one to the next; 0 where there is none.
std::vector<double> around(double radius) {
  if (radius == 0) return {0};
  std::vector<double> numbers;
  for (int k = -40; k <= 40; ++k) numbers.push_back(on_grain(radius + k * ulp / 8));
  return numbers;
}

/// Motions whose coordinates are beside these.
Count motions(Question question, const Motion<double>& size) {
  Count count;
  for (const double x : beside(size.c.x))
    for (const double y : beside(size.c.y))
      for (const double vx : beside(size.v.x))
        for (const double vy : beside(size.v.y))
          for (const double r : around(size.r)) {
            const Motion<double> m{{x, y, 0}, {vx, vy, 0}, r};
            count.add(said<Wide, WideFormat>(question, converted<Wide>(m, [](double n) { return Wide{n}; })),
                      truth(question, converted<robust::kernel::Int128>(m, in_grains)));
          }
  return count;
}

Count nearly_degenerate(Question question) {
  switch (question) {
    case start: return motions(start, {{-1, -1, 0}, {0, 0, 0}, std::sqrt(2.0)});
    case slope_at_start: return motions(slope_at_start, {{1, 1, 0}, {1, -1, 0}, 0});
    case slope_at_end: return motions(slope_at_end, {{2, -2.5, 0}, {0.25, 0.25, 0}, 0});
    case end: return motions(end, {{-0.25, -1, 0}, {0, -1, 0}, std::sqrt(4.0625)});
    default: return motions(passage, {{-1 - 6 * ulp, 0, 0}, {0.2453, 1 + 503 * ulp, 0}, 1.0039});
  }
}

std::uint64_t wrong_with(double relative, Question question) {
  const Weakened<WideFormat> weakened(relative, 1);
  std::uint64_t wrong = 0;
  for (int rounding = 0; rounding < 4; ++rounding) {
    Wide::set({rounding, false, false});
    wrong += nearly_degenerate(question).wrong;
  }
  return wrong;
}

// A format in which squares, and squares of products, of numbers far above the least normal one underflow.
constexpr int low = -30, high = 7;
using Narrow = Short<low, high>;
using NarrowFormat = ToyFormat<Narrow, bits, low, high>;

/// All motions of coordinates among these.
Count windows(Question question, const std::vector<double>& of_c, const std::vector<double>& of_v,
              const std::vector<double>& of_r) {
  Count count;
  // The windows of the product of four numbers end earlier: 128 bits hold it.
  const int places = question == passage ? 5 - low / 2 : bits - 1 - low;
  const auto whole = [places](double x) { return static_cast<robust::kernel::Int128>(std::ldexp(x, places)); };
  for (const double x : of_c)
    for (const double y : of_c)
      for (const double z : of_c)
        for (const double vx : of_v)
          for (const double vy : of_v)
            for (const double vz : of_v)
              for (const double r : of_r) {
                const Motion<double> m{{x, y, z}, {vx, vy, vz}, r};
                count.add(
                    said<Narrow, NarrowFormat>(question, converted<Narrow>(m, [](double n) { return Narrow{n}; })),
                    truth(question, converted<robust::kernel::Int128>(m, whole)));
              }
  return count;
}

/// Where numbers, squares or squares of products are beside the least normal one, and where subnormal numbers meet
/// others at the guard or beyond it.
Count underflowing(Question question) {
  const auto scaled = [](int exponent) {
    return std::vector<double>{std::ldexp(14, exponent - 4), std::ldexp(17, exponent - 4),
                               std::ldexp(-15, exponent - 4)};
  };
  const auto positive = [](int exponent) {
    return std::vector<double>{std::ldexp(15, exponent - 4), std::ldexp(17, exponent - 4),
                               std::ldexp(23, exponent - 4)};
  };
  Count count = windows(question, scaled(low / 2), scaled(low / 2), positive(low / 2)) +
                windows(question, scaled(low / 2 - 1), scaled(low / 2 - 1), positive(low / 2)) +
                windows(question, scaled(low / 4), scaled(low / 4), positive(low / 4)) +
                windows(question, scaled(low / 4 - 1), scaled(low / 4), {0, std::ldexp(1, low / 4)});
  if (question == passage) return count;
  return count + windows(question, scaled(low), {0, 1, -1.875}, {0, 1, 2.5}) +
         windows(question, {0, 1, -1.875}, scaled(low), {1, 1.875, 2}) +
         windows(question, scaled(low), scaled(low), {0, 1});
}

std::uint64_t underflowing_wrong(Question question) {
  return in_all_environments<Narrow>([question] { return underflowing(question); }).wrong;
}

}  // namespace

TEST_CASE("toy floats: no certain sign of a sweep is wrong where its bound is nearly reached") {
  for (const Question question : all) CHECK(wrong_with(1, question) == 0);
}

TEST_CASE("toy floats: a quarter of the bounds for a sweep's start and end is too small, and an eighth of the others") {
  // Those are looser: of a product of two sums of magnitudes, their unit, two terms that cancel are a quarter each.
  CHECK(wrong_with(0.25, start) > 0);
  CHECK(wrong_with(0.25, end) > 0);
  for (const Question question : {slope_at_start, slope_at_end, passage}) CHECK(wrong_with(0.125, question) > 0);
}

TEST_CASE("toy floats: no certain sign of a sweep is wrong where numbers underflow; without absolute terms some are") {
  for (const Question question : all) CHECK(underflowing_wrong(question) == 0);
  const Weakened<NarrowFormat> weakened(1, 0);
  for (const Question question : all) CHECK(underflowing_wrong(question) > 0);
}

}  // namespace touchstone::proptests
