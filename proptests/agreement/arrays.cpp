// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <map>

#include "catalogue/judge/environment.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

// Where robust answers arrays, each row is answered as one question is, with every instruction set that this processor
// has.
namespace touchstone::proptests::arrays_tests {
namespace {

using catalogue::Word;
using robust::batch::Column;
using robust::batch::Instructions;

constexpr Instructions every_set[] = {Instructions::portable, Instructions::avx2, Instructions::avx512};

/// What robust decides of one question.
Word decision(const Operation& operation, const Question& question, std::size_t environment = 0) {
  const auto& row = operation.row();
  return row.decide != nullptr ? row.decide(question, environment) : row.robust(question, environment).words.at(0);
}

/// Who is wrong; empty where it is nobody.
std::string refusal(const Operation& operation, const Question& question) {
  try {
    decision(operation, question);
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  return "";
}

/// Questions that arrays can ask in one call: they differ in the columns' numbers alone.
struct Table {
  std::vector<Question> questions;
  std::vector<std::size_t> columns;
};

/// As many questions of all families in turn, those that are refused too or not.
std::vector<Question> drawn(const Operation& operation, std::size_t count, bool valid) {
  std::vector<Question> questions;
  for (std::uint64_t i = 0; questions.size() < count && i < 40 * count; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "arrays", i));
    Question question = operation.draw(draws, i % operation.families().size());
    if (refusal(operation, question).empty() == valid) questions.push_back(std::move(question));
  }
  return questions;
}

/// Tables of questions: where every argument has columns, one for each alternative; else one for each question, whose
/// rows take their numbers from that one and from others in turn.
std::vector<Table> tables(const Operation& operation, std::size_t count) {
  constexpr std::size_t rows_of_a_list = 75;
  std::vector<Table> made;
  const auto columns_of = operation.row().batch.columns;
  const std::vector<Question> first = drawn(operation, 1, true);
  if (columns_of(first[0]).size() == first[0].numbers.size()) {
    std::map<std::vector<Word>, Table> by_words;
    for (Question& question : drawn(operation, count, true)) {
      Table& table = by_words[question.words];
      if (table.questions.empty()) table.columns = columns_of(question);
      table.questions.push_back(std::move(question));
    }
    for (auto& [words, table] : by_words) made.push_back(std::move(table));
    return made;
  }
  const std::vector<Question> questions = drawn(operation, std::max<std::size_t>(count / rows_of_a_list, 8), true);
  for (std::size_t n = 0; n < questions.size(); ++n) {
    Table table{{}, columns_of(questions[n])};
    for (std::size_t i = 0; i < rows_of_a_list; ++i) {
      Question question = questions[n];
      const Question& other = questions[(n + i) % questions.size()];
      const std::vector<std::size_t> others = columns_of(other);
      for (std::size_t k = 0; k < others.size(); ++k) question.numbers[table.columns[k]] = other.numbers[others[k]];
      // Every second one of the shape's own numbers: points on vertices, and between them.
      const std::size_t at = i % question.numbers.size();
      if (i % 2 == 1 && at + others.size() <= question.numbers.size())
        for (std::size_t k = 0; k < others.size(); ++k)
          question.numbers[table.columns[k]] = questions[n].numbers[at + k];
      table.questions.push_back(std::move(question));
    }
    made.push_back(std::move(table));
  }
  return made;
}

/// The first questions of a table as columns, each number `stride` after the one before (0: all are that of the first),
/// the first `shift` after an aligned address.
struct Columns {
  std::vector<std::vector<double>> numbers;
  std::vector<Column> columns;
  Columns(const Table& table, std::size_t count, const std::vector<std::ptrdiff_t>& strides, std::size_t shift)
      : numbers(table.columns.size()) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const std::ptrdiff_t stride = strides[k], last = count == 0 ? 0 : static_cast<std::ptrdiff_t>(count - 1);
      const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(shift) + (stride < 0 ? -stride * last : 0);
      numbers[k].assign(shift + static_cast<std::size_t>(std::abs(stride) * last) + 1,
                        std::numeric_limits<double>::quiet_NaN());
      for (std::size_t i = count; i-- > 0;)
        numbers[k][static_cast<std::size_t>(start + stride * static_cast<std::ptrdiff_t>(i))] =
            table.questions[i].numbers[table.columns[k]];
      columns.emplace_back(numbers[k].data() + start, stride);
    }
  }
};

std::vector<Word> decisions(const Operation& operation, const Table& table) {
  std::vector<Word> answers;
  for (const Question& question : table.questions) answers.push_back(decision(operation, question));
  return answers;
}

void check(const Operation& operation, const Table& table, const std::vector<Word>& expected, std::size_t count,
           const std::vector<std::ptrdiff_t>& strides, std::size_t shift, std::size_t environment = 0) {
  const Columns given(table, count, strides, shift);
  for (const Instructions set : every_set) {
    std::vector<std::uint8_t> answers(count + 1, 255);
    {
      const catalogue::Environment environment_set(environment);
      operation.row().batch.decide(table.questions[0], given.columns.data(), count, answers.data(), set);
    }
    REQUIRE(answers[count] == 255);
    for (std::size_t i = 0; i < count; ++i) {
      if (answers[i] == expected[i]) continue;
      FAIL("instructions " << static_cast<int>(set) << ", row " << i << " of " << count << ", " << answers[i] + 0
                           << " instead of " << expected[i] << ": "
                           << catalogue::one_line(operation.print(table.questions[i])));
    }
  }
}

std::vector<std::ptrdiff_t> all_of(const Table& table, std::ptrdiff_t stride) {
  return std::vector<std::ptrdiff_t>(table.columns.size(), stride);
}

std::size_t asked_of(const Operation& operation, std::uint64_t questions) {
  return static_cast<std::size_t>(
      affordable(operation, static_cast<std::uint64_t>(scaled(static_cast<int>(questions)))));
}

}  // namespace

/// Asks each of the rows many times, in turn, in every way that `check` knows.
void check_in_turn(const char* name, const std::vector<Question>& rows, const std::vector<Word>& answers) {
  const Operation& operation = *catalogue::find_operation(name);
  Table table{{}, operation.row().batch.columns(rows[0])};
  std::vector<Word> expected;
  for (std::size_t i = 0; i < 70; ++i) {
    table.questions.push_back(rows[i % rows.size()]);
    expected.push_back(answers[i % rows.size()]);
  }
  check(operation, table, expected, expected.size(), all_of(table, 1), 0);
  CHECK(decisions(operation, table) == expected);
}

/// The same of points beside a mesh, and beside the mesh with its faces in the opposite order.
void check_in_every_order(Meshd mesh, const std::vector<Point3d>& points, const std::vector<Word>& places) {
  for (int order = 0; order < 2; ++order) {
    std::vector<Question> rows;
    for (const Point3d& point : points) rows.emplace_back(catalogue::packed(std::tuple(mesh, point)));
    check_in_turn("point_in_convex_polyhedron", rows, places);
    check_in_turn("point_in_polyhedron", rows, places);
    std::reverse(mesh.faces.begin(), mesh.faces.end());
  }
}

TEST_CASE("arrays: what follows asks something") {
  std::size_t with_arrays = 0;
  for (const Operation* operation : catalogue::all_operations())
    with_arrays += operation->row().batch.decide != nullptr;
  CHECK(with_arrays >= 15);
}

TEST_CASE("arrays: turns whose sign in double is wrong by nearly three units of rounding") {
  // In each product all three roundings go the same way, and in the other product the other way. The difference of the
  // products in double is 2.9999999 * 2^-53 times the magnitude of their sum, and on the other side of 0.
  const Operation& operation = *catalogue::find_operation("orientation");
  const std::vector<double> right = {-0x1.0000000008p-53,   -0x1.0000000008p-53,   0x1.0000002p+0,
                                     -0x1.0000002000003p+0, -0x1.0000003fffffdp+0, 0x1.0000003fffffep+0};
  std::vector<double> left = right;
  for (std::size_t k = 0; k < left.size(); k += 2) left[k] = -left[k];
  Table table{{}, operation.row().batch.columns({right, {}})};
  std::vector<Word> expected;
  for (std::size_t i = 0; i < 70; ++i) {
    table.questions.push_back({i % 2 == 0 ? right : left, {}});
    expected.push_back(i % 2 == 0 ? 2 : 0);  // right, left
  }
  check(operation, table, expected, expected.size(), all_of(table, 1), 0);
}

TEST_CASE("arrays: three points on the diagonal, whose differences are rounded, and one beside it") {
  // 1 - 2^-60 and 3 - 2^-60 are rounded to 1 and 3: the products are equal as computed, whatever the turn is.
  const Operation& operation = *catalogue::find_operation("orientation");
  const double least = 0x1p-60, beyond = 0x1.8000000000001p1;
  const std::vector<Question> rows = {{{least, least, 1, 1, 3, 3}, {}},      {{least, least, 1, 1, 3, beyond}, {}},
                                      {{least, least, 1, 1, beyond, 3}, {}}, {{least, least * 2, 1, 1, 3, 3}, {}},
                                      {{least * 2, least, 1, 1, 3, 3}, {}},  {{1, 1, least, least, 1, 1}, {}}};
  const std::vector<Word> sides = {1, 0, 2, 0, 2, 1};  // on, left, right
  Table table{{}, operation.row().batch.columns(rows[0])};
  std::vector<Word> expected;
  for (std::size_t i = 0; i < 300; ++i) {
    table.questions.push_back(rows[i % rows.size()]);
    expected.push_back(sides[i % rows.size()]);
  }
  check(operation, table, expected, expected.size(), all_of(table, 1), 0);
}

TEST_CASE("arrays: of two rows that are refused the first is named, also where fewer rows of its chunk are open") {
  const Operation& operation = *catalogue::find_operation("orientation");
  const double bad = std::numeric_limits<double>::infinity();
  const Question sure{{0, 0, 1, 0, 0, 1}, {}}, on_line{{0, 0, 1, 1, 2, 2}, {}}, refused{{0, 0, 1, bad, 2, 2}, {}};
  Table table{{}, operation.row().batch.columns(sure)};
  for (std::size_t i = 0; i < 128; ++i) table.questions.push_back(i < 64 ? sure : on_line);
  table.questions[5] = refused, table.questions[100] = refused;
  const Columns given(table, table.questions.size(), all_of(table, 1), 0);
  for (const Instructions set : every_set) {
    std::vector<std::uint8_t> answers(table.questions.size());
    std::string named;
    try {
      operation.row().batch.decide(table.questions[0], given.columns.data(), answers.size(), answers.data(), set);
    } catch (const InvalidInput& error) {
      named = error.field();
    }
    CHECK(named == "questions[5].p1[1]");
  }
}

TEST_CASE("arrays: decimals whose height in double has the wrong sign") {
  // normal, offset, point
  const std::vector<Question> rows = {{{0.7, 0.6, 0.8, -0.63, 0.1, 0.8, 0.1}, {}},
                                      {{0.3, 0.6, 0.3, -0.6, 0.4, 0.7, 0.2}, {}},
                                      {{0.7, 0.2, 0.7, -1.18, 0.8, 0.3, 0.8}, {}},
                                      {{0.8, 0.8, 0.5, -1.07, 0.1, 0.8, 0.7}, {}},
                                      // 1 is lost beside 2^60 before that is taken away again.
                                      {{1, 0x1p60, -0x1p60, -0.5, 1, 1, 1}, {}},
                                      {{-1, -0x1p60, 0x1p60, 0.5, 1, 1, 1}, {}}};
  const std::vector<Word> sides = {0, 2, 0, 2, 0, 2};  // front, back
  check_in_turn("point_plane", rows, sides);
}

TEST_CASE("arrays: points in the plane of one face, and on either side of another by less than is rounded") {
  // 3 times 0.1, as a double, is greater than 0.3, and 3 times the double before 0.1 is less: x - 3 y + 2 z is outside
  // where it is positive, and the base has z = 0. Another face has x = z.
  const double before = std::nextafter(0.1, 0.0), after = std::nextafter(0.1, 1.0);
  const Meshd mesh{{{0, 0, 0}, {3, 1, 0}, {0, 3, 0}, {1, 1, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const std::vector<Point3d> points = {{0.3, 0.1, 0},     {0.3, before, 0}, {0.3, 0.1, 0x1p-70}, {0.3, before, 0x1p-70},
                                       {after, 0.5, 0.1}, {0.1, 0.5, 0.1},  {before, 0.5, 0.1}};
  const std::vector<Word> places = {1, 2, 0, 2, 0, 1, 2};  // on the boundary 1, outside 2
  check_in_every_order(mesh, points, places);
}

TEST_CASE("arrays: points between two faces that are closer to each other than is rounded") {
  // Two faces meet in an edge along z and lead to x = 2^60 and x = 2^60 + 256 where y is 1. Where y is 0.1, as a double,
  // they are at 2^60 times that, which is a double, and 25.6 farther on; the next double is 16 farther on.
  const double y = 0.1, x = 0x1p60 * y;
  const Meshd mesh{{{0, 0, -1}, {0, 0, 1}, {0x1p60, 1, 0}, {0x1p60 + 256, 1, 0}},
                   {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  check_in_every_order(mesh, {{x - 16, y, 0.05}, {x, y, 0.05}, {x + 16, y, 0.05}, {x + 32, y, 0.05}}, {2, 1, 0, 2});
}

TEST_CASE("arrays: balls that meet only by a radius too small to be told beside the other") {
  // The second center is a hair farther than the first radius: h h, with h = 2^-170, is less than twice the product of
  // the radii 2^400 and 2^-721, and more than that of 2^400 and 2^-750.
  const double r = 0x1p400, hair = 0x1p-170;
  const std::vector<double> much{0, 0, r, r, hair, 0x1p-721}, little{0, 0, r, r, hair, 0x1p-750};
  check_in_turn("sphere_sphere", {{much, {0}}, {little, {0}}}, {2, 0});
}

EACH_OPERATION("over arrays it answers as one by one, and as the oracle") {
  if (operation.row().batch.decide == nullptr) return;
  for (const Table& table : tables(operation, asked_of(operation, 20'000))) {
    const std::vector<Word> expected = decisions(operation, table);
    check(operation, table, expected, expected.size(), all_of(table, 1), 0);
    check(operation, table, expected, expected.size(), all_of(table, 3), 1);
    const std::size_t step = std::max<std::size_t>(1, expected.size() / 500);
    for (std::size_t i = 0; i < expected.size(); i += step)
      REQUIRE(operation.row().solve(table.questions[i]).answer.words.at(0) == expected[i]);
  }
}

EACH_OPERATION("over arrays of any length, alignment and stride it answers as one by one") {
  if (operation.row().batch.decide == nullptr) return;
  for (const Table& table : tables(operation, 300)) {
    const std::vector<Word> expected = decisions(operation, table);
    // Where a list is shared it is validated in each call: each length with one alignment.
    const bool shares = table.columns.size() != table.questions[0].numbers.size();
    for (std::size_t count = 0; count <= std::min<std::size_t>(70, expected.size()); ++count) {
      for (std::size_t shift = 0; shift < 8; ++shift) {
        if (shares && shift != count % 8) continue;
        check(operation, table, expected, count, all_of(table, 1), shift);
        const auto stride = static_cast<std::ptrdiff_t>(shift % 4) + 2;
        check(operation, table, expected, count, all_of(table, shift % 2 == 0 ? stride : -stride), shift);
      }
    }
  }
}

EACH_OPERATION("over arrays one operand that all rows share is as good as many") {
  if (operation.row().batch.decide == nullptr) return;
  for (const Table& table : tables(operation, 300)) {
    // Each half of the columns in turn, and all of them.
    for (std::size_t part = 0; part < 3; ++part) {
      std::vector<std::ptrdiff_t> strides = all_of(table, 1);
      Table shared{{}, table.columns};
      for (std::size_t k = 0; k < strides.size(); ++k)
        if (part == 2 || (k < strides.size() / 2) == (part == 0)) strides[k] = 0;
      for (Question question : table.questions) {
        for (std::size_t k = 0; k < strides.size(); ++k)
          if (strides[k] == 0) question.numbers[table.columns[k]] = table.questions[0].numbers[table.columns[k]];
        if (refusal(operation, question).empty()) shared.questions.push_back(std::move(question));
      }
      const std::vector<Word> expected = decisions(operation, shared);
      for (const std::size_t count : {std::size_t{1}, std::size_t{63}, std::size_t{64}, expected.size()})
        if (count <= expected.size()) check(operation, shared, expected, count, strides, 3);
    }
  }
}

EACH_OPERATION("over arrays of numbers of any size it answers as one by one") {
  if (operation.row().batch.decide == nullptr) return;
  // By every power of two: a bound must not stay finite where something in the value overflows, nor hide underflow.
  const std::vector<Table> all = tables(operation, 300);
  int turn = 0;
  for (int exponent = -1074; exponent <= 1023; exponent += operation.metadata().cost) {
    const Table& table = all[static_cast<std::size_t>(turn++) % all.size()];
    Table scaled_table{{}, table.columns};
    for (Question question : table.questions) {
      for (double& number : question.numbers) number = std::ldexp(number, exponent);
      if (scaled_table.questions.size() < 70 && refusal(operation, question).empty())
        scaled_table.questions.push_back(std::move(question));
    }
    if (scaled_table.questions.empty()) continue;
    check(operation, scaled_table, decisions(operation, scaled_table), scaled_table.questions.size(), all_of(table, 1),
          0);
  }
}

EACH_OPERATION("over arrays it answers alike in every floating-point environment") {
  if (operation.row().batch.decide == nullptr) return;
  for (const Table& table : tables(operation, asked_of(operation, 1'000))) {
    const std::vector<Word> expected = decisions(operation, table);
    for (std::size_t environment = 0; environment < catalogue::environment_count; ++environment)
      check(operation, table, expected, expected.size(), all_of(table, 1), 0, environment);
  }
}

EACH_OPERATION("over arrays the first question that is refused is named") {
  if (operation.row().batch.decide == nullptr) return;
  const auto refused_by_arrays = [&](const Table& table, Instructions set) -> std::string {
    std::vector<std::uint8_t> answers(table.questions.size());
    const Columns given(table, table.questions.size(), all_of(table, 1), 0);
    try {
      operation.row().batch.decide(table.questions[0], given.columns.data(), answers.size(), answers.data(), set);
    } catch (const InvalidInput& refused) {
      return refused.what();
    }
    return "nothing";
  };
  Table table = tables(operation, 300)[0];
  table.questions.resize(std::min<std::size_t>(table.questions.size(), 200));
  for (const std::size_t place : {std::size_t{0}, std::size_t{17}, std::size_t{69}}) {
    const Question kept = table.questions.at(place);
    for (const std::size_t k : table.columns) {
      for (const double bad : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()}) {
        table.questions[place].numbers[k] = bad;
        const std::string expected =
            "questions[" + std::to_string(place) + "]." + refusal(operation, table.questions[place]);
        for (const Instructions set : every_set) REQUIRE(refused_by_arrays(table, set) == expected);
        table.questions[place] = kept;
      }
    }
  }
  // What the families break on purpose: a radius below 0, a normal of length 0, a polygon that is not convex.
  for (const Question& bad : drawn(operation, 200, false)) {
    const bool of_a_row = operation.row().batch.columns(bad).size() == bad.numbers.size();
    Table with{{}, operation.row().batch.columns(bad)};
    if (of_a_row) {
      if (bad.words != table.questions[0].words) continue;
      with = table;
      with.questions[40] = bad;
    } else {
      with.questions.assign(70, bad);
    }
    const std::string expected = (of_a_row ? "questions[40]." : "") + refusal(operation, bad);
    for (const Instructions set : every_set) REQUIRE(refused_by_arrays(with, set) == expected);
  }
}

}  // namespace touchstone::proptests::arrays_tests
