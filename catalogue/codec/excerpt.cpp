// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/excerpt.h"

#include <algorithm>

namespace touchstone::catalogue {
namespace {

unsigned byte(char c) { return static_cast<unsigned char>(c); }

/// The length in bytes of the first character if it may be printed as it is; 0 if not. Control characters of ASCII, and
/// those from U+0080 to U+009F, may not.
std::size_t printable(std::string_view text) {
  const unsigned first = byte(text[0]);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(text[i]) & 0xc0) != 0x80) return 0;
  }
  return first == 0xc2 && byte(text[1]) < 0xa0 ? 0 : length;
}

}  // namespace

std::string excerpt(std::string_view text, std::size_t most) {
  constexpr const char* digits = "0123456789abcdef";
  std::string shown;
  std::size_t at = 0;
  while (at < std::min(text.size(), most)) {
    const std::size_t length = printable(text.substr(at));
    if (length == 0) {
      const unsigned code = byte(text[at]);
      shown += {'\\', 'x', digits[code >> 4], digits[code & 15]};
    }
    shown += text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return at < text.size() ? shown + "... (" + std::to_string(text.size()) + " bytes)" : shown;
}

}  // namespace touchstone::catalogue
