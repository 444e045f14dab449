# SPDX-License-Identifier: Apache-2.0
# The program `touchstone`, at the top of the build directory.

if(EXISTS ${PROJECT_SOURCE_DIR}/program/main.cpp)
  find_package(CLI11 REQUIRED)
  add_executable(touchstone program/main.cpp)
  touchstone_own(touchstone)
  target_link_libraries(touchstone PRIVATE touchstone_audit CLI11::CLI11 fmt::fmt)
  set_target_properties(touchstone PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
  install(TARGETS touchstone)
endif()
