// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "robust/kernel/filters.h"

/// Floating-point formats so small that everything can be tried: few bits, few exponents, every rounding mode, flush to
/// zero. Tables hold every sum and product, so that the filters of robust run on them as they stand.
namespace touchstone::proptests {

struct ToyMode {
  int rounding = 0;                   ///< 0 to nearest, ties to even; 1 downwards; 2 upwards; 3 towards zero
  bool flush = false, zeros = false;  ///< FTZ: results; DAZ: operands
};

/// precision bits, 2^min_exponent the least normal number, all numbers below 2^(max_exponent + 1). A number is its rank
/// among all numbers of the format; -0.0 is 0, because no filter divides.
template <int precision, int min_exponent, int max_exponent>
class Toy {
 public:
  Toy() : rank_(zero_rank()) {}

  /// The number with that value, which has to be one of the format.
  static Toy of(double value) { return Toy(rank_of(value)); }
  double value() const { return tables().values[static_cast<std::size_t>(rank_)]; }

  /// Fills the tables for one environment; every number of the format keeps its meaning.
  static void set(const ToyMode& mode) {
    Tables& t = tables();
    const std::size_t n = t.values.size();
    t.read.resize(n);
    t.sums.assign(n * n, 0), t.products.assign(n * n, 0);
    for (std::size_t i = 0; i < n; ++i)
      t.read[i] = static_cast<std::int16_t>(mode.zeros && subnormal(t.values[i]) ? zero_rank() : static_cast<int>(i));
    for (std::size_t i = 0; i < n; ++i) {
      const double x = t.values[static_cast<std::size_t>(t.read[i])];
      for (std::size_t j = 0; j < n; ++j) {
        const double y = t.values[static_cast<std::size_t>(t.read[j])];
        t.sums[i * n + j] = static_cast<std::int16_t>(rank_of(rounded(x + y, mode)));
        t.products[i * n + j] = static_cast<std::int16_t>(rank_of(rounded(x * y, mode)));
      }
    }
  }

  /// Sums and products of numbers of the format are exact in double, so this rounds once.
  static double rounded(double exact, const ToyMode& mode) {
    if (exact != exact || std::isinf(exact) || exact == 0) return exact;
    const int exponent = std::max(std::ilogb(exact), min_exponent);
    const double unit = std::ldexp(1.0, exponent - precision + 1), count = exact / unit, below = std::floor(count);
    double kept = below;
    switch (mode.rounding) {
      case 0:
        kept = count - below > 0.5 || (count - below == 0.5 && std::fmod(below, 2) != 0) ? below + 1 : below;
        break;
      case 1: break;
      case 2: kept = std::ceil(count); break;
      default: kept = std::trunc(count); break;
    }
    const double result = kept * unit;
    if (mode.flush && subnormal(result)) return 0;
    if (std::fabs(result) <= greatest()) return result;
    const bool away = mode.rounding == 0 || mode.rounding == (result < 0 ? 1 : 2);
    return std::copysign(away ? std::numeric_limits<double>::infinity() : greatest(), result);
  }

  static double greatest() { return std::ldexp(2 - std::ldexp(1.0, 1 - precision), max_exponent); }

  friend Toy operator+(Toy a, Toy b) { return Toy(tables().sums[place(a, b)]); }
  friend Toy operator-(Toy a, Toy b) { return a + b.negated(); }
  friend Toy operator*(Toy a, Toy b) { return Toy(tables().products[place(a, b)]); }
  friend bool operator<(Toy a, Toy b) { return ordered(a, b) && a.read() < b.read(); }
  friend bool operator>(Toy a, Toy b) { return b < a; }
  friend bool operator<=(Toy a, Toy b) { return ordered(a, b) && a.read() <= b.read(); }
  friend bool operator>=(Toy a, Toy b) { return b <= a; }

  /// A bit is cleared: the environment has no say.
  Toy magnitude() const { return rank_ < zero_rank() ? negated() : *this; }

  /// The least number of the format that is not below c.
  static Toy above(double c) { return of(rounded(c, ToyMode{2, false, false})); }

 private:
  struct Tables {
    std::vector<double> values;  ///< rising, the infinities at both ends; NaN comes last
    std::vector<std::int16_t> sums, products, read;
    Tables() {
      values.push_back(0);
      for (int e = min_exponent; e <= max_exponent; ++e) {
        for (int m = e == min_exponent ? 1 : 1 << (precision - 1); m < 1 << precision; ++m) {
          values.push_back(std::ldexp(m, e - precision + 1)), values.push_back(-values.back());
        }
      }
      values.push_back(std::numeric_limits<double>::infinity()), values.push_back(-values.back());
      std::sort(values.begin(), values.end());
      values.push_back(std::numeric_limits<double>::quiet_NaN());
    }
  };

  explicit Toy(int rank) : rank_(static_cast<std::int16_t>(rank)) {}

  inline static Tables made_;
  static Tables& tables() { return made_; }
  static constexpr int magnitudes =
      (max_exponent - min_exponent + 1) * (1 << (precision - 1)) + (1 << (precision - 1));  // and infinity
  static constexpr int zero_rank() { return magnitudes; }
  static constexpr int nan_rank() { return 2 * magnitudes + 1; }

  /// Normal numbers m 2^(e - precision + 1) follow one another as (e, m) do, and subnormals as m does.
  static int rank_of(double value) {
    if (value != value) return nan_rank();
    if (value == 0) return zero_rank();
    if (std::isinf(value)) return value < 0 ? 0 : 2 * magnitudes;
    const int exponent = std::max(std::ilogb(value), min_exponent);
    const int m = static_cast<int>(std::ldexp(std::fabs(value), precision - 1 - exponent));
    const int rank = (exponent - min_exponent) * (1 << (precision - 1)) + m;
    return value < 0 ? zero_rank() - rank : zero_rank() + rank;
  }
  static bool subnormal(double x) { return x != 0 && std::fabs(x) < std::ldexp(1.0, min_exponent); }
  static std::size_t place(Toy a, Toy b) {
    return static_cast<std::size_t>(a.rank_) * static_cast<std::size_t>(nan_rank() + 1) +
           static_cast<std::size_t>(b.rank_);
  }
  static bool ordered(Toy a, Toy b) { return a.rank_ != nan_rank() && b.rank_ != nan_rank(); }
  Toy negated() const { return rank_ == nan_rank() ? *this : Toy(2 * zero_rank() - rank_); }
  int read() const { return tables().read[static_cast<std::size_t>(rank_)]; }

  std::int16_t rank_;
};

/// What a filter asks of the format. The constants can be weakened, to see that a wrong one is found: `absolute`
/// multiplies the bounds' absolute terms (powers of two below 1), `relative` their relative ones (no powers of two);
/// the guards are left alone.
template <class Float, int p, int low, int high>
struct ToyFormat {
  static constexpr int precision = p, min_exponent = low, max_exponent = high;
  inline static double relative = 1, absolute = 1;

  static Float above(double c) {
    int exponent = 0;
    const bool power = std::frexp(c, &exponent) == 0.5;
    const double factor = !power ? relative : c < 1 ? absolute : 1;
    return factor == 0 ? Float() : Float::above(c * factor);
  }
  static Float magnitude(Float x) { return x.magnitude(); }
};

}  // namespace touchstone::proptests
