/* SPDX-License-Identifier: Apache-2.0 */
#ifndef TOUCHSTONE_H
#define TOUCHSTONE_H

/* Every operation of touchstone in C, one question at a time, as JSON: what robust answers, what the truth is, and why
 * it is; and audits of a function of yours. Arrays of questions are in touchstone_robust.h.
 *
 * A question is an object with the fields that docs/operations.md lists for its operation, {"a":[[0,0],[2,0]], ...};
 * its numbers are read as the nearest doubles. Numbers of an answer in doubles are written with a point or an exponent
 * (1.0), so that they are told from indices; exact ones are texts, "p/q", "p" or "p+q*sqrt(r)".
 *
 * Each function returns TOUCHSTONE_OK and a text, which touchstone_free frees; or another touchstone_code, and says in
 * *error, which may be NULL, which field breaks which rule. Then *result is NULL. Nothing is thrown, and all functions
 * may be called from several threads at once. */

#include <stdint.h>
#include <touchstone_robust.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What robust answers: {"relation":"point","ta":0.5,...}. */
int touchstone_answer(const char* operation, const char* question, char** result, touchstone_error* error);

/* {"op":..,"input":..,"truth":..,"rounded":..,"margin":..,"touch":..,"certificate":..}: the exact truth, a right answer
 * in doubles, how far the question is from another answer ("margin", where something is decided), whether open sets
 * have another answer, and the proof. The line is a claim for touchstone_certify. */
int touchstone_truth(const char* operation, const char* question, char** result, touchstone_error* error);

/* What `touchstone ask` prints: truth, certificate, robust and the textbook formula with the verdict on each. */
int touchstone_ask(const char* operation, const char* question, char** result, touchstone_error* error);

/* The line of touchstone_ask with more fields, for people: "sentence" (the truth in words), "rounded", "outcome",
 * "touch", "as_typed" (the truth of the decimals of the text, where the operation has one), "sentence" and "why" of
 * each answer that was judged, "reference_in_float" (the textbook formula in float, with "input" and "truth" where
 * rounding to float makes another question of it, or with "not_evaluated" where that takes too many steps), "checker"
 * (the checker's complaint about the certificate; "" if there is none). */
int touchstone_explain(const char* operation, const char* question, char** result, touchstone_error* error);

/* The figures of a question and its truth, and of `answer`, an answer to it in JSON, if it is not NULL: "figures" in
 * the plane and "space", lists of {"kind":..,"label":..,"numbers":[..],"whose":"question|truth|answer"} with numbers as
 * in catalogue/draw/drawing.h and "faces" of a mesh; "notes", what cannot be drawn; and what the pages of a report
 * show: "svg" in the plane, otherwise "model", which report/scripts/viewer.js draws. */
int touchstone_drawing(const char* operation, const char* question, const char* answer, char** result,
                       touchstone_error* error);

/* The questions around a question in which two of its numbers, counted from 0, move by units in the last place of
 * double or float: to the right in `first`, upwards in `second`; `side` of them each way, an odd number up to 255, with
 * the question itself in the middle. {"fields":["p[0]","p[1]"],"steps":[..],"verdicts":[[..]],"truths":[[..]]}: rows
 * from the top; the verdict on the textbook formula and the truth's enumerator, or "refused" outside the contract. */
int touchstone_map(const char* operation, const char* question, size_t first, size_t second, size_t side, int binary32,
                   char** result, touchstone_error* error);

/* Whether the certificate of a claim proves its truth. TOUCHSTONE_REFUSED: it does not; error->rule says why. */
int touchstone_certify(const char* claim, touchstone_error* error);

/* What `touchstone draw` prints: questions within the contract, degenerate on purpose, a line each: {"op":..,
 * "family":..,"index":..,"input":..,"truth":..,"rounded":..,"margin":..,"touch":..}. `families`: names with commas;
 * NULL or "": all. The same seed gives the same questions on every machine. */
int touchstone_draw(const char* operation, const char* families, uint64_t cases, uint64_t seed, char** result,
                    touchstone_error* error);

/* The question that these bytes draw from a family; past their end every choice is the simplest, so fewer and smaller
 * bytes give a simpler question of the same family: what a property test shrinks. It may lie outside the contract. */
int touchstone_replay(const char* operation, const char* family, const uint8_t* bytes, size_t count, char** result,
                      touchstone_error* error);

/* A question in JSON, from a text in JSON, WKT or GeoJSON, as in `touchstone ask --wkt` and --geojson; its decimals
 * stay as they were typed. */
int touchstone_read(const char* operation, const char* text, char** result, touchstone_error* error);

/* The file that `touchstone ask --as` prints: a regression test of the question for "catch2", "gtest", "pytest",
 * "jest" or "rust". */
int touchstone_regression_test(const char* operation, const char* question, const char* framework, char** result,
                               touchstone_error* error);

/* An implementation that is judged, called with a name and a question in JSON. Returns what an engine over pipes
 * answers (docs/engines.md), without its id: {"answer":..}, {"error":"why"} or {"unsupported":true}; NULL leaves the
 * question unasked. The text must stay valid until the next call. It is called from the thread of the caller alone. Its
 * greeting is that of docs/engines.md: {"engine":"mine 1.0","ops":["orientation"],"boundary":"closed"}. */
typedef const char* (*touchstone_engine)(void* user, const char* operation, const char* question);

/* The verdict on one reply of an engine: {"answer":..,"verdict":..,"cause":..,"finding":true,"truth":..,"why":..}. */
int touchstone_judge(const char* greeting, const char* operation, const char* question, const char* reply,
                     char** result, touchstone_error* error);

/* An audit in this process, as `touchstone audit` makes it: {"exit_code":0,"table":"..","tally":{..}}, with the exit
 * code and the table of the program, and the tally of its --json. `options`, which may be NULL: an object of "ops" and
 * "families" (lists of names; left out: all), "cases" (20000), "seed" (1), "by_cost", "ordinary_only", "fail_on" (a
 * list of causes), "summary", and "program" and "options", with which the table says how to ask again. */
int touchstone_audit(const char* options, const char* greeting, touchstone_engine engine, void* user, char** result,
                     touchstone_error* error);

/* The shortest question on which the textbook formula, or the engine if it is not NULL, is wrong in the same way:
 * {"input":..,"candidates":..,"finished":true}. `options`, which may be NULL: an object of "binary32" (the formula in
 * float), "any_answer" (the same cause suffices) and "allow_degenerate". The field "question" is refused where the
 * answer is right. */
int touchstone_shrink(const char* operation, const char* question, const char* options, const char* greeting,
                      touchstone_engine engine, void* user, char** result, touchstone_error* error);

/* A scene (docs/simulate.md), as `touchstone simulate` plays it: {"summary":"..","page":".."}, what the program prints
 * and the page of its --page; of an exact gas the summary alone; and "ended", why, where a step cannot be made.
 * `options`, which may be NULL: an object of "runs" (["float","double","robust"]) and "steps" (0: those of the scene).
 */
int touchstone_simulate(const char* scene, const char* options, char** result, touchstone_error* error);

/* A list of all operations: names, fields, answers, enumerators, families. */
int touchstone_operations(char** result, touchstone_error* error);

void touchstone_free(char* result);

#ifdef __cplusplus
}
#endif

#endif
