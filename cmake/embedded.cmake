# SPDX-License-Identifier: Apache-2.0
# A file NAME of another language -> NAME_script, its text, in the header embedded.h: pages of a report carry their
# scripts in themselves, and the program prints its completion.

set(scripts "")
file(GLOB scripts_of_pages CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/report/scripts/*.js)
foreach(file ${scripts_of_pages} report/pages/deck.json program/completion.bash)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
  file(READ ${PROJECT_SOURCE_DIR}/${file} script)
  cmake_path(GET file STEM name)
  string(APPEND scripts "constexpr const char* ${name}_script = R\"text(${script})text\";\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/embedded/embedded.h @ONLY CONTENT [[
#pragma once

namespace touchstone::report {

@scripts@
}  // namespace touchstone::report
]])
set_source_files_properties(${PROJECT_SOURCE_DIR}/report/parts/html_parts.cpp ${PROJECT_SOURCE_DIR}/report/pages/deck_page.cpp
                            ${PROJECT_SOURCE_DIR}/program/documentation.cpp
                            PROPERTIES INCLUDE_DIRECTORIES ${PROJECT_BINARY_DIR}/embedded)

# The contract of each row's operation, the comment above its declaration in reference/, in the header contracts.h.
set(contracts "")
file(GLOB rows CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/catalogue/rows ${PROJECT_SOURCE_DIR}/catalogue/rows/*/*.h)
foreach(row ${rows})
  set(header ${PROJECT_SOURCE_DIR}/reference/${row})
  cmake_path(GET row STEM name)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  file(READ ${header} text)
  string(REGEX MATCH "((\n///[^\n]*)+)\n(template[^\n]*\n)?[^\n]* ${name}\\(" declared "${text}")
  if(NOT declared)
    message(FATAL_ERROR "reference/${row}: no contract stands above ${name}")
  endif()
  string(REGEX REPLACE "\n/// ?" "\n" contract "${CMAKE_MATCH_1}")
  string(APPEND contracts "    {\"${name}\", R\"text(${contract})text\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/embedded/contracts.h @ONLY CONTENT [[
#pragma once

namespace touchstone::report {

constexpr struct {
  const char *operation, *text;
} contracts[] = {
@contracts@};

}  // namespace touchstone::report
]])
set_source_files_properties(${PROJECT_SOURCE_DIR}/report/pages/contract.cpp
                            PROPERTIES INCLUDE_DIRECTORIES ${PROJECT_BINARY_DIR}/embedded)
