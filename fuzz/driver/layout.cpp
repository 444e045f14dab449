// SPDX-License-Identifier: Apache-2.0
#include "fuzz/driver/layout.h"

namespace touchstone::fuzz {
namespace {

using catalogue::Question;
using catalogue::Shape;

/// Most indices are those of a short list.
constexpr std::uint64_t usual_indices = 8;

class Reader {
 public:
  explicit Reader(const Question& question) : words_(question.words.data()) {}

  void read(const Shape& shape) {
    switch (shape.kind) {
      case Shape::Kind::number: ++at_.number; return;
      case Shape::Kind::word: found.words.push_back({at_.word++, shape.words.size()}); return;
      case Shape::Kind::flag: found.words.push_back({at_.word++, 2}); return;
      case Shape::Kind::index: found.words.push_back({at_.word++, usual_indices}); return;
      case Shape::Kind::optional:
        if (words_[at_.word++] != 0) read(*shape.parts[0].shape);
        return;
      case Shape::Kind::choice: {
        const catalogue::Word which = words_[at_.word++];
        return read(*shape.parts[which].shape);
      }
      case Shape::Kind::list: return read_list(shape);
      case Shape::Kind::record:
        if (shape.meaning == Meaning::place || shape.meaning == Meaning::direction)
          found.points.push_back({at_.number, shape.parts.size()});
        for (const Shape::Part& part : shape.parts) read(*part.shape);
    }
  }

  Layout found;

 private:
  void read_list(const Shape& shape) {
    const std::size_t place = found.lists.size();
    found.lists.push_back({at_.word, shape.parts[0].shape, {}});
    const catalogue::Word length = words_[at_.word++];
    for (catalogue::Word i = 0; i < length; ++i) {
      found.lists[place].elements.push_back(at_);
      read(*shape.parts[0].shape);
    }
    found.lists[place].elements.push_back(at_);
  }

  const catalogue::Word* words_;
  Layout::Place at_{0, 0};
};

}  // namespace

Layout layout_of(const Shape& shape, const Question& question) {
  Reader reader(question);
  reader.read(shape);
  return std::move(reader.found);
}

void insert_zeros(const Shape& shape, Question& question, const Layout::Place& at) {
  Question zero;
  append_zeros(shape, 0, zero);
  question.numbers.insert(question.numbers.begin() + static_cast<std::ptrdiff_t>(at.number), zero.numbers.begin(),
                          zero.numbers.end());
  question.words.insert(question.words.begin() + static_cast<std::ptrdiff_t>(at.word), zero.words.begin(),
                        zero.words.end());
}

}  // namespace touchstone::fuzz
