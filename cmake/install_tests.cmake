# SPDX-License-Identifier: Apache-2.0
# What users do with the installed package, and with the sources in a project of theirs: proptests/install, and the examples.

set(installed ${PROJECT_BINARY_DIR}/installed)
set(consumers ${PROJECT_BINARY_DIR}/consumers)
set(install_tests ${PROJECT_SOURCE_DIR}/proptests/install)
set(build ${PROJECT_BINARY_DIR})
if(TOUCHSTONE_LINK_FROM)
  set(build ${TOUCHSTONE_LINK_FROM})
endif()

add_test(NAME install/prefix
         COMMAND sh -c "rm -rf '${installed}' && '${CMAKE_COMMAND}' --install '${build}' --prefix '${installed}'")
set_tests_properties(install/prefix PROPERTIES FIXTURES_SETUP installed)
# install_consumer(NAME SOURCE [BUILD folder] OPTIONS option... THEN command...): configures and builds a project, then runs the command there.
function(install_consumer name source)
  cmake_parse_arguments(PARSE_ARGV 2 of "" "BUILD" "OPTIONS;THEN")
  if(NOT of_BUILD)
    set(of_BUILD ${consumers}/${name})
  endif()
  add_test(NAME install/${name}
           COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${source} ${of_BUILD} --build-generator ${CMAKE_GENERATOR}
                   --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
                   -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} ${of_OPTIONS} --test-command ${of_THEN})
endfunction()
install_consumer(consumer ${install_tests} OPTIONS -DCMAKE_PREFIX_PATH=${installed}
                 THEN ${CMAKE_CTEST_COMMAND} --output-on-failure -E "^audit/naive_segments$")
install_consumer(my_engine ${PROJECT_SOURCE_DIR}/examples/my_engine OPTIONS -DCMAKE_PREFIX_PATH=${installed} THEN
                 ${CMAKE_COMMAND} -E true)
# Generators and laws in users' own tests.
install_consumer(own_tests ${PROJECT_SOURCE_DIR}/examples/own_tests OPTIONS -DCMAKE_PREFIX_PATH=${installed}
                 THEN ${CMAKE_CTEST_COMMAND} --output-on-failure)

# From C, with CMake and with pkg-config.
install_consumer(c ${install_tests}/c OPTIONS -DCMAKE_PREFIX_PATH=${installed} THEN ${CMAKE_CTEST_COMMAND} --output-on-failure)
install_consumer(c_example ${PROJECT_SOURCE_DIR}/examples/c OPTIONS -DCMAKE_PREFIX_PATH=${installed} THEN
                 sh -c "test \"$(./segments | head -n 3 | tr '\\n' ' ')\" = 'point overlap disjoint '")
find_program(TOUCHSTONE_C_COMPILER gcc)
mark_as_advanced(TOUCHSTONE_C_COMPILER)
add_test(NAME install/c_pkg_config
         COMMAND sh -c "command -v pkg-config >/dev/null && test -x '${TOUCHSTONE_C_COMPILER}' || exit 77; mkdir -p '${consumers}' && \
'${TOUCHSTONE_C_COMPILER}' -std=c99 -pedantic -Wall -Werror '${install_tests}'/c/main.c -o '${consumers}'/pkg_config_c \
$(pkg-config --cflags --libs touchstone-c) && '${consumers}'/pkg_config_c")
set_tests_properties(install/c_pkg_config PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT
                                                     PKG_CONFIG_PATH=${installed}/${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set_tests_properties(install/c install/c_example install/c_pkg_config PROPERTIES FIXTURES_REQUIRED installed)

# With pkg-config and the compiler alone.
set(words "${CMAKE_CXX_COMPILER} ${CMAKE_CXX_FLAGS} -std=c++20")
add_test(NAME install/pkg_config
         COMMAND sh -c "command -v pkg-config >/dev/null || exit 77; mkdir -p '${consumers}' && for of in robust oracle; do \
flags=$(pkg-config --cflags --libs touchstone-$of) && \
${words} '${install_tests}'/alone/$of.cpp -o '${consumers}'/pkg_config_$of $flags && '${consumers}'/pkg_config_$of || exit 1; done; \
test \"$(pkg-config --variable=vectors touchstone-geometry)\"/orientation.jsonl -ef '${installed}/${CMAKE_INSTALL_DATADIR}/touchstone/vectors/orientation.jsonl'")
set_tests_properties(install/pkg_config PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT
                                                   PKG_CONFIG_PATH=${installed}/${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set_tests_properties(install/consumer install/my_engine install/own_tests install/pkg_config PROPERTIES FIXTURES_REQUIRED installed)

# It audits a naive engine, so that it ends with findings (exit code 1) is as it should be.
add_test(NAME install/my_engine_audits COMMAND ${consumers}/my_engine/my_engine --cases 1000 --seed 1)
set_tests_properties(install/my_engine_audits PROPERTIES DEPENDS install/my_engine PASS_REGULAR_EXPRESSION
                                                         "my engine 1.0.*segment_segment")
# So does its ctest, by touchstone_add_audit.
add_test(NAME install/my_engine_fails COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${consumers}/my_engine --output-on-failure)
set_tests_properties(install/my_engine_fails PROPERTIES DEPENDS install/my_engine PASS_REGULAR_EXPRESSION
                     "audit/my_engine [.]*\\*\\*\\*Failed.*my engine 1.0.*gate: failed.*segment_segment, collinear: algorithm")
# Its fuzz target: any bytes are a question, and it answers all; libFuzzer soon finds an answer that is wrong.
set(fuzz_my_engine ${consumers}/my_engine/fuzz_my_engine)
add_test(NAME install/my_engine_replays COMMAND ${fuzz_my_engine} ${PROJECT_SOURCE_DIR}/examples/my_engine/fuzz.cpp)
set_tests_properties(install/my_engine_replays PROPERTIES DEPENDS install/my_engine ENVIRONMENT
                                                          TOUCHSTONE_FUZZ_ONLY=invalid)
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  add_test(NAME install/my_engine_fuzzes
           COMMAND ${fuzz_my_engine} -seed=1 -max_len=640 -runs=200000 -artifact_prefix=${consumers}/)
  set_tests_properties(
    install/my_engine_fuzzes PROPERTIES DEPENDS install/my_engine PASS_REGULAR_EXPRESSION
                                        "my engine 1.0: segment_segment \\((rounding|algorithm)\\) on .* the truth is")
endif()

# What no compiler changes is asked once.
if(TOUCHSTONE_TEST_ROBUST_ALONE)
  return()
endif()

if(TARGET touchstone_alone)
  add_test(NAME install/carried
           COMMAND sh ${install_tests}/carried.sh ${PROJECT_BINARY_DIR} ${CMAKE_COMMAND} ${CMAKE_CPACK_COMMAND})
endif()

set(package_holds ${Python3_EXECUTABLE} ${install_tests}/package_holds.py)
add_test(NAME install/package_holds COMMAND ${package_holds} ${PROJECT_SOURCE_DIR} ${installed})
set_tests_properties(install/package_holds PROPERTIES FIXTURES_REQUIRED installed)
add_test(NAME install/package_holds_self_check COMMAND ${package_holds} --self-check)

# The wrappers of foreign libraries, those of the target all; ./dev engines builds the others. It audits, so that it ends with findings.
install_consumer(engines ${PROJECT_SOURCE_DIR}/engines BUILD ${PROJECT_BINARY_DIR}/engines OPTIONS -DCMAKE_PREFIX_PATH=${installed}
                 THEN ./ray_watertight --ops ray_triangle --cases 500)
set_tests_properties(install/engines PROPERTIES FIXTURES_REQUIRED installed PASS_REGULAR_EXPRESSION
                                                "Watertight ray and triangle of Woop, Benthin and Wald.*answers wrong")

install_consumer(in_source ${install_tests}/in_source OPTIONS -DTOUCHSTONE_SOURCE=${PROJECT_SOURCE_DIR} THEN ${CMAKE_COMMAND} -E true)

# touchstone_add_audit of an engine that is wrong: ctest fails, for the engine's findings.
add_test(NAME install/naive_audit_fails COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${consumers}/consumer -R "^audit/naive_segments$" --output-on-failure)
set_tests_properties(install/naive_audit_fails PROPERTIES DEPENDS install/consumer PASS_REGULAR_EXPRESSION
                     "audit/naive_segments [.]*\\*\\*\\*Failed.*textbook in Python.*segment_segment")

# What it says to those who misuse it: misuse(NAME complaint argument...).
function(misuse name complaint)
  list(JOIN ARGN " " arguments)
  add_test(NAME install/add_audit_${name}
           COMMAND ${CMAKE_COMMAND} -DARGUMENTS=${arguments} -P ${install_tests}/misuses_add_audit.cmake)
  set_tests_properties(install/add_audit_${name} PROPERTIES PASS_REGULAR_EXPRESSION "touchstone_add_audit\\(engine\\):[ \n]+${complaint}")
endfunction()
misuse(no_target "no target[ \n]+has this name; an engine that is none is given by COMMAND" engine)
misuse(no_keyword "--cases 50[ \n]+belongs to none of" engine --cases 50)
misuse(no_value "nothing stands[ \n]+after BASELINE" engine BASELINE ARGS --cases 50)

# The steps of action.yml, on the installed package.
add_test(NAME install/action COMMAND ${Python3_EXECUTABLE} ${install_tests}/action_runs.py ${PROJECT_SOURCE_DIR} ${installed} ${consumers}/action)
set_tests_properties(install/action PROPERTIES FIXTURES_REQUIRED installed SKIP_RETURN_CODE 77)
