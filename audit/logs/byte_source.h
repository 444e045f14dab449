// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "audit/engines/process.h"

namespace touchstone::audit {

/// The bytes of a file, or of standard input for "-", holding no more of them than requested. Files compressed by gzip
/// or zstd are decompressed by these programs.
class ByteSource {
 public:
  /// Throws LogError with the file's name if it cannot be read, or if the program that decompresses it is missing.
  explicit ByteSource(const std::string& file);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// The next bytes, at least `size` unless the source ends before; valid until the next call.
  std::string_view peek(std::size_t size);
  void skip(std::size_t size) { begin_ += size, position_ += size; }
  /// The next line without its end, and whether it had one; nullopt at the end of the source. Throws LogError if
  /// a line is longer than most_bytes.
  struct Line {
    std::string_view text;
    bool ended;
  };
  std::optional<Line> line();

  /// The number of bytes read.
  std::uint64_t position() const { return position_; }
  /// The reason why the compressed bytes ended early; empty if they did not.
  const std::string& broken() const { return broken_; }

  /// For a line, or a frame of the binary form.
  static constexpr std::size_t most_bytes = std::size_t{1} << 28;

 private:
  bool fill();
  bool read_file(std::string& bytes);
  bool read_decompressed();
  void end_of_decompressed();

  std::string file_;
  int descriptor_ = -1;
  std::string compressed_;  ///< bytes not yet passed to the process
  std::string_view outbox_;
  std::string program_;
  std::unique_ptr<Process> process_;
  std::string buffer_, broken_;
  std::size_t begin_ = 0;
  std::uint64_t position_ = 0;
  bool file_ended_ = false, ended_ = false;
};

}  // namespace touchstone::audit
