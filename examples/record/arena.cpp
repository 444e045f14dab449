// SPDX-License-Identifier: Apache-2.0
// A small game in float: 150 balls and 50 crates on a grid, players that shoot and walk, and three bugs (arena_tests.h)
// that its own tests do not see. It records what it asks itself; 60 seconds of play are 2.2 million calls.
//
//   arena --test               its own tests, which pass
//   arena LOG SECONDS [SEED]   plays, 60 steps a second of its own time, and records
#if __has_include(<touchstone/record.h>)
#include <touchstone/record.h>
#else
#include "c/record.h"  // in the source tree: -I. -Ic
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "arena_tests.h"

namespace {

using namespace arena;

class Arena {
 public:
  explicit Arena(unsigned seed) : random_(seed) {
    for (int i = 0; i < 150; ++i) balls_.push_back({{on_grid(), on_grid()}, 0.25f}), speeds_.push_back(speed());
    for (int i = 0; i < 50; ++i) {
      const Point corner{on_grid(), on_grid()};
      crates_.push_back({corner, {corner.x + 1, corner.y + 1}});
    }
  }

  void step() {
    if (steps_++ % 60 == 0) {  // three balls fly apart
      const Point from{on_grid(), on_grid()};
      for (int i = 0; i < 3; ++i) balls_[random_() % balls_.size()].center = from;
    }
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      for (std::size_t k = i + 1; k < balls_.size(); ++k) {
        const Ball &a = balls_[i], &b = balls_[k];
        if (std::fabs(a.center.x - b.center.x) > 1 || std::fabs(a.center.y - b.center.y) > 1) continue;
        const auto meet = [&] { return balls_meet(a, b); };
        if (touchstone::record("sphere_sphere", meet, a, b)) std::swap(speeds_[i], speeds_[k]);
      }
      for (const Crate& crate : crates_) {
        const Ball& ball = balls_[i];
        if (std::fabs(ball.center.x - crate.min.x) > 2 || std::fabs(ball.center.y - crate.min.y) > 2) continue;
        const auto meet = [&] { return ball_meets_crate(ball, crate); };
        if (touchstone::record("sphere_aabb", meet, ball, crate)) speeds_[i] = {-speeds_[i].x, -speeds_[i].y};
      }
    }
    // Players stand on the grid, walk along it and shoot across it.
    const Point from{on_grid(), on_grid()}, to{on_grid(), on_grid()};
    const Segment shot{from, random_() % 4 == 0 ? Point{to.x, from.y} : to};
    for (const Crate& crate : crates_) {
      const auto meet = [&] { return shot_meets_crate(shot, crate); };
      hits_ += touchstone::record("segment_aabb", meet, shot, crate);
    }
    const Point end{on_grid(), on_grid()};
    const Segment first{from, {from.x + 1, from.y}}, second{end, random_() % 2 == 0 ? Point{end.x + 1, end.y} : from};
    const auto meet = [&] { return steps_meet(first, second); };
    hits_ += touchstone::record("segment_segment", meet, first, second);
    for (std::size_t i = 0; i < balls_.size(); ++i) move(balls_[i], speeds_[i]);
  }

  int hits() const { return hits_; }

 private:
  float on_grid() { return static_cast<float>(random_() % 64) * 0.25f; }
  Point speed() { return {static_cast<float>(random_() % 9) - 4, static_cast<float>(random_() % 9) - 4}; }
  static void move(Ball& ball, Point& speed) {
    for (float Point::*axis : {&Point::x, &Point::y}) {
      ball.center.*axis += speed.*axis / 60;
      if (ball.center.*axis < 0 || ball.center.*axis > 16) speed.*axis = -(speed.*axis);
    }
  }

  std::mt19937 random_;
  std::vector<Ball> balls_;
  std::vector<Point> speeds_;
  std::vector<Crate> crates_;
  int steps_ = 0, hits_ = 0;
};

/// What the game's own tests try.
bool tests_pass() {
  const Crate crate{{0, 0}, {1, 1}};
  return balls_meet({{0, 0}, 1}, {{2, 0}, 1}) && !balls_meet({{0, 0}, 1}, {{2.5f, 0}, 1}) &&
         ball_meets_crate({{1.5f, 0.5f}, 0.5f}, crate) && !ball_meets_crate({{2, 2}, 1}, crate) &&
         shot_meets_crate({{-1, -1}, {2, 2}}, crate) && shot_meets_crate({{-1, 0.5f}, {2, 0.5f}}, crate) &&
         !shot_meets_crate({{-1, 2}, {2, 2}}, crate) && steps_meet({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}) &&
         steps_meet({{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}) && !steps_meet({{0, 0}, {2, 0}}, {{0, 1}, {2, 1}});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--test")
    return std::puts(tests_pass() ? "all tests pass" : "a test fails"), tests_pass() ? 0 : 1;
  if (argc < 3) return std::fputs("arena --test, or arena LOG SECONDS [SEED]\n", stderr), 2;
  const touchstone::Recording recording(argv[1], {.engine = "arena 1.0", .boundary = "closed"});
  Arena arena(argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1);
  for (int step = 0; step < 60 * std::atoi(argv[2]); ++step) arena.step();
  std::printf("%d hits\n", arena.hits());
}
