# SPDX-License-Identifier: Apache-2.0
# proptests/operations/CHAPTER, proptests/machine/FOLDER and the other folders -> the program test_FOLDER; every file is a test of its own
# in ctest, named FOLDER/FILE.
# A folder with a CMakeLists.txt builds itself; proptests/install is a project of its own that uses the installed package.

find_package(Catch2 QUIET)
find_package(rapidcheck QUIET)
if(NOT Catch2_FOUND OR NOT rapidcheck_FOUND)
  set(level WARNING)
  if(TOUCHSTONE_TESTS STREQUAL REQUIRED)
    set(level FATAL_ERROR)
  endif()
  message(${level} "proptests/ is left out: it needs Catch2 (2 or 3) and RapidCheck")
  return()
endif()
# Catch2 3 comes with a main, and refuses by itself to run no test.
set(catch Catch2::Catch2 rapidcheck)
set(catch_arguments --filenames-as-tags --durations yes)
if(Catch2_VERSION VERSION_LESS 3)
  list(APPEND catch_arguments --warn NoTests)
else()
  list(PREPEND catch Catch2::Catch2WithMain)
endif()

function(touchstone_test_sources target)
  touchstone_own(${target})
  target_compile_options(${target} PRIVATE -Wno-conversion)
  target_link_libraries(${target} PRIVATE touchstone_audit ${catch} MPFR::mpfr)
endfunction()

function(touchstone_test_program folder)
  set(target test_${folder})
  add_executable(${target} ${ARGN})
  touchstone_test_sources(${target})
  target_link_libraries(${target} PRIVATE touchstone_test_main)
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  if(TOUCHSTONE_PCH)
    target_precompile_headers(${target} REUSE_FROM touchstone_test_headers)
  endif()
  foreach(source ${ARGN})
    cmake_path(GET source STEM file)
    # The durations are read by costs.py: a test that asks all operations says how long each took.
    add_test(NAME ${folder}/${file} COMMAND ${target} ${catch_arguments} "[#${file}]"
             WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  endforeach()
endfunction()

if(EXISTS ${PROJECT_SOURCE_DIR}/proptests/main.cpp)
  # RapidCheck is compiled here, once, and main.cpp holds all of Catch2 2's own code: a third of the compile time without
  # optimisation, and it is never in a loop.
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/proptests/*.cpp)
  add_library(touchstone_test_main OBJECT ${sources})
  touchstone_test_sources(touchstone_test_main)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/proptests/main.cpp PROPERTIES COMPILE_OPTIONS -O0)
  if(TOUCHSTONE_PCH)
    # main.cpp chooses how Catch2 2 is expanded, so the precompiled headers live with a program that does nothing.
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/test_headers.cpp CONTENT "int main() {}\n")
    add_executable(touchstone_test_headers ${PROJECT_BINARY_DIR}/test_headers.cpp)
    touchstone_test_sources(touchstone_test_headers)
    target_precompile_headers(touchstone_test_headers PRIVATE ${PROJECT_SOURCE_DIR}/proptests/catch.h <nlohmann/json.hpp> <gmpxx.h>)
  endif()
  file(GLOB folders CONFIGURE_DEPENDS LIST_DIRECTORIES true ${PROJECT_SOURCE_DIR}/proptests/*
       ${PROJECT_SOURCE_DIR}/proptests/operations/* ${PROJECT_SOURCE_DIR}/proptests/machine/*)
  foreach(folder ${folders})
    cmake_path(GET folder FILENAME name)
    cmake_path(GET folder PARENT_PATH parent)
    cmake_path(GET parent FILENAME parent)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    if(TOUCHSTONE_TEST_ROBUST_ALONE)
      if(parent STREQUAL "operations" OR (parent STREQUAL "machine" AND NOT name STREQUAL "robust"))
        continue()
      endif()
      list(FILTER sources EXCLUDE REGEX "/agreement/(certificates|outcomes|promises)\\.cpp$|/robust/toy_[a-z_]+\\.cpp$")
    endif()
    if(name MATCHES "^(install|operations|machine)$" OR NOT sources)
      continue()
    elseif(EXISTS ${folder}/CMakeLists.txt)
      add_subdirectory(${folder})
    else()
      touchstone_test_program(${name} ${sources})
    endif()
  endforeach()
endif()

find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(rooms_line_up ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/rooms_line_up.py)
add_test(NAME rooms_line_up/self_check COMMAND ${rooms_line_up} --self-check)
add_test(NAME costs/self_check COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/costs.py --self-check)
add_test(NAME coverage_gates/self_check COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/coverage/gates.py --self-check)
if(TARGET touchstone)
  add_test(NAME rooms_line_up COMMAND ${rooms_line_up} --program $<TARGET_FILE:touchstone>)
endif()

# What a user does with the installed package. Not while counting coverage: the flags for that stay in this build.
if(NOT TOUCHSTONE_COVERAGE)
  set(installed ${PROJECT_BINARY_DIR}/installed)
  add_test(NAME install/prefix
           COMMAND sh -c "rm -rf '${installed}' && '${CMAKE_COMMAND}' --install '${PROJECT_BINARY_DIR}' --prefix '${installed}'")
  set_tests_properties(install/prefix PROPERTIES FIXTURES_SETUP installed)
  foreach(consumer proptests/install examples/my_engine)
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${consumer}/CMakeLists.txt)
      continue()
    endif()
    cmake_path(GET consumer FILENAME name)
    if(name STREQUAL install)
      set(name consumer)
    endif()
    add_test(NAME install/${name}
             COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${PROJECT_SOURCE_DIR}/${consumer}
                     ${PROJECT_BINARY_DIR}/consumers/${name} --build-generator ${CMAKE_GENERATOR} --build-options
                     -DCMAKE_PREFIX_PATH=${installed} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
                     "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}" -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} --test-command ctest
                     --output-on-failure)
    set_tests_properties(install/${name} PROPERTIES FIXTURES_REQUIRED installed)
  endforeach()
  # It audits a naive engine, so that it ends with findings (exit code 1) is as it should be.
  add_test(NAME install/my_engine_audits COMMAND ${PROJECT_BINARY_DIR}/consumers/my_engine/my_engine --cases 1000 --seed 1)
  set_tests_properties(install/my_engine_audits PROPERTIES DEPENDS install/my_engine PASS_REGULAR_EXPRESSION
                                                           "my engine 1.0.*segment_segment")
  # Its fuzz target: any bytes are a question, and it answers all; libFuzzer soon finds an answer that is wrong.
  set(fuzz_my_engine ${PROJECT_BINARY_DIR}/consumers/my_engine/fuzz_my_engine)
  add_test(NAME install/my_engine_replays COMMAND ${fuzz_my_engine} ${PROJECT_SOURCE_DIR}/examples/my_engine/fuzz.cpp)
  set_tests_properties(install/my_engine_replays PROPERTIES DEPENDS install/my_engine ENVIRONMENT
                                                            TOUCHSTONE_FUZZ_ONLY=invalid)
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    add_test(NAME install/my_engine_fuzzes
             COMMAND ${fuzz_my_engine} -seed=1 -max_len=640 -runs=200000 -artifact_prefix=${PROJECT_BINARY_DIR}/consumers/)
    set_tests_properties(
      install/my_engine_fuzzes PROPERTIES DEPENDS install/my_engine PASS_REGULAR_EXPRESSION
                                          "my engine 1.0: segment_segment \\((rounding|algorithm)\\) on .* the truth is")
  endif()
endif()
