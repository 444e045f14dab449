// SPDX-License-Identifier: Apache-2.0
#include "audit/reducing/question_parts.h"

#include <algorithm>

namespace touchstone::audit::reducing {
namespace {

bool is_coordinates(const Shape& shape) {
  return shape.kind == Shape::Kind::record && shape.meaning != Meaning::number && shape.fixed &&
         shape.word_count == 0 && shape.numbers == shape.parts.size();
}

class Finder {
 public:
  Finder(const Question& question, QuestionParts& parts) : question_(question), parts_(parts) {}

  void look(const Shape& shape, bool in_mesh = false, std::size_t axis = 0) {
    switch (shape.kind) {
      case Shape::Kind::number:
        parts_.numbers.push_back({shape.meaning, axis});
        ++at_.number;
        return;
      case Shape::Kind::word:
      case Shape::Kind::flag:
      case Shape::Kind::index:
        if (!in_mesh) parts_.words.push_back({&shape, at_.word});
        ++at_.word;
        return;
      case Shape::Kind::optional: look_at_optional(shape, in_mesh); return;
      case Shape::Kind::list: look_at_list(shape, in_mesh); return;
      case Shape::Kind::choice: look(*shape.parts[question_.words[at_.word++]].shape, in_mesh); return;
      case Shape::Kind::record: break;
    }
    const Position begin = at_;
    const bool is_mesh = shape.form == Form::mesh, coordinates = is_coordinates(shape);
    for (std::size_t i = 0; i < shape.parts.size(); ++i)
      look(*shape.parts[i].shape, in_mesh || is_mesh, coordinates ? i : 0);
    if (is_mesh) parts_.meshes.push_back({begin, at_});
  }

 private:
  void look_at_optional(const Shape& shape, bool in_mesh) {
    const std::size_t flag = at_.word++;
    if (question_.words[flag] == 0) return;
    const std::size_t place = parts_.words.size();
    const Position begin = at_;
    if (!in_mesh) parts_.words.push_back({&shape, flag});
    look(*shape.parts[0].shape, in_mesh);
    if (!in_mesh) parts_.words[place].value = {begin, at_};
  }

  void look_at_list(const Shape& shape, bool in_mesh) {
    const std::size_t place = parts_.lists.size(), length_word = at_.word++;
    if (!in_mesh) parts_.lists.push_back({shape.parts[0].shape, length_word, {}});
    std::vector<Position> begin;
    for (Word left = question_.words[length_word]; left > 0; --left) {
      begin.push_back(at_);
      look(*shape.parts[0].shape, in_mesh);
    }
    begin.push_back(at_);
    if (!in_mesh) parts_.lists[place].begin = std::move(begin);
  }

  const Question& question_;
  QuestionParts& parts_;
  Position at_{};
};

/// Copies a question, leaving out elements that refer to dropped ones.
class Copy {
 public:
  Copy(const Question& from, std::size_t length_word, Word first, Word last)
      : from_(from), length_word_(length_word), first_(first), last_(last) {}

  Question made(const Shape& shape) {
    copy(shape, false);
    return std::move(to_);
  }

 private:
  void copy(const Shape& shape, bool in_mesh) {
    switch (shape.kind) {
      case Shape::Kind::number: to_.numbers.push_back(from_.numbers[at_.number++]); return;
      case Shape::Kind::index: to_.words.push_back(in_mesh ? from_.words[at_.word++] : counted_anew()); return;
      case Shape::Kind::word:
      case Shape::Kind::flag: to_.words.push_back(from_.words[at_.word++]); return;
      case Shape::Kind::optional:
        to_.words.push_back(from_.words[at_.word]);
        if (from_.words[at_.word++] != 0) copy(*shape.parts[0].shape, in_mesh);
        return;
      case Shape::Kind::choice:
        to_.words.push_back(from_.words[at_.word]);
        return copy(*shape.parts[from_.words[at_.word++]].shape, in_mesh);
      case Shape::Kind::record:
        for (const Shape::Part& part : shape.parts) copy(*part.shape, in_mesh || shape.form == Form::mesh);
        return;
      case Shape::Kind::list: break;
    }
    const bool dropped_from = at_.word == length_word_;
    const Word length = from_.words[at_.word++];
    const std::size_t length_place = to_.words.size();
    to_.words.push_back(0);
    for (Word i = 0; i < length; ++i) {
      const Position begin{to_.numbers.size(), to_.words.size()};
      const bool outer = refers_;
      refers_ = false;
      copy(*shape.parts[0].shape, in_mesh);
      if (refers_ || (dropped_from && first_ <= i && i < last_)) {
        to_.numbers.resize(begin.number), to_.words.resize(begin.word);
      } else {
        ++to_.words[length_place];
      }
      refers_ = outer;
    }
  }

  Word counted_anew() {
    const Word index = from_.words[at_.word++];
    refers_ = refers_ || (first_ <= index && index < last_);
    return index < last_ ? index : index - (last_ - first_);
  }

  const Question& from_;
  std::size_t length_word_;
  Word first_, last_;
  Position at_{};
  Question to_{};
  bool refers_ = false;  ///< the element being copied refers to a dropped one
};

template <class T>
void append(const std::vector<T>& from, std::size_t begin, std::size_t end, std::vector<T>& to) {
  to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
            from.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace

QuestionParts parts_of(const Shape& shape, const Question& question) {
  QuestionParts parts;
  Finder(question, parts).look(shape);
  return parts;
}

Question without(const Question& question, const ListPlace& list, std::size_t first, std::size_t last) {
  Question result = with_part(question, {list.begin[first], list.begin[last]}, {});
  result.words[list.length_word] -= static_cast<Word>(last - first);
  return result;
}

Question without_and_referring(const Shape& shape, const Question& question, const ListPlace& list, std::size_t first,
                               std::size_t last) {
  return Copy(question, list.length_word, static_cast<Word>(first), static_cast<Word>(last)).made(shape);
}

Question with_part(const Question& question, const Extent& part, const Question& other) {
  Question result;
  result.numbers.reserve(question.numbers.size() + other.numbers.size());
  result.words.reserve(question.words.size() + other.words.size());
  append(question.numbers, 0, part.begin.number, result.numbers);
  append(other.numbers, 0, other.numbers.size(), result.numbers);
  append(question.numbers, part.end.number, question.numbers.size(), result.numbers);
  append(question.words, 0, part.begin.word, result.words);
  append(other.words, 0, other.words.size(), result.words);
  append(question.words, part.end.word, question.words.size(), result.words);
  return result;
}

}  // namespace touchstone::audit::reducing
