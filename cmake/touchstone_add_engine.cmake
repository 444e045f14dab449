# SPDX-License-Identifier: Apache-2.0
# touchstone_add_engine(target source... [LIKE engine])
#
# The program of an engine in C++, of sources of which one has TOUCHSTONE_ENGINE_MAIN. It is linked to touchstone::audit, whose header
# brings every operation along and is compiled once: a change of the engine compiles the engine alone. LIKE another engine of the same
# directory, which must be compiled with the same options: they share that compiled header.
function(touchstone_add_engine target)
  cmake_parse_arguments(PARSE_ARGV 1 engine "" "LIKE" "")
  if(NOT engine_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "touchstone_add_engine(${target}): no source stands after the target's name")
  endif()
  add_executable(${target} ${engine_UNPARSED_ARGUMENTS})
  target_link_libraries(${target} PRIVATE touchstone::audit)
  if(engine_LIKE)
    target_precompile_headers(${target} REUSE_FROM ${engine_LIKE})
  else()
    target_precompile_headers(${target} PRIVATE <touchstone/program/engine_main.h>)
  endif()
endfunction()
