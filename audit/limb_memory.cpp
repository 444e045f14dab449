// SPDX-License-Identifier: Apache-2.0
#include "audit/limb_memory.h"

#include <gmp.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>

namespace touchstone::audit {
namespace {

// A piece is exactly as long as requested, in full limbs: pieces from malloc fit into the lists.
constexpr std::size_t limb = 8, classes = 257, block = std::size_t{1} << 16;  // pieces of up to 2 kB

struct Free {
  Free* next;
};
/// Free pieces by their number of limbs, and the rest of a block. Trivially destructible: numbers may be released after
/// the other objects of a thread.
struct Lists {
  std::array<Free*, classes> of{};
  char* fresh = nullptr;
  std::size_t left = 0;
  Lists* next = nullptr;
};
thread_local Lists lists;

/// Lists of threads that have ended.
struct {
  std::mutex mutex;
  Lists* first = nullptr;
} left_behind;

/// Made with the first block of a thread: takes over the lists of a finished thread, and leaves its own.
struct Heir {
  Heir() {
    const std::lock_guard<std::mutex> lock(left_behind.mutex);
    Lists* const found = left_behind.first;
    if (found == nullptr) return;
    left_behind.first = found->next;
    lists = *found;
    delete found;
  }
  ~Heir() {
    const std::lock_guard<std::mutex> lock(left_behind.mutex);
    Lists* const kept = new (std::nothrow) Lists(lists);
    if (kept == nullptr) return;
    kept->next = left_behind.first;
    left_behind.first = kept;
    lists = {};
  }
};

void* there(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

std::size_t class_of(std::size_t size) { return size <= limb ? 1 : (size + limb - 1) / limb; }

void* listed(std::size_t c) {
  Free* const found = lists.of[c];
  if (found != nullptr) lists.of[c] = found->next;
  return found;
}

void* take(std::size_t size) {
  const std::size_t c = class_of(size);
  if (c >= classes) return there(std::malloc(size));
  if (void* const found = listed(c)) return found;
  if (lists.left < c * limb) {
    [[maybe_unused]] static thread_local const Heir heir;
    if (void* const found = listed(c)) return found;
    if (lists.left < c * limb) lists.fresh = static_cast<char*>(there(std::malloc(block))), lists.left = block;
  }
  void* const piece = lists.fresh;
  lists.fresh += c * limb;
  lists.left -= c * limb;
  return piece;
}

void give(void* piece, std::size_t size) {
  const std::size_t c = class_of(size);
  if (c >= classes) return std::free(piece);
  lists.of[c] = new (piece) Free{lists.of[c]};
}

void* resize(void* piece, std::size_t before, std::size_t after) {
  const std::size_t b = class_of(before), a = class_of(after);
  if (a == b && a < classes) return piece;
  if (a >= classes && b >= classes) return there(std::realloc(piece, after));
  void* const moved = take(after);
  std::memcpy(moved, piece, before < after ? before : after);
  give(piece, before);
  return moved;
}

}  // namespace

void use_limb_memory() { mp_set_memory_functions(take, resize, give); }

}  // namespace touchstone::audit
