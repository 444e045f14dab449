// SPDX-License-Identifier: Apache-2.0
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/pages/contract.h"
#include "report/parts/html_parts.h"
#include "report/words/formula.h"

/// Formulas of contracts in MathML; what is expected is written by hand.
namespace touchstone::proptests::formula_tests {
namespace {

std::string inside(const std::string& text) {
  const std::string html = formula_in_mathml(text).value_or("none"), opening = "<math display=\"block\">";
  return html == "none" ? html : html.substr(opening.size(), html.rfind("</math>") - opening.size());
}

}  // namespace

TEST_CASE("formulas: what is divided is the product before the stroke, without its parentheses") {
  CHECK(
      inside("t = 2 a / (b + c) d") ==
      "<mi>t</mi><mo>=</mo><mfrac><mrow><mn>2</mn><mi>a</mi></mrow><mrow><mi>b</mi><mo>+</mo><mi>c</mi></mrow></mfrac>"
      "<mi>d</mi>");
  CHECK(inside("t = -a / b") ==
        "<mi>t</mi><mo>=</mo><mo>\u2212</mo><mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac>");
}

TEST_CASE("formulas: short names and fields have an index, primes stand above it, roots and powers are drawn") {
  CHECK(inside("v1' = sqrt(a^2)") ==
        "<msubsup><mi>v</mi><mrow><mn>1</mn></mrow><mo>\u2032</mo></msubsup><mo>=</mo><msqrt><msup><mrow><mi>a</mi>"
        "</mrow><mrow><mn>2</mn></mrow></msup></msqrt>");
  CHECK(inside("a.max < b.min or b") ==
        "<msub><mi>a</mi><mrow><mi>max</mi></mrow></msub><mo>&lt;</mo><msub><mi>b</mi><mrow><mi>min</mi></mrow></msub>"
        "<mtext>&#160;or&#160;</mtext><mi>b</mi>");
}

TEST_CASE("formulas: an x between two factors is a cross product, beside a sign it is a name; a point alone is a dot") {
  CHECK(inside("N = a x b") == "<mi>N</mi><mo>=</mo><mi>a</mi><mo>\u00d7</mo><mi>b</mi>");
  CHECK(inside("E = m x + b") == "<mi>E</mi><mo>=</mo><mi>m</mi><mi>x</mi><mo>+</mo><mi>b</mi>");
  CHECK(inside("E = N . p") == "<mi>E</mi><mo>=</mo><mi>N</mi><mo>\u22c5</mo><mi>p</mi>");
}

TEST_CASE("formulas: prose, and what is not closed, is no formula") {
  for (const char* text :
       {"are its neighbours. If the closed triangle", "no neighbours.", "a = (b", "a = / b", "a + b", "a = #", ""}) {
    INFO(text);
    CHECK(inside(text) == "none");
  }
}

TEST_CASE(
    "formulas: an indented line with an equals sign is one, where a contract says what is asked; and not a few are") {
  std::size_t formulas = 0;
  for (const Operation* operation : all_operations()) {
    const std::string text = contract_of(operation->name()).at(1);
    for (std::size_t at = 0; (at = text.find("\n    ", at)) != std::string::npos; ++at) {
      const std::string line = text.substr(at + 5, text.find('\n', at + 1) - at - 5);
      if (line.find(" = ") == std::string::npos) continue;
      INFO(operation->name() << ": " << line);
      CHECK(formula_in_mathml(line));
      ++formulas;
    }
  }
  CHECK(formulas > 35);
  // Elsewhere words may stand beside it.
  CHECK(paragraph("Rounding:\n    e = u |N| bounds the error\n    of both") ==
        "<p>Rounding:</p><pre>e = u |N| bounds the error</pre><p>    of both</p>");
}

TEST_CASE("formulas: words between backquotes are code") {
  CHECK(words_in_html("a `b<c` d") == "a <code>b&lt;c</code> d");
  CHECK(words_in_html("a `b") == "a <code>b</code>");
}

TEST_CASE("formulas: of a contract's second paragraph the formula and its sentence are shown, the rest is folded") {
  using Parts = std::pair<std::string, std::string>;
  CHECK(formula_and_rest("Deck p. 5: it is\n    a = b;\nleft of 0. a, b: any unit.\nClosed.") ==
        Parts("Deck p. 5: it is\n    a = b;\nleft of 0.", "a, b: any unit.\nClosed."));
  CHECK(formula_and_rest("Deck p. 5:\n    a = b.\na: any unit.") == Parts("Deck p. 5:\n    a = b.", "a: any unit."));
  CHECK(formula_and_rest("Deck p. 44: as on p. 5, squares. The slide ends.") ==
        Parts("Deck p. 44: as on p. 5, squares.", "The slide ends."));
  CHECK(formula_and_rest("It is that of another (p. 48-50, 53). The slide ends.") ==
        Parts("It is that of another (p. 48-50, 53).", "The slide ends."));
  CHECK(formula_and_rest("No page of the deck asks this. The formula is another. Units.") ==
        Parts("No page of the deck asks this. The formula is another.", "Units."));
  CHECK(formula_and_rest("Deck p. 54:\n    a = b,\nwhere (b x c) . N >= 0. a: any unit.") ==
        Parts("Deck p. 54:\n    a = b,\nwhere (b x c) . N >= 0.", "a: any unit."));
  CHECK(formula_and_rest("One sentence") == Parts("One sentence", ""));
}

}  // namespace touchstone::proptests::formula_tests
