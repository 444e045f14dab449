/* SPDX-License-Identifier: Apache-2.0 */
/* Decides segment pairs by the array, and asks for the truth of one. */
#include <stdio.h>
#include <touchstone.h>

int main(void) {
  /* Two segments in each row: x and y of both ends. The first pair crosses, the second overlaps, the third only seems to
   * meet: its ends miss each other by one unit in the last place. */
  const double pairs[3][8] = {
      {0, 0, 2, 2, 0, 2, 2, 0},
      {0, 0, 2, 0, 1, 0, 3, 0},
      {0, 0, 1, 1, 1, 1.0000000000000002, 2, 2},
  };
  const char* const words[] = {"disjoint", "point", "overlap"};
  uint8_t answers[3];
  touchstone_error error;
  char* truth;
  size_t i;

  const touchstone_segments2 a = touchstone_segments2_rows(&pairs[0][0], 8);
  const touchstone_segments2 b = touchstone_segments2_rows(&pairs[0][4], 8);
  if (touchstone_segment_segment(a, b, 3, answers, &error) != TOUCHSTONE_OK) {
    fprintf(stderr, "question %lu: %s: %s\n", (unsigned long)error.question, error.field, error.rule);
    return 1;
  }
  for (i = 0; i < 3; ++i) puts(words[answers[i]]);

  if (touchstone_truth("segment_segment", "{\"a\":[[0,0],[3,3]],\"b\":[[0,1],[1,0]]}", &truth, &error) != TOUCHSTONE_OK) {
    fprintf(stderr, "%s: %s\n", error.field, error.rule);
    return 1;
  }
  puts(truth);
  touchstone_free(truth);
  return 0;
}
