// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/members.h"

/// The tests of numbers in rules. Doubles are tested by their bits, so this holds in every floating-point environment
/// and build type; numbers of other types compare themselves.
namespace touchstone::validation {

constexpr bool finite(double value) { return (__builtin_bit_cast(std::uint64_t, value) >> 52 & 0x7ff) != 0x7ff; }

/// -0.0 and 0.0 are zero; a subnormal is not, whatever the control word says. clang 17 and later would compile the last
/// line as value == 0.0, which is another question where subnormals are read as zero: the empty instruction hides from
/// it where the bits came from.
inline bool zero(double value) {
  auto bits = __builtin_bit_cast(std::uint64_t, value);
  __asm__("" : "+r"(bits));
  return bits << 1 == 0;
}
inline bool negative(double value) { return __builtin_bit_cast(std::int64_t, value) < 0 && !zero(value); }
inline bool same(double a, double b) {
  return __builtin_bit_cast(std::uint64_t, a) == __builtin_bit_cast(std::uint64_t, b) || (zero(a) && zero(b));
}
/// min <= max, of finite numbers.
inline bool in_order(double min, double max) {
  const auto key = [](double x) {
    const auto bits = __builtin_bit_cast(std::int64_t, x);
    return bits < 0 ? INT64_MIN - bits : bits;
  };
  return key(min) <= key(max);
}

template <class Real>
bool zero(const Real& value) {
  return value == 0;
}
template <class Real>
bool negative(const Real& value) {
  return value < 0;
}
template <class Real>
bool same(const Real& a, const Real& b) {
  return a == b;
}
template <class Real>
bool in_order(const Real& min, const Real& max) {
  return min <= max;
}

template <class Real>
bool positive(const Real& value) {
  return !zero(value) && !negative(value);
}
/// The vector of length 0.
template <class Vector>
bool still(const Vector& v) {
  return with_members(v, [](const auto&... coordinate) { return (zero(coordinate) && ...); });
}
template <class Point>
bool same_position(const Point& p, const Point& q) {
  if constexpr (requires { p.z; }) {
    if (!same(p.z, q.z)) return false;
  }
  return same(p.x, q.x) && same(p.y, q.y);
}

/// Decides whether the last position of a ring repeats the first, as GeoJSON, WKT and editors write rings. Such a
/// position is no vertex: it is dropped, once, so that every other keeps its index. -0.0 equals 0.0.
template <class Ring>
bool closed(const Ring& ring) {
  return ring.size() > 1 && same_position(ring.front(), ring.back());
}
template <class Ring>
bool fewer_than_three(const Ring& ring) {
  return ring.size() < 3 || (ring.size() == 3 && closed(ring));
}

}  // namespace touchstone::validation

/// Rules of numbers, vectors and lists, each with the words that refuse. A struct says in its own body which rules it
/// has, in the order in which they are asked, for every number type:
///
///   bool rules(const auto& check) const { return check("radius", rule::radius(radius)); }
///
/// `check.part("sphere", sphere)` asks the rules of a member. A struct without `rules` has those of its members.
namespace touchstone::rule {

struct Outcome {
  bool holds;
  const char* words;
};

inline constexpr auto mass = [](const auto& m) { return Outcome{validation::positive(m), "mass > 0"}; };
inline constexpr auto inverse_mass = [](const auto& w) {
  return Outcome{!validation::negative(w), "inverse mass >= 0"};
};
inline constexpr auto timestep = [](const auto& h) { return Outcome{validation::positive(h), "timestep > 0"}; };
inline constexpr auto restitution = []<class Real>(const Real& e) {
  return Outcome{!validation::negative(e) && validation::in_order(e, Real(1)), "between 0 and 1"};
};
inline constexpr auto radius = [](const auto& r) { return Outcome{!validation::negative(r), "radius >= 0"}; };
inline constexpr auto direction = [](const auto& v) { return Outcome{!validation::still(v), "nonzero direction"}; };
inline constexpr auto normal = [](const auto& n) { return Outcome{!validation::still(n), "nonzero normal"}; };
inline constexpr auto interval = [](const auto& min, const auto& max) {
  return Outcome{validation::in_order(min, max), "min <= max"};
};
inline constexpr auto points = [](const auto& list) { return Outcome{!list.empty(), "at least 1 point"}; };
inline constexpr auto normals = [](const auto& list) { return Outcome{!list.empty(), "at least 1 normal"}; };
inline constexpr auto ring = [](const auto& vertices) {
  return Outcome{!validation::fewer_than_three(vertices), "at least 3 vertices"};
};

/// A rule that takes exact arithmetic: `robust` and `oracle` decide it each in its own way, and refuse by these words.
struct Exact {
  const char *member, *words;
};

}  // namespace touchstone::rule
