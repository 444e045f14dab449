// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/excerpt.h"

#include "catalogue/codec/json.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

namespace touchstone::proptests::excerpt_tests {

TEST_CASE("excerpt: letters of any language stay, control characters and broken UTF-8 are escaped") {
  CHECK(excerpt("M\u00f6bius \u6e2c \U0001f600", 100) == "M\u00f6bius \u6e2c \U0001f600");
  CHECK(excerpt(std::string("a\0b\x1b\x7f", 5), 100) == "a\\x00b\\x1b\\x7f");
  CHECK(excerpt("\u0080\u009f\u00a0", 100) == "\\xc2\\x80\\xc2\\x9f\u00a0");
  CHECK(excerpt("\xff\xc0\x80\xe6\xb8", 100) == "\\xff\\xc0\\x80\\xe6\\xb8");
}

TEST_CASE("excerpt: what is longer is cut between characters, and its length is told") {
  CHECK(excerpt("12345", 5) == "12345");
  CHECK(excerpt("123456", 5) == "12345... (6 bytes)");
  CHECK(excerpt("\u6e2c\u6e2c", 1) == "\u6e2c... (6 bytes)");
}

TEST_CASE("one line: text is written so that a terminal shows nothing else") {
  CHECK(one_line("\x7f\u009b\u00f6") == R"("\u007f\u009b\u00f6")");
}

}  // namespace touchstone::proptests::excerpt_tests
