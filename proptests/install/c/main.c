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

static void scenes(void) {
  static const char* const falls =
      "{\"touchstone_scene\":1,\"title\":\"a fall\",\"gravity\":[0,0,-1],\"advance\":{\"timestep\":0.5,\"steps\":4,\"option\":2},"
      "\"bodies\":[{\"name\":\"p\",\"shape\":{\"particle\":{}},\"position\":[0,0,8]}]}";
  touchstone_error error;
  char* text;
  const int code = touchstone_simulate(falls, "{\"runs\":[\"double\",\"robust\"],\"steps\":3}", &text, &error);
  check(code == TOUCHSTONE_OK, error.rule);
  if (code == TOUCHSTONE_OK) {
    check(strstr(text, "\"summary\":") != NULL && strstr(text, "a fall") != NULL, text);
    touchstone_free(text);
  }
  check(touchstone_simulate(falls, "{\"runs\":[\"quad\"]}", &text, &error) == TOUCHSTONE_INVALID_INPUT, "no run quad");
  check(strcmp(error.field, "options.runs") == 0, error.field);
  check(touchstone_simulate("{}", NULL, &text, &error) == TOUCHSTONE_INVALID_INPUT, "no bodies");
}

/* What an engine that always says "left" is called with. */
struct asked {
  int times;
  char last[200];
};
static const char* always_left(void* user, const char* operation, const char* question) {
  struct asked* const asked = user;
  ++asked->times;
  strncpy(asked->last, question, sizeof asked->last - 1);
  if (strcmp(operation, "orientation") != 0) return "{\"unsupported\":true}";
  return "{\"answer\":{\"side\":\"left\"}}";
}
static const char* never_asked(void* user, const char* operation, const char* question) {
  (void)user, (void)operation, (void)question;
  return NULL;
}

static void audits(void) {
  static const char* const greeting = "{\"engine\":\"left 1.0\",\"ops\":[\"orientation\"],\"boundary\":\"closed\"}";
  static const char* const right = "{\"p0\":[0,0],\"p1\":[4,0],\"p\":[3,-7]}";
  struct asked asked = {0, {0}};
  touchstone_error error;
  char* text;
  check(touchstone_judge(greeting, "orientation", right, "{\"answer\":{\"side\":\"left\"}}", &text, &error) == TOUCHSTONE_OK,
        "an answer is judged");
  check(says(text, "verdict", "wrong") && strstr(text, "\"finding\":true") != NULL && strstr(text, "\"why\":") != NULL, text);
  touchstone_free(text);
  check(touchstone_judge(greeting, "orientation", right, "nonsense", &text, &error) == TOUCHSTONE_OK && says(text, "verdict", "invalid"),
        "a reply that is not JSON is invalid");
  touchstone_free(text);
  check(touchstone_audit("{\"ops\":[\"orientation\"],\"cases\":200}", greeting, always_left, &asked, &text, &error) == TOUCHSTONE_OK,
        "an engine is audited");
  check(asked.times >= 200 && strstr(text, "\"exit_code\":1,") != NULL, "it is asked, and wrong");
  check(text != NULL && strstr(text, "touchstone audit of left 1.0 (binary64), boundary closed; 200 cases") != NULL, "it has a table");
  touchstone_free(text);
  check(touchstone_audit("{\"ops\":[\"orientation\"],\"cases\":20}", greeting, never_asked, NULL, &text, &error) == TOUCHSTONE_OK &&
            strstr(text, "\"exit_code\":1,") != NULL && strstr(text, "questions not asked") != NULL, "unasked questions are reported");
  touchstone_free(text);
  check(touchstone_audit("{\"case\":20}", greeting, always_left, &asked, &text, &error) == TOUCHSTONE_INVALID_INPUT &&
            strcmp(error.field, "options.case") == 0 && strstr(error.rule, "cases") != NULL, "a misspelt option");
  check(touchstone_audit(NULL, greeting, NULL, NULL, &text, &error) == TOUCHSTONE_INVALID_INPUT, "no engine");
  check(touchstone_shrink("orientation", "{\"p0\":[0.5,0.25],\"p1\":[4.5,0.125],\"p\":[3.75,-7.5]}", NULL, greeting, always_left, &asked,
                          &text, &error) == TOUCHSTONE_OK && strstr(text, "\"finished\":true") != NULL, "a finding is made small");
  touchstone_free(text);
  check(touchstone_shrink("orientation", right, NULL, NULL, NULL, NULL, &text, &error) == TOUCHSTONE_INVALID_INPUT &&
            strcmp(error.field, "question") == 0, "where the formula is right, there is nothing to shrink");
}

/* 257 balls far from each other: the formula takes 257^2 steps, and 2^16 are the most for which a cause is sought. */
static void many_balls(void) {
  static char question[257 * 40 + 20] = "{\"spheres\":[";
  touchstone_error error;
  char *text, *end = question + strlen(question);
  for (int i = 0; i < 257; ++i)
    end += sprintf(end, "%s{\"center\":[0,%d00,0],\"radius\":1}", i == 0 ? "" : ",", i + 1);
  strcpy(end, "]}");
  check(touchstone_explain("all_pairs", question, &text, &error) == TOUCHSTONE_OK &&
            strstr(text, "\"reference_in_float\":{\"not_evaluated\":\"66049 steps (n^2, n = 257)\"}") != NULL,
        "what takes too many steps is not evaluated");
  touchstone_free(text);
}

static void pictures(void) {
  static const char* const question = "{\"p0\":[0,0],\"p1\":[0.3,0.3],\"p\":[0.1,0.1]}";
  static const char* const segments = "{\"a\":[[0,0,0],[2,0,0]],\"b\":[[1,1,1],[3,0,0]]}";
  const uint8_t bytes[4] = {1, 2, 3, 4};
  touchstone_error error;
  char* text;
  check(touchstone_explain("orientation", question, &text, &error) == TOUCHSTONE_OK && says(text, "checker", "") &&
            says(text, "outcome", "on") && strstr(text, "\"as_typed\":{\"sentence\":") != NULL, "explained");
  touchstone_free(text);
  check(touchstone_drawing("orientation", question, NULL, &text, &error) == TOUCHSTONE_OK && strstr(text, "<svg") != NULL &&
            strstr(text, "\"whose\":\"question\"") != NULL, "drawn in the plane");
  touchstone_free(text);
  check(touchstone_drawing("segment_segment_distance", segments, NULL, &text, &error) == TOUCHSTONE_OK &&
            strstr(text, "\"model\":{\"title\"") != NULL, "drawn in space");
  touchstone_free(text);
  check(touchstone_map("orientation", question, 0, 5, 3, 0, &text, &error) == TOUCHSTONE_OK &&
            strstr(text, "\"fields\":[\"p0[0]\",\"p[1]\"]") != NULL, "a map");
  touchstone_free(text);
  check(touchstone_map("orientation", question, 0, 6, 3, 0, &text, &error) == TOUCHSTONE_INVALID_INPUT &&
            strcmp(error.field, "axes") == 0, "no such axis");
  check(touchstone_map("orientation", question, 0, 1, 4, 0, &text, &error) == TOUCHSTONE_INVALID_INPUT, "no middle");
  check(touchstone_replay("orientation", "collinear", bytes, 4, &text, &error) == TOUCHSTONE_OK && strstr(text, "\"p1\":") != NULL,
        "a question of bytes");
  touchstone_free(text);
  check(touchstone_read("segment_segment", "LINESTRING (0 0, 2 0); LINESTRING (1 0, 0.10 3)", &text, &error) == TOUCHSTONE_OK &&
            strcmp(text, "{\"a\":[[0,0],[2,0]],\"b\":[[1,0],[0.10,3]]}") == 0, text);
  touchstone_free(text);
  check(touchstone_regression_test("orientation", question, "jest", &text, &error) == TOUCHSTONE_OK && strstr(text, "my_orientation") != NULL,
        "a regression test");
  touchstone_free(text);
  check(touchstone_regression_test("orientation", question, "junit", &text, &error) == TOUCHSTONE_INVALID_INPUT, "no such framework");
  check(touchstone_replay("orientation", "colinear", NULL, 0, &text, &error) == TOUCHSTONE_INVALID_INPUT, "no family to replay");
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
  scenes();
  audits();
  many_balls();
  pictures();
#ifdef VERSION_OF_PACKAGE
  check(strcmp(TOUCHSTONE_VERSION, VERSION_OF_PACKAGE) == 0, "the version in the header is the package's");
#endif
  return wrong > 125 ? 125 : wrong;
}
