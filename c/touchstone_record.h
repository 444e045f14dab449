/* SPDX-License-Identifier: Apache-2.0 */
/* Records calls of one's own functions, with their answers, in a log (docs/own_inputs.md).
 *
 * C99 or C++, this header and touchstone_record_log.h beside it: nothing is linked. It needs gcc or clang, POSIX
 * threads, and IEEE 754 numbers.
 *
 *   touchstone_record_options options = {0};
 *   options.engine = "my game 1.0";
 *   options.one_in = 100;
 *   touchstone_record_open("game.log", &options);
 *   ...
 *   int hit = my_test(a, b);
 *   const double numbers[8] = {a.x1, a.y1, a.x2, a.y2, b.x1, b.y1, b.x2, b.y2};
 *   TOUCHSTONE_RECORD_DOUBLES("segment_segment", numbers, 8, TOUCHSTONE_RECORD_FLAG, hit);
 *
 * Each thread fills a buffer of its own without a lock. A buffer is written as one block when it is full, when its
 * thread ends and when the log is closed, which happens at exit. What a process that is killed has lost is what was in
 * its buffers; the log then has no end mark, and its reader says so. Where this header cannot write, calls are counted
 * as lost: it never ends the program, and never writes to its standard error. */
#ifndef TOUCHSTONE_RECORD_H
#define TOUCHSTONE_RECORD_H

#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- What is called ---- */

typedef struct touchstone_record_options {
  const char* engine;            /* name and version of what is recorded */
  const char* boundary;          /* "closed" or "open": whether what only touches meets; NULL: neither is promised */
  double tolerance;              /* in the unit of the input coordinates */
  unsigned long one_in;          /* of each site, one call in so many is written; 0 and 1: every call */
  unsigned long first;           /* the first calls of each site in each thread are written all */
  double near;                   /* and so is a call whose nearness (see below) is less */
  unsigned long long most_bytes; /* of the file; 0: 1 GiB. Calls for which there is no room are counted as lost. */
} touchstone_record_options;

/* Begins a log, and closes the one before. options may be NULL. Returns 0, or an error number. */
static inline int touchstone_record_open(const char* file, const touchstone_record_options* options);

/* Writes what all threads have recorded, and the end mark. Calls after this are not recorded. Returns 0, or EIO where
 * the file could not be written. */
static inline int touchstone_record_close(void);

/* What is recorded as an answer. */
typedef enum touchstone_record_answer {
  TOUCHSTONE_RECORD_FLAG,  /* 0 or 1: whether they meet */
  TOUCHSTONE_RECORD_WHOLE, /* all words and numbers of the operation's answer */
  TOUCHSTONE_RECORD_ERROR, /* why there is no answer */
  TOUCHSTONE_RECORD_WORD   /* the decision alone, as the place of its enumerator in `touchstone ops` */
} touchstone_record_answer;

/* Records a call of an operation whose questions are `count` numbers, a constant, in the order of `touchstone ops`; the
 * numbers are not evaluated where the call is not written. answer: an int, or an enumerator. */
#define TOUCHSTONE_RECORD_DOUBLES(operation, numbers, count, kind, answer) \
  TOUCHSTONE_RECORD_FIXED_(operation, double, numbers, count, kind, answer)
#define TOUCHSTONE_RECORD_FLOATS(operation, numbers, count, kind, answer) \
  TOUCHSTONE_RECORD_FIXED_(operation, float, numbers, count, kind, answer)

/* How near to degenerate the call is that this thread records next, in a unit of one's own: |determinant| / error
 * bound. It is for one call; where it is given several times, the least counts. */
static inline void touchstone_record_nearness(double nearness);

/* Any other question: lists, enumerators, flags. Numbers and words stand in the order of `touchstone ops`; a word is
 * the length of a list, an enumerator, a flag (0 or 1), an index, or whether something optional is there. Which
 * alternative of a question it is (in the plane, in space) is not said: it is the first that these numbers fit. */
typedef struct touchstone_record_value {
  const void* numbers;
  size_t number_count;
  const uint32_t* words;
  size_t word_count;
} touchstone_record_value;

/* A place in the program where calls are recorded; static, and one for each kind of answer. */
typedef struct touchstone_record_site {
  const char *operation, *place;
  size_t bytes_of_number; /* 8: double, 4: float */
  touchstone_record_answer answer;
  size_t numbers; /* of each question, where it has no words; 0: they differ */
  uint64_t id;    /* of the log that is open: its number, then 1 more than the site's */
} touchstone_record_site;
#define TOUCHSTONE_RECORD_SITE(operation, type, kind) \
  { operation, TOUCHSTONE_RECORD_PLACE_, sizeof(type), kind, 0, 0 }

/* Whether the site's next call is to be written: it is counted. If so, record it. */
static inline int touchstone_record_wants(touchstone_record_site* site);
/* answer: of a flag, a word or a whole answer. text: of an error. */
static inline void touchstone_record_call(touchstone_record_site* site, const touchstone_record_value* question,
                                          const touchstone_record_value* answer, const char* text);

/* ---- How it is done ---- */

#include <touchstone_record_log.h>

#define TOUCHSTONE_RECORD_TEXT_(x) #x
#define TOUCHSTONE_RECORD_LINE_(x) TOUCHSTONE_RECORD_TEXT_(x)
#define TOUCHSTONE_RECORD_PLACE_ __FILE__ ":" TOUCHSTONE_RECORD_LINE_(__LINE__)

#define TOUCHSTONE_RECORD_FIXED_(operation_, type_, numbers_, count_, kind_, answer_)                                  \
  do {                                                                                                                 \
    static touchstone_record_site touchstone_site_ = {                                                                 \
        operation_, TOUCHSTONE_RECORD_PLACE_, sizeof(type_), kind_, count_, 0};                                        \
    if (touchstone_record_wants(&touchstone_site_)) {                                                                  \
      const type_* touchstone_numbers_ = (numbers_);                                                                   \
      touchstone_record_fixed_(&touchstone_site_, touchstone_numbers_, (count_) * sizeof(type_),                     \
                               (kind_) == TOUCHSTONE_RECORD_FLAG ? (uint32_t)((answer_) != 0) : (uint32_t)(answer_));  \
    }                                                                                                                  \
  } while (0)

static inline void touchstone_record_nearness(double nearness) {
  if (nearness < touchstone_record_next_nearness) touchstone_record_next_nearness = nearness;
}

static inline int touchstone_record_wants(touchstone_record_site* site) {
  touchstone_record_state_* const state = &touchstone_record_state;
  const uint32_t log = __atomic_load_n(&state->log, __ATOMIC_ACQUIRE);
  const double nearness = touchstone_record_next_nearness;
  touchstone_record_thread_* thread = touchstone_record_thread;
  touchstone_record_count_* count;
  uint64_t id;
  touchstone_record_next_nearness = HUGE_VAL;
  if (log == 0) return 0;
  id = __atomic_load_n(&site->id, __ATOMIC_ACQUIRE);
  if (thread == NULL || thread->log != log || id >> 32 != log || thread->count_room < (id & 0xffffffff)) {
    if (!touchstone_record_prepare_(site)) return 0;
    thread = touchstone_record_thread;
    id = site->id;
  }
  count = &thread->counts[(id & 0xffffffff) - 1];
  TOUCHSTONE_RECORD_SET_(thread->seen, thread->seen + 1);
  if (state->one_in > 1 && count->seen++ >= state->first && !(nearness < state->near)) {
    if (count->left_out_next > 0) {
      --count->left_out_next;
      TOUCHSTONE_RECORD_SET_(thread->sampled_out, thread->sampled_out + 1);
      return 0;
    }
    /* From 0 to 2 one_in - 2 are left out next, at random, so that no rhythm of the program is followed. */
    thread->random ^= thread->random << 13;
    thread->random ^= thread->random >> 7;
    thread->random ^= thread->random << 17;
    count->left_out_next = (thread->random >> 11) % (2 * (uint64_t)state->one_in - 1);
  }
  if (!TOUCHSTONE_RECORD_READ_(state->full)) return 1;
  TOUCHSTONE_RECORD_SET_(thread->lost, thread->lost + 1);
  return 0;
}

/* Where the next call of so many bytes begins; NULL: it is lost. */
static inline unsigned char* touchstone_record_room_(touchstone_record_thread_* thread, size_t size) {
  size_t used = (size_t)(thread->filled & 0xffffffff);
  if (used + size > thread->room) {
    unsigned char* larger = thread->bytes;
    pthread_mutex_lock(&touchstone_record_state.lock);
    if (thread->log == touchstone_record_state.log) touchstone_record_flush_(thread);
    else TOUCHSTONE_RECORD_SET_(thread->filled, 0);
    if (size > thread->room)
      larger = size >> 31 ? NULL : (unsigned char*)realloc(larger, touchstone_record_head_ + size);
    if (larger != NULL && size > thread->room) thread->room = size;
    if (larger != NULL) thread->bytes = larger;
    else TOUCHSTONE_RECORD_SET_(thread->lost, thread->lost + 1);
    pthread_mutex_unlock(&touchstone_record_state.lock);
    if (larger == NULL) return NULL;
    used = 0;
  }
  return thread->bytes + touchstone_record_head_ + used;
}

static inline void touchstone_record_done_(touchstone_record_thread_* thread, const unsigned char* begin,
                                           const unsigned char* end) {
  __atomic_store_n(&thread->filled, thread->filled + (uint64_t)(end - begin) + ((uint64_t)1 << 32), __ATOMIC_RELEASE);
}

static inline void touchstone_record_fixed_(touchstone_record_site* site, const void* numbers, size_t bytes,
                                            uint32_t answer) {
  touchstone_record_thread_* const thread = touchstone_record_thread;
  unsigned char *const begin = touchstone_record_room_(thread, bytes + 10), *at = begin;
  if (begin == NULL) return;
  at += touchstone_record_put_integer_(at, (site->id & 0xffffffff) - 1);
  at += touchstone_record_put_numbers_(at, numbers, bytes, site->bytes_of_number);
  at += touchstone_record_put_integer_(at, answer);
  touchstone_record_done_(thread, begin, at);
}

static inline unsigned char* touchstone_record_put_value_(unsigned char* at, const touchstone_record_value* value,
                                                          size_t each, int sizes) {
  size_t i;
  if (sizes) {
    at += touchstone_record_put_integer_(at, value->word_count);
    at += touchstone_record_put_integer_(at, value->number_count);
  }
  for (i = 0; i < value->word_count; ++i) at += touchstone_record_put_integer_(at, value->words[i]);
  return at + touchstone_record_put_numbers_(at, value->numbers, each * value->number_count, each);
}

static inline void touchstone_record_call(touchstone_record_site* site, const touchstone_record_value* question,
                                          const touchstone_record_value* answer, const char* text) {
  touchstone_record_thread_* const thread = touchstone_record_thread;
  const size_t each = site->bytes_of_number, length = text != NULL ? strlen(text) : 0;
  size_t size = 40 + 5 * question->word_count + each * question->number_count + length;
  unsigned char *begin, *at;
  if (answer != NULL) size += 5 * answer->word_count + each * answer->number_count;
  begin = at = touchstone_record_room_(thread, size);
  if (begin == NULL) return;
  at += touchstone_record_put_integer_(at, (site->id & 0xffffffff) - 1);
  at = touchstone_record_put_value_(at, question, each, site->numbers == 0);
  if (site->answer == TOUCHSTONE_RECORD_ERROR) {
    at += touchstone_record_put_integer_(at, length);
    if (length > 0) memcpy(at, text, length);
    at += length;
  } else {
    at = touchstone_record_put_value_(at, answer, each, site->answer == TOUCHSTONE_RECORD_WHOLE);
  }
  touchstone_record_done_(thread, begin, at);
}

#ifdef __cplusplus
}
#endif

#endif
