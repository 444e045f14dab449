// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "catalogue/families/draw_stream.h"
#include "catalogue/families/numbers.h"
#include "fuzz/driver/layout.h"
#include "fuzz/driver/target.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace touchstone::fuzz {
namespace {

using catalogue::DrawStream;

/// The layout of a question, valid until the next call. It is made once if all questions share it.
const Layout& layout_for(const catalogue::Shape& shape, const Question& question) {
  static thread_local Layout found;
  static thread_local const catalogue::Shape* made_for = nullptr;
  if (!shape.fixed || made_for != &shape) found = layout_of(shape, question);
  made_for = &shape;
  return found;
}

class Mutation {
 public:
  Mutation(const catalogue::Shape& shape, Question& question, DrawStream& draws)
      : question_(question), numbers_(question.numbers), draws_(draws), layout_(layout_for(shape, question)) {}

  void apply() {
    if (!layout_.words.empty() && draws_.below(numbers_.empty() ? 2 : 8) == 0) return change_word();
    if (numbers_.empty()) return grow_or_shrink();
    if (draws_.below(128) == 0) return spoil();
    switch (draws_.below(layout_.lists.empty() ? 12 : 14)) {
      case 0:
      case 1:
      case 2: return nudge();
      case 3:
      case 4: return snap_to_line();
      case 5: return coincide();
      case 6: return copy_number();
      case 7: return small_integer();
      case 8: return common_power();
      case 9: return swap_points();
      case 10: return flip_bits();
      case 11: return typed();
      default: return grow_or_shrink();
    }
  }

 private:
  double& any_number() { return numbers_[draws_.below(numbers_.size())]; }
  Layout::Point any_point() { return layout_.points[draws_.below(layout_.points.size())]; }
  /// Another point of the same dimension, or the same point.
  Layout::Point any_point_like(const Layout::Point& p) {
    const Layout::Point q = any_point();
    return q.dimension == p.dimension ? q : p;
  }

  void nudge() {
    double& number = any_number();
    const int ulps = 1 + static_cast<int>(draws_.below(3));
    if (std::isfinite(number)) number = catalogue::moved_by_ulps(number, draws_.below(2) == 1 ? -ulps : ulps);
  }

  /// r = p + k/8 (q - p), rounded: mostly next to the line, sometimes on it.
  void snap_to_line() {
    if (layout_.points.size() < 2) return nudge();
    const auto p = any_point(), q = any_point_like(p), r = any_point_like(p);
    const double t = (static_cast<double>(draws_.below(25)) - 8) / 8;
    for (std::size_t i = 0; i < r.dimension; ++i) {
      numbers_[r.first + i] = numbers_[p.first + i] + t * (numbers_[q.first + i] - numbers_[p.first + i]);
    }
  }

  void coincide() {
    if (layout_.points.size() < 2) return copy_number();
    const auto p = any_point(), q = any_point_like(p);
    for (std::size_t i = 0; i < q.dimension; ++i) numbers_[q.first + i] = numbers_[p.first + i];
  }

  void change_word() {
    const Layout::Choosable word = layout_.words[draws_.below(layout_.words.size())];
    question_.words[word.place] = static_cast<catalogue::Word>(draws_.below(word.values));
  }

  /// Duplicates or removes one element of a list.
  void grow_or_shrink() {
    if (layout_.lists.empty()) return;
    const Layout::List& list = layout_.lists[draws_.below(layout_.lists.size())];
    catalogue::Word& length = question_.words[list.length];
    if (length == 0) {
      length = 1;
      return insert_zeros(*list.element, question_, list.elements[0]);
    }
    const std::size_t which = draws_.below(length);
    const Layout::Place first = list.elements[which], last = list.elements[which + 1];
    const bool shrink = draws_.below(2) == 1;
    length += shrink ? static_cast<catalogue::Word>(-1) : 1;
    repeat_or_erase(numbers_, first.number, last.number, shrink);
    repeat_or_erase(question_.words, first.word, last.word, shrink);
  }
  template <class T>
  static void repeat_or_erase(std::vector<T>& values, std::size_t first, std::size_t last, bool erase) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(last);
    if (erase) {
      values.erase(begin, end);
    } else {
      const std::vector<T> copied(begin, end);
      values.insert(begin, copied.begin(), copied.end());
    }
  }

  void copy_number() {
    const double copied = any_number();
    any_number() = draws_.below(4) == 3 ? -copied : copied;
  }

  void small_integer() { any_number() = catalogue::small_integer(draws_); }
  void typed() { any_number() = catalogue::typed(draws_); }

  void common_power() {
    const int power =
        draws_.below(2) == 1 ? static_cast<int>(draws_.below(2098)) - 1074 : static_cast<int>(draws_.below(21)) - 10;
    for (double& number : numbers_) {
      const double multiplied = std::ldexp(number, power);
      if (std::isfinite(multiplied)) number = multiplied;
    }
  }

  void swap_points() {
    if (layout_.points.size() < 2) return std::swap(any_number(), any_number());
    const auto p = any_point(), q = any_point_like(p);
    for (std::size_t i = 0; i < p.dimension; ++i) std::swap(numbers_[p.first + i], numbers_[q.first + i]);
  }

  void flip_bits() {
    double& number = any_number();
    const auto flipped =
        std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) ^ std::uint64_t{1} << draws_.below(64));
    if (std::isfinite(flipped)) number = flipped;
  }

  void spoil() {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr double numbers[] = {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
    any_number() = numbers[draws_.below(3)];
  }

  Question& question_;
  std::vector<double>& numbers_;
  DrawStream& draws_;
  const Layout& layout_;
};

}  // namespace

/// Draws a question of some family. A question that has become numbers never returns to draws, so without this step
/// families would rarely be asked. A mesh takes hundreds of bytes.
void draw_afresh(DrawStream& draws, std::vector<std::uint8_t>& result) {
  result.resize(1 + draws.below(draws.one_in(4) ? 400 : 48));
  for (std::uint8_t& byte : result) byte = static_cast<std::uint8_t>(draws.below(256));
  result[0] = static_cast<std::uint8_t>(draws.below(target().operation().families().size()));
}

bool mutated(Bytes data, unsigned seed, std::vector<std::uint8_t>& result) {
  DrawStream draws = DrawStream::seeded(seed);
  const std::uint64_t kind = draws.below(16);
  if (kind < 2) return false;
  if (kind < 5) {
    draw_afresh(draws, result);
    return true;
  }
  static thread_local Question question;
  target().decode(data, question);
  for (double& number : question.numbers)
    number = std::isfinite(number) ? number : 0;  // a refused question has descendants that are valid
  const catalogue::Shape& shape = target().operation().question_shape();
  for (std::uint64_t left = 1 + draws.below(3); left > 0; --left) Mutation(shape, question, draws).apply();
  encode(shape, question, result);
  return true;
}

}  // namespace touchstone::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  static thread_local std::vector<std::uint8_t> result;
  if (!touchstone::fuzz::mutated({data, size}, seed, result) || result.size() > max_size) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  std::memcpy(data, result.data(), result.size());
  return result.size();
}
