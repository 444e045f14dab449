# SPDX-License-Identifier: Apache-2.0
# The catalogue's list, made from its rows, catalogue/rows/CHAPTER/NAME.h: a header that declares them in the order of the deck, one that
# includes them all, and for each chapter one translation unit that makes their operations (one for each row would take five times as
# long, because it is the headers that cost).

# In the order of the deck, and within a chapter by page; last what lies between its chapters.
set(touchstone_chapters lines polygons planes volumes sweeps polyhedra broad_phase response mixed)
file(GLOB folders CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/catalogue/rows ${PROJECT_SOURCE_DIR}/catalogue/rows/*)
foreach(folder ${folders})
  if(NOT folder IN_LIST touchstone_chapters)
    message(FATAL_ERROR "catalogue/rows/${folder}: name this chapter in touchstone_chapters of cmake/rows.cmake, where it comes in the order")
  endif()
endforeach()
set(row_order "")
set(row_sources "")
foreach(chapter ${touchstone_chapters})
  file(GLOB rows CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/catalogue/rows/${chapter} ${PROJECT_SOURCE_DIR}/catalogue/rows/${chapter}/*.h)
  set(keys "")
  set(includes "")
  set(operations "")
  foreach(row ${rows})
    cmake_path(GET row STEM name)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/catalogue/rows/${chapter}/${row})
    # pages = "2, 14" or "45-47, 51": the operation is where the last of them begin.
    file(STRINGS ${PROJECT_SOURCE_DIR}/catalogue/rows/${chapter}/${row} pages REGEX "\\.pages = \"" LIMIT_COUNT 1)
    string(REGEX REPLACE ".*\\.pages = \"([0-9-]+, )*([0-9]+)-?([0-9]*)\".*" "\\2 \\3" pages "${pages}")
    list(APPEND keys "${pages} ${name}")
    string(APPEND includes "#include \"catalogue/rows/${chapter}/${row}\"\n")
    string(APPEND operations "template const Operation& operation_of_row<rows::${name}>();\n")
  endforeach()
  list(SORT keys COMPARE NATURAL)
  foreach(key ${keys})
    string(REGEX REPLACE ".* " "" name "${key}")
    list(APPEND row_order ${name})
  endforeach()
  string(APPEND all_includes "${includes}")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/rows/${chapter}.cpp @ONLY CONTENT [[
#include "catalogue/operation/row_of.h"
@includes@
namespace touchstone::catalogue {
@operations@
}  // namespace touchstone::catalogue
]])
  list(APPEND row_sources ${PROJECT_BINARY_DIR}/rows/${chapter}.cpp)
endforeach()
list(JOIN row_order ";\nstruct " declared)
list(JOIN row_order ",\n    rows::" row_order)
set(touchstone_generated ${PROJECT_BINARY_DIR}/generated)
file(CONFIGURE OUTPUT ${touchstone_generated}/catalogue/rows/declared.h @ONLY CONTENT [[
// Made by cmake/rows.cmake from the names of the rows.
#pragma once

namespace touchstone::catalogue {
namespace rows {
struct @declared@;
}  // namespace rows

template <class... R>
struct RowList;
using Rows = RowList<
    rows::@row_order@>;

}  // namespace touchstone::catalogue
]])
file(CONFIGURE OUTPUT ${touchstone_generated}/catalogue/rows/all.h @ONLY CONTENT [[
// Made by cmake/rows.cmake from the rows.
#pragma once

#include "catalogue/rows/declared.h"
@all_includes@]])
file(GLOB shapes RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/geometry/*.h)
list(TRANSFORM shapes REPLACE "(.+)" "#include \"\\1\"\n")
list(JOIN shapes "" shapes)
file(CONFIGURE OUTPUT ${touchstone_generated}/geometry/all.h @ONLY CONTENT [[
// Made by cmake/rows.cmake from geometry/: every type of questions and answers.
#pragma once

@shapes@]])
