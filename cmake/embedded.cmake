# SPDX-License-Identifier: Apache-2.0
# A file NAME of another language -> NAME_script, its text, in the header embedded.h: pages of a report carry their
# scripts in themselves, and the program prints its completion. Beside it generate.py makes contracts.h.

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
