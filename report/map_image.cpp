// SPDX-License-Identifier: Apache-2.0
#include "report/map_image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "audit/parallel.h"
#include "catalogue/codec/plain.h"
#include "geometry/invalid_input.h"
#include "report/palette.h"
#include "report/wording.h"

namespace touchstone::audit {
namespace {

double step_above(double number, bool binary32) {
  const double size = std::fabs(number);
  if (!binary32) return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  const auto narrow = static_cast<float>(size);
  return static_cast<double>(std::nextafter(narrow, std::numeric_limits<float>::infinity()) - narrow);
}

/// Where two inputs of one shape differ: the path of the first number that is not the same, as "polygon[3][0]".
std::string path_of_difference(const Json& a, const Json& b, const std::string& path = "") {
  if (!a.is_structured()) return a == b ? "" : path;
  std::string found;
  for (std::size_t i = 0; a.is_array() && i < a.size() && found.empty(); ++i) {
    found = path_of_difference(a[i], b[i], path + "[" + std::to_string(i) + "]");
  }
  if (a.is_array()) return found;
  for (const auto& [key, value] : a.items()) {
    found = path_of_difference(value, b[key], path.empty() ? key : path + "." + key);
    if (!found.empty()) break;
  }
  return found;
}

/// The name of a number of the map's centre, found by moving it: beside coordinates a question may hold lengths of
/// lists.
std::string field_of(const Operation& operation, const Question& centre, std::size_t number, double step) {
  Question moved = centre;
  moved.numbers[number] += step;
  return path_of_difference(operation.print(centre), operation.print(moved));
}

/// What one implementation did at one pixel. Answers that are numbers alone are shown by how far they are off.
struct Shade {
  Verdict verdict = Verdict::unsupported;
  std::string said;
  bool refused = false;
  std::size_t decade = words_only;  ///< of the distance in ulps: 0, then up to 1, 10, 100 ...
  static constexpr std::size_t words_only = 99, last_decade = 7;

  bool operator<(const Shade& other) const {
    return std::tie(verdict, said, refused, decade) < std::tie(other.verdict, other.said, other.refused, other.decade);
  }
};

Shade shade_of_distance(const Judgement& judgement) {
  std::uint64_t limit = 1;
  std::size_t decade = judgement.ulps > 0 ? 1 : 0;
  while (decade > 0 && decade < Shade::last_decade + 1 && static_cast<double>(limit) < judgement.ulps)
    limit *= 10, ++decade;
  if (!(judgement.ulps <= 1e6))
    return {judgement.verdict, "more than 1,000,000 ulps off", false, Shade::last_decade + 1};
  return {judgement.verdict, decade == 0 ? "correctly rounded" : "up to " + counted(limit, "ulp") + " off", false,
          decade};
}

/// Of an answer that is one of many right ones, and of one whose numbers are not those that were asked for, the verdict
/// says all.
template <class Answer>
Shade shade_of(Kind kind, const Judgement& judgement, const std::string& outcome, const Answer& answer) {
  if (outcome == "value") {
    const bool measured = judgement.verdict == Verdict::agree || judgement.verdict == Verdict::inexact;
    return measured && kind != Kind::checked && kind != Kind::covering ? shade_of_distance(judgement)
                                                                       : Shade{judgement.verdict, ""};
  }
  const bool decided = judgement.verdict == Verdict::agree || judgement.verdict == Verdict::inexact;
  return {judgement.verdict, decided ? outcome : word_in(answer())};
}

struct Plate {
  std::string subject;
  std::vector<Shade> shades;
};

/// A row of the map: its questions, null where the contract refuses one, and what reference and robust did.
struct Row {
  std::vector<std::unique_ptr<Examination>> examinations;
  std::vector<Shade> reference, robust;
  std::map<std::string, std::uint64_t> outcomes;
};

Row examined(const Operation& operation, const MapGrid& grid, int row, bool binary32) {
  const Kind kind = operation.card().kind;
  Row result;
  for (int column = 0; column < MapGrid::side; ++column) {
    try {
      result.examinations.push_back(operation.examine(grid.at(column, row)));
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

void ask_engine(const Operation& operation, const MapGrid& grid,
                const std::vector<std::unique_ptr<Examination>>& row_of, int row, Engine& engine,
                std::vector<Shade>& shades) {
  std::vector<Question> questions;
  for (int column = 0; column < MapGrid::side; ++column) {
    if (row_of[static_cast<std::size_t>(column)]) questions.push_back(grid.at(column, row));
  }
  const std::vector<Reply> replies = engine.ask(operation, questions);
  std::size_t next = 0;
  for (const auto& examination : row_of) {
    if (!examination) {
      shades.push_back({Verdict::unsupported, "", true});
      continue;
    }
    const Reply& reply = replies[next++];
    if (reply.kind == Reply::Kind::answered) {
      const Judgement judgement = examination->judge_engine(reply.answer, engine.declaration());
      shades.push_back(
          shade_of(operation.card().kind, judgement, examination->outcome(), [&] { return plain(reply.answer); }));
    } else {
      shades.push_back({reply.kind == Reply::Kind::failed ? Verdict::invalid : Verdict::unsupported, "no answer"});
    }
  }
}

/// Words by how common they are among the truths, so that all maps of an operation give a word the same tint; a word so
/// rare that it may be a line one pixel wide gets the dark one.
std::map<std::string, std::size_t> ranks_of(const std::map<std::string, std::uint64_t>& outcomes) {
  std::vector<std::pair<std::string, std::uint64_t>> sorted(outcomes.begin(), outcomes.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  constexpr std::uint64_t rare = MapGrid::side * MapGrid::side / 25;
  constexpr std::size_t light[] = {0, 1, 3}, dark = 2;
  std::map<std::string, std::size_t> ranks;
  std::size_t common = 0;
  for (const auto& [word, n] : sorted) ranks[word] = n < rare ? dark : light[common++ % std::size(light)];
  return ranks;
}

Colour colour_in_map(const Shade& shade, std::map<std::string, std::size_t>& ranks) {
  if (shade.refused) return {255, 255, 255};
  if (shade.decade != Shade::words_only) return distance_colour(shade.verdict, shade.decade);
  if (shade.said.empty())
    return shade.verdict == Verdict::agree ? map_colour(shade.verdict, 0) : colour_of(shade.verdict);
  return map_colour(shade.verdict, ranks.emplace(shade.said, ranks.size()).first->second);
}

FailureMap developed(const Plate& plate, std::map<std::string, std::size_t> ranks) {
  FailureMap map;
  map.subject = plate.subject;
  map.image.width = map.image.height = MapGrid::side;
  std::map<Shade, std::uint64_t> counts;
  for (const Shade& shade : plate.shades) ++counts[shade];
  std::map<Shade, std::uint8_t> index;
  for (const auto& [shade, n] : counts) {
    const Colour colour = colour_in_map(shade, ranks);
    index[shade] = static_cast<std::uint8_t>(map.image.palette.size());
    map.image.palette.push_back(colour);
    if (shade.refused) {
      map.refused += n;
      continue;
    }
    map.counts[static_cast<std::size_t>(shade.verdict)] += n;
    map.classes.push_back({shade.verdict, shade.said, n, colour});
  }
  for (const Shade& shade : plate.shades) map.image.pixels.push_back(index[shade]);
  std::stable_sort(map.classes.begin(), map.classes.end(), [](const MapClass& a, const MapClass& b) {
    return a.verdict != b.verdict ? a.verdict < b.verdict : a.count > b.count;
  });
  return map;
}

}  // namespace

Question MapGrid::at(int column, int row) const {
  Question question = centre;
  question.numbers[axes.first] += (column - side / 2) * step.first;
  question.numbers[axes.second] += (side / 2 - 1 - row) * step.second;
  return question;
}

MapGrid map_grid(const Operation& operation, bool binary32) {
  MapGrid grid;
  grid.centre = binary32 ? operation.in_binary32(operation.map_centre()) : operation.map_centre();
  grid.axes = operation.map_axes();
  grid.step = {step_above(grid.centre.numbers[grid.axes.first], binary32),
               step_above(grid.centre.numbers[grid.axes.second], binary32)};
  grid.fields = {field_of(operation, grid.centre, grid.axes.first, grid.step.first),
                 field_of(operation, grid.centre, grid.axes.second, grid.step.second)};
  return grid;
}

std::vector<FailureMap> failure_maps(const Operation& operation, int jobs, bool binary32, Engine* engine) {
  const MapGrid grid = map_grid(operation, binary32);
  Declaration ours;
  ours.engine = "reference";
  ours.binary32 = binary32;
  std::vector<Plate> plates{{subject(ours), {}}, {"robust", {}}};
  const bool with_engine = engine && engine->supports(operation.name());
  if (with_engine) plates.push_back({subject(engine->declaration()), {}});
  std::map<std::string, std::uint64_t> outcomes;
  constexpr int together = 32;  // rows; the engine is asked of these, in order, before the next are looked at
  static_assert(MapGrid::side % together == 0);
  for (int first = 0; first < MapGrid::side; first += together) {
    std::vector<Row> rows(together);
    in_parallel(jobs, rows.size(), [&](std::size_t i) {
      rows[i] = examined(operation, grid, first + static_cast<int>(i), binary32);
      if (!with_engine) rows[i].examinations.clear();
    });
    for (int i = 0; i < together; ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      plates[0].shades.insert(plates[0].shades.end(), row.reference.begin(), row.reference.end());
      plates[1].shades.insert(plates[1].shades.end(), row.robust.begin(), row.robust.end());
      for (const auto& [outcome, n] : row.outcomes) outcomes[outcome] += n;
      if (with_engine) ask_engine(operation, grid, row.examinations, first + i, *engine, plates[2].shades);
    }
  }
  std::vector<FailureMap> maps;
  for (const Plate& plate : plates) maps.push_back(developed(plate, ranks_of(outcomes)));
  return maps;
}

Image side_by_side(const std::vector<FailureMap>& maps, std::uint32_t gap) {
  Image all;
  all.height = MapGrid::side;
  all.palette.push_back({255, 255, 255});
  std::vector<std::vector<std::uint8_t>> translations;
  for (const FailureMap& map : maps) {
    std::vector<std::uint8_t>& translation = translations.emplace_back();
    for (const Colour& colour : map.image.palette) {
      const auto found = std::find(all.palette.begin(), all.palette.end(), colour);
      translation.push_back(static_cast<std::uint8_t>(found - all.palette.begin()));
      if (found == all.palette.end()) all.palette.push_back(colour);
    }
    all.width += (all.width > 0 ? gap : 0) + map.image.width;
  }
  for (std::size_t row = 0; row < MapGrid::side; ++row) {
    for (std::size_t m = 0; m < maps.size(); ++m) {
      if (m > 0) all.pixels.insert(all.pixels.end(), gap, 0);
      const auto from = maps[m].image.pixels.begin() + static_cast<std::ptrdiff_t>(row * MapGrid::side);
      std::transform(from, from + MapGrid::side, std::back_inserter(all.pixels),
                     [&](std::uint8_t i) { return translations[m][i]; });
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

}  // namespace touchstone::audit
