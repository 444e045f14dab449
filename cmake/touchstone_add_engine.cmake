# SPDX-License-Identifier: Apache-2.0
# touchstone_add_engine(target source...)
#
# The program of an engine in C++, of sources of which one has TOUCHSTONE_ENGINE_MAIN, linked to touchstone::audit.
function(touchstone_add_engine target)
  if(NOT ARGN)
    message(FATAL_ERROR "touchstone_add_engine(${target}): no source stands after the target's name")
  endif()
  add_executable(${target} ${ARGN})
  target_link_libraries(${target} PRIVATE touchstone::audit)
endfunction()
