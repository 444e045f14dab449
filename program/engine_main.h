// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/engines/adapter.h"
#include "program/terminal/uses.h"

namespace touchstone::audit {
struct Served;
}

namespace touchstone::program {

/// The text above the table of an engine's audit: the operations found in it by name, and those not found, so that a
/// misspelt name is noticed; unless they are `named`, only their number, in one line.
std::string operations_found(const Served& engine, bool named = true);

/// The main program of an engine. With the argument --serve it answers over pipes; with the name of a command first
/// (ask, exhaust, map, vectors check, check-engine) it is that command of `touchstone` with itself as the engine, in a
/// process of its own; otherwise it is `touchstone audit` of itself.
int engine_program(const EngineMembers& engine, int argc, const char* const* argv);

}  // namespace touchstone::program

/// The audit program of an engine: the options of `touchstone audit`; with --serve it answers over pipes.
#define TOUCHSTONE_ENGINE_MAIN(EngineType)                                                             \
  int main(int argc, char** argv) {                                                                    \
    EngineType engine{};                                                                               \
    return ::touchstone::program::engine_program(::touchstone::audit::members_of(engine), argc, argv); \
  }
