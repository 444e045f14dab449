/* SPDX-License-Identifier: Apache-2.0 */
/* Records what two threads of a game ask their own segment test. C99, and C++ as well. */
#include <pthread.h>
#include <stdio.h>
#include <touchstone_record.h>

typedef struct point {
  double x, y;
} point;

static double side(point p, point q, point r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); }

/* The test as it is in many a game: right but for segments on one line. */
static int segments_meet(point a, point b, point c, point d) {
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

/* A wall of ten segments, and a ball that moves along it. */
static void* play(void* player) {
  const double y = *(const double*)player;
  int step, wall;
  for (step = 0; step < 1000; ++step) {
    for (wall = 0; wall < 10; ++wall) {
      const double x = 0.01 * step, left = wall;
      const point a = {x, y}, b = {x + 0.05, y}, c = {left, 0}, d = {left + 0.5, 0};
      const int hit = segments_meet(a, b, c, d);
      const double numbers[8] = {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
      TOUCHSTONE_RECORD_DOUBLES("segment_segment", numbers, 8, TOUCHSTONE_RECORD_FLAG, hit);
    }
  }
  return NULL;
}

int main(int argc, char** argv) {
  touchstone_record_options options;
  double first = 0, second = 1;
  pthread_t thread;
  memset(&options, 0, sizeof options);
  options.engine = "game 1.0";
  options.boundary = "closed";
  if (touchstone_record_open(argc > 1 ? argv[1] : "game.log", &options) != 0) {
    perror("the log");
    return 1;
  }
  if (pthread_create(&thread, NULL, play, &second) != 0) return 1;
  play(&first);
  pthread_join(thread, NULL);
  return touchstone_record_close();
}
