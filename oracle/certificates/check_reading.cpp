// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_reading.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace touchstone::certify {
namespace {

Rational times_power_of_two(const Rational& value, std::int64_t exponent) {
  Rational result;
  if (exponent >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

/// Reads the bits of a double, so that no floating-point environment matters.
Rational from_double(double value, const std::string& what) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const std::int64_t field = static_cast<std::int64_t>(bits >> 52 & 0x7ff);
  expect(field != 0x7ff, what + ": finite number");
  const std::uint64_t fraction = bits & 0xfffffffffffff;
  const Rational magnitude(mpz_class(field == 0 ? fraction : fraction | std::uint64_t{1} << 52));
  const Rational result = times_power_of_two(magnitude, (field == 0 ? 1 : field) - 1075);
  return bits >> 63 ? Rational(-result) : result;
}

/// True for a value whose denominator is a power of two.
bool binary64(const Rational& value) {
  if (sgn(value) == 0) return true;
  const mpz_class& numerator = value.get_num();
  const mpz_class& denominator = value.get_den();
  const std::int64_t low = static_cast<std::int64_t>(mpz_scan1(numerator.get_mpz_t(), 0));
  const std::int64_t high = static_cast<std::int64_t>(mpz_sizeinbase(numerator.get_mpz_t(), 2));
  const std::int64_t scale = static_cast<std::int64_t>(mpz_sizeinbase(denominator.get_mpz_t(), 2)) - 1;
  return high - low <= 53 && low - scale >= -1074 && high - scale <= 1024;
}

bool digits(const std::string& text, const char* allowed) {
  return !text.empty() && text.find_first_not_of(allowed) == std::string::npos;
}

/// [sign] 0x digits [. digits] [p [sign] digits], and exactly a binary64 number.
Rational from_hexadecimal(const std::string& text, const std::string& what) {
  const std::string malformed = what + ": a number or a hexadecimal float string";
  std::string rest = text;
  const bool negative = rest.starts_with('-');
  if (negative || rest.starts_with('+')) rest.erase(0, 1);
  expect(rest.starts_with("0x") || rest.starts_with("0X"), malformed);
  rest.erase(0, 2);
  std::int64_t exponent = 0;
  if (const auto p = rest.find_first_of("pP"); p != std::string::npos) {
    std::string power = rest.substr(p + 1);
    const bool below = power.starts_with('-');
    if (below || power.starts_with('+')) power.erase(0, 1);
    expect(digits(power, "0123456789") && power.size() <= 5, malformed);
    exponent = below ? -std::stoll(power) : std::stoll(power);
    rest.erase(p);
  }
  if (const auto dot = rest.find('.'); dot != std::string::npos) {
    exponent -= 4 * static_cast<std::int64_t>(rest.size() - dot - 1);
    rest.erase(dot, 1);
  }
  expect(digits(rest, "0123456789abcdefABCDEF") && rest.size() <= 1000, malformed);
  const Rational value = times_power_of_two(Rational(mpz_class(rest, 16)), exponent);
  expect(binary64(value), what + ": a binary64 number");
  return negative ? Rational(-value) : value;
}

bool not_finite(const json& value) { return value == "inf" || value == "-inf" || value == "nan"; }

/// The rank of a member among those of its shape. They are in alphabetical order, except for these.
std::pair<std::size_t, std::string> rank(const std::string& member) {
  constexpr std::array first{"origin",       "min",      "vertices", "mass",    "inertia",
                             "inverse_mass", "position", "velocity", "segment", "outer"};
  const auto found = std::find(first.begin(), first.end(), member);
  return {static_cast<std::size_t>(found - first.begin()), member};
}

/// Checks an entire field, in the order of its shape.
void expect_finite(const json& value, const std::string& what) {
  expect(!not_finite(value), what + ": finite number");
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) expect_finite(value[i], what + "[" + std::to_string(i) + "]");
  } else if (value.is_object()) {
    std::vector<std::pair<std::size_t, std::string>> members;
    for (const auto& [name, part] : value.items()) members.push_back(rank(name));
    std::sort(members.begin(), members.end());
    for (const auto& [place, name] : members) expect_finite(value[name], what + "." + name);
  }
}

}  // namespace

void array_of_two(const json& value, const std::string& what) {
  expect(value.is_array() && value.size() == 2, what + ": a list of two");
}

bool is_square(const Rational& x) {
  return mpz_perfect_square_p(x.get_num_mpz_t()) != 0 && mpz_perfect_square_p(x.get_den_mpz_t()) != 0;
}

void only(const json& object, const std::string& what, std::initializer_list<const char*> names) {
  expect(object.is_object(), what + ": an object");
  for (const char* name : names) expect(object.contains(name), what + ": field " + name + " is missing");
  expect(object.size() == names.size(), what + ": an unexpected field");
}

Rational number(const json& value, const std::string& what) {
  expect(!not_finite(value), what + ": finite number");
  if (value.is_string()) return from_hexadecimal(value.get_ref<const std::string&>(), what);
  expect(value.is_number(), what + ": a number or a hexadecimal float string");
  return from_double(value.get<double>(), what);
}

Pair point(const json& value, const std::string& what) {
  array_of_two(value, what);
  return {number(value[0], what + "[0]"), number(value[1], what + "[1]")};
}

Ends segment(const json& value, const std::string& what) {
  array_of_two(value, what);
  return {point(value[0], what + "[0]"), point(value[1], what + "[1]")};
}

Ends line_of_two_points(const json& value, const std::string& what) {
  const Ends ends = segment(value, what);
  expect(!(ends.a == ends.b), what + ": two distinct points");
  return ends;
}

Ray ray(const json& value, const std::string& what) {
  only(value, what, {"origin", "direction"});
  const Ray result{point(value["origin"], what + ".origin"), point(value["direction"], what + ".direction")};
  expect(sgn(result.direction.x) != 0 || sgn(result.direction.y) != 0, what + ".direction: nonzero direction");
  return result;
}

Circle circle(const json& value, const std::string& what) {
  only(value, what, {"center", "radius"});
  const Circle result{point(value["center"], what + ".center"), number(value["radius"], what + ".radius")};
  expect(sgn(result.radius) >= 0, what + ".radius: radius >= 0");
  return result;
}

std::vector<Pair> polygon(const json& value, const std::string& what) {
  expect(value.is_array(), what + ": a list of vertices");
  std::vector<Pair> ring;
  for (const json& vertex : value) ring.push_back(point(vertex, numbered(what, ring.size())));
  return open_ring(std::move(ring), what);
}

void expect_not_too_long(const std::string& exact, const std::string& what) {
  expect(exact.size() <= 100'000, what + ": at most 100000 characters");
}

Rational exact_value(const json& value, const std::string& what) {
  const std::string malformed = what + ": an exact value \"p/q\"";
  expect(value.is_string(), malformed);
  std::string numerator = value.get<std::string>(), denominator = "1";
  expect_not_too_long(numerator, what);
  if (const auto bar = numerator.find('/'); bar != std::string::npos) {
    denominator = numerator.substr(bar + 1);
    numerator.erase(bar);
  }
  const bool negative = numerator.starts_with('-');
  if (negative) numerator.erase(0, 1);
  expect(digits(numerator, "0123456789") && digits(denominator, "0123456789"), malformed);
  const mpz_class below(denominator, 10);
  expect(sgn(below) != 0, malformed);
  Rational result(mpz_class(numerator, 10), below);
  result.canonicalize();
  return negative ? Rational(-result) : result;
}

Pair exact_pair(const json& value, const std::string& what) {
  array_of_two(value, what);
  return {exact_value(value[0], what + "[0]"), exact_value(value[1], what + "[1]")};
}

void Claim::inputs(std::initializer_list<const char*> names) const {
  only(input, "input", names);
  for (const char* name : names) expect_finite(input[name], name);
}

std::string Claim::word(const char* name) const {
  expect(truth.is_object() && truth.contains(name) && truth[name].is_string(),
         std::string("truth: field ") + name + " is missing");
  return truth[name].get<std::string>();
}

std::string Claim::kind() const {
  expect(certificate.is_object() && certificate.contains("kind") && certificate["kind"].is_string(),
         "certificate: field kind is missing");
  return certificate["kind"].get<std::string>();
}

void Claim::facts(std::initializer_list<const char*> names) const {
  for (const char* name : names) {
    expect(certificate.contains(name), std::string("certificate: field ") + name + " is missing");
  }
  expect(certificate.size() == names.size() + 1, "certificate: an unexpected field");
}

Rational Claim::single(const char* name) const {
  const json& list = certificate[name];
  const std::string what = std::string("certificate.") + name;
  expect(list.is_array() && list.size() == 1, what + ": a list of one");
  return exact_value(list[0], what + "[0]");
}

std::vector<Rational> Claim::list(const char* name) const {
  const std::string what = std::string("certificate.") + name;
  expect(certificate[name].is_array(), what + ": a list");
  std::vector<Rational> values;
  for (const json& value : certificate[name])
    values.push_back(exact_value(value, what + "[" + std::to_string(values.size()) + "]"));
  return values;
}

std::vector<Claim> Claim::proofs(const char* name) const {
  const json& list = certificate[name];
  expect(list.is_array(), std::string("certificate.") + name + ": a list");
  std::vector<Claim> found;
  for (const json& proof : list) found.push_back({input, truth, proof});
  return found;
}

Pair Claim::pair(const char* name) const { return exact_pair(certificate[name], std::string("certificate.") + name); }

}  // namespace touchstone::certify
