# SPDX-License-Identifier: Apache-2.0
# touchstone_add_audit(target [NAME test] [BASELINE file] [ARGS argument...])
# touchstone_add_audit(name COMMAND word... [NAME test] [BASELINE file] [ARGS argument...])
#
# A test for ctest that audits an engine, and fails where the audit ends with findings. The engine is an executable of this project whose
# main is TOUCHSTONE_ENGINE_MAIN; or, with COMMAND, any program that answers over pipes (docs/engines.md), its words as add_test takes them.
#
#   NAME       the test's name in ctest is audit/NAME, so that ctest -R ^audit/ runs every audit; if left out, audit/target
#   BASELINE   known findings, which are accepted: --baseline. If the path is relative it begins at the current source directory. The
#              target audit_NAME_baseline, with _ for every / in NAME, writes the file anew
#   ARGS       options of `touchstone audit`, as they stand: --ops orientation --cases 5000 --fail-on algorithm. Files among them that have
#              relative paths are looked for in the current binary directory
#
# The same questions are asked in every run: their seed is 1, if ARGS name no other.
function(touchstone_add_audit target)
  cmake_parse_arguments(PARSE_ARGV 1 audit "" "NAME;BASELINE" "COMMAND;ARGS")
  if(audit_UNPARSED_ARGUMENTS)
    list(JOIN audit_UNPARSED_ARGUMENTS " " audit_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "touchstone_add_audit(${target}): ${audit_UNPARSED_ARGUMENTS} belongs to none of NAME, BASELINE, COMMAND, "
                        "ARGS; options of `touchstone audit` stand after ARGS")
  endif()
  if(audit_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "touchstone_add_audit(${target}): nothing stands after ${audit_KEYWORDS_MISSING_VALUES}")
  endif()
  if(NOT audit_NAME)
    set(audit_NAME ${target})
  endif()
  if(NOT audit_NAME MATCHES "^audit/")
    set(audit_NAME audit/${audit_NAME})
  endif()
  if(audit_COMMAND)
    # One word for a shell: the program starts the engine with one.
    set(engine "")
    foreach(word IN LISTS audit_COMMAND)
      string(REPLACE "'" "'\\''" word "${word}")
      list(APPEND engine "'${word}'")
    endforeach()
    list(JOIN engine " " engine)
    set(command $<TARGET_FILE:touchstone::program> audit --engine ${engine})
    if(TARGET touchstone AND NOT TARGET touchstone_for_audits)  # its sources are part of the project
      add_custom_target(touchstone_for_audits ALL DEPENDS touchstone)
    endif()
  elseif(NOT TARGET ${target})
    message(FATAL_ERROR "touchstone_add_audit(${target}): no target has this name; an engine that is none is given by COMMAND")
  else()
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL EXECUTABLE)
      message(FATAL_ERROR "touchstone_add_audit(${target}): the target must be an executable with TOUCHSTONE_ENGINE_MAIN, but is a ${type}")
    endif()
    set(command $<TARGET_FILE:${target}>)
  endif()
  list(APPEND command ${audit_ARGS})
  set(test ${command})
  if(audit_BASELINE)
    cmake_path(ABSOLUTE_PATH audit_BASELINE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    list(APPEND test --baseline ${audit_BASELINE})
    string(REPLACE "/" "_" baseline_target ${audit_NAME}_baseline)
    add_custom_target(${baseline_target} COMMAND ${command} --write-baseline ${audit_BASELINE} VERBATIM)
  endif()
  add_test(NAME ${audit_NAME} COMMAND ${test})
  set_tests_properties(${audit_NAME} PROPERTIES LABELS touchstone)
endfunction()
