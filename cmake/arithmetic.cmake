# SPDX-License-Identifier: Apache-2.0
# Integers, rationals and rounded numbers: GMP and MPFR, or arithmetic/, which has their names and needs no library. It
# stands for GMP::gmp, GMP::gmpxx and MPFR::mpfr, and its folder of headers for theirs.

set(TOUCHSTONE_ARITHMETIC GMP CACHE STRING "GMP: by GMP and MPFR; OWN: by arithmetic/, without tests, fuzz targets, benchmarks and installation")
set_property(CACHE TOUCHSTONE_ARITHMETIC PROPERTY STRINGS GMP OWN)
if(NOT TOUCHSTONE_ARITHMETIC MATCHES "^(GMP|OWN)$")
  message(FATAL_ERROR "TOUCHSTONE_ARITHMETIC: ${TOUCHSTONE_ARITHMETIC} is none of GMP, OWN")
endif()

file(GLOB arithmetic_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/arithmetic/*.cpp)
# touchstone_arithmetic(target definitions...): the library, and what uses it instead of GMP and MPFR.
function(touchstone_arithmetic target)
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${arithmetic_sources})
  touchstone_own(${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_definitions(${target} PUBLIC ${ARGN} INTERFACE TOUCHSTONE_OWN_ARITHMETIC)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR} INTERFACE ${PROJECT_SOURCE_DIR}/arithmetic/interface)
endfunction()
touchstone_arithmetic(touchstone_arithmetic)

if(TOUCHSTONE_ARITHMETIC STREQUAL OWN)
  foreach(name GMP::gmp GMP::gmpxx MPFR::mpfr)
    add_library(${name} ALIAS touchstone_arithmetic)
  endforeach()
  # These compare with MPFR, or would have to find the library.
  foreach(without TESTS FUZZ BENCH INSTALL PYTHON)
    set(TOUCHSTONE_${without} OFF)
  endforeach()
endif()
