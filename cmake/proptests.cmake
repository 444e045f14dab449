# SPDX-License-Identifier: Apache-2.0
# proptests/operations/CHAPTER, proptests/infrastructure/FOLDER and the other folders -> the program test_FOLDER; every file is a test of its own
# in ctest, named FOLDER/FILE. proptests/infrastructure/FOLDER/sessions/FILE.txt is one too, FOLDER/sessions/FILE.
# A folder with a CMakeLists.txt builds itself; proptests/install is a project of its own that uses the installed package.

# In two tiers: what a user needs to trust his build, and with TOUCHSTONE_TESTS=FULL all the rest.
set(TOUCHSTONE_FULL_TESTS FALSE)
if(TOUCHSTONE_TESTS STREQUAL FULL)
  set(TOUCHSTONE_FULL_TESTS TRUE)
endif()

find_package(Catch2 QUIET)
find_package(rapidcheck QUIET)
if(NOT Catch2_FOUND OR NOT rapidcheck_FOUND)
  set(level WARNING)
  if(TOUCHSTONE_TESTS MATCHES "^(REQUIRED|FULL)$")
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
  touchstone_compiled_lightly(${target})
  target_link_libraries(${target} PRIVATE touchstone_audit ${catch} MPFR::mpfr)
endfunction()

function(touchstone_test_program folder)
  set(target test_${folder})
  add_executable(${target} ${ARGN})
  touchstone_test_sources(${target})
  target_link_libraries(${target} PRIVATE touchstone_test_main)
  # Some files a unit, those with a namespace of their own: it is the headers that cost.
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests
                                             UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 5)
  if(TOUCHSTONE_PCH)
    target_precompile_headers(${target} REUSE_FROM touchstone_test_headers)
  endif()
  touchstone_generate(own own-namespace ${ARGN})
  foreach(source ${ARGN})
    cmake_path(GET source STEM file)
    if(NOT source IN_LIST own)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
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
       ${PROJECT_SOURCE_DIR}/proptests/operations/* ${PROJECT_SOURCE_DIR}/proptests/infrastructure/*)
  foreach(folder ${folders})
    cmake_path(GET folder FILENAME name)
    cmake_path(GET folder PARENT_PATH parent)
    cmake_path(GET parent FILENAME parent)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    if(TOUCHSTONE_TEST_ROBUST_ALONE)
      if(parent STREQUAL "operations" OR (parent STREQUAL "infrastructure" AND NOT name STREQUAL "robust"))
        continue()
      endif()
      list(FILTER sources EXCLUDE REGEX "/agreement/outcomes\\.cpp$|/robust/toy_[a-z_]+\\.cpp$")
    endif()
    if(NOT TOUCHSTONE_FULL_TESTS)  # CGAL's second opinions take minutes to compile
      list(FILTER sources EXCLUDE REGEX "/oracle/(nef_solids|quadratic_programs|side_of_mesh)\\.cpp$")
    endif()
    if(name MATCHES "^(install|operations|infrastructure)$" OR NOT sources)
      continue()
    elseif(EXISTS ${folder}/CMakeLists.txt)
      if(TOUCHSTONE_FULL_TESTS)
        add_subdirectory(${folder})
      endif()
    else()
      touchstone_test_program(${name} ${sources})
    endif()
  endforeach()
endif()

# They ask very long lists, in seconds, and would not end in time if that grew like the square of the length.
foreach(name robust/ring_defect oracle/rings volumes/convex_hull volumes/convex_hull_2d)
  if(TEST ${name})
    set_tests_properties(${name} PROPERTIES TIMEOUT 300)
  endif()
endforeach()
# Where all are written anew, vectors/are_as_written solves the same questions.
if(TARGET touchstone AND (TOUCHSTONE_TEST_ROBUST_ALONE OR NOT TOUCHSTONE_FULL_TESTS))
  add_test(NAME vectors/hold COMMAND touchstone vectors check ${PROJECT_SOURCE_DIR}/vectors)
endif()
# proptests/infrastructure/FOLDER/sessions/FILE.txt: what the program prints at a shell.
if(TARGET touchstone AND NOT TOUCHSTONE_TEST_ROBUST_ALONE)
  file(GLOB sessions CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/proptests/infrastructure/*/sessions/*.txt)
  foreach(session ${sessions})
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR}/proptests/infrastructure ${session})
    string(REPLACE ".txt" "" name ${name})
    add_test(NAME ${name} COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/sessions.py
                                  --program $<TARGET_FILE:touchstone> ${session})
  endforeach()
  set_tests_properties(simulate/sessions/engines PROPERTIES
                       ENVIRONMENT TOUCHSTONE_ENGINE_PROGRAMS=${PROJECT_BINARY_DIR}/engines)
  add_test(NAME sessions/self_check COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/sessions.py --self-check)
endif()
if(NOT TOUCHSTONE_FULL_TESTS)
  return()
endif()

add_test(NAME engines/wrong_signatures
         COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/infrastructure/engines/wrong_signatures.py ${CMAKE_CXX_COMPILER}
                 ${PROJECT_SOURCE_DIR} ${touchstone_generated})
add_test(NAME preprocessed COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/preprocessed.py ${CMAKE_CXX_COMPILER}
                                   ${PROJECT_SOURCE_DIR} ${touchstone_generated})
if(TARGET touchstone)
  include(vector_tests)
endif()

# Of the tree, its pages and its proofs: once, whatever the compiler.
if(TARGET touchstone AND NOT TOUCHSTONE_TEST_ROBUST_ALONE)
  set(program --program $<TARGET_FILE:touchstone>)
  # NAME SCRIPT ARGS...
  function(touchstone_script_test name script)
    add_test(NAME ${name} COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/${script} ${ARGN})
  endfunction()
  touchstone_script_test(layout proptests/layout.py ${program})
  touchstone_script_test(layout/self_check proptests/layout.py --self-check)
  touchstone_script_test(floors proptests/floors.py)
  touchstone_script_test(floors/self_check proptests/floors.py --self-check)
  touchstone_script_test(declarations/self_check cmake/generate.py --self-check)
  touchstone_script_test(words proptests/words.py)
  touchstone_script_test(words/self_check proptests/words.py --self-check)
  touchstone_script_test(out_of_memory proptests/out_of_memory.py ${program})
  touchstone_script_test(costs/self_check proptests/costs.py --self-check)
  touchstone_script_test(coverage_gates/self_check coverage/gates.py --self-check)
  touchstone_script_test(bench_page/self_check bench/page.py --self-check)
  touchstone_script_test(bench_tables bench/tables.py --check)
  touchstone_script_test(bench_tables/self_check bench/tables.py --self-check)
  touchstone_script_test(bench_tables/guard_self_check bench/guard.py --self-check)
  touchstone_script_test(install/bill_of_materials_self_check cmake/bill_of_materials.py --self-check)
  touchstone_script_test(documentation proptests/documentation.py ${program})
  touchstone_script_test(documentation/self_check proptests/documentation.py --self-check)
  touchstone_script_test(documentation/facts proptests/facts.py ${program})
  touchstone_script_test(documentation/facts_self_check proptests/facts.py ${program} --self-check)
  touchstone_script_test(documentation/findings proptests/findings.py ${program})
  touchstone_script_test(documentation/findings_self_check proptests/findings.py ${program} --self-check)
  touchstone_script_test(documentation/deck proptests/deck.py ${program})
  touchstone_script_test(documentation/deck_self_check proptests/deck.py --self-check)
  touchstone_script_test(documentation/status proptests/status.py ${program})
  touchstone_script_test(report/opened_pages proptests/opened_pages.py ${program})
  touchstone_script_test(report/opened_pages_self_check proptests/opened_pages.py --self-check)
  touchstone_script_test(report/answering_page proptests/answering_page.py ${program}
                         --package ${PROJECT_SOURCE_DIR}/build/wasm/package)
  # A share of the theorems about filters; ./dev proofs proves all.
  touchstone_script_test(proofs robust/proofs/prove.py --share --jobs 1 --work ${PROJECT_BINARY_DIR}/proofs)
  touchstone_script_test(proofs/self_check robust/proofs/prove.py --self-check)
  # The checker of certificates that is proved: its verdicts beside those of the other two, and conditions weakened, of
  # which each has to fail a proof; ./dev proofs proves all of it.
  touchstone_script_test(certificates/proved proptests/infrastructure/oracle/proved_checker.py ${program}
                         --work ${PROJECT_BINARY_DIR}/certify_proved)
  touchstone_script_test(certificates/weakened oracle/certificates/proved/kinds.py --weakened 12 --jobs 1
                         --work ${PROJECT_BINARY_DIR}/weakened)
  touchstone_script_test(certificates/one_file proptests/infrastructure/oracle/certify_file.py)
  touchstone_script_test(certificates/proofs_self_check oracle/certificates/proved/kinds.py --self-check)
  set_tests_properties(proofs certificates/proved certificates/weakened report/opened_pages
                       report/opened_pages_self_check report/answering_page PROPERTIES SKIP_RETURN_CODE 77)
endif()

# The launchers of examples/cluster, each where it is installed: otherwise its test is skipped, and says why.
if(TARGET touchstone AND NOT TOUCHSTONE_TEST_ROBUST_ALONE)
  foreach(launcher kubernetes parallel slurm)
    add_test(NAME cluster/${launcher} COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/cluster.py
                                              $<TARGET_FILE:touchstone> ${launcher})
    set_tests_properties(cluster/${launcher} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 120)
  endforeach()
endif()

# touchstone draw in the test suites of other languages. Debian's python3-hypothesis belongs to Debian's Python.
find_program(TOUCHSTONE_SYSTEM_PYTHON python3 HINTS /usr/bin)
find_program(TOUCHSTONE_NODE node)
mark_as_advanced(TOUCHSTONE_SYSTEM_PYTHON TOUCHSTONE_NODE)
if(TOUCHSTONE_NODE AND NOT TOUCHSTONE_TEST_ROBUST_ALONE)
  foreach(script viewer player drag)
    add_test(NAME report/${script} COMMAND ${TOUCHSTONE_NODE} ${PROJECT_SOURCE_DIR}/proptests/infrastructure/report/${script}.mjs)
  endforeach()
  # The npm package: its sources, and the WebAssembly module where ./dev wasm, which also tests the package, has built it.
  add_test(NAME js/sources COMMAND ${TOUCHSTONE_NODE} ${PROJECT_SOURCE_DIR}/js/tests/sources.mjs)
  add_test(NAME js/module COMMAND sh -c "test -e '${PROJECT_SOURCE_DIR}/build/wasm/package/module.wasm' || \
{ echo 'skipped: ./dev wasm builds the module'; exit 77; }; '${TOUCHSTONE_NODE}' '${PROJECT_SOURCE_DIR}/js/tests/same.mjs' \
'${PROJECT_SOURCE_DIR}/build/wasm/package' '${PROJECT_SOURCE_DIR}/vectors' --share 16 --program '$<TARGET_FILE:touchstone>'")
  set_tests_properties(js/module PROPERTIES SKIP_RETURN_CODE 77)
endif()
# example_suite(NAME PROGRAM FILE): skipped by itself where its framework is not installed.
function(example_suite name program file)
  if(program AND TARGET touchstone AND NOT TOUCHSTONE_TEST_ROBUST_ALONE)
    add_test(NAME own_tests/${name} COMMAND ${program} ${PROJECT_SOURCE_DIR}/examples/own_tests/${file})
    set_tests_properties(own_tests/${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT TOUCHSTONE=$<TARGET_FILE:touchstone>)
  endif()
endfunction()
example_suite(hypothesis "${TOUCHSTONE_SYSTEM_PYTHON}" test_hypothesis.py)
example_suite(fast_check "${TOUCHSTONE_NODE}" test_fast_check.mjs)

# The recorders of calls, each in the language that it is for.
if(TOUCHSTONE_SYSTEM_PYTHON AND TARGET touchstone AND NOT TOUCHSTONE_TEST_ROBUST_ALONE)
  add_test(NAME logs/recorders COMMAND ${TOUCHSTONE_SYSTEM_PYTHON} -B ${PROJECT_SOURCE_DIR}/proptests/infrastructure/logs/recorders.py
                                       --program $<TARGET_FILE:touchstone> --cxx ${CMAKE_CXX_COMPILER})
endif()

# The Python module, by the Python for which it is built.
if(NOT TOUCHSTONE_TEST_ROBUST_ALONE)
  foreach(name arrays operations types)
    set(suite ${PROJECT_SOURCE_DIR}/proptests/infrastructure/python)
    if(TARGET touchstone_python)
      add_test(NAME python/${name} COMMAND ${Python_EXECUTABLE} -B ${suite}/run.py ${suite}/test_${name}.py WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
    else()
      add_test(NAME python/${name} COMMAND sh -c "echo 'skipped: built without pybind11 or the headers of Python'; exit 77")
    endif()
    set_tests_properties(python/${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT PYTHONPATH=${PROJECT_BINARY_DIR}/python)
  endforeach()
  if(TARGET touchstone_python)
    set_target_properties(touchstone_python PROPERTIES EXCLUDE_FROM_ALL FALSE)
  endif()
endif()

# What `touchstone ask --as` prints, of all operations: Catch2's is built and run with robust as the user's code, the others are run.
if(TARGET touchstone AND NOT TOUCHSTONE_TEST_ROBUST_ALONE)
  set(printed ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/regression_tests.py --program $<TARGET_FILE:touchstone>)
  set(regression_tests ${PROJECT_BINARY_DIR}/regression_tests)
  file(MAKE_DIRECTORY ${regression_tests})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR} ${regression_tests}/touchstone SYMBOLIC)
  add_custom_command(OUTPUT ${regression_tests}/all.cpp COMMAND ${printed} --catch2 ${regression_tests}/all.cpp
                     DEPENDS touchstone ${PROJECT_SOURCE_DIR}/proptests/regression_tests.py)
  add_executable(test_printed ${regression_tests}/all.cpp)
  touchstone_test_sources(test_printed)
  target_include_directories(test_printed PRIVATE ${regression_tests})
  target_compile_options(test_printed PRIVATE -O0)
  target_link_libraries(test_printed PRIVATE touchstone_test_main)
  add_test(NAME regression_tests/catch2 COMMAND test_printed ~[checked])
  add_test(NAME regression_tests/others COMMAND ${printed} --run)
endif()

# What a user does with the installed package. Not while counting coverage: the flags for that stay in this build.
if(NOT TOUCHSTONE_COVERAGE)
  include(install_tests)
endif()
