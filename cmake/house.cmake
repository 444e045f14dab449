# SPDX-License-Identifier: Apache-2.0
# How our own sources are compiled. Nothing here reaches a user of the installed libraries.

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT EMSCRIPTEN)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers are cached only when ccache may overlook their time stamps and macros; paths are taken relative to
  # the build directory, so that build directories beside each other share what they compiled. What is not cached is not
  # preprocessed first: the compiler says which headers it read.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=/ CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
endif()

# lld, where the compiler finds one: a test program is linked in a fifth of the time.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=lld TOUCHSTONE_HAS_LLD)
if(TOUCHSTONE_HAS_LLD)
  add_link_options(-fuse-ld=lld)
endif()

set(coverage_flags "")
if(TOUCHSTONE_COVERAGE)
  set(coverage_flags -fprofile-instr-generate -fcoverage-mapping)
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 19)
    list(APPEND coverage_flags -fcoverage-mcdc)
  endif()
endif()

# WebAssembly rounds to nearest and no other way.
set(of_platform "")
if(NOT EMSCRIPTEN)
  list(APPEND of_platform -frounding-math)
endif()
# Where lengths have 32 bits. There g++ 12.2 also loses a result: from -O1 on, a std::optional<Vector3<TwoWords>> that a
# function returns stays unwritten, unless its pass ipa-modref is off.
set(of_lengths "")
if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(of_lengths -Wno-conversion -fno-ipa-modref)
elseif(CMAKE_SIZEOF_VOID_P EQUAL 4)
  set(of_lengths -Wno-shorten-64-to-32)
endif()
include(CheckCXXSymbolExists)
check_cxx_symbol_exists(_LIBCPP_VERSION version TOUCHSTONE_LIBCXX)
if(TOUCHSTONE_LIBCXX)
  list(PREPEND of_platform -include ${PROJECT_SOURCE_DIR}/cmake/libcxx.h)
endif()

# A target compiled from our sources: strict floating point and all warnings, privately.
function(touchstone_own target)
  if(NOT PROJECT_IS_TOP_LEVEL)
    # First, for the project around ours may have a geometry/ too.
    target_include_directories(${target} BEFORE PRIVATE ${PROJECT_SOURCE_DIR} ${touchstone_generated})
  endif()
  target_compile_options(
    ${target} PRIVATE -ffp-contract=off ${of_platform} -Wall -Wextra -Wconversion -Wno-sign-conversion
                      -Wno-missing-field-initializers ${of_lengths} ${coverage_flags}
                      "$<$<BOOL:${TOUCHSTONE_LIBFUZZER}>:-fsanitize=fuzzer-no-link;-fsanitize-coverage-allowlist=${PROJECT_SOURCE_DIR}/fuzz/driver/instrumented.txt>")
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # g++ 12 warns wrongly about literal + std::string (its bug 105329).
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
                                             -Wno-array-bounds)
    # Its garbage is collected later than by default: 11 to 19 % of the compile time for a quarter to 40 % more of memory,
    # 1.75 GB at most for the program's units and 3.5 GB for the benchmarks'.
    target_compile_options(${target} PRIVATE "SHELL:--param ggc-min-expand=300" "SHELL:--param ggc-min-heapsize=1000000")
  elseif(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    # ccache: a precompiled header must not carry the time at which it was made.
    target_compile_options(${target} PRIVATE -Xclang -fno-pch-timestamp)
    if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 17)
      # The rewritten == of nlohmann-json 3.11 refuses std::string there.
      target_compile_definitions(${target} PRIVATE JSON_HAS_THREE_WAY_COMPARISON=0)
    endif()
  endif()
  target_link_options(${target} PRIVATE ${coverage_flags})
endfunction()

# touchstone_compiled_lightly(target...): what computes with GMP, or hardly at all, runs as fast with -O1, which compiles it in two thirds of
# the time.
function(touchstone_compiled_lightly)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
  endforeach()
endfunction()

# touchstone_precompiled(target): the heavy third-party headers, precompiled once for all such targets of a directory. They are
# programs compiled with the same flags.
function(touchstone_precompiled target)
  if(NOT TOUCHSTONE_PCH)
    return()
  endif()
  get_property(first DIRECTORY PROPERTY touchstone_first_precompiled)
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE <nlohmann/json.hpp> <gmpxx.h>)
    set_property(DIRECTORY PROPERTY touchstone_first_precompiled ${target})
  endif()
endfunction()
