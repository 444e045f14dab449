# SPDX-License-Identifier: Apache-2.0
# What is made of the declarations in our sources, by generate.py.

find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
set(touchstone_generate ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/cmake/generate.py)
# touchstone_generate(RESULT argument...): RESULT is what it lists.
function(touchstone_generate result)
  execute_process(COMMAND ${touchstone_generate} ${ARGN} OUTPUT_VARIABLE listed OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${listed}" PARENT_SCOPE)
endfunction()

set(touchstone_generated ${PROJECT_BINARY_DIR}/generated)
include(rows)

set(touchstone_c_headers ${touchstone_generated})
if(NOT PROJECT_IS_TOP_LEVEL)  # then users see that folder, and nothing else shall be in it
  set(touchstone_c_headers ${PROJECT_BINARY_DIR}/c)
endif()
foreach(header touchstone touchstone_record touchstone_record_log)
  configure_file(${PROJECT_SOURCE_DIR}/c/${header}.h ${touchstone_c_headers}/${header}.h COPYONLY)
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/c/record.h ${touchstone_generated}/record.h COPYONLY)  # <touchstone/record.h>
configure_file(${PROJECT_SOURCE_DIR}/audit/version.h.in ${touchstone_generated}/audit/version.h @ONLY)

file(GLOB read CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/*.py ${PROJECT_SOURCE_DIR}/robust/batch/*.h ${PROJECT_SOURCE_DIR}/robust/batch/isa/columns.h
     ${PROJECT_SOURCE_DIR}/geometry/*.h ${PROJECT_SOURCE_DIR}/reference/*/*.h ${PROJECT_SOURCE_DIR}/oracle/certificates/check*.cpp
     ${PROJECT_SOURCE_DIR}/robust/c/*.in ${PROJECT_SOURCE_DIR}/python/touchstone/*.in)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${read})
touchstone_generate(none files ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} ${touchstone_c_headers} ${PROJECT_VERSION})
set(array_forms_source ${PROJECT_BINARY_DIR}/array_forms/touchstone_robust.cpp)
