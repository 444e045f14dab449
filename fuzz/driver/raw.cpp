// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "fuzz/driver/target.h"

// Questions as raw doubles in canonical order; numbers and enumerators are encoded alike.
namespace touchstone::fuzz {
namespace {

using catalogue::Shape;
using catalogue::Word;

/// Reads doubles from bytes; those past the end are 0.
class Slots {
 public:
  Slots(Bytes bytes, bool make_finite) : bytes_(bytes), make_finite_(make_finite) {}

  double number() {
    const double number = next();
    if (!make_finite_ || std::isfinite(number)) return number;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) &
                                 ~(std::uint64_t{1} << 62));  // the exponent of 1
  }
  /// Returns an enumerator below `values`.
  Word word(std::uint64_t values) {
    const double slot = next();
    return slot >= 1 && slot < 0x1p32 ? static_cast<Word>(static_cast<std::uint64_t>(slot) % values) : 0;
  }
  /// No list is longer than the number of slots left.
  Word length() {
    const double slot = next();
    const auto left = static_cast<double>((bytes_.size() + sizeof(double) - 1) / sizeof(double));
    return slot > 0 ? static_cast<Word>(std::min(slot, left)) : 0;  // NaN: 0
  }

 private:
  double next() {
    double slot = 0;
    const std::size_t size = std::min(sizeof slot, bytes_.size());
    if (size > 0) std::memcpy(&slot, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return slot;
  }

  Bytes bytes_;
  bool make_finite_;
};

void read(const Shape& shape, Slots& slots, Question& question) {
  const auto word = [&](std::uint64_t values) {
    question.words.push_back(slots.word(values));
    return question.words.back();
  };
  switch (shape.kind) {
    case Shape::Kind::number: question.numbers.push_back(slots.number()); return;
    case Shape::Kind::word: word(shape.words.size()); return;
    case Shape::Kind::flag: word(2); return;
    case Shape::Kind::index: word(std::uint64_t{1} << 32); return;
    case Shape::Kind::optional:
      if (word(2) != 0) read(*shape.parts[0].shape, slots, question);
      return;
    case Shape::Kind::choice: {
      const Word which = word(shape.parts.size());
      return read(*shape.parts[which].shape, slots, question);
    }
    case Shape::Kind::list: {
      const Word length = slots.length();
      question.words.push_back(length);
      for (Word i = 0; i < length; ++i) read(*shape.parts[0].shape, slots, question);
      return;
    }
    case Shape::Kind::record:
      for (const Shape::Part& part : shape.parts) read(*part.shape, slots, question);
  }
}

struct Writer {
  std::vector<std::uint8_t>& data;
  void append(double slot) {
    data.resize(data.size() + sizeof slot);
    std::memcpy(data.data() + data.size() - sizeof slot, &slot, sizeof slot);
  }
  void number(const Shape&, const catalogue::Cursor<double>& at) { append(*at.number); }
  void word(const Shape&, const catalogue::Cursor<double>& at) { append(*at.word); }
};

}  // namespace

void decode(const Shape& shape, Bytes rest, bool make_finite, Question& question) {
  question.clear();
  Slots slots(rest, make_finite);
  read(shape, slots, question);
}

void encode(const Shape& shape, const Question& question, std::vector<std::uint8_t>& data) {
  const bool finite = std::all_of(question.numbers.begin(), question.numbers.end(),
                                  [](double number) { return std::isfinite(number); });
  data.clear();
  data.push_back(finite ? finite_numbers_follow : any_numbers_follow);
  Writer writer{data};
  catalogue::Cursor<double> at(question);
  walk_encoded(shape, at, writer);
}

}  // namespace touchstone::fuzz
