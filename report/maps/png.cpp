// SPDX-License-Identifier: Apache-2.0
#include "report/maps/png.h"

#include <png.h>

#include <stdexcept>

namespace touchstone::report {
namespace {

void append(png_structp file, png_bytep bytes, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(file))->append(reinterpret_cast<const char*>(bytes), size);
}
void nothing_to_flush(png_structp) {}

[[noreturn]] void fail(png_structp, png_const_charp what) { throw std::runtime_error(std::string("png: ") + what); }

struct Writer {
  png_structp file = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_infop info = png_create_info_struct(file);
  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&file, &info); }
};

}  // namespace

std::string png(const Image& image, std::uint32_t scale) {
  std::string bytes;
  Writer writer;
  png_set_write_fn(writer.file, &bytes, append, nothing_to_flush);
  png_set_IHDR(writer.file, writer.info, image.width * scale, image.height * scale, 8, PNG_COLOR_TYPE_PALETTE,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // Fixed, so that the same image gives the same bytes whatever the library's default.
  png_set_compression_level(writer.file, 9);
  png_set_filter(writer.file, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  std::vector<png_color> palette;
  for (const Colour& colour : image.palette) palette.push_back({colour.red, colour.green, colour.blue});
  png_set_PLTE(writer.file, writer.info, palette.data(), static_cast<int>(palette.size()));
  png_write_info(writer.file, writer.info);
  std::vector<std::uint8_t> row(std::size_t{image.width} * scale);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const std::uint8_t* from = image.pixels.data() + std::size_t{y} * image.width;
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = from[x / scale];
    for (std::uint32_t i = 0; i < scale; ++i) png_write_row(writer.file, row.data());
  }
  png_write_end(writer.file, nullptr);
  return bytes;
}

std::string data_uri(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:image/png;base64,";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u;
    };
    const std::uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
    text += digits[three >> 18];
    text += digits[three >> 12 & 63];
    text += i + 1 < bytes.size() ? digits[three >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? digits[three & 63] : '=';
  }
  return text;
}

}  // namespace touchstone::report
