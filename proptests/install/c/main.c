/* SPDX-License-Identifier: Apache-2.0 */
/* What a C programmer has of the installed package, in C99: arrays equal single answers equal the truth, wherever the
 * numbers stand; and errors. Returns the number of what is wrong. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone.h>
#include <touchstone_record.h>

static int wrong = 0;

static void check(int right, const char* what) {
  if (right) return;
  printf("wrong: %s\n", what);
  ++wrong;
}

static const char* const relations[] = {"disjoint", "point", "overlap"};

/* Whether a text holds "key":"word". */
static int says(const char* text, const char* key, const char* word) {
  char expected[64];
  sprintf(expected, "\"%s\":\"%s\"", key, word);
  return text != NULL && strstr(text, expected) != NULL;
}

/* All segments between points of {0, 1, 2}^2, in pairs. */
enum { points = 9, segments = points * points, pairs = segments * segments };

static void segment(int number, double* ends) {
  const int a = number / points, b = number % points;
  ends[0] = a / 3;
  ends[1] = a % 3;
  ends[2] = b / 3;
  ends[3] = b % 3;
}

static void decisions(void) {
  double* const rows = malloc(sizeof(double) * 8 * pairs);
  double* const columns = malloc(sizeof(double) * 8 * pairs);
  uint8_t* const by_rows = malloc(pairs);
  uint8_t* const by_columns = malloc(pairs);
  int seen[3] = {0, 0, 0};
  touchstone_error error;
  int i, k;
  for (i = 0; i < pairs; ++i) {
    segment(i / segments, rows + 8 * i);
    segment(i % segments, rows + 8 * i + 4);
    for (k = 0; k < 8; ++k) columns[k * pairs + i] = rows[8 * i + k];
  }
  check(touchstone_segment_segment(touchstone_segments2_rows(rows, 8), touchstone_segments2_rows(rows + 4, 8), pairs, by_rows,
                                   &error) == TOUCHSTONE_OK, "segments in rows are answered");
  {
    const touchstone_segments2 a = {{{columns, 1}, {columns + pairs, 1}}, {{columns + 2 * pairs, 1}, {columns + 3 * pairs, 1}}};
    const touchstone_segments2 b = {{{columns + 4 * pairs, 1}, {columns + 5 * pairs, 1}},
                                    {{columns + 6 * pairs, 1}, {columns + 7 * pairs, 1}}};
    check(touchstone_segment_segment(a, b, pairs, by_columns, NULL) == TOUCHSTONE_OK, "segments in columns are answered");
  }
  check(memcmp(by_rows, by_columns, pairs) == 0, "rows and columns are answered alike");
  /* One segment for all: those of the pairs that begin with it. */
  check(touchstone_segment_segment(touchstone_segments2_rows(rows, 0), touchstone_segments2_rows(rows + 4, 8), segments,
                                   by_columns, &error) == TOUCHSTONE_OK, "one segment for all is answered");
  check(memcmp(by_rows, by_columns, segments) == 0, "one segment for all is answered like rows of it");
  for (i = 0; i < pairs; i += 7) {
    char question[256];
    char *answer, *truth;
    const double* const p = rows + 8 * i;
    sprintf(question, "{\"a\":[[%g,%g],[%g,%g]],\"b\":[[%g,%g],[%g,%g]]}", p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]);
    ++seen[by_rows[i]];
    check(touchstone_answer("segment_segment", question, &answer, &error) == TOUCHSTONE_OK, "a question is answered");
    check(says(answer, "relation", relations[by_rows[i]]), question);
    touchstone_free(answer);
    if (i % 49 != 0) continue;
    check(touchstone_truth("segment_segment", question, &truth, &error) == TOUCHSTONE_OK, "a truth is told");
    check(says(truth, "relation", relations[by_rows[i]]), question);
    check(touchstone_certify(truth, &error) == TOUCHSTONE_OK, "its certificate proves it");
    touchstone_free(truth);
  }
  for (k = 0; k < 3; ++k) check(seen[k] > 0, relations[k]);
  free(rows);
  free(columns);
  free(by_rows);
  free(by_columns);
}

static void shapes(void) {
  const double square[] = {0, 0, 4, 0, 4, 4, 0, 4};
  const double at[] = {2, 2, 4, 2, 5, 2};
  const double corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const uint32_t faces[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const double in_space[] = {0.125, 0.125, 0.125, 0, 0, 0, 1, 1, 1};
  const touchstone_polygon2 polygon = {square, 4};
  const touchstone_mesh mesh = {corners, 4, faces, 4};
  uint8_t answers[3];
  touchstone_error error;
  check(touchstone_point_in_polygon(polygon, touchstone_points2_rows(at, 2), 3, answers, &error) == TOUCHSTONE_OK, "a polygon");
  check(answers[0] == TOUCHSTONE_LOCATION_INSIDE && answers[1] == TOUCHSTONE_LOCATION_BOUNDARY &&
            answers[2] == TOUCHSTONE_LOCATION_OUTSIDE, "locations of a polygon");
  check(touchstone_point_in_polyhedron(mesh, touchstone_points3_rows(in_space, 3), 3, answers, &error) == TOUCHSTONE_OK, "a mesh");
  check(answers[0] == TOUCHSTONE_LOCATION_INSIDE && answers[1] == TOUCHSTONE_LOCATION_BOUNDARY &&
            answers[2] == TOUCHSTONE_LOCATION_OUTSIDE, "locations of a mesh");
}

static void errors(void) {
  double rows[40 * 2] = {0};
  uint8_t answers[40];
  const touchstone_points2 p = touchstone_points2_rows(rows, 2);
  const touchstone_polygon2 two_corners = {rows, 2};
  touchstone_error error;
  char* text = (char*)answers; /* not NULL, so that it is seen to become so */
  int i;
  for (i = 0; i < 80; ++i) rows[i] = i;
  rows[34] = INFINITY;
  rows[47] = NAN;
  check(touchstone_orientation(touchstone_points2_rows(rows, 0), p, touchstone_points2_rows(rows, 0), 40, answers, &error) ==
            TOUCHSTONE_INVALID_INPUT, "a number that is not finite is refused");
  check(error.question == 17 && strcmp(error.field, "p1[0]") == 0 && strcmp(error.rule, "finite number") == 0, error.field);
  check(touchstone_orientation(p, p, p, 40, answers, NULL) == TOUCHSTONE_INVALID_INPUT, "the same without a place for it");
  check(touchstone_orientation(p, p, p, 17, answers, &error) == TOUCHSTONE_OK, "what comes before it is answered");
  check(touchstone_point_in_polygon(two_corners, p, 10, answers, &error) == TOUCHSTONE_INVALID_INPUT, "a polygon is refused");
  check(error.question == TOUCHSTONE_NO_QUESTION && strncmp(error.field, "polygon", 7) == 0, error.field);

  check(touchstone_answer("segment_segmnt", "{}", &text, &error) == TOUCHSTONE_INVALID_INPUT && text == NULL, "a misspelt name");
  check(strcmp(error.field, "operation") == 0 && strstr(error.rule, "segment_segment") != NULL, error.rule);
  check(touchstone_truth("orientation", "{\"p0\":[0,0],\"p1\":[1,1e999],\"p\":[0,0]}", &text, &error) == TOUCHSTONE_INVALID_INPUT,
        "1e999");
  check(strcmp(error.field, "p1[1]") == 0 && strcmp(error.rule, "finite number") == 0, error.field);
  check(touchstone_answer(NULL, "{}", &text, &error) == TOUCHSTONE_INVALID_INPUT, "no operation");
  check(touchstone_answer("orientation", NULL, &text, &error) == TOUCHSTONE_INVALID_INPUT, "no question");
  check(touchstone_answer("orientation", "{}", NULL, &error) == TOUCHSTONE_INVALID_INPUT, "no place for the answer");
  check(touchstone_certify("{\"op\":\"orientation\"}", &error) == TOUCHSTONE_REFUSED && error.rule[0] != 0, "no certificate");
  check(touchstone_certify(NULL, NULL) == TOUCHSTONE_INVALID_INPUT, "no claim");
  check(touchstone_draw("orientation", "no_such_family", 3, 1, &text, &error) == TOUCHSTONE_INVALID_INPUT, "no such family");
  check(strcmp(error.field, "families") == 0, error.field);
  check(touchstone_draw("orientation", "collinear", 3, 1, &text, &error) == TOUCHSTONE_OK, "drawn");
  check(says(text, "family", "collinear"), text);
  touchstone_free(text);
  check(touchstone_operations(&text, &error) == TOUCHSTONE_OK && strstr(text, "\"segment_segment\"") != NULL, "operations");
  touchstone_free(text);
  check(touchstone_ask("orientation", "{\"p0\":[0,0],\"p1\":[1,1],\"p\":[2,2]}", &text, &error) == TOUCHSTONE_OK, "asked");
  check(strstr(text, "\"verdict\"") != NULL, text);
  touchstone_free(text);
}

static void records(void) {
  const double points[6] = {0, 0, 1, 0, 2, 0};
  FILE* log;
  char first[6] = {0};
  check(touchstone_record_open("from_c.log", NULL) == 0, "a log is open");
  TOUCHSTONE_RECORD_DOUBLES("orientation", points, 6, TOUCHSTONE_RECORD_WORD, 1);
  check(touchstone_record_close() == 0, "a log is closed");
  log = fopen("from_c.log", "rb");
  check(log != NULL && fread(first, 1, 6, log) == 6 && memcmp(first, "\x89TSLOG", 6) == 0, "a log is written");
  if (log != NULL) fclose(log);
}

int main(void) {
  records();
  decisions();
  shapes();
  errors();
#ifdef VERSION_OF_PACKAGE
  check(strcmp(TOUCHSTONE_VERSION, VERSION_OF_PACKAGE) == 0, "the version in the header is the package's");
#endif
  return wrong > 125 ? 125 : wrong;
}
