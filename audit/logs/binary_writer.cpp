// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <tuple>

#include "audit/logs/little_endian.h"
#include "audit/logs/log_form.h"

namespace touchstone::audit {
namespace {

/// The size of a block of calls in bytes.
constexpr std::size_t block_size = std::size_t{1} << 16;

/// True if a number is the same as a float. For NaN, including its sign and payload.
bool is_float(double number) {
  const double back = static_cast<float>(number);
  return std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(number);
}

bool are_floats(const EncodedValue<double>& value) {
  return std::all_of(value.numbers.begin(), value.numbers.end(), is_float);
}

class BinaryWriter : public LogWriter {
 public:
  explicit BinaryWriter(std::ostream& out) : LogWriter(out) { out_ << binary_magic << static_cast<char>(log_version); }

  void header(const LogHeader& header) override {
    binary32_ = header.declaration.binary32;
    write_frame(Frame::header, one_line(header.fields));
  }

  void write(const RecordedCall& call, const std::string& site) override {
    const bool floats = call.binary32 && are_floats(call.question) && are_floats(call.answer.value);
    append_varint(identifier(call, site, floats), calls_);
    const Shape& question = call.operation->question_shape();
    append(call.question, question.fixed, floats);
    switch (call.answer.kind) {
      case RecordedAnswer::Kind::plain: append_varint(call.answer.value.words[0], calls_); break;
      case RecordedAnswer::Kind::whole: append(call.answer.value, call.operation->answer_shape().fixed, floats); break;
      case RecordedAnswer::Kind::partial: append(call.answer.value, false, floats); break;
      case RecordedAnswer::Kind::text:
      case RecordedAnswer::Kind::error: append_varint(call.answer.text.size(), calls_); calls_ += call.answer.text;
    }
    if (calls_.size() >= block_size) flush();
  }

  void end(const LogEnd& end) override {
    flush();
    write_frame(Frame::end, one_line(json_of(end)));
  }

  void flush() override {
    if (!calls_.empty()) write_frame(Frame::calls, calls_);
    calls_.clear();
  }

 private:
  void write_frame(Frame kind, std::string_view text) {
    std::string head(1, static_cast<char>(kind));
    append_varint(text.size(), head);
    out_ << head << text;
  }

  void append(const EncodedValue<double>& value, bool fixed, bool floats) {
    if (!fixed) append_varint(value.words.size(), calls_), append_varint(value.numbers.size(), calls_);
    for (const Word word : value.words) append_varint(word, calls_);
    for (const double number : value.numbers) {
      if (floats) append_little_endian(std::bit_cast<std::uint32_t>(static_cast<float>(number)), calls_);
      else append_little_endian(std::bit_cast<std::uint64_t>(number), calls_);
    }
  }

  /// A declaration is written before the block that first uses it.
  std::size_t identifier(const RecordedCall& call, const std::string& site, bool floats) {
    const Key key{call.operation, site, call.answer.kind, call.binary32, floats};
    const auto [found, is_new] = identifiers_.try_emplace(key, identifiers_.size());
    if (!is_new) return found->second;
    const auto size_of = [](const Shape& shape) { return Json::array({shape.word_count, shape.numbers}); };
    Json declared = {{"id", found->second}, {"op", call.operation->name()}};
    if (!site.empty()) declared["site"] = site;
    if (call.binary32 != binary32_) declared["number"] = number_names[call.binary32];
    if (floats != call.binary32) declared["stored"] = number_names[floats];
    declared["answer"] = answer_names[static_cast<std::size_t>(call.answer.kind)];
    const Shape &question = call.operation->question_shape(), &answer = call.operation->answer_shape();
    if (question.fixed) declared["question_size"] = size_of(question);
    if (call.answer.kind == RecordedAnswer::Kind::whole && answer.fixed) declared["answer_size"] = size_of(answer);
    write_frame(Frame::declaration, one_line(declared));
    return found->second;
  }

  using Key = std::tuple<const Operation*, std::string, RecordedAnswer::Kind, bool, bool>;
  std::map<Key, std::size_t> identifiers_;
  std::string calls_;
  bool binary32_ = false;
};

}  // namespace

std::unique_ptr<LogWriter> binary_writer(std::ostream& out) { return std::make_unique<BinaryWriter>(out); }

}  // namespace touchstone::audit
