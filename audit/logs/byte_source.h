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

/// The bytes of a file, or of standard input for "-", of which no more are held than somebody looks at. What gzip or
/// zstd compressed is decompressed by these programs.
class ByteSource {
 public:
  /// Throws LogError naming the file where it cannot be read, or the program is missing that decompresses it.
  explicit ByteSource(const std::string& file);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// The next bytes, at least `size` unless the source ends before; they stay until the next call.
  std::string_view peek(std::size_t size);
  void skip(std::size_t size) { begin_ += size, position_ += size; }
  /// The next line without its end, and whether it had one; it is skipped. Empty where the source has ended. Throws
  /// LogError where a line is longer than most_bytes.
  struct Line {
    std::string_view text;
    bool ended;
  };
  std::optional<Line> line();

  /// How many bytes were skipped.
  std::uint64_t position() const { return position_; }
  /// Why the compressed bytes ended before they should; empty where they did not.
  const std::string& broken() const { return broken_; }

  /// Of a line, or of a frame of the binary form.
  static constexpr std::size_t most_bytes = std::size_t{1} << 28;

 private:
  bool fill();
  bool read_file(std::string& bytes);
  bool read_decompressed();
  void end_of_decompressed();

  std::string file_;
  int descriptor_ = -1;
  std::string compressed_;  ///< bytes on their way into the process
  std::string_view outbox_;
  std::string program_;
  std::unique_ptr<Process> process_;
  std::string buffer_, broken_;
  std::size_t begin_ = 0;
  std::uint64_t position_ = 0;
  bool file_ended_ = false, ended_ = false;
};

}  // namespace touchstone::audit
