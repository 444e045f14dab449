// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/uses.h"

namespace touchstone::report {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// An image of at most 256 colours, rows from the top.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<Colour> palette;
  std::vector<std::uint8_t> pixels;  ///< indices into the palette, row by row
};

/// The bytes of a PNG file. Each pixel becomes a square of `scale` pixels.
std::string png(const Image& image, std::uint32_t scale = 1);

/// "data:image/png;base64,..."
std::string data_uri(const std::string& png_bytes);

}  // namespace touchstone::report
