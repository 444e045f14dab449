// SPDX-License-Identifier: Apache-2.0
#include "proptests/infrastructure/arithmetic/results.h"

#include <gmpxx.h>
#include <mpfr.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <utility>

#include "catalogue/families/draw_stream.h"

/// TOUCHSTONE_RESULTS names the arithmetic that the headers above are.
namespace touchstone::proptests::arithmetic_results::TOUCHSTONE_RESULTS {
namespace {

using catalogue::DrawStream;

/// Where carries run, quotients are guessed wrong, and words of 32 and 64 bits end.
std::uint64_t piece(DrawStream& draws) {
  static constexpr std::uint32_t hard[]{0, 1, 2, 0x7fffffff, 0x80000000, 0x80000001, 0xfffffffe, 0xffffffff};
  return draws.below(4) == 0 ? draws.below(std::uint64_t{1} << 32) : hard[draws.below(8)];
}

mpz_class natural(DrawStream& draws, std::uint64_t most_pieces) {
  std::vector<std::uint64_t> limbs(1 + draws.below(most_pieces) / 2);
  const bool random = draws.below(3) == 0;
  for (std::uint64_t& limb : limbs) {
    limb = random ? draws.any_bits() : piece(draws);
    if (!random) limb |= piece(draws) << 32;
  }
  limbs.back() >>= draws.below(64);
  mpz_class n;
  mpz_import(n.get_mpz_t(), limbs.size(), -1, 8, 0, 0, limbs.data());
  return n;
}

mpz_class integer(DrawStream& draws, std::uint64_t most_pieces) {
  mpz_class n = natural(draws, most_pieces);
  if (draws.coin()) n = -n;
  return n;
}

mpz_class nonzero(DrawStream& draws, std::uint64_t most_pieces) {
  const mpz_class n = integer(draws, most_pieces);
  return sgn(n) == 0 ? mpz_class(1) : n;
}

std::int64_t small(DrawStream& draws, std::int64_t most) {
  return static_cast<std::int64_t>(draws.below(2 * static_cast<std::uint64_t>(most) + 1)) - most;
}

/// A dividend and a divisor that is not 0.
std::pair<mpz_class, mpz_class> couple(DrawStream& draws) {
  const std::uint64_t length = draws.below(8) == 0 ? 60 : 14;
  mpz_class a = integer(draws, length), b = nonzero(draws, length);
  switch (draws.below(7)) {
    case 0: a = b * integer(draws, length), a += small(draws, 2); break;
    case 1: b = a, b += small(draws, 2); break;
    case 2: {  // Fibonacci's neighbours, on which Euclid takes the most steps
      a = 1, b = 1;
      for (std::uint64_t steps = draws.below(900); steps > 0; --steps) a += b, std::swap(a, b);
      break;
    }
    case 3: {
      const mpz_class common = nonzero(draws, length);
      a *= common, b *= common;
      break;
    }
    case 4: b = mpz_class(1) << draws.below(200); break;
    default: break;
  }
  if (sgn(b) == 0) b = 1;
  return {a, b};
}

std::string text(const mpz_class& n) { return n.get_str(16); }
std::string text(double x) {
  std::array<char, 40> written{};
  std::snprintf(written.data(), written.size(), "%a", x);
  return written.data();
}

struct Found {
  Results results;

  void operator()(const char* what, const mpz_class& n) { results.push_back({what, text(n)}); }
  void rational(const char* what, const mpq_class& q) {
    results.push_back({what, text(q.get_num()) + "/" + text(q.get_den())});
  }
  void number(const char* what, double x) { results.push_back({what, text(x)}); }
  void count(const char* what, std::uint64_t n) { results.push_back({what, std::to_string(n)}); }
  void sign(const char* what, int n) { results.push_back({what, n < 0 ? "-" : n > 0 ? "+" : "0"}); }
  void told(const char* what, const std::string& words) { results.push_back({what, words}); }
};

void divisions(Found& found, const mpz_class& a, const mpz_class& b, DrawStream& draws) {
  const mpz_class product = a * b;
  mpz_class q, r;
  found("quotient", a / b), found("rest", a % b);
  mpz_tdiv_qr(q.get_mpz_t(), r.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  found("tdiv_qr", q), found("its rest", r);
  mpz_fdiv_qr(q.get_mpz_t(), r.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  found("fdiv_qr", q), found("its rest", r);
  q = a, r = b;
  mpz_tdiv_qr(q.get_mpz_t(), r.get_mpz_t(), q.get_mpz_t(), r.get_mpz_t());
  found("tdiv_qr in place", q), found("its rest", r);
  mpz_fdiv_q(q.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  found("fdiv_q", q);
  mpz_cdiv_q(q.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  found("cdiv_q", q);
  mpz_divexact(q.get_mpz_t(), product.get_mpz_t(), b.get_mpz_t());
  found("divexact", q);
  found.count("divisible", mpz_divisible_p(a.get_mpz_t(), b.get_mpz_t()) != 0);
  found.count("product divisible", mpz_divisible_p(product.get_mpz_t(), b.get_mpz_t()) != 0);
  found.count("fdiv_ui", mpz_fdiv_ui(a.get_mpz_t(), 1 + (draws.any_bits() >> draws.below(64)) / 2));
  q = a, q /= b, found("divided in place", q);
  q = b, q /= q, found("divided by itself", q);
  q = a, q %= b, found("rest in place", q);
  found("gcd", gcd(a, b)), found("lcm", lcm(a, b));
  const mpz_class three = 3;
  found.count("times 3", a == 0 ? 0 : mpz_remove(q.get_mpz_t(), product.get_mpz_t(), three.get_mpz_t()));
  found("without 3", a == 0 ? mpz_class(0) : q);
}

void roots(Found& found, const mpz_class& a, DrawStream& draws) {
  mpz_class near = a * a, root, rest;
  near += small(draws, 1);
  for (const mpz_class& n : {mpz_class(abs(a)), mpz_class(abs(near))}) {
    mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), n.get_mpz_t());
    found("root", root), found("its rest", rest), found("sqrt", sqrt(n));
    found.count("square", mpz_perfect_square_p(n.get_mpz_t()) != 0);
    const std::uint64_t degree = 1 + draws.below(5);
    found.count("exact root", mpz_root(root.get_mpz_t(), n.get_mpz_t(), degree) != 0);
    found("root of a degree", root);
  }
  found.count("negative square", mpz_perfect_square_p(mpz_class(-1 - abs(a)).get_mpz_t()) != 0);
}

void bits(Found& found, const mpz_class& a, DrawStream& draws) {
  const std::uint64_t by = draws.below(3) == 0 ? 32 * draws.below(9) : draws.below(300);
  mpz_class r;
  found("up", a << by), found("down", a >> by);
  mpz_tdiv_q_2exp(r.get_mpz_t(), a.get_mpz_t(), by), found("tdiv_q_2exp", r);
  mpz_fdiv_q_2exp(r.get_mpz_t(), a.get_mpz_t(), by), found("fdiv_q_2exp", r);
  mpz_tdiv_r_2exp(r.get_mpz_t(), a.get_mpz_t(), by), found("tdiv_r_2exp", r);
  mpz_mul_2exp(r.get_mpz_t(), a.get_mpz_t(), by), found("mul_2exp", r);
  r = abs(a), mpz_setbit(r.get_mpz_t(), by), found("setbit", r);
  found.count("popcount", mpz_popcount(a.get_mpz_t())), found.count("size", mpz_sizeinbase(a.get_mpz_t(), 2));
  found.count("zeros", sgn(a) == 0 ? 0 : mpz_scan1(a.get_mpz_t(), 0)),
      found.count("odd", mpz_odd_p(a.get_mpz_t()) != 0);
  found.count("ui", a.get_ui()), found.count("limb", mpz_getlimbn(a.get_mpz_t(), static_cast<int>(draws.below(4))));
  found("masked", a & mpz_class(draws.any_bits() >> draws.below(64)).get_ui());
  if (mpz_sizeinbase(a.get_mpz_t(), 2) < 63) found.told("si", std::to_string(a.get_si()));
}

void texts(Found& found, const mpz_class& a, const mpz_class& b) {
  found.told("decimal", a.get_str());
  mpz_class r;
  found.count("read", r.set_str(a.get_str(), 10) == 0), found("decimal read", r);
  found.count("read", r.set_str(b.get_str(16), 16) == 0), found("hexadecimal read", r);
  found.count("refused", r.set_str("12x", 10) != 0 && r.set_str("", 10) != 0 && r.set_str("-", 10) != 0);
  found.number("double", a.get_d());
  std::int64_t exponent = 0;
  const double digits = mpz_get_d_2exp(&exponent, a.get_mpz_t());
  found.number("digits", digits), found.told("exponent", std::to_string(exponent));
}

double drawn_double(DrawStream& draws) {
  for (;;) {
    const auto x = std::bit_cast<double>(draws.any_bits());
    if (!std::isfinite(x)) continue;
    if (draws.coin()) return x;
    return std::ldexp(std::frexp(x, std::array<int, 1>{}.data()), static_cast<int>(draws.below(140)) - 70);
  }
}

mpq_class rational(DrawStream& draws) {
  switch (draws.below(4)) {
    case 0: return mpq_class(drawn_double(draws));
    case 1: return mpq_class(integer(draws, 6));
    default: {
      const mpz_class above = integer(draws, 12);
      mpq_class q(above, draws.coin() ? nonzero(draws, 12) : mpz_class(mpz_class(1) << draws.below(100)));
      q.canonicalize();
      return q;
    }
  }
}

/// A rational as near to another as a denominator of its own lets it be: the two products of the comparison are nearly
/// equal, while the lengths of their factors often are not.
mpq_class neighbour_of(const mpq_class& a, DrawStream& draws) {
  const mpz_class below = abs(nonzero(draws, 12));
  mpz_class above = a.get_num() * below;
  mpz_fdiv_q(above.get_mpz_t(), above.get_mpz_t(), a.get_den_mpz_t());
  above += small(draws, 1);
  mpq_class q(above, below);
  q.canonicalize();
  return q;
}

/// digits and exponent of what is not 0
void found_number(Found& found, const char* what, mpfr_srcptr x) {
  mpz_class digits;
  const auto exponent = mpfr_get_z_2exp(digits.get_mpz_t(), x);
  found.told(what, sgn(digits) == 0 ? "0" : text(digits) + "*2^" + std::to_string(exponent));
}

constexpr mpfr_rnd_t modes[]{MPFR_RNDN, MPFR_RNDZ, MPFR_RNDU, MPFR_RNDD};

class Number {
 public:
  explicit Number(std::uint64_t precision) { mpfr_init2(value_, static_cast<mpfr_prec_t>(precision)); }
  ~Number() { mpfr_clear(value_); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  mpfr_ptr operator*() { return value_; }

 private:
  mpfr_t value_;
};

std::uint64_t precision(DrawStream& draws) { return 2 + draws.below(draws.below(20) == 0 ? 1500 : 200); }

/// An integer of at most that size, times a power of two.
void draw_dyadic(mpfr_ptr x, DrawStream& draws, std::int64_t most, std::int64_t most_exponent) {
  const std::int64_t n = small(draws, most);
  mpfr_set_si_2exp(x, n, static_cast<int>(small(draws, most_exponent)), MPFR_RNDN);
}

/// An angle of any size, or one near a multiple of a quarter turn.
void draw_angle(mpfr_ptr x, DrawStream& draws) {
  if (draws.below(3) == 0) {
    mpfr_const_pi(x, modes[draws.below(4)]);
    Number times(64);
    draw_dyadic(*times, draws, 40, 3);
    mpz_class n;
    mpfr_get_z_2exp(n.get_mpz_t(), *times);
    if (sgn(n) != 0) mpfr_div(x, x, *times, MPFR_RNDN);
    return;
  }
  const mpq_class q(integer(draws, 5));
  mpfr_set_q(x, q.get_mpq_t(), MPFR_RNDN);
  const std::uint64_t by = draws.below(draws.below(10) == 0 ? 900 : 180);
  if (draws.below(3) == 0) mpfr_mul_2ui(x, x, by / 4, MPFR_RNDN);
  else mpfr_div_2ui(x, x, by, MPFR_RNDN);
}

}  // namespace

Results integers(std::uint64_t seed) {
  DrawStream draws = DrawStream::seeded(seed);
  Found found;
  const auto [a, b] = couple(draws);
  found("a", a), found("b", b);
  found("sum", a + b), found("difference", a - b), found("product", a * b), found("negative", -a);
  mpz_class r = a;
  r += r, found("twice", r), r = a, r -= r, found("nothing", r), r = a, r *= r, found("square", r);
  r = a, mpz_addmul(r.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t()), found("addmul", r);
  r = b, mpz_submul(r.get_mpz_t(), a.get_mpz_t(), r.get_mpz_t()), found("submul", r);
  r = a, ++r, found("next", r), r = a, --r, found("last", r);
  found.sign("cmp", cmp(a, b)), found.sign("cmp abs", cmp(abs(a), abs(b))), found.count("equal", a == b);
  mpz_pow_ui(r.get_mpz_t(), b.get_mpz_t(), draws.below(6)), found("power", r);
  const double x = drawn_double(draws);
  found("of a double", mpz_class(x));
  divisions(found, a, b, draws);
  roots(found, a, draws);
  bits(found, a, draws);
  texts(found, a, b);
  return found.results;
}

Results rationals(std::uint64_t seed) {
  DrawStream draws = DrawStream::seeded(seed);
  Found found;
  mpq_class a = rational(draws), b = rational(draws);
  switch (draws.below(5)) {
    case 0: b = a + mpq_class(1, mpz_class(1) << draws.below(70)); break;
    case 1: b = neighbour_of(a, draws); break;
    default: break;
  }
  if (sgn(b) == 0) b = 1;
  found.rational("a", a), found.rational("b", b);
  found.rational("sum", a + b), found.rational("difference", a - b), found.rational("product", a * b),
      found.rational("quotient", a / b);
  found.rational("nothing", a - a), found.rational("one", b / b), found.rational("negative", -a),
      found.rational("absolute", abs(a));
  found.sign("cmp", cmp(a, b)), found.count("less", a < b), found.count("equal", a == b);
  found("integer", mpz_class(a)), found.number("double", a.get_d());
  const std::uint64_t by = draws.below(200);
  found.rational("up", a << by), found.rational("down", a >> by), found.told("text", a.get_str());
  mpq_class tiny(b);
  tiny >>= 900 + draws.below(300);
  found.number("tiny double", tiny.get_d());
  const auto digits = [&found](const char* what, const mpf_class& x) {
    for (const std::size_t most : {1, 4, 8}) {  // with 17 GMP's are not rounded to nearest where a half is near
      mp_exp_t exponent = 0;
      const std::string text = x.get_str(exponent, 10, most);
      found.told(what, text + " " + std::to_string(exponent));
    }
    std::array<char, 64> text{};
    gmp_snprintf(text.data(), text.size(), "%.4Fg", x.get_mpf_t());
    found.told("general", text.data());
  };
  const mpf_class x(a, 256), y(b, 256);
  digits("digits", x), digits("sum", mpf_class(x + y)), digits("product", mpf_class(x * y));
  digits("quotient", mpf_class(x / y)), digits("root", mpf_class(sqrt(mpf_class(abs(x)))));
  return found.results;
}

Results rounded(std::uint64_t seed) {
  DrawStream draws = DrawStream::seeded(seed);
  Found found;
  const mpfr_rnd_t mode = modes[draws.below(4)];
  const std::uint64_t of_a = precision(draws), of_b = precision(draws), of_r = precision(draws);
  Number a(of_a), b(of_b), r(of_r), s(of_r);
  // Often halfway between two results, or a little beside.
  mpz_class n = (mpz_class(1) << of_r) + 1, quotient;
  n += natural(draws, 2) << 2;
  const mpq_class q = draws.coin() ? mpq_class(n) : rational(draws);
  mpfr_set_q(*r, q.get_mpq_t(), mode), found_number(found, "of a rational", *r);
  mpfr_set_z(*r, n.get_mpz_t(), mode), found_number(found, "of an integer", *r);
  mpfr_set_q(*a, rational(draws).get_mpq_t(), MPFR_RNDN), mpfr_set_q(*b, rational(draws).get_mpq_t(), MPFR_RNDN);
  found_number(found, "a", *a), found_number(found, "b", *b);
  mpfr_add(*r, *a, *b, mode), found_number(found, "sum", *r);
  mpz_class digits_of_b;
  mpfr_get_z_2exp(digits_of_b.get_mpz_t(), *b);
  if (sgn(digits_of_b) != 0) mpfr_div(*r, *a, *b, mode), found_number(found, "quotient", *r);
  draw_dyadic(*s, draws, 1000, 3);
  mpfr_get_z(quotient.get_mpz_t(), *s, MPFR_RNDN), found("nearest integer", quotient);
  const mpz_class square = draws.coin() ? mpz_class(n * n) : n;
  Number root(mpz_sizeinbase(square.get_mpz_t(), 2) + 2);
  mpfr_set_z(*root, square.get_mpz_t(), MPFR_RNDN);
  mpfr_sqrt(*r, *root, mode), found_number(found, "root", *r);
  mpfr_const_pi(*r, mode), found_number(found, "pi", *r);
  draw_angle(*a, draws);
  found_number(found, "angle", *a);
  mpfr_sin(*r, *a, mode), found_number(found, "sine", *r);
  mpfr_cos(*r, *a, mode), found_number(found, "cosine", *r);
  mpfr_sin_cos(*r, *s, *a, mode), found_number(found, "sine of both", *r), found_number(found, "cosine of both", *s);
  Number across(64), along(64);
  draw_dyadic(*across, draws, 3, 100), draw_dyadic(*along, draws, 3, 100);
  if (draws.coin()) mpfr_set_q(*across, rational(draws).get_mpq_t(), MPFR_RNDN);
  mpz_class up, right;
  mpfr_get_z_2exp(up.get_mpz_t(), *across), mpfr_get_z_2exp(right.get_mpz_t(), *along);
  if (sgn(up) != 0 || sgn(right) != 0) mpfr_atan2(*r, *across, *along, mode), found_number(found, "arc tangent", *r);
  // 1 - x or x - 1, or between.
  mpq_class x(natural(draws, 4), (mpz_class(1) << 140) + 1);
  x.canonicalize();
  if (draws.coin()) x = 1 - (x >> draws.below(200));
  if (x > 1) x = 1 / x;
  if (draws.coin()) x = -x;
  Number cosine(300);
  mpfr_set_q(*cosine, x.get_mpq_t(), MPFR_RNDZ);
  mpfr_acos(*r, *cosine, mode), found_number(found, "arc cosine", *r);
  return found.results;
}

}  // namespace touchstone::proptests::arithmetic_results::TOUCHSTONE_RESULTS
