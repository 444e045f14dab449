// SPDX-License-Identifier: Apache-2.0
#include "program/terminal/out_of_memory.h"

#include <gmp.h>

#include <cstdlib>
#include <new>

namespace touchstone::program {
namespace {

void* there(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* allocate(std::size_t size) { return there(std::malloc(size)); }
void* reallocate(void* memory, std::size_t, std::size_t size) { return there(std::realloc(memory, size)); }
void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

// What GMP has from malloc already can be released by these functions: its own call the same.
void have_gmp_throw() { mp_set_memory_functions(allocate, reallocate, release); }

}  // namespace touchstone::program
