/* SPDX-License-Identifier: Apache-2.0 */
/* The file of touchstone_record.h: its blocks, its declarations, its end mark, and the buffers of threads. Nothing here
 * is called by users, nor for a call that finds room in its buffer. Included by that header alone. */
#ifndef TOUCHSTONE_RECORD_LOG_H
#define TOUCHSTONE_RECORD_LOG_H

enum { touchstone_record_block_ = 1 << 17, touchstone_record_head_ = 16, touchstone_record_reserve_ = 256 };

/* The counters of one site in one thread. */
typedef struct touchstone_record_count_ {
  uint64_t seen, left_out_next;
} touchstone_record_count_;

/* What a thread has recorded. `filled` and the totals are read by whoever closes the log; the rest is its own. */
typedef struct touchstone_record_thread_ {
  struct touchstone_record_thread_ *next, *previous;
  unsigned char* bytes; /* touchstone_record_head_, then calls */
  size_t room;
  uint64_t filled; /* the bytes of these calls, and 2^32 times how many they are */
  unsigned long long seen, sampled_out, lost;
  uint64_t random;
  touchstone_record_count_* counts;
  size_t count_room;
  uint32_t log; /* for which all this is */
} touchstone_record_thread_;

/* What all threads share, under the lock; `log` and `full` are also read without it. */
typedef struct touchstone_record_state_ {
  pthread_mutex_t lock;
  pthread_key_t key;
  FILE* file;
  unsigned long long bytes, most_bytes, seen, written, sampled_out, lost;
  unsigned long one_in, first;
  double near;
  touchstone_record_thread_* threads;
  uint32_t log;  /* the number of the log that is open, 0 for none */
  uint32_t logs; /* that were opened */
  uint32_t sites;
  int full;   /* nothing more is written */
  int failed; /* and the file may end within a block */
  int prepared;
} touchstone_record_state_;

/* One in the program, however many of its files and shared libraries include this; on Windows one in the program and
 * one in each DLL that does. */
#ifdef _WIN32
#define TOUCHSTONE_RECORD_SHARED_ __attribute__((selectany))
#else
#define TOUCHSTONE_RECORD_SHARED_ __attribute__((weak, visibility("default")))
#endif
TOUCHSTONE_RECORD_SHARED_ touchstone_record_state_ touchstone_record_state = {
    PTHREAD_MUTEX_INITIALIZER, 0, NULL, 0, 0, 0, 0, 0, 0, 0, 0, 0, NULL, 0, 0, 0, 0, 0, 0};
TOUCHSTONE_RECORD_SHARED_ __thread touchstone_record_thread_* touchstone_record_thread = NULL;
TOUCHSTONE_RECORD_SHARED_ __thread double touchstone_record_next_nearness = HUGE_VAL;

#define TOUCHSTONE_RECORD_READ_(place) __atomic_load_n(&(place), __ATOMIC_RELAXED)
#define TOUCHSTONE_RECORD_SET_(place, value) __atomic_store_n(&(place), (value), __ATOMIC_RELAXED)

static inline size_t touchstone_record_put_integer_(unsigned char* to, uint64_t value) {
  size_t size = 0;
  for (; value >= 0x80; value >>= 7) to[size++] = (unsigned char)(value | 0x80);
  to[size++] = (unsigned char)value;
  return size;
}

static inline size_t touchstone_record_put_numbers_(unsigned char* to, const void* numbers, size_t bytes, size_t each) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  size_t i;
  for (i = 0; i < bytes; ++i) to[i] = ((const unsigned char*)numbers)[i / each * each + each - 1 - i % each];
#else
  (void)each;
  if (bytes > 0) memcpy(to, numbers, bytes);
#endif
  return bytes;
}

/* Under the lock: one write of all these bytes, or none. */
static inline int touchstone_record_put_(const unsigned char* bytes, size_t size, size_t reserve) {
  touchstone_record_state_* const state = &touchstone_record_state;
  if (state->failed || (state->full && reserve > 0)) return 0;
  if (state->bytes + size + reserve > state->most_bytes) {
    TOUCHSTONE_RECORD_SET_(state->full, 1);
    return 0;
  }
  if (fwrite(bytes, 1, size, state->file) != size) {
    state->failed = 1;
    TOUCHSTONE_RECORD_SET_(state->full, 1);
    return 0;
  }
  state->bytes += size;
  return 1;
}

/* The same of a frame of text. */
static inline int touchstone_record_put_text_(char kind, const char* text, size_t reserve) {
  const size_t length = strlen(text);
  unsigned char* const frame = (unsigned char*)malloc(length + 16);
  size_t head = 1;
  int done;
  if (frame == NULL) return 0;
  frame[0] = (unsigned char)kind;
  head += touchstone_record_put_integer_(frame + 1, length);
  memcpy(frame + head, text, length);
  done = touchstone_record_put_(frame, head + length, reserve);
  free(frame);
  return done;
}

/* Appends text to JSON, or `,"name":"text"` where there is a name. */
static inline char* touchstone_record_json_(char* to, const char* name, const char* text) {
  if (name != NULL) to += sprintf(to, ",\"%s\":\"", name);
  for (; *text != 0; ++text) {
    const unsigned char c = (unsigned char)*text;
    if (c < 0x20 || c > 0x7e) to += sprintf(to, "?");
    else {
      if (c == '"' || c == '\\') *to++ = '\\';
      *to++ = (char)c;
    }
  }
  if (name != NULL) *to++ = '"';
  *to = 0;
  return to;
}

/* `,"name":0.5`, whatever the locale writes for a point. */
static inline char* touchstone_record_number_(char* to, const char* name, double number) {
  char *const end = to + sprintf(to, ",\"%s\":%.17g", name, number), *at = to + strlen(name) + 4;
  for (; *at != 0; ++at) {
    if (*at == ',') *at = '.';
  }
  return end;
}

/* Under the lock: the calls of a thread become a block. */
static inline void touchstone_record_flush_(touchstone_record_thread_* thread) {
  touchstone_record_state_* const state = &touchstone_record_state;
  const uint64_t filled = __atomic_load_n(&thread->filled, __ATOMIC_ACQUIRE);
  const size_t used = (size_t)(filled & 0xffffffff);
  unsigned char head[16];
  size_t size;
  if (used == 0) return;
  head[0] = 'C';
  size = 1 + touchstone_record_put_integer_(head + 1, used);
  memcpy(thread->bytes + touchstone_record_head_ - size, head, size);
  if (touchstone_record_put_(thread->bytes + touchstone_record_head_ - size, size + used, touchstone_record_reserve_))
    state->written += filled >> 32;
  else state->lost += filled >> 32;
  TOUCHSTONE_RECORD_SET_(thread->filled, 0);
}

/* Under the lock: all that a thread has recorded and counted. */
static inline void touchstone_record_settle_(touchstone_record_thread_* thread) {
  touchstone_record_state_* const state = &touchstone_record_state;
  if (state->log == 0 || thread->log != state->log) return;
  touchstone_record_flush_(thread);
  state->seen += TOUCHSTONE_RECORD_READ_(thread->seen);
  state->sampled_out += TOUCHSTONE_RECORD_READ_(thread->sampled_out);
  state->lost += TOUCHSTONE_RECORD_READ_(thread->lost);
}

/* A thread has ended. */
static inline void touchstone_record_end_thread_(void* ended) {
  touchstone_record_thread_* const thread = (touchstone_record_thread_*)ended;
  pthread_mutex_lock(&touchstone_record_state.lock);
  touchstone_record_settle_(thread);
  if (thread->next != NULL) thread->next->previous = thread->previous;
  if (thread->previous != NULL) thread->previous->next = thread->next;
  else touchstone_record_state.threads = thread->next;
  pthread_mutex_unlock(&touchstone_record_state.lock);
  touchstone_record_thread = NULL;
  free(thread->bytes);
  free(thread->counts);
  free(thread);
}

#ifdef _WIN32
static inline int touchstone_record_before_forks_(void) { return 0; } /* Windows has none */
#else
static inline void touchstone_record_before_fork_(void) { pthread_mutex_lock(&touchstone_record_state.lock); }
static inline void touchstone_record_in_parent_(void) { pthread_mutex_unlock(&touchstone_record_state.lock); }
/* The log stays the parent's: the child records nothing. */
static inline void touchstone_record_in_child_(void) {
  TOUCHSTONE_RECORD_SET_(touchstone_record_state.log, 0);
  pthread_mutex_unlock(&touchstone_record_state.lock);
}
static inline int touchstone_record_before_forks_(void) {
  return pthread_atfork(touchstone_record_before_fork_, touchstone_record_in_parent_, touchstone_record_in_child_);
}
#endif
static inline void touchstone_record_at_exit_(void) { touchstone_record_close(); }

static inline int touchstone_record_close(void) {
  touchstone_record_state_* const state = &touchstone_record_state;
  touchstone_record_thread_* thread;
  char end[touchstone_record_reserve_];
  int failed;
  pthread_mutex_lock(&state->lock);
  if (state->log == 0) {
    pthread_mutex_unlock(&state->lock);
    return 0;
  }
  for (thread = state->threads; thread != NULL; thread = thread->next) touchstone_record_settle_(thread);
  TOUCHSTONE_RECORD_SET_(state->log, 0);
  sprintf(end, "{\"seen\":%llu,\"written\":%llu,\"sampled_out\":%llu,\"lost\":%llu}", state->seen, state->written,
          state->sampled_out, state->lost);
  touchstone_record_put_text_('E', end, 0);
  failed = state->failed;
  if (fclose(state->file) != 0) failed = 1;
  state->file = NULL;
  pthread_mutex_unlock(&state->lock);
  return failed ? EIO : 0;
}

/* Under the lock. */
static inline int touchstone_record_put_header_(const touchstone_record_options* options) {
  const char* const engine = options->engine != NULL ? options->engine : "";
  char* const text = (char*)malloc(2 * strlen(engine) + 400);
  char* at = text;
  int done;
  if (text == NULL) return 0;
  at += sprintf(at, "{\"touchstone_log\":1");
  at = touchstone_record_json_(at, "engine", engine);
  if (options->boundary != NULL && strlen(options->boundary) < 20)
    at = touchstone_record_json_(at, "boundary", options->boundary);
  if (options->tolerance > 0) at = touchstone_record_number_(at, "tolerance", options->tolerance);
  at += sprintf(at, ",\"sampled\":{\"one_in\":%lu", options->one_in > 1 ? options->one_in : 1);
  if (options->first > 0) at += sprintf(at, ",\"first\":%lu", options->first);
  if (options->near > 0 && options->near < HUGE_VAL) at = touchstone_record_number_(at, "near", options->near);
  sprintf(at, "}}");
  done = touchstone_record_put_((const unsigned char*)"\x89TSLOG\n\x01", 8, touchstone_record_reserve_) &&
         touchstone_record_put_text_('H', text, touchstone_record_reserve_);
  free(text);
  return done;
}

static inline int touchstone_record_open(const char* file, const touchstone_record_options* given) {
  static const touchstone_record_options usual = {NULL, NULL, 0, 0, 0, 0, 0};
  const touchstone_record_options* const options = given != NULL ? given : &usual;
  touchstone_record_state_* const state = &touchstone_record_state;
  FILE* opened;
  int error = 0;
  touchstone_record_close();
  errno = 0;
  opened = fopen(file, "wb");
  if (opened == NULL) return errno != 0 ? errno : EIO;
  setvbuf(opened, NULL, _IONBF, 0);
  pthread_mutex_lock(&state->lock);
  if (!state->prepared) {
    error = pthread_key_create(&state->key, touchstone_record_end_thread_);
    if (error == 0) error = touchstone_record_before_forks_();
    if (error == 0) atexit(touchstone_record_at_exit_);
    state->prepared = error == 0;
  }
  state->file = opened;
  state->bytes = state->seen = state->written = state->sampled_out = state->lost = 0;
  state->most_bytes = options->most_bytes != 0 ? options->most_bytes : 1ull << 30;
  state->one_in = options->one_in;
  state->first = options->first;
  state->near = options->near;
  state->full = state->failed = 0;
  state->sites = 0;
  if (error == 0 && !touchstone_record_put_header_(options)) error = state->failed ? EIO : EFBIG;
  if (error == 0) __atomic_store_n(&state->log, ++state->logs, __ATOMIC_RELEASE);
  else fclose(opened);
  pthread_mutex_unlock(&state->lock);
  return error;
}

/* Under the lock: the site has a number in this log, and its declaration is written. */
static inline void touchstone_record_declare_(touchstone_record_site* site) {
  static const char* const kinds[] = {"plain", "whole", "error", "word"};
  touchstone_record_state_* const state = &touchstone_record_state;
  char* const text = (char*)malloc(2 * (strlen(site->operation) + strlen(site->place)) + 300);
  char* at = text;
  if (text == NULL) return;
  at += sprintf(at, "{\"id\":%lu", (unsigned long)state->sites);
  at = touchstone_record_json_(at, "op", site->operation);
  at = touchstone_record_json_(at, "site", site->place);
  at = touchstone_record_json_(at, "number", site->bytes_of_number == 4 ? "binary32" : "binary64");
  at = touchstone_record_json_(at, "answer", kinds[site->answer]);
  at = touchstone_record_json_(at, "alternative", "that_fits");
  if (site->numbers > 0) at += sprintf(at, ",\"question_size\":[0,%lu]", (unsigned long)site->numbers);
  sprintf(at, "}");
  touchstone_record_put_text_('D', text, touchstone_record_reserve_);
  free(text);
  __atomic_store_n(&site->id, (uint64_t)state->log << 32 | ++state->sites, __ATOMIC_RELEASE);
}

/* A thread's first call in a log, or its first of a site. 0: there is no memory. */
static inline int touchstone_record_prepare_(touchstone_record_site* site) {
  touchstone_record_state_* const state = &touchstone_record_state;
  touchstone_record_thread_* thread = touchstone_record_thread;
  size_t needed;
  int done = 0;
  pthread_mutex_lock(&state->lock);
  if (thread == NULL && (thread = (touchstone_record_thread_*)calloc(1, sizeof *thread)) != NULL) {
    thread->room = touchstone_record_block_;
    thread->bytes = (unsigned char*)malloc(touchstone_record_head_ + thread->room);
    thread->random = 0x9e3779b97f4a7c15u;
    if (thread->bytes == NULL || pthread_setspecific(state->key, thread) != 0) {
      free(thread->bytes);
      free(thread);
      thread = NULL;
    } else {
      thread->next = state->threads;
      if (thread->next != NULL) thread->next->previous = thread;
      state->threads = touchstone_record_thread = thread;
    }
  }
  if (thread != NULL && state->log != 0) {
    if (thread->log != state->log) {
      thread->filled = 0;
      thread->seen = thread->sampled_out = thread->lost = 0;
      if (thread->count_room > 0) memset(thread->counts, 0, thread->count_room * sizeof *thread->counts);
      thread->log = state->log;
    }
    if (site->id >> 32 != state->log) touchstone_record_declare_(site);
    needed = (size_t)(site->id & 0xffffffff);
    done = site->id >> 32 == state->log;
    if (done && thread->count_room < needed) {
      touchstone_record_count_* const counts =
          (touchstone_record_count_*)realloc(thread->counts, 2 * needed * sizeof *counts);
      done = counts != NULL;
      if (done) {
        memset(counts + thread->count_room, 0, (2 * needed - thread->count_room) * sizeof *counts);
        thread->counts = counts;
        thread->count_room = 2 * needed;
      }
    }
  }
  pthread_mutex_unlock(&state->lock);
  return done;
}

#endif
