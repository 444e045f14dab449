// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/engines/adapter.h"

namespace touchstone::audit {

/// The main program of an engine: with the argument --serve it serves; else it is `touchstone audit` of itself, in a
/// process of its own, with the same options and exit codes.
int engine_program(const Served& engine, int argc, const char* const* argv);

}  // namespace touchstone::audit

/// The audit program of an engine: the options of `touchstone audit`; with --serve it answers over pipes.
#define TOUCHSTONE_ENGINE_MAIN(EngineType)                                                       \
  int main(int argc, char** argv) {                                                              \
    EngineType engine{};                                                                         \
    return ::touchstone::audit::engine_program(::touchstone::audit::served(engine), argc, argv); \
  }
