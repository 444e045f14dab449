// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/broad_phase/broad_phase.h"

#include "proptests/space_laws.h"
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
  for (const Pairs& reply : expected) replies.push_back(PairsReply{reply});
  example<Row>({boxes, commands}, replies);
  CHECK(examined<Row>({boxes, commands})->margin() == margin);
}

/// The same of one query.
void finds(const Boxes& boxes, const Commandd& query, const QueryReply& expected,
           const std::optional<Rational>& margin) {
  example<Row>({boxes, {query}}, {expected});
  CHECK(examined<Row>({boxes, {query}})->margin() == margin);
}
AlongRayd ray(const Point3d& from, const Vector3d& by) { return {{from, by}}; }

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
  struct Erase {
    Index body;
    void operator()(PairsReply& reply) const {
      std::erase_if(reply.pairs, [this](const IndexPair& pair) { return pair.i == body || pair.j == body; });
    }
    void operator()(BodiesReply& reply) const { std::erase(reply.bodies, body); }
    void operator()(RayReply& reply) const { std::erase(reply.in_order, body); }
  };
  for (QueryReply& reply : replies) std::visit(Erase{body}, reply);
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
    if (!is_query(command)) continue;
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

LAW("broad_phase: the bodies around a point meet its box, and a ray that starts there first", boxes, commands) {
  Commands at, in, along;
  for (const Aabb3d& box : boxes) {
    at.emplace_back(AtPointd{box.min}), in.emplace_back(InBoxd{{box.min, box.min}});
    along.emplace_back(ray(box.min, {1, 0, -0.0}));
  }
  const Replies points = ask(Row::Question{boxes, at});
  if (points != ask(Row::Question{boxes, in})) return false;
  const Replies rays = ask(Row::Question{boxes, along});
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::vector<Index>&bodies = std::get<BodiesReply>(points[i]).bodies,
          &met = std::get<RayReply>(rays[i]).in_order;
    if (met.size() < bodies.size() || !std::equal(bodies.begin(), bodies.end(), met.begin())) return false;
  }
  return true;
}

LAW("broad_phase: pairs are what each body's box meets", boxes, commands) {
  Commands each{pairs};
  for (const Aabb3d& box : boxes) each.emplace_back(InBoxd{box});
  const Replies replies = ask(Row::Question{boxes, each});
  Pairs found;
  for (Index i = 0; i < boxes.size(); ++i)
    for (const Index j : std::get<BodiesReply>(replies[i + 1]).bodies)
      if (i < j) found.push_back({i, j});
  return std::get<PairsReply>(replies[0]).pairs == found;
}

LAW("broad_phase: a ray of twice the direction meets the same", boxes, commands) {
  Commands rays, doubled;
  for (const Commandd& command : commands) {
    const auto* query = std::get_if<AlongRayd>(&command);
    if (query == nullptr) continue;
    const auto& [o, d] = query->ray;
    const Vector3d twice{2 * d.x, 2 * d.y, 2 * d.z};
    if (!std::isfinite(twice.x) || !std::isfinite(twice.y) || !std::isfinite(twice.z)) continue;
    rays.push_back(command), doubled.emplace_back(ray(o, twice));
  }
  return ask(Row::Question{boxes, rays}) == ask(Row::Question{boxes, doubled});
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

TEST_CASE("broad_phase: a box and a point against intervals, worked by hand") {
  const Boxes three{along_x(0, 1), along_x(1, 2), along_x(4, 6)};
  // 1 is an end of two bodies; 2.5 is a half beyond the nearest end, and the point a half inside on y.
  finds(three, InBoxd{along_x(1, 1)}, BodiesReply{{0, 1}}, 0);
  finds(three, InBoxd{along_x(2.5, 3)}, BodiesReply{}, Rational(1, 4));
  finds(three, AtPointd{{1, 0.5, 0.5}}, BodiesReply{{0, 1}}, 0);
  finds(three, AtPointd{{5, 0.5, 0.5}}, BodiesReply{{2}}, Rational(1, 4));
  finds(three, AtPointd{{-0.0, 0, 1}}, BodiesReply{{0}}, 0);
  finds({}, InBoxd{far_away}, BodiesReply{}, std::nullopt);
  finds({}, ray({0, 0, 0}, {1, 0, 0}), RayReply{}, std::nullopt);
  finds({far_away}, AtPointd{{0, 0, 0}}, BodiesReply{}, Rational(2000 * 2000));
}

TEST_CASE("broad_phase: a ray's bodies are in the order of their first t, worked by hand") {
  const Boxes three{{{6, -4, -4}, {8, 4, 4}}, {{2, -3, -3}, {4, 3, 3}}, {{-4, -2, -2}, {-2, 2, 2}}};
  // t = 6/2 and 2/2; 2/2. Halfway through, the ray is 1 from both faces on x, and farther from the others.
  finds(three, ray({0, 0, 0}, {2, 0.5, 0.5}), RayReply{{1, 0}}, 1);
  finds(three, ray({0, 0, 0}, {-2, 0.5, 0.5}), RayReply{{2}}, 1);
  // From within the second; into the first at t = 3, and out of it on y at 3.75.
  finds(three, ray({3, 0.25, 0.25}, {1, 1, 1}), RayReply{{1, 0}}, Rational(9, 64));
  // Through a corner of one and a face of the other: both at t = 1, by their indices.
  const Boxes corner{{{1, 1, 1}, {2, 2, 2}}, {{0, 1, 0}, {2, 2, 2}}};
  finds(corner, ray({0, 0, 0}, {1, 1, 1}), RayReply{{0, 1}}, 0);
  // Around the origin: t = 0, by their indices; the first begins 1 behind it.
  const Boxes around{{{-1, -1, -1}, {5, 5, 5}}, {{-3, -3, -3}, {2, 2, 2}}};
  finds(around, ray({0, 0, 0}, {1, 1, 1}), RayReply{{0, 1}}, 1);
}

TEST_CASE("broad_phase: along a face, and with 0 and -0.0 in the direction") {
  const Boxes box{along_x(0, 1)};
  finds(box, ray({0, -1, 0}, {0, 1, 0}), RayReply{{0}}, 0);
  finds(box, ray({0, -1, 0}, {-0.0, 1, -0.0}), RayReply{{0}}, 0);
  finds(box, ray({1, 2, 1}, {0, -1, 0}), RayReply{{0}}, 0);
  CHECK(robust::broad_phase(box, {ray({2, -1, 0.5}, {0, 1, 0})}) == Replies{RayReply{}});
}

TEST_CASE("broad_phase: first parameters that round alike, overflow or are subnormal are told apart") {
  const auto order = [](const Boxes& boxes, const AlongRayd& query) {
    const Replies found = robust::broad_phase(boxes, {query});
    CHECK(found == oracle::broad_phase(boxes, {Commandd(query)}).answer);
    return std::get<RayReply>(found[0]).in_order;
  };
  using Order = std::vector<Index>;
  // 1/3 on x; on y a number below it by far less than an ulp of either.
  const double third = 1.0 / 3;
  const Boxes thirds{{{1, -9, -9}, {9, 9, 9}}, {{-9, third, -9}, {9, 9, 9}}};
  CHECK(order(thirds, ray({0, 0, 0}, {3, 1, 0})) == Order{1, 0});
  // 2^1023 / 2^-1074 and the next.
  const Boxes beyond{{{0x1.8p1023, 0, 0}, {greatest, 1, 1}}, {{0x1p1023, 0, 0}, {greatest, 1, 1}}};
  CHECK(order(beyond, ray({-greatest, 0.5, 0.5}, {tiny, 0, 0})) == Order{1, 0});
  // 3 and 2 times 2^-1074 / 2^1000.
  const Boxes least{{{3 * tiny, -1, -1}, {1, 1, 1}}, {{2 * tiny, -1, -1}, {1, 1, 1}}};
  CHECK(order(least, ray({0, 0, 0}, {0x1p1000, 0, 0})) == Order{1, 0});
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
  refused<Row>({{}, {InBoxd{wrong}}}, "commands[0].in_box.max[0]", order);
  refused<Row>({{wrong}, {InBoxd{not_finite}}}, "commands[0].in_box.max[0]", finite);
  refused<Row>({{}, {AtPointd{{0, 0, not_a_number}}}}, "commands[0].at_point[2]", finite);
  refused<Row>({{}, {ray({0, infinity, 0}, {0, 0, 0})}}, "commands[0].along_ray.origin[1]", finite);
  refused<Row>({{}, {ray({0, 0, 0}, {0, -0.0, 0}), InBoxd{not_finite}}}, "commands[1].in_box.max[0]", finite);
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

TEST_CASE("broad_phase: an engine's bodies may come in any order, but along a ray in the truth's") {
  using catalogue::Verdict;
  const auto judge = [](const Commandd& query, const std::string& reply) {
    const Boxes boxes{along_x(4, 5), along_x(2, 3), along_x(0, 1), along_x(9, 9.5)};
    const auto examination = examined<Row>({boxes, {query}});
    return examination->judge_engine(catalogue::parse_line(R"({"replies":[)" + reply + "]}"),
                                     {"by hand", catalogue::Declaration::Boundary::closed});
  };
  const Commandd along = ray({-1, 0.5, 0.5}, {1, 0, 0}), in = InBoxd{along_x(0.5, 4.5)};
  CHECK(judge(in, R"({"bodies":[2,0,1]})").verdict == Verdict::agree);
  CHECK(judge(in, R"({"bodies":[2,1]})").verdict == Verdict::algorithm);
  CHECK(judge(along, R"({"in_order":[2,1,0,3]})").verdict == Verdict::agree);
  for (const char* reply : {"[2,0,1,3]", "[0,1,2,3]", "[2,1,0]", "[3,2,1,0]", "[]"}) {
    INFO(reply);
    CHECK(judge(along, R"({"in_order":)" + std::string(reply) + "}").verdict == Verdict::algorithm);
  }
  const auto twice = judge(along, R"({"in_order":[2,1,2,0,3]})");
  CHECK(twice.verdict == Verdict::agree);
  CHECK(twice.surplus == 1);
  CHECK(judge(along, R"({"bodies":[2,1,0,3]})").remark == "answer.replies[0]: a reply of in_order");
  CHECK(judge(in, R"({"bodies":[4000]})").remark == "answer.replies[0].bodies[0]: a place in the list");
}

TEST_CASE("broad_phase: a structure is seen after the start and after each command") {
  const Row::Question question{{along_x(0, 4), along_x(2, 6)}, {pairs, Remove{0}, Insertd{far_away}, pairs}};
  std::vector<std::size_t> seen;
  const auto see = [&seen](const robust::SweptBoxes& bodies) { seen.push_back(bodies.pairs().size()); };
  const Replies found = replies(robust::SweptBoxes{}, std::get<0>(question), std::get<1>(question), see);
  CHECK(seen == std::vector<std::size_t>{1, 1, 0, 0, 0});
  CHECK(found == Replies{PairsReply{{{0, 1}}}, PairsReply{}});
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
  refuses([&] { bodies.in_box(along_x(1, 0)); }, "box.max[0]: min <= max");
  refuses([&] { bodies.at_point({0, infinity, 0}); }, "point[1]: finite number");
  refuses([&] { bodies.along_ray({{0, 0, 0}, {0, 0, 0}}); }, "ray.direction: nonzero direction");
  bodies.remove(0);
  CHECK(bodies.insert(along_x(5, 9)) == 2);
  CHECK(bodies.pairs() == Pairs{{1, 2}});
  CHECK_THROWS_AS(bodies.remove(0), InvalidInput);
}

}  // namespace touchstone::proptests::broad_phase_tests
