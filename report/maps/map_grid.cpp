// SPDX-License-Identifier: Apache-2.0
#include "report/maps/map_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "audit/counting/audit_run.h"
#include "geometry/invalid_input.h"

namespace touchstone::report {
namespace {

double step_above(double number, bool binary32) {
  const double size = std::fabs(number);
  if (!binary32) return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  const auto narrow = static_cast<float>(size);
  return static_cast<double>(std::nextafter(narrow, std::numeric_limits<float>::infinity()) - narrow);
}

/// Around 0 the next double is 5e-324, too small to change anything.
double step_of(const Question& question, std::size_t number, bool binary32) {
  double size = std::fabs(question.numbers[number]);
  for (std::size_t i = 0; i < question.numbers.size() && question.numbers[number] == 0; ++i) {
    size = std::max(size, std::fabs(question.numbers[i]));
  }
  return step_above(size, binary32);
}

/// The first difference between two inputs of one shape: the path of the number, such as "polygon[3][0]".
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

/// The name of a number of the map's centre, found by moving it: besides coordinates a question may hold lengths of
/// lists.
std::string field_of(const Operation& operation, const Question& centre, std::size_t number, double step) {
  Question moved = centre;
  moved.numbers[number] += step;
  return path_of_difference(operation.print(centre), operation.print(moved));
}

/// The pixels that are sampled before a map is made. The stride is odd, so that stripes of powers of two are not
/// missed.
struct Stride {
  int start, step;
  static Stride of(const MapEffort& effort) { return effort.side > 64 ? Stride{7, 11} : Stride{19, 31}; }
  std::uint64_t questions() const {
    const auto across = static_cast<std::uint64_t>((MapGrid::side - start + step - 1) / step);
    return across * across;
  }
};

/// Right and wrong answers of an implementation on some pixels of a grid.
struct Probe {
  std::uint64_t right = 0, wrong = 0, inexact = 0, refused = 0;
  void add(Verdict verdict) { ++(verdict == Verdict::inexact ? inexact : is_finding(verdict) ? wrong : right); }
  /// True if the grid crosses a border of the contract, beyond which nothing is asked.
  bool is_cut() const { return 8 * refused > right + wrong + inexact; }
  /// Higher if the border of the failing region is visible, and for a wrong decision than for a number; 0 if nothing
  /// fails, or much is outside the contract.
  std::uint64_t worth() const {
    constexpr std::uint64_t decision = 100;
    if (is_cut()) return 0;
    return decision * std::min(right + inexact, wrong) + std::min(right, inexact) + (wrong + inexact > 0 ? 1 : 0);
  }
  bool is_plenty() const { return !is_cut() && 8 * std::min(right + inexact, wrong) > right + inexact + wrong; }
};

Probe probed(const Operation& operation, const MapGrid& grid, bool binary32, Engine* engine, const Stride& stride) {
  Probe probe;
  std::vector<Question> questions;
  std::vector<std::unique_ptr<Examination>> examinations;
  for (int row = stride.start; row < MapGrid::side; row += stride.step) {
    for (int column = stride.start; column < MapGrid::side; column += stride.step) {
      Question question = grid.at(column, row);
      try {
        auto examination = operation.examine(question);
        if (engine == nullptr) {
          probe.add(examination->judge_reference(binary32).verdict);
        } else {
          questions.push_back(std::move(question));
          examinations.push_back(std::move(examination));
        }
      } catch (const InvalidInput&) {
        ++probe.refused;
      }
    }
  }
  if (engine == nullptr) return probe;
  std::vector<Verdict> verdicts(questions.size());
  engine->ask_each(operation, questions, [&](std::size_t i, const Reply& reply) {
    verdicts[i] = judged(reply, *examinations[i], engine->declaration()).verdict;
  });
  for (const Verdict verdict : verdicts) probe.add(verdict);
  return probe;
}

constexpr std::uint64_t most_drawn = 400;
constexpr std::size_t most_candidates = 6;

bool of_ordinary_size(const Question& question) {
  return std::all_of(question.numbers.begin(), question.numbers.end(),
                     [](double x) { return x == 0 || (std::fabs(x) >= 0x1p-100 && std::fabs(x) <= 0x1p100); });
}

/// Questions of ordinary magnitude that the formula answers wrongly.
std::vector<Question> failing_questions(const Operation& operation, bool binary32, std::uint64_t most) {
  std::vector<Question> failing;
  const std::size_t families = operation.families().size();
  for (std::uint64_t i = 0; i < most && failing.size() < most_candidates; ++i) {
    const std::size_t family = i % families;
    DrawStream draws = case_draws(operation, family, 1, i / families);
    Question question = operation.draw(draws, family);
    if (binary32) question = operation.in_binary32(question);
    if (!of_ordinary_size(question)) continue;
    try {
      if (is_finding(operation.examine(question)->judge_reference(binary32).verdict)) failing.push_back(question);
    } catch (const InvalidInput&) {
    }
  }
  return failing;
}

using Axes = std::pair<std::size_t, std::size_t>;

std::vector<Axes> axes_to_try(const Operation& operation, std::size_t numbers) {
  std::vector<Axes> axes;
  for (const Axes& pair : {operation.map_axes(), Axes{0, 1}, Axes{numbers - 2, numbers - 1}}) {
    const bool fits = pair.first < numbers && pair.second < numbers && pair.first != pair.second;
    if (fits && std::find(axes.begin(), axes.end(), pair) == axes.end()) axes.push_back(pair);
  }
  return axes;
}

}  // namespace

MapEffort MapEffort::of(std::uint64_t cases) {
  MapEffort effort;
  const auto questions = [&](int side) { return static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side); };
  for (effort.side = 16; effort.side < MapGrid::side && questions(2 * effort.side) <= cases;) effort.side *= 2;
  return effort;
}

int column_of(int square, int side) {
  const int wide = MapGrid::side / side;
  return square * wide + (square == side / 2 ? 0 : (7 * square + 3) % wide);
}

int row_of(int square, int side) {
  const int wide = MapGrid::side / side;
  return square * wide + (square == side / 2 - 1 ? wide - 1 : (5 * square + 2) % wide);
}

Question MapGrid::at(int column, int row) const {
  Question question = centre;
  question.numbers[axes.first] += (column - side / 2) * step.first;
  question.numbers[axes.second] += (side / 2 - 1 - row) * step.second;
  return question;
}

MapGrid map_grid(const Operation& operation, Question centre, std::pair<std::size_t, std::size_t> axes, bool binary32) {
  MapGrid grid;
  grid.centre = binary32 ? operation.in_binary32(centre) : std::move(centre);
  grid.axes = axes;
  grid.step = {step_of(grid.centre, axes.first, binary32), step_of(grid.centre, axes.second, binary32)};
  grid.fields = {field_of(operation, grid.centre, axes.first, grid.step.first),
                 field_of(operation, grid.centre, axes.second, grid.step.second)};
  return grid;
}

MapGrid map_grid(const Operation& operation, bool binary32) {
  return map_grid(operation, operation.map_centre(), operation.map_axes(), binary32);
}

MapGrid failing_grid(const Operation& operation, bool binary32, Engine* engine, const std::vector<Question>& candidates,
                     const MapEffort& effort) {
  const Stride stride = Stride::of(effort);
  constexpr std::uint64_t most_per_square = 4;
  const std::uint64_t most_asked =
      most_per_square * static_cast<std::uint64_t>(effort.side) * static_cast<std::uint64_t>(effort.side);
  const MapGrid own = map_grid(operation, binary32);
  const Probe of_own = probed(operation, own, binary32, engine, stride);
  const bool numbers_alone = operation.words().empty();
  const std::uint64_t fails = numbers_alone ? of_own.wrong + of_own.inexact : of_own.wrong;
  if (fails > 0 && of_own.right + of_own.inexact > 0 && !of_own.is_cut()) return own;
  MapGrid best = own;
  std::uint64_t most = of_own.worth(), asked = stride.questions();
  const auto is_found = [&](const std::vector<Question>& around) {
    for (const Question& centre : around) {
      if (centre.numbers.size() < 2 || !of_ordinary_size(centre)) continue;
      for (const Axes& axes : axes_to_try(operation, centre.numbers.size())) {
        if ((asked += stride.questions()) > most_asked || effort.abandoned()) return true;
        MapGrid grid = map_grid(operation, centre, axes, binary32);
        const Probe probe = probed(operation, grid, binary32, engine, stride);
        if (probe.worth() > most) most = probe.worth(), best = std::move(grid);
        if (probe.is_plenty()) return true;
      }
    }
    return false;
  };
  if (!is_found(candidates))
    is_found(failing_questions(operation, binary32, std::min<std::uint64_t>(most_drawn, most_asked / 4)));
  return best;
}

}  // namespace touchstone::report
