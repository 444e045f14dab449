# SPDX-License-Identifier: Apache-2.0
# The program `touchstone`, at the top of the build directory.

find_package(CLI11 REQUIRED)
add_executable(touchstone program/main.cpp)
add_executable(touchstone::program ALIAS touchstone)
touchstone_own(touchstone)
target_link_libraries(touchstone PRIVATE touchstone_audit CLI11::CLI11 fmt::fmt)
set_target_properties(touchstone PROPERTIES EXPORT_NAME program RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
if(NOT PROJECT_IS_TOP_LEVEL AND NOT TOUCHSTONE_INSTALL)
  set_target_properties(touchstone PROPERTIES EXCLUDE_FROM_ALL TRUE)
endif()
