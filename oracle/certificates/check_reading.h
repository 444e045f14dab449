// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace touchstone::certify {

using nlohmann::json;
using Rational = mpq_class;

/// Why a claim is not accepted.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline Rational square(const Rational& x) { return Rational(x * x); }
/// Whether its root is rational.
bool is_square(const Rational& x);

/// The element of a list, as a refusal names it.
inline std::string numbered(const std::string& what, std::size_t i) { return what + "[" + std::to_string(i) + "]"; }

inline void expect(bool holds, const std::string& reason) {
  if (!holds) throw Refusal(reason);
}

inline constexpr const char* wrong_kind = "certificate: no such kind for this truth";

/// A position or a displacement.
struct Pair {
  Rational x, y;
};

inline bool operator==(const Pair& p, const Pair& q) { return p.x == q.x && p.y == q.y; }
inline Pair operator-(const Pair& p, const Pair& q) { return {Rational(p.x - q.x), Rational(p.y - q.y)}; }
inline Rational dot(const Pair& p, const Pair& q) { return Rational(p.x * q.x + p.y * q.y); }
inline Rational cross(const Pair& p, const Pair& q) { return Rational(p.x * q.y - p.y * q.x); }
inline Pair along(const Pair& from, const Rational& t, const Pair& step) {
  return {Rational(from.x + t * step.x), Rational(from.y + t * step.y)};
}

struct Ends {
  Pair a, b;
};

struct Ray {
  Pair origin, direction;
};

struct Circle {
  Pair center;
  Rational radius;
};

void array_of_two(const json& value, const std::string& what);
/// An object of which every key has to be named, and every name has to be there.
void only(const json& object, const std::string& what, std::initializer_list<const char*> names);

/// Input, by the field's name; `what` is how the field is called in a refusal. Each checks the rules of its shape.
Rational number(const json& value, const std::string& what);
Pair point(const json& value, const std::string& what);
Ends segment(const json& value, const std::string& what);
Ends line_of_two_points(const json& value, const std::string& what);
Ray ray(const json& value, const std::string& what);
Circle circle(const json& value, const std::string& what);
std::vector<Pair> polygon(const json& value, const std::string& what);

/// A ring without a last position that repeats the first: it is dropped once.
template <class Position>
std::vector<Position> open_ring(std::vector<Position> ring, const std::string& what) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  expect(ring.size() >= 3, what + ": at least 3 vertices");
  return ring;
}

/// Exact values of the truth and of the certificate. What doubles make of each other in any operation has far fewer
/// digits; a limit keeps one line from taking minutes.
void expect_not_too_long(const std::string& exact, const std::string& what);
Rational exact_value(const json& value, const std::string& what);
Pair exact_pair(const json& value, const std::string& what);

/// What one operation's check sees.
struct Claim {
  const json& input;
  const json& truth;
  const json& certificate;

  /// Every check says first which fields the input has, in the order of the contract: of all their numbers the first
  /// that is not finite is refused before any other rule.
  void inputs(std::initializer_list<const char*> names) const;
  void answers(std::initializer_list<const char*> names) const { only(truth, "truth", names); }
  std::string word(const char* name) const;
  std::string kind() const;
  void expect_kind(const char* only) const { expect(kind() == only, wrong_kind); }
  /// Says which facts the certificate holds beside its kind.
  void facts(std::initializer_list<const char*> names) const;
  Rational single(const char* name) const;
  Pair pair(const char* name) const;
  std::vector<Rational> list(const char* name) const;
};

/// Returns where the certificate proves the truth and throws Refusal otherwise.
using Check = void (*)(const Claim&);
/// By operation. A file check_NAME.cpp ends with `Checks checks_of_NAME()`: the build makes the table of all from that
/// line.
using Checks = std::map<std::string, Check>;

}  // namespace touchstone::certify
