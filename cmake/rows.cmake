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
set(signature_order "")
set(signature_includes "")
set(row_sources "")
foreach(chapter ${touchstone_chapters})
  file(GLOB rows CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/catalogue/rows/${chapter}/*.h)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${rows})
  touchstone_generate(in_order order ${rows})
  list(APPEND row_order ${in_order})
  set(touchstone_rows_of_${chapter} ${in_order})
  set(includes "")
  set(operations "")
  foreach(row ${rows})
    cmake_path(GET row STEM name)
    string(APPEND includes "#include \"catalogue/rows/${chapter}/${name}.h\"\n")
    string(APPEND operations "template const Operation& operation_of_row<rows::${name}>();\n")
  endforeach()
  foreach(name ${in_order})  # a structure or a method for another operation's question has no signature of its own
    if(EXISTS ${PROJECT_SOURCE_DIR}/catalogue/signatures/${chapter}/${name}.h)
      list(APPEND signature_order ${name})
      string(APPEND signature_includes "#include \"catalogue/signatures/${chapter}/${name}.h\"
")
    endif()
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
# touchstone_declare_rows(folder rows...): declared.h in this folder, with these rows in this order.
function(touchstone_declare_rows folder)
  list(JOIN ARGN ";\nstruct " declared)
  list(JOIN ARGN ",\n    rows::" in_order)
  file(CONFIGURE OUTPUT ${folder}/catalogue/rows/declared.h @ONLY CONTENT [[
// Made by cmake/rows.cmake from the names of the rows.
#pragma once

namespace touchstone::catalogue {
namespace rows {
struct @declared@;
}  // namespace rows

template <class... R>
struct RowList;
using Rows = RowList<
    rows::@in_order@>;

}  // namespace touchstone::catalogue
]])
endfunction()
touchstone_declare_rows(${touchstone_generated} ${row_order})
list(JOIN signature_order ",\n    signatures::" signature_order)
file(CONFIGURE OUTPUT ${touchstone_generated}/catalogue/rows/all.h @ONLY CONTENT [[
// Made by cmake/rows.cmake from the rows.
#pragma once

#include "catalogue/rows/declared.h"
@all_includes@]])
file(CONFIGURE OUTPUT ${touchstone_generated}/catalogue/signatures/all.h @ONLY CONTENT [[
// Made by cmake/rows.cmake from the signatures.
#pragma once

@signature_includes@
namespace touchstone::catalogue {

using AllSignatures = SignatureList<
    signatures::@signature_order@>;

}  // namespace touchstone::catalogue
]])
