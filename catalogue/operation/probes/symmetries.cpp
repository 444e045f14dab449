// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/symmetries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "catalogue/numbers/ulps.h"

namespace touchstone::catalogue {
namespace {

/// A linear map, row by row, then a translation; in the plane the third row and column are ignored.
struct Map {
  std::array<std::array<int, 3>, 3> rows;
  std::array<int, 3> shift{};
  int factor = 1;  ///< factor of lengths; 0 if it is not a similarity

  bool reflects(std::size_t dimension) const {
    const auto& [a, b, c] = rows;
    const int plane = a[0] * b[1] - a[1] * b[0];
    if (dimension == 2) return plane < 0;
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) <
           0;
  }
};

constexpr Map axis_maps[] = {
    {{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}},  {{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}},
    {{{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}},   {{{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}},
    {{{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}}, {{{{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}}}},
};
/// Only in space: these mix z with the others.
constexpr Map space_axis_maps[] = {{{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}}, {{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}}};
constexpr Map similarity_maps[] = {
    {{{{3, -4, 0}, {4, 3, 0}, {0, 0, 5}}}, {7, -11, 13}, 5},
    {{{{-5, 12, 0}, {12, 5, 0}, {0, 0, 13}}}, {1000000, -1, 3}, 13},
};
constexpr Map affine_maps[] = {
    {{{{1, 3, 0}, {0, 1, 0}, {0, 2, 1}}}, {7, -11, 5}, 0},
    {{{{2, -1, 1}, {1, 2, 0}, {0, 1, 3}}}, {-1000000, 1000000, 17}, 0},
    {{{{1, 2, 0}, {2, 1, 0}, {0, 0, 1}}}, {3, 5, -7}, 0},
    {{{{5, -4, 0}, {3, 5, 1}, {1, 0, 4}}}, {12345, 67890, 1}, 0},
};

/// 0 times infinity is 0 here: an answer beyond the range has an image too.
double times(int factor, double number) { return factor == 0 ? 0 : factor * number; }
TrueNumber times(int factor, const TrueNumber& number) { return TrueNumber(mpq_class(factor)) * number; }
double plus(double a, double b) { return a + b; }
TrueNumber plus(const TrueNumber& a, const TrueNumber& b) { return a + b; }

/// Changes the numbers of an encoded value by their meaning.
template <class Real>
class Changed {
 public:
  Changed(EncodedValue<Real>& encoded, const Shape& shape, const Laws& laws)
      : encoded_(encoded), laws_(laws), shape_(shape) {}

  void map(const Map& by) {
    map_ = &by;
    place_ = word_ = 0;
    walk(shape_);
  }
  /// Changes every position, displacement and length.
  void lengths(const std::function<Real(const Real&)>& change) {
    change_ = change;
    map_ = nullptr;
    place_ = word_ = 0;
    walk(shape_);
  }

 private:
  void walk(const Shape& shape) {
    switch (shape.kind) {
      case Shape::Kind::number: return number(shape);
      case Shape::Kind::word: return word(shape);
      case Shape::Kind::flag:
      case Shape::Kind::index: ++word_; return;
      case Shape::Kind::optional:
        if (encoded_.words[word_++] != 0) walk(*shape.parts[0].shape);
        return;
      case Shape::Kind::list:
        for (Word left = encoded_.words[word_++]; left > 0; --left) walk(*shape.parts[0].shape);
        return;
      case Shape::Kind::choice: {
        const Word which = encoded_.words[word_++];
        return walk(*shape.parts[which].shape);
      }
      case Shape::Kind::record: break;
    }
    const std::size_t first = place_;
    const bool vector = shape.meaning == Meaning::place || shape.meaning == Meaning::direction;
    if (vector && map_ != nullptr) {
      image(shape.parts.size(), shape.meaning == Meaning::place);
      place_ += shape.parts.size();
      return;
    }
    for (const Shape::Part& part : shape.parts) {
      const std::size_t before = place_;
      walk(*part.shape);
      if (map_ != nullptr && is_sorted(part.name)) in_order(before, (place_ - before) / 2, true);
    }
    const bool box = shape.parts.size() == 2 && std::strcmp(shape.parts[0].name, "min") == 0;
    if (map_ != nullptr && box) in_order(first, (place_ - first) / 2, false);
  }

  void number(const Shape& shape) {
    Real& number = encoded_.numbers[place_++];
    if (map_ == nullptr) {
      if (shape.meaning != Meaning::number) number = change_(number);
    } else if (shape.meaning == Meaning::length) {
      number = times(map_->factor, number);
    }
  }

  void word(const Shape& shape) {
    Word& word = encoded_.words[word_++];
    if (map_ == nullptr || !map_->reflects(dimension_)) return;
    const std::string now = shape.words[word];
    for (const auto& [one, other] : laws_.reflected) {
      const std::string to = now == one ? other : now == other ? one : "";
      for (std::size_t i = 0; i < shape.words.size(); ++i) {
        if (to == shape.words[i]) word = static_cast<Word>(i);
      }
    }
  }

  void image(std::size_t dimension, bool moved) {
    std::array<Real, 3> before;
    for (std::size_t i = 0; i < dimension; ++i) before[i] = encoded_.numbers[place_ + i];
    for (std::size_t i = 0; i < dimension; ++i) {
      Real sum = times(map_->rows[i][0], before[0]);
      for (std::size_t j = 1; j < dimension; ++j) sum = plus(sum, times(map_->rows[i][j], before[j]));
      encoded_.numbers[place_ + i] = moved ? plus(sum, Real(map_->shift[i])) : sum;
    }
  }

  bool is_sorted(const char* name) const {
    return std::any_of(laws_.sorted.begin(), laws_.sorted.end(),
                       [name](const char* sorted) { return std::strcmp(sorted, name) == 0; });
  }

  /// Sorts two points from `first` on: in lexicographic order, or coordinate by coordinate.
  void in_order(std::size_t first, std::size_t dimension, bool as_wholes) {
    const auto a = encoded_.numbers.begin() + static_cast<std::ptrdiff_t>(first);
    const auto b = a + static_cast<std::ptrdiff_t>(dimension);
    if (as_wholes) {
      if (std::lexicographical_compare(b, b + static_cast<std::ptrdiff_t>(dimension), a, b)) std::swap_ranges(a, b, b);
      return;
    }
    for (std::size_t i = 0; i < dimension; ++i) {
      if (b[static_cast<std::ptrdiff_t>(i)] < a[static_cast<std::ptrdiff_t>(i)])
        std::swap(a[static_cast<std::ptrdiff_t>(i)], b[static_cast<std::ptrdiff_t>(i)]);
    }
  }

 public:
  void dimension(std::size_t of_question) { dimension_ = of_question; }

 private:
  EncodedValue<Real>& encoded_;
  const Laws& laws_;
  const Shape& shape_;
  const Map* map_ = nullptr;
  std::function<Real(const Real&)> change_;
  std::size_t place_ = 0, word_ = 0, dimension_ = 2;
};

/// The dimension of the first point or vector of a question.
std::size_t dimension_of(const Shape& shape, const Question& question) {
  if (shape.kind == Shape::Kind::choice) return dimension_of(*shape.parts[question.words[0]].shape, question);
  if (shape.meaning == Meaning::place || shape.meaning == Meaning::direction) return shape.parts.size();
  for (const Shape::Part& part : shape.parts) {
    if (const std::size_t found = dimension_of(*part.shape, question)) return found;
  }
  return 0;
}

template <class Real>
EncodedValue<Real> mapped(EncodedValue<Real> encoded, const Shape& shape, const Laws& laws, const Map& map,
                          std::size_t dimension) {
  Changed<Real> changed(encoded, shape, laws);
  changed.dimension(dimension);
  changed.map(map);
  return encoded;
}

/// The parts of a record, each an encoded value of its own.
template <class Real>
std::vector<EncodedValue<Real>> parts_of(const Shape& record, const EncodedValue<Real>& encoded) {
  struct Collected {
    EncodedValue<Real> part{};
    void number(const Shape&, const Cursor<Real>& at) { part.numbers.push_back(*at.number); }
    void word(const Shape&, const Cursor<Real>& at) { part.words.push_back(*at.word); }
  };
  std::vector<EncodedValue<Real>> parts;
  Cursor<Real> at(encoded);
  for (const Shape::Part& part : record.parts) {
    Collected collected;
    walk_encoded(*part.shape, at, collected);
    parts.push_back(std::move(collected.part));
  }
  return parts;
}
template <class Real>
EncodedValue<Real> joined(const std::vector<EncodedValue<Real>>& parts) {
  EncodedValue<Real> encoded;
  for (const EncodedValue<Real>& part : parts) {
    encoded.numbers.insert(encoded.numbers.end(), part.numbers.begin(), part.numbers.end());
    encoded.words.insert(encoded.words.end(), part.words.begin(), part.words.end());
  }
  return encoded;
}

Question exchanged(const Shape& shape, const Question& question, const Laws::Exchange& exchange) {
  if (shape.kind == Shape::Kind::choice) {
    Question inner = question;
    inner.words.erase(inner.words.begin());
    Question found = exchanged(*shape.parts[question.words[0]].shape, inner, exchange);
    found.words.insert(found.words.begin(), question.words[0]);
    return found;
  }
  auto parts = parts_of(shape, question);
  std::swap(parts[exchange.first], parts[exchange.second]);
  return joined(parts);
}

template <class Real>
EncodedValue<Real> exchanged(const Shape& shape, const EncodedValue<Real>& answer,
                             const std::vector<Laws::Words>& members) {
  if (members.empty() || shape.kind != Shape::Kind::record) return answer;
  auto parts = parts_of(shape, answer);
  const auto place = [&shape](const char* name) {
    const auto found = std::find_if(shape.parts.begin(), shape.parts.end(),
                                    [name](const Shape::Part& part) { return std::strcmp(part.name, name) == 0; });
    if (found == shape.parts.end()) return shape.parts.size();
    return static_cast<std::size_t>(found - shape.parts.begin());
  };
  for (const auto& [one, other] : members) {
    if (std::max(place(one), place(other)) < parts.size()) std::swap(parts[place(one)], parts[place(other)]);
  }
  return joined(parts);
}

/// True if every number is an integer of at most 40 bits, so that the maps of lattice questions do not round.
bool on_lattice(const Question& question) {
  return std::all_of(question.numbers.begin(), question.numbers.end(),
                     [](double n) { return std::fabs(n) <= 0x1p40 && n == std::trunc(n); });
}

/// Positions and lengths of rounded answers differ from those of the image: they are all set to 0.
template <class Real>
void forget_lengths(EncodedValue<Real>& encoded, const Shape& shape, const Laws& laws) {
  Changed<Real>(encoded, shape, laws).lengths([](const Real&) { return Real(0); });
}

/// Rounding commutes with scaling as long as no number is subnormal, or may have been before it was rounded, or is
/// infinite.
bool scaled_number(double n, double found, int k) {
  if (std::fabs(n) < 0x1p-1021) return std::fabs(found) <= std::ldexp(0x1p-1021, k);
  if (std::isinf(n)) return true;
  const double expected = std::ldexp(n, k);
  return found == expected || (std::fabs(expected) < 0x1p-1021 && std::fabs(found) < 0x1p-1021);
}
bool scaled_number(const TrueNumber& n, const TrueNumber& found, int k) {
  return found == TrueNumber(exact_value(std::ldexp(1, k))) * n;
}

/// Marks the numbers of an answer that are lengths.
template <class Real>
std::vector<bool> lengths_in(const Shape& shape, const EncodedValue<Real>& answer) {
  struct Marks {
    std::vector<bool> length{};
    void number(const Shape& of, const Cursor<Real>&) { length.push_back(of.meaning != Meaning::number); }
    void word(const Shape&, const Cursor<Real>&) {}
  } marks;
  Cursor<Real> at(answer);
  walk_encoded(shape, at, marks);
  return marks.length;
}

template <class Real>
bool scaled(const Shape& shape, const EncodedValue<Real>& answer, const EncodedValue<Real>& found, int k) {
  if (answer.words != found.words) return false;
  const std::vector<bool> length = lengths_in(shape, answer);
  for (std::size_t i = 0; i < length.size(); ++i) {
    const bool right =
        length[i] ? scaled_number(answer.numbers[i], found.numbers[i], k) : found.numbers[i] == answer.numbers[i];
    if (!right) return false;
  }
  return true;
}

Question times_two_to(const RowFunctions& row, Question question, int k) {
  if (row.scale != nullptr) {
    row.scale(question, k);
  } else {
    for (double& number : question.numbers) number = std::ldexp(number, k);
  }
  return question;
}

/// If only decisions count, no number of an answer does.
template <class Real>
bool alike(const EncodedValue<Real>& a, const EncodedValue<Real>& b, Compared compared) {
  return compared == Compared::decisions ? a.words == b.words : a == b;
}

template <class Real>
std::string broken(const Operation& operation, const Question& question, const Answering<Real>& ask, const Shape& shape,
                   Compared compared) {
  const RowFunctions& row = operation.row();
  const Laws& laws = row.laws;
  EncodedValue<Real> answer;
  try {
    answer = ask(question);
  } catch (const InvalidInput&) {
    return "";
  }
  for (const Laws::Exchange& exchange : laws.exchanges) {
    const EncodedValue<Real> found = ask(exchanged(*row.question, question, exchange));
    if (!alike(found, exchanged(shape, answer, exchange.members), compared)) return "arguments exchanged";
  }
  if (laws.scales) {
    for (const int k : {1, -29, 300, -300, 1000, -1000}) {
      const Question larger = times_two_to(row, question, k);
      if (times_two_to(row, larger, -k) != question) continue;
      const EncodedValue<Real> found = ask(larger);
      if (compared == Compared::decisions ? found.words != answer.words : !scaled(shape, answer, found, k))
        return "times a power of two";
    }
  }
  if (laws.maps == Laws::Maps::none) return "";
  const std::size_t dimension = dimension_of(*row.question, question);
  const auto image_is_wrong = [&](const Map& map, bool rounds) {
    EncodedValue<Real> found = ask(mapped(question, *row.question, laws, map, dimension)),
                       expected = mapped(answer, shape, laws, map, dimension);
    if (rounds && std::is_same_v<Real, double>) {
      forget_lengths(found, shape, laws);
      forget_lengths(expected, shape, laws);
    }
    return !alike(found, expected, compared);
  };
  for (const Map& map : axis_maps) {
    if (image_is_wrong(map, false)) return "a symmetry of the axes";
  }
  if (dimension == 3) {
    for (const Map& map : space_axis_maps) {
      if (image_is_wrong(map, false)) return "a symmetry of the axes";
    }
  }
  if (!on_lattice(question) || laws.maps == Laws::Maps::axes) return "";
  for (const Map& map : similarity_maps) {
    if (image_is_wrong(map, true)) return "an integer similarity";
  }
  if (laws.maps != Laws::Maps::affine) return "";
  for (const Map& map : affine_maps) {
    if (image_is_wrong(map, true)) return "an integer map";
  }
  return "";
}

}  // namespace

bool declares_laws(const Operation& operation) {
  const Laws& laws = operation.row().laws;
  return !operation.metadata().is_implementation() &&
         (laws.maps != Laws::Maps::none || laws.scales || !laws.exchanges.empty());
}

std::string broken_law(const Operation& operation, const Question& question, const Answering<double>& ask,
                       const Shape& answer, Compared compared) {
  return broken<double>(operation, question, ask, answer, compared);
}

std::string broken_law(const Operation& operation, const Question& question, const Answering<TrueNumber>& ask) {
  return broken<TrueNumber>(operation, question, ask, operation.answer_shape(), Compared::everything);
}

}  // namespace touchstone::catalogue
