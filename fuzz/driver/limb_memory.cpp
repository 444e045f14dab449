// SPDX-License-Identifier: Apache-2.0
#include <gmp.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <new>

// Memory for GMP's limbs from free lists. The sanitizer's allocator would take most of the time of a fuzz target, and
// could watch nothing there: GMP is not instrumented, and it alone touches its limbs.
namespace {

constexpr std::size_t grain = 16, classes = 128, block = std::size_t{1} << 16;  // pieces of up to 2 kB

struct Free {
  Free* next;
};
std::array<Free*, classes> lists{};
char* fresh = nullptr;
std::size_t left = 0;

std::size_t class_of(std::size_t size) { return (size + grain - 1) / grain; }

void* take(std::size_t size) {
  const std::size_t c = size == 0 ? 1 : class_of(size);
  if (c >= classes) return std::malloc(size);
  if (Free* const found = lists[c]) {
    lists[c] = found->next;
    return found;
  }
  if (left < c * grain) {
    fresh = static_cast<char*>(std::malloc(block));
    if (fresh == nullptr) std::abort();
    left = block;
  }
  void* const piece = fresh;
  fresh += c * grain;
  left -= c * grain;
  return piece;
}

void give(void* piece, std::size_t size) {
  const std::size_t c = size == 0 ? 1 : class_of(size);
  if (c >= classes) return std::free(piece);
  lists[c] = new (piece) Free{lists[c]};
}

void* resize(void* piece, std::size_t before, std::size_t after) {
  const std::size_t b = before == 0 ? 1 : class_of(before), a = after == 0 ? 1 : class_of(after);
  if (a == b && a < classes) return piece;
  void* const moved = take(after);
  std::memcpy(moved, piece, before < after ? before : after);
  give(piece, before);
  return moved;
}

// Before anything else of the program makes a number: what malloc gave must not come back to these lists.
[[gnu::constructor(101)]] void install() { mp_set_memory_functions(take, resize, give); }

}  // namespace
