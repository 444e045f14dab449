// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/broad_phase/broad_phase.h"

#include "proptests/space_laws.h"
#include "robust/broad_phase/all_pairs.h"
#include "robust/structures/swept_boxes.h"

namespace touchstone::proptests::broad_phase_tests {
namespace {

using Row = rows::broad_phase;
using Boxes = Row::Boxes;
using Commands = Row::Commands;
using Pairs = std::vector<IndexPair>;

const Ask pairs{Query::pairs};

Aabb3d along_x(double low, double high) { return {{low, 0, 0}, {high, 1, 1}}; }
const Aabb3d far_away = along_x(2000, 2001);

/// A worked example and its margin.
void gives(const Boxes& boxes, const Commands& commands, const std::vector<Pairs>& expected,
           const std::optional<Rational>& margin) {
  Replies replies;
  for (const Pairs& reply : expected) replies.push_back({reply});
  example<Row>({boxes, commands}, replies);
  CHECK(examined<Row>({boxes, commands})->margin() == margin);
}

/// What the judge says of an engine's replies where the boxes 0 and 1 touch, 1 goes away, and comes back into 0.
catalogue::Judgement judged(const std::string& answer, catalogue::Declaration::Boundary boundary) {
  const Boxes boxes{along_x(0, 1), along_x(1, 2), along_x(5, 6)};
  const auto examination =
      examined<Row>({boxes, {pairs, Moved{1, along_x(3, 4)}, pairs, Moved{1, along_x(0, 2)}, pairs}});
  return examination->judge_engine(catalogue::parse_line(answer), {"by hand", boundary});
}

/// Whether an index of the program is that of `body`, which is there all the time.
bool touches(const Commandd& command, Index body) {
  if (const auto* move = std::get_if<Moved>(&command)) return move->body == body;
  const auto* remove = std::get_if<Remove>(&command);
  return remove != nullptr && remove->body == body;
}

Replies without(Replies replies, Index body) {
  for (PairsReply& reply : replies)
    std::erase_if(reply.pairs, [body](const IndexPair& pair) { return pair.i == body || pair.j == body; });
  return replies;
}

}  // namespace

LAW("broad_phase: inserted bodies are like those to start with", boxes, commands) {
  Commands all;
  for (const Aabb3d& box : boxes) all.emplace_back(Insertd{box});
  all.insert(all.end(), commands.begin(), commands.end());
  return ask(Row::Question{Boxes{}, all}) == ask(asked);
}

LAW("broad_phase: a query changes nothing", boxes, commands) {
  Commands twice;
  Replies expected;
  const Replies once = ask(asked);
  for (const Commandd& command : commands) {
    twice.push_back(command);
    if (!std::holds_alternative<Ask>(command)) continue;
    twice.push_back(command);
    expected.insert(expected.end(), 2, once[expected.size() / 2]);
  }
  return ask(Row::Question{boxes, twice}) == expected;
}

LAW("broad_phase: who is removed at last was in no other pair", boxes, commands) {
  if (boxes.empty()) return true;
  for (const Commandd& command : commands)
    if (touches(command, 0)) return true;
  Commands first{Remove{0}};
  first.insert(first.end(), commands.begin(), commands.end());
  return ask(Row::Question{boxes, first}) == without(ask(asked), 0);
}

LAW("broad_phase: moving a body to where it is changes nothing", boxes, commands) {
  Commands moved;
  for (Index i = 0; i < boxes.size(); ++i) moved.emplace_back(Moved{i, boxes[i]});
  moved.insert(moved.end(), commands.begin(), commands.end());
  return ask(Row::Question{boxes, moved}) == ask(asked);
}

TEST_CASE("broad_phase: p. 56's loop between commands, worked by hand") {
  gives({along_x(0, 1), along_x(1, 2)}, {pairs}, {{{0, 1}}}, 0);
  // 1 apart, 2 apart; the inserted body is the second, and the first is removed.
  gives({along_x(0, 1)}, {Insertd{along_x(2, 3)}, pairs, Moved{1, along_x(3, 4)}, pairs, Remove{0}, pairs},
        {{}, {}, {}}, 1);
  // Indices stay: 0 is gone, 3 is new.
  gives({along_x(0, 9), along_x(0, 4), along_x(2, 6)}, {Remove{0}, Insertd{along_x(5, 8)}, pairs}, {{{1, 2}, {2, 3}}},
        1);
  gives({along_x(0, 4), along_x(2, 6)}, {Remove{1}, Remove{0}, pairs, Insertd{along_x(2, 6)}, pairs}, {{}, {}},
        std::nullopt);
  gives({}, {}, {}, std::nullopt);
  gives({along_x(0, 4), along_x(2, 6)}, {}, {}, std::nullopt);
}

TEST_CASE("broad_phase: boxes in order, then commands; a command's body before its box") {
  const Aabb3d wrong = along_x(1, 0), not_finite = along_x(0, infinity);
  const std::string there = "index of a body that is there", order = "min <= max", finite = "finite number";
  refused<Row>({{along_x(0, 1), wrong}, {Remove{7}}}, "boxes[1].max[0]", order);
  refused<Row>({{}, {pairs, Insertd{wrong}}}, "commands[1].insert.max[0]", order);
  refused<Row>({{far_away}, {Moved{1, wrong}}}, "commands[0].move", there);
  refused<Row>({{wrong}, {Remove{7}, Moved{0, not_finite}}}, "commands[1].box.max[0]", finite);
  refused<Row>({{far_away}, {Remove{0}, pairs, Remove{0}}}, "commands[2].remove", there);
  refused<Row>({{far_away}, {Remove{0}, Insertd{far_away}, Moved{0, far_away}}}, "commands[2].move", there);
}

TEST_CASE("broad_phase: an engine must miss nothing in any reply") {
  constexpr auto closed = catalogue::Declaration::Boundary::closed,
                 unspecified = catalogue::Declaration::Boundary::unspecified;
  using catalogue::Verdict;
  const std::string right = R"({"replies":[{"pairs":[[0,1]]},{"pairs":[]},{"pairs":[[1,0]]}]})";
  CHECK(judged(right, closed).verdict == Verdict::agree);
  const std::string more = R"({"replies":[{"pairs":[[0,1],[1,2]]},{"pairs":[[0,1]]},{"pairs":[[0,1]]}]})";
  CHECK(judged(more, closed).verdict == Verdict::agree);
  CHECK(judged(more, closed).surplus == 2);
  // The pair of the first reply in the second is no pair of the first.
  const std::string late = R"({"replies":[{"pairs":[]},{"pairs":[[0,1]]},{"pairs":[[0,1]]}]})";
  CHECK(judged(late, closed).verdict == Verdict::algorithm);
  CHECK(judged(late, unspecified).verdict == Verdict::convention);
  const std::string lost = R"({"replies":[{"pairs":[[0,1]]},{"pairs":[]},{"pairs":[]}]})";
  CHECK(judged(lost, unspecified).verdict == Verdict::algorithm);
  const std::string few = R"({"replies":[{"pairs":[[0,1]]},{"pairs":[]}]})";
  CHECK(judged(few, closed).verdict == Verdict::invalid);
  CHECK(judged(few, closed).remark == "answer.replies: a reply to each of the 3 queries");
  const std::string twin = R"({"replies":[{"pairs":[[0,1]]},{"pairs":[[1,1]]},{"pairs":[]}]})";
  CHECK(judged(twin, closed).remark == "answer.replies[1].pairs[0]: different places in the list");
}

TEST_CASE("broad_phase: a structure is seen after the start and after each command") {
  const Row::Question question{{along_x(0, 4), along_x(2, 6)}, {pairs, Remove{0}, Insertd{far_away}, pairs}};
  std::vector<std::size_t> seen;
  const auto see = [&seen](const robust::SweptBoxes& bodies) { seen.push_back(bodies.pairs().size()); };
  const Replies found = replies(robust::SweptBoxes{}, std::get<0>(question), std::get<1>(question), see);
  CHECK(seen == std::vector<std::size_t>{1, 1, 0, 0, 0});
  CHECK(found == Replies{{{{0, 1}}}, {}});
}

TEST_CASE("SweptBoxes: what is refused changes nothing") {
  robust::SweptBoxes bodies;
  CHECK(bodies.insert(along_x(0, 4)) == 0);
  CHECK(bodies.insert(along_x(2, 6)) == 1);
  const auto refuses = [&](const auto& change, const std::string& complaint) {
    CHECK_THROWS_WITH(change(), complaint);
    CHECK(bodies.pairs() == Pairs{{0, 1}});
  };
  refuses([&] { bodies.insert(along_x(1, 0)); }, "box.max[0]: min <= max");
  refuses([&] { bodies.move(0, along_x(0, infinity)); }, "box.max[0]: finite number");
  refuses([&] { bodies.move(2, far_away); }, "body: index of a body that is there");
  refuses([&] { bodies.remove(9); }, "body: index of a body that is there");
  bodies.remove(0);
  CHECK(bodies.insert(along_x(5, 9)) == 2);
  CHECK(bodies.pairs() == Pairs{{1, 2}});
  CHECK_THROWS_AS(bodies.remove(0), InvalidInput);
}

}  // namespace touchstone::proptests::broad_phase_tests
