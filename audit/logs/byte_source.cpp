// SPDX-License-Identifier: Apache-2.0
#include "audit/logs/byte_source.h"

#include <unistd.h>

#include <cerrno>

#include "audit/logs/recorded_call.h"
#include "audit/platform.h"
#include "catalogue/codec/expected.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t piece = std::size_t{1} << 18;
constexpr std::string_view gzip_magic = "\x1f\x8b", zstd_magic = "\x28\xb5\x2f\xfd";

}  // namespace

ByteSource::ByteSource(const std::string& file) : file_(file == "-" ? "standard input" : file) {
  descriptor_ = file == "-" ? STDIN_FILENO : open_to_read(file);
  if (descriptor_ < 0) throw LogError(file_, why_of(errno));
  while (buffer_.size() < zstd_magic.size() && read_file(buffer_)) continue;
  const std::string_view first = buffer_;
  if (first.substr(0, gzip_magic.size()) == gzip_magic) program_ = "gzip";
  else if (first.substr(0, zstd_magic.size()) == zstd_magic) program_ = "zstd";
  else return;
  compressed_ = std::move(buffer_);
  outbox_ = compressed_;
  buffer_.clear();
  process_ = std::make_unique<Process>(program_ + " -dc");
  fill();
}

ByteSource::~ByteSource() {
  if (descriptor_ > STDIN_FILENO) close(descriptor_);
}

/// Appends the next bytes of the file; returns false at its end.
bool ByteSource::read_file(std::string& bytes) {
  const std::size_t before = bytes.size();
  bytes.resize(before + piece);
  ssize_t count = 0;
  do count = ::read(descriptor_, bytes.data() + before, piece);
  while (count < 0 && errno == EINTR);
  bytes.resize(before + static_cast<std::size_t>(count > 0 ? count : 0));
  if (count < 0) throw LogError(file_, why_of(errno));
  return count > 0;
}

bool ByteSource::read_decompressed() {
  const std::size_t before = buffer_.size();
  while (buffer_.size() == before) {
    if (outbox_.empty() && !file_ended_) {
      compressed_.clear();
      file_ended_ = !read_file(compressed_);
      outbox_ = compressed_;
      if (file_ended_) process_->close_input();
    }
    process_->write(outbox_);
    if (!process_->read(buffer_)) {
      if (buffer_.size() == before) end_of_decompressed();
      return buffer_.size() > before;
    }
    if (buffer_.size() == before && (file_ended_ || !outbox_.empty()))
      process_->wait_for(!outbox_.empty(), std::chrono::steady_clock::now() + std::chrono::seconds(1));
  }
  return true;
}

void ByteSource::end_of_decompressed() {
  const std::string how = process_->end();
  if (how.find("exit code 127") == 0)
    throw LogError(file_, "compressed by " + program_ + ", and there is no program " + program_ + " to read it");
  if (how.find("exit code 0") != 0) broken_ = program_ + " ended with " + how;
}

bool ByteSource::fill() {
  if (ended_) return false;
  buffer_.erase(0, begin_);
  begin_ = 0;
  ended_ = process_ ? !read_decompressed() : !read_file(buffer_);
  return !ended_;
}

std::string_view ByteSource::peek(std::size_t size) {
  while (buffer_.size() - begin_ < size && fill()) continue;
  return std::string_view(buffer_).substr(begin_);
}

std::optional<ByteSource::Line> ByteSource::line() {
  std::size_t without_end = 0;
  while (true) {
    const std::string_view bytes = peek(without_end + 1);
    const std::size_t end = bytes.find('\n', without_end);
    if (end != bytes.npos) {
      skip(end + 1);
      return Line{bytes.substr(0, end), true};
    }
    if (bytes.size() > most_bytes)
      throw LogError(file_, "a line of more than " + std::to_string(most_bytes >> 20) + " MiB");
    if (bytes.size() == without_end) {
      if (bytes.empty()) return std::nullopt;
      skip(bytes.size());
      return Line{bytes, false};
    }
    without_end = bytes.size();
  }
}

}  // namespace touchstone::audit
