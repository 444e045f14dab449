# SPDX-License-Identifier: Apache-2.0
# The program `touchstone`, at the top of the build directory.

find_package(CLI11 REQUIRED)
add_executable(touchstone program/main.cpp)
add_executable(touchstone::program ALIAS touchstone)
touchstone_own(touchstone)
if(WIN32)  # a library of its own: our options are not for the compiler of resources
  add_library(touchstone_manifest OBJECT program/windows/touchstone.rc)
  target_sources(touchstone PRIVATE $<TARGET_OBJECTS:touchstone_manifest>)
endif()
target_link_libraries(touchstone PRIVATE touchstone_audit CLI11::CLI11 ${touchstone_fmt})
set_target_properties(touchstone PROPERTIES EXPORT_NAME program RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
if(NOT PROJECT_IS_TOP_LEVEL AND NOT TOUCHSTONE_INSTALL)
  set_target_properties(touchstone PROPERTIES EXCLUDE_FROM_ALL TRUE)
endif()

# What documents the program is printed by it. Left out where the program was not built.
if(PROJECT_IS_TOP_LEVEL)
  set(documentation ${PROJECT_BINARY_DIR}/documentation)
  file(MAKE_DIRECTORY ${documentation})
  add_custom_command(
    OUTPUT ${documentation}/touchstone.1 ${documentation}/touchstone.bash ${documentation}/_touchstone
    COMMAND touchstone --man > ${documentation}/touchstone.1
    COMMAND touchstone --completion bash > ${documentation}/touchstone.bash
    COMMAND touchstone --completion zsh > ${documentation}/_touchstone
    DEPENDS touchstone)
  add_custom_target(manual ALL DEPENDS ${documentation}/touchstone.1)
  install(FILES ${documentation}/touchstone.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
  install(FILES ${documentation}/touchstone.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          RENAME touchstone OPTIONAL)
  install(FILES ${documentation}/_touchstone DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions OPTIONAL)
endif()
