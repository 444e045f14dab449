// SPDX-License-Identifier: Apache-2.0
#include "report/maps/map_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "audit/parallel.h"
#include "catalogue/codec/plain.h"
#include "geometry/invalid_input.h"
#include "report/words/wording.h"

namespace touchstone::report {
namespace {

/// The result of one implementation at one pixel. Answers that are numbers alone are shown by their distance.
struct Shade {
  Verdict verdict = Verdict::unsupported;
  std::string said;
  bool refused = false;
  std::size_t level = words_only;  ///< of the distance in ulps: the greater the distance, the higher
  static constexpr std::size_t words_only = 99;

  bool operator<(const Shade& other) const {
    return std::tie(verdict, said, refused, level) < std::tie(other.verdict, other.said, other.refused, other.level);
  }
};

Shade shade_of_distance(const Judgement& judgement) {
  if (judgement.verdict == Verdict::agree) {
    return judgement.ulps > 0 ? Shade{judgement.verdict, "within the stated bound", false, 1}
                              : Shade{judgement.verdict, "correctly rounded", false, 0};
  }
  // A unit is the last of 53 binary digits or of 24; lost decimal digits are those that its multiples reach.
  const double lost = std::log10(std::max(judgement.ulps, 1.0));
  constexpr std::array<int, distance_levels - 1> digits{1, 2, 4, 7, 10, 15};
  for (std::size_t level = 0; level < digits.size(); ++level) {
    if (lost > digits[level]) continue;
    const std::string words =
        level == 0 ? "up to 1 digit lost" : fmt::format("{} to {} digits lost", digits[level - 1], digits[level]);
    return {judgement.verdict, words, false, level};
  }
  return {judgement.verdict, "more than 15 digits lost", false, digits.size()};
}

/// For an answer with several right ones, and for one whose numbers are not the requested ones, the verdict is
/// sufficient.
template <class Answer>
Shade shade_of(Kind kind, const Judgement& judgement, const std::string& outcome, const Answer& answer) {
  if (outcome == "value") {
    const bool measured =
        judgement.verdict == Verdict::agree ||
        (is_finding(judgement.verdict) && judgement.verdict != Verdict::invalid && judgement.ulps > 0);
    return measured && kind != Kind::checked && kind != Kind::covering ? shade_of_distance(judgement)
                                                                       : Shade{judgement.verdict, ""};
  }
  if (judgement.verdict == Verdict::invalid) return {judgement.verdict, ""};  // it may have answered anything
  const bool decided = judgement.verdict == Verdict::agree || judgement.verdict == Verdict::inexact;
  return {judgement.verdict, decided ? outcome : word_in(answer())};
}

std::vector<Question> questions_of(const MapGrid& grid, int row, int side) {
  std::vector<Question> questions;
  for (int column = 0; column < side; ++column)
    questions.push_back(grid.at(column_of(column, side), row_of(row, side)));
  return questions;
}

struct Plate {
  std::string subject;
  std::vector<Shade> shades;
};

/// A row of the map: its questions, null if the contract refuses one, and the results of reference and robust.
struct PixelRow {
  std::vector<std::unique_ptr<Examination>> examinations;
  std::vector<Shade> reference, robust;
  std::map<std::string, std::uint64_t> outcomes;
};

PixelRow examined(const Operation& operation, const std::vector<Question>& asked, bool binary32) {
  const Kind kind = operation.metadata().kind;
  PixelRow result;
  for (const Question& pixel : asked) {
    try {
      result.examinations.push_back(operation.examine(pixel));
      const Examination& question = *result.examinations.back();
      const std::string outcome = question.outcome();
      if (outcome != "value") ++result.outcomes[outcome];
      result.reference.push_back(
          shade_of(kind, question.judge_reference(binary32), outcome, [&] { return question.reference(binary32); }));
      result.robust.push_back(shade_of(kind, question.judge_robust(), outcome, [&] { return question.robust(); }));
    } catch (const InvalidInput&) {
      result.examinations.push_back(nullptr);
      for (std::vector<Shade>* shades : {&result.reference, &result.robust})
        shades->push_back({Verdict::unsupported, "", true});
    }
  }
  return result;
}

void ask_engine(const Operation& operation, const std::vector<std::unique_ptr<Examination>>& row, Engine& engine,
                std::vector<Shade>& shades) {
  const std::size_t before = shades.size();
  std::vector<Question> questions;
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < row.size(); ++i) {
    shades.push_back({Verdict::unsupported, "", true});
    if (row[i]) questions.push_back(row[i]->question()), pixels.push_back(i);
  }
  engine.ask_each(operation, questions, [&](std::size_t i, const Reply& reply) {
    const Examination& examination = *row[pixels[i]];
    Shade& shade = shades[before + pixels[i]];
    if (reply.kind == Reply::Kind::answered) {
      const Judgement judgement = examination.judge_engine(reply.answer, engine.declaration());
      shade =
          shade_of(operation.metadata().kind, judgement, examination.outcome(), [&] { return plain(reply.answer); });
    } else {
      shade = {reply.kind == Reply::Kind::failed ? Verdict::invalid : Verdict::unsupported, "no answer"};
    }
  });
}

/// Ranks answers by their frequency among the truths, so that all maps of an operation show an answer alike.
std::map<std::string, Rank> ranks_of(const std::map<std::string, std::uint64_t>& outcomes, int side) {
  std::vector<std::pair<std::string, std::uint64_t>> sorted(outcomes.begin(), outcomes.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  const auto rare = static_cast<std::uint64_t>(side * side / 25);
  std::map<std::string, Rank> ranks;
  std::size_t common = 0, uncommon = 0;
  for (const auto& [word, n] : sorted) ranks[word] = n < rare ? Rank{uncommon++, true} : Rank{common++, false};
  return ranks;
}

Look look_in_map(const Shade& shade, std::map<std::string, Rank>& ranks, Scheme scheme) {
  if (shade.level != Shade::words_only)
    return shade.verdict == Verdict::agree ? look_of(shade.verdict, {shade.level, false}, scheme)
                                           : look_of_distance(shade.level, shade.verdict, scheme);
  if (shade.said.empty()) return look_of(shade.verdict, {}, scheme);
  return look_of(shade.verdict, ranks.emplace(shade.said, Rank{ranks.size(), false}).first->second, scheme);
}

FailureMap developed(const MapGrid& grid, int side, const Plate& plate, std::map<std::string, Rank> ranks) {
  FailureMap map;
  map.grid = grid;
  map.side = side;
  map.subject = plate.subject;
  std::map<Shade, std::uint64_t> counts;
  for (const Shade& shade : plate.shades) ++counts[shade];
  std::vector<std::pair<Shade, std::uint64_t>> sorted;
  for (const auto& [shade, n] : counts) {
    if (shade.refused) {
      map.refused += n;
    } else {
      sorted.emplace_back(shade, n);
    }
  }
  // A scale keeps its order.
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    if (a.first.verdict != b.first.verdict) return a.first.verdict < b.first.verdict;
    return a.first.level != b.first.level ? a.first.level < b.first.level : a.second > b.second;
  });
  std::map<Shade, std::uint8_t> index;
  for (const auto& [shade, n] : sorted) {
    index[shade] = static_cast<std::uint8_t>(map.classes.size());
    map.counts[static_cast<std::size_t>(shade.verdict)] += n;
    map.classes.push_back({shade.verdict,
                           shade.said,
                           n,
                           {look_in_map(shade, ranks, Scheme::light), look_in_map(shade, ranks, Scheme::dark)}});
  }
  const auto refused = static_cast<std::uint8_t>(map.classes.size());
  for (const Shade& shade : plate.shades) map.squares.push_back(shade.refused ? refused : index[shade]);
  return map;
}

}  // namespace

std::uint64_t FailureMap::findings() const {
  std::uint64_t sum = 0;
  for (std::size_t v = 0; v < verdict_count; ++v) sum += is_finding(static_cast<Verdict>(v)) ? counts[v] : 0;
  return sum;
}

const FailureMap& subject_of(const std::vector<FailureMap>& maps) { return maps.size() > 2 ? maps[2] : maps[0]; }

std::vector<FailureMap> failure_maps(const Operation& operation, int jobs, bool binary32, Engine* engine,
                                     const std::vector<Question>& candidates, const MapEffort& effort) {
  const bool with_engine = engine && engine->supports(operation.name());
  const MapGrid grid = failing_grid(operation, binary32, with_engine ? engine : nullptr, candidates, effort);
  Declaration ours;
  ours.engine = "reference";
  ours.binary32 = binary32;
  std::vector<Plate> plates{{subject(ours), {}}, {"robust", {}}};
  if (with_engine) plates.push_back({subject(engine->declaration()), {}});
  std::map<std::string, std::uint64_t> outcomes;
  constexpr int together = 16;  // rows; the engine is asked about these, in order, before the next ones
  for (int first = 0; first < effort.side; first += together) {
    if (effort.abandoned()) return {};
    std::vector<PixelRow> rows(together);
    in_parallel(jobs, rows.size(), [&](std::size_t i) {
      rows[i] = examined(operation, questions_of(grid, first + static_cast<int>(i), effort.side), binary32);
      if (!with_engine) rows[i].examinations.clear();
    });
    for (const PixelRow& row : rows) {
      plates[0].shades.insert(plates[0].shades.end(), row.reference.begin(), row.reference.end());
      plates[1].shades.insert(plates[1].shades.end(), row.robust.begin(), row.robust.end());
      for (const auto& [outcome, n] : row.outcomes) outcomes[outcome] += n;
      if (with_engine) ask_engine(operation, row.examinations, *engine, plates[2].shades);
    }
  }
  std::vector<FailureMap> maps;
  for (const Plate& plate : plates)
    maps.push_back(developed(grid, effort.side, plate, ranks_of(outcomes, effort.side)));
  return maps;
}

Image image_of(const FailureMap& map, Scheme scheme) {
  constexpr auto side = static_cast<std::size_t>(MapGrid::side);
  const auto squares = static_cast<std::size_t>(map.side), wide = side / squares;
  Image image;
  image.width = image.height = MapGrid::side;
  for (const MapClass& entry : map.classes) {
    image.palette.push_back(entry.look(scheme).ground);
    image.palette.push_back(entry.look(scheme).mark);
  }
  image.palette.push_back(blank_colour(scheme));
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const std::size_t of = map.squares[row / wide * squares + column / wide];
      const bool marked = of < map.classes.size() && map.classes[of].look(scheme).marked(column, row);
      image.pixels.push_back(static_cast<std::uint8_t>(2 * of + (marked ? 1 : 0)));
    }
  }
  return image;
}

Image sample_of(const MapClass& entry, Scheme scheme) {
  constexpr std::uint32_t side = 12;
  const Look& look = entry.look(scheme);
  Image image{side, side, {look.ground, look.mark}, {}};
  for (std::uint32_t i = 0; i < side * side; ++i) image.pixels.push_back(look.marked(i % side, i / side) ? 1 : 0);
  return image;
}

Image side_by_side(const std::vector<FailureMap>& maps, std::uint32_t gap) {
  Image all;
  all.height = MapGrid::side;
  all.width = static_cast<std::uint32_t>(maps.size()) * (MapGrid::side + gap) - gap;
  all.palette.push_back(blank_colour());
  all.pixels.resize(std::size_t{all.width} * all.height, 0);
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const Image one = image_of(maps[m]);
    const std::size_t first = all.palette.size();
    all.palette.insert(all.palette.end(), one.palette.begin(), one.palette.end());
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
      const std::size_t column = m * (MapGrid::side + gap) + i % MapGrid::side;
      all.pixels[i / MapGrid::side * all.width + column] = static_cast<std::uint8_t>(first + one.pixels[i]);
    }
  }
  return all;
}

std::string in_words(const std::vector<FailureMap>& maps) {
  std::string text;
  for (const FailureMap& map : maps) {
    text += (text.empty() ? "" : "; ") + map.subject + ": " + summary_of(Cell::of(map.counts));
  }
  return text;
}

}  // namespace touchstone::report
