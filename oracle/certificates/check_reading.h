// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <initializer_list>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace touchstone::certify {

using nlohmann::json;
using Rational = mpq_class;

/// The reason why a claim is not accepted.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline Rational square(const Rational& x) { return Rational(x * x); }
/// True if its root is rational.
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
/// Requires an object with exactly these keys.
void only(const json& object, const std::string& what, std::initializer_list<const char*> names);

/// Input, by the field's name; `what` names the field in a refusal. Each checks the rules of its shape.
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

/// Exact values of the truth and of the certificate. Results of operations on doubles have far fewer digits; the limit
/// keeps one line from taking minutes.
void expect_not_too_long(const std::string& exact, const std::string& what);
Rational exact_value(const json& value, const std::string& what);
Pair exact_pair(const json& value, const std::string& what);

/// The input of one operation's check.
struct Claim {
  const json& input;
  const json& truth;
  const json& certificate;

  /// Every check first lists the fields of the input, in the order of the contract: the first number that is not finite
  /// is refused before any other rule.
  void inputs(std::initializer_list<const char*> names) const;
  void answers(std::initializer_list<const char*> names) const { only(truth, "truth", names); }
  std::string word(const char* name) const;
  std::string kind() const;
  void expect_kind(const char* only) const { expect(kind() == only, wrong_kind); }
  /// Lists the facts of the certificate besides its kind.
  void facts(std::initializer_list<const char*> names) const;
  Rational single(const char* name) const;
  Pair pair(const char* name) const;
  std::vector<Rational> list(const char* name) const;
  /// The proofs of parts of the claim.
  std::vector<Claim> proofs(const char* name) const;
};

/// Returns if the certificate proves the truth and throws Refusal otherwise.
using Check = std::function<void(const Claim&)>;
/// Checks by operation. A file check_NAME.cpp ends with `Checks checks_of_NAME()`: the build generates the table of all
/// from that line.
using Checks = std::map<std::string, Check>;

}  // namespace touchstone::certify
