// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/numbers.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <utility>

#include "catalogue/codec/json.h"
#include "catalogue/codec/nearest_double.h"
#include "catalogue/numbers/ulps.h"
#include "proptests/catch.h"
#include "proptests/refusal.h"
#include "proptests/uses.h"

namespace touchstone::proptests::numbers_tests {
namespace {

double as_double(const std::string& typed) { return read_double(parse_line("{\"x\":" + typed + "}")["x"], "x"); }
mpq_class as_exact(const std::string& typed) { return read_exact(parse_line("{\"x\":" + typed + "}")["x"], "x"); }

std::string refused_double(const std::string& typed) {
  return refusal_of([&] { as_double(typed); });
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

}  // namespace

TEST_CASE("numbers: every double reads back bit by bit from its decimal and from its hexadecimal string") {
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < 50000; ++i) {
    DrawStream draws = DrawStream::seeded(seed_of(1, "read back", i));
    const double value = i % 3 == 0 ? any_finite(draws) : i % 3 == 1 ? mixed_exponent(draws) : ordinary(draws);
    if (bits(as_double(decimal(value))) != bits(value)) ++wrong;
    if (bits(as_double('"' + hexadecimal(value) + '"')) != bits(value)) ++wrong;
    if (as_exact('"' + hexadecimal(value) + '"') != exact_value(value)) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(bits(as_double(decimal(-0.0))) == bits(-0.0));
  CHECK(decimal(3) == "3");
  CHECK(decimal(-0.5) == "-0.5");
  CHECK(hexadecimal(3) == "0x1.8p+1");
}

TEST_CASE("numbers: a decimal is read as exactly what was typed, and as the double nearest to it") {
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < 30000; ++i) {
    DrawStream draws = DrawStream::seeded(seed_of(2, "typed", i));
    const std::uint64_t digits = draws.below(std::uint64_t{1} << (1 + draws.below(63)));
    const std::int64_t exponent = static_cast<std::int64_t>(draws.below(640)) - 340;
    const bool negative = draws.below(2) == 1;
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<std::uint64_t>(std::abs(exponent)));
    mpq_class expected = exponent < 0 ? mpq_class(mpz_class(digits), power) : mpq_class(mpz_class(digits) * power);
    expected.canonicalize();
    if (negative) expected = -expected;
    const std::string typed = (negative ? "-" : "") + std::to_string(digits) + "e" + std::to_string(exponent);
    if (as_exact(typed) != expected) ++wrong;
    const double rounded = nearest(expected);
    const bool same = std::isinf(rounded) ? refused_double(typed) == "x: finite number" : as_double(typed) == rounded;
    if (!same) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("numbers: 0.1 is one tenth when asked for exactly") {
  CHECK(as_exact("0.1") == mpq_class(1, 10));
  CHECK(as_exact("-12.50e1") == -125);
  CHECK(as_exact("1e-3") == mpq_class(1, 1000));
  CHECK(as_exact("\"0x1.8p+1\"") == 3);
  CHECK(as_exact("\"-0x.8p-1\"") == mpq_class(-1, 4));
  CHECK(as_double("0.1") != as_exact("0.1"));
}

TEST_CASE("numbers: ties go to the even double, and one digit beyond the tie decides") {
  CHECK(as_double("9007199254740993") == 9007199254740992.0);  // 2^53 + 1, half way
  CHECK(as_double("9007199254740993.0000000001") == 9007199254740994.0);
  CHECK(as_double("9007199254740995") == 9007199254740996.0);
  CHECK(as_double("\"0x1.00000000000008p+0\"") == 1);
  CHECK(as_double("\"0x1.000000000000081p+0\"") == 0x1.0000000000001p+0);
}

TEST_CASE("numbers: beyond the range is refused by its field, below it is a zero that keeps its sign") {
  CHECK(refused_double("1e999") == "x: finite number");
  CHECK(refused_double("-1e309") == "x: finite number");
  // Half way between the greatest double and 2^1024 lies 1.79769313486231580793...e308.
  CHECK(as_double("1.7976931348623158e308") == 0x1.fffffffffffffp+1023);
  CHECK(refused_double("1.7976931348623159e308") == "x: finite number");
  CHECK(refused_double("\"0x1p+1024\"") == "x: finite number");
  CHECK(bits(as_double("1e-400")) == bits(0.0));
  CHECK(bits(as_double("-1e-400")) == bits(-0.0));
  // Half of the least double is 2.47032822920623272088...e-324.
  CHECK(as_double("2.4703282292062327e-324") == 0);
  CHECK(as_double("2.4703282292062328e-324") == 5e-324);
}

TEST_CASE("numbers: NaN and infinities name their field") {
  for (const char* typed : {"NaN", "Infinity", "-Infinity", "\"nan\"", "\"inf\"", "\"-inf\""}) {
    INFO(typed);
    CHECK(refused_double(typed) == "x: finite number");
  }
  const auto answered = [](const std::string& typed) {
    return read_answer_number(parse_line("{\"x\":" + typed + "}")["x"], "x");
  };
  CHECK(std::isnan(answered("\"nan\"")));
  CHECK(answered("\"inf\"") == HUGE_VAL);
  CHECK(answered("\"-inf\"") == -HUGE_VAL);
  CHECK(answered("0.25") == 0.25);
  CHECK(written(std::nan("")) == "nan");
  CHECK(written(-HUGE_VAL) == "-inf");
}

TEST_CASE("numbers: the one reader reads subnormal numbers, tells infinity from 0, and takes nothing but a number") {
  CHECK(nearest_double("1e-310") == 1e-310);
  CHECK(nearest_double("+.5") == 0.5);
  CHECK(nearest_double("-1e400") == -HUGE_VAL);
  CHECK(nearest_double("0.0001e99999999999999999999") == HUGE_VAL);
  CHECK(nearest_double("100e-99999999999999999999") == 0);
  CHECK(nearest_double("-0x1.8p+1", true) == -3);
  CHECK(nearest_double("0xep1024", true) == HUGE_VAL);
  CHECK(nearest_double("0x.0001p-2000", true) == 0);
  for (const char* none : {"", "-", ".", "+-1", "1e", "inf", "nan", "0x1", " 1", "1 "}) CHECK(!nearest_double(none));
  for (const char* none : {"0x", "0x-1", "0xinf", "0x1p", "--0x1"}) CHECK(!nearest_double(none, true));
}

TEST_CASE("numbers: what is no number is refused as one") {
  for (const char* typed : {"01",       "1.",      "1e",          "1e+",  "--1",     "1-2",   "0x1",    "true",
                            "null",     "[]",      "{}",          "\"\"", "\"abc\"", "\"1\"", "\"0x\"", "\"-0x\"",
                            "\"0x1p\"", "\"0xg\"", "\"0x1p+1 \"", "-",    "1.5.5",   "NaNs",  "+1",     ".5"}) {
    INFO(typed);
    // A mark that tells numbers from strings is not shown.
    CHECK(refused_double(typed) == "x: expected a number, got " + std::string(typed));
  }
}

TEST_CASE("numbers: digits inside strings and keys are left alone") {
  const Json line = parse_line(R"({"a1":"2 and \"3\" -4","b":"\\","c":5})");
  CHECK(line["a1"] == "2 and \"3\" -4");
  CHECK(line["b"] == "\\");
  CHECK(is_typed_number(line["c"]));
  CHECK_FALSE(is_typed_number(line["a1"]));
}

TEST_CASE("numbers: exact values are printed as p or p/q") {
  CHECK(written(mpq_class(3, 7)) == "3/7");
  CHECK(written(mpq_class(-4)) == "-4");
}

TEST_CASE("lines: a key given twice and what is no JSON are refused") {
  const auto refused = [](const std::string& text) { return refusal_of([&] { parse_line(text); }); };
  CHECK(refused(R"({"a":1,"a":2})") == "a: given once");
  CHECK(refused(R"({"a":{"b":1,"c":[{"b":2}],"b":3}})") == "a.b: given once");
  CHECK(refused(R"({"a":[{"b":1},{"c":{"d":1,"d":2}}]})") == "a[1].c.d: given once");
  CHECK(refused(R"([{"a":1},{"a":2}])") == "accepted");
  const std::pair<const char*, const char*> all[]{{"", "the text ends in column 1"},
                                                  {"{", "the text ends in column 2"},
                                                  {"[1,2", "the text ends in column 5"},
                                                  {R"({"a":})", R"(unexpected "}" in column 6)"},
                                                  {"{'a':1}", R"(unexpected "'" in column 2)"},
                                                  {"nonsense", R"(unexpected "n" in column 1)"},
                                                  {R"({"a":1} x)", R"(unexpected "x" in column 9)"},
                                                  {R"({"a":1,})", R"(unexpected "}" after a comma in column 8)"},
                                                  {"{\n \"a\": 1.5 x}", R"(unexpected "x" in line 2, column 11)"}};
  for (const auto& [text, why] : all) {
    INFO(text);
    CHECK(refused(text) == std::string("line: not JSON: ") + why);
  }
}

TEST_CASE("lines: what is nested deeper than 64 is refused however deep it is, and costs its line alone") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  for (Json (*const parse)(const std::string&) : {parse_line, parse_own_line}) {
    const auto refused = [parse](const std::string& text) { return refusal_of([&] { parse(text); }); };
    CHECK(refused(nested(64)) == "accepted");
    CHECK(refused("[\"" + std::string(65, '[') + "\"]") == "accepted");
    for (const std::size_t depth : {65u, 100'000u, 1'000'000u}) {
      CHECK(refused(nested(depth)) == "line: nested at most 64 deep");
      CHECK(refused("{\"a\":" + nested(depth) + ",\"b\":1}") == "line: nested at most 64 deep");
      CHECK(refused(std::string(depth, '[')) == "line: nested at most 64 deep");
    }
  }
}

TEST_CASE("lines: a list of objects is read in time that grows with its length alone") {
  const auto list_of = [](std::size_t objects) {
    std::string text = "[{\"a\":1}";
    for (std::size_t i = 1; i < objects; ++i) text += ",{\"a\":1}";
    return text + "]";
  };
  const auto ticks = [](std::size_t times, const std::string& text) {
    const std::clock_t start = std::clock();
    for (std::size_t i = 0; i < times; ++i) parse_line(text);
    return std::clock() - start;
  };
  const std::string few = list_of(2'000), many = list_of(100'000);
  CHECK(ticks(1, many) < 8 * ticks(50, few));  // as many objects: quadratic would be 50 times
}

TEST_CASE("lines: a zero byte ends no line") {
  CHECK(refusal_of([] { parse_line(std::string("{\"a\":1}\0 nonsense", 17)); }) ==
        R"(line: not JSON: unexpected "\x00" in column 8)");
}

}  // namespace touchstone::proptests::numbers_tests
