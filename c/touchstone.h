/* SPDX-License-Identifier: Apache-2.0 */
#ifndef TOUCHSTONE_H
#define TOUCHSTONE_H

/* Every operation of touchstone in C, one question at a time, as JSON: what robust answers, what the truth is, and why
 * it is. Arrays of questions are in touchstone_robust.h.
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

/* Whether the certificate of a claim proves its truth. TOUCHSTONE_REFUSED: it does not; error->rule says why. */
int touchstone_certify(const char* claim, touchstone_error* error);

/* What `touchstone draw` prints: questions within the contract, degenerate on purpose, a line each: {"op":..,
 * "family":..,"index":..,"input":..,"truth":..,"rounded":..,"margin":..,"touch":..}. `families`: names with commas;
 * NULL or "": all. The same seed gives the same questions on every machine. */
int touchstone_draw(const char* operation, const char* families, uint64_t cases, uint64_t seed, char** result,
                    touchstone_error* error);

/* A list of all operations: names, fields, answers, enumerators, families. */
int touchstone_operations(char** result, touchstone_error* error);

void touchstone_free(char* result);

#ifdef __cplusplus
}
#endif

#endif
