# SPDX-License-Identifier: Apache-2.0
# touchstone_alone: the program as one file to carry, which needs the C library and nothing else; ./dev package packs it.
# The objects are those of the program; only what they are linked with is static (docs/package.md: licences).

set(static_libraries "")
foreach(library mpfr gmpxx gmp png16 z expat)
  find_library(TOUCHSTONE_STATIC_${library} lib${library}.a)
  mark_as_advanced(TOUCHSTONE_STATIC_${library})
  if(NOT TOUCHSTONE_STATIC_${library})
    message(STATUS "touchstone_alone is left out: no static lib${library}.a")
    return()
  endif()
  list(APPEND static_libraries ${TOUCHSTONE_STATIC_${library}})
endforeach()

add_executable(touchstone_alone EXCLUDE_FROM_ALL program/main.cpp)
touchstone_own(touchstone_alone)
target_include_directories(touchstone_alone PRIVATE ${PROJECT_SOURCE_DIR})
# Debian has {fmt} as a shared library and as headers: what the objects expect of the one is compiled from the other.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/fmt.cpp CONTENT [[
#define FMT_HEADER_ONLY 1
#undef FMT_SHARED
#include <fmt/format.h>
std::string (*const touchstone_vformat)(fmt::string_view, fmt::format_args) = fmt::vformat;
void (*const touchstone_throw)(const char*) = fmt::detail::throw_format_error;
bool (*const touchstone_is_printable)(std::uint32_t) = fmt::detail::is_printable;
extern const void* const touchstone_fmt[] = {&touchstone_vformat, &touchstone_throw, &touchstone_is_printable};
]])
target_sources(touchstone_alone PRIVATE ${PROJECT_BINARY_DIR}/fmt.cpp)
set(archives "")
foreach(module ${touchstone_modules})
  list(PREPEND archives touchstone_module_${module})
endforeach()
list(APPEND archives touchstone_robust touchstone_oracle touchstone_certify)
add_dependencies(touchstone_alone ${archives})
list(TRANSFORM archives REPLACE "(.+)" "$<TARGET_FILE:\\1>")
target_link_libraries(touchstone_alone PRIVATE -Wl,--start-group ${archives} -Wl,--end-group ${static_libraries}
                                               -static-libstdc++ -static-libgcc)
set_target_properties(touchstone_alone PROPERTIES OUTPUT_NAME touchstone RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/alone)

# The notices of what is linked, as the Debian packages that it came from have them: installed, or unpacked for another processor.
set(notices "")
set(packages "")
set(runtimes gcc-12-base gcc-13-base gcc-14-base)
if(CMAKE_CROSSCOMPILING)
  set(runtimes gcc-12-cross-base gcc-13-cross-base gcc-14-cross-base)
endif()
foreach(package libgmp-dev libmpfr-dev libpng-dev zlib1g-dev libexpat1-dev libfmt-dev nlohmann-json3-dev libcli11-dev ${runtimes})
  set(unpacked "")
  if(CMAKE_CROSSCOMPILING)
    file(GLOB unpacked ${TOUCHSTONE_LIBRARIES}/${package}_*.deb)
  endif()
  set(notice /usr/share/doc/${package}/copyright)
  if(unpacked)
    set(notice ${TOUCHSTONE_LIBRARIES}${notice})
  endif()
  if(EXISTS ${notice})
    list(APPEND notices ${notice})
    list(APPEND packages ${unpacked})
    if(NOT unpacked)
      list(APPEND packages ${package})
    endif()
  endif()
endforeach()
set(bill "")
set(sources "")
if(notices)
  file(STRINGS ${PROJECT_SOURCE_DIR}/CITATION.cff released REGEX "^date-released: ")
  string(REPLACE "date-released: " "" released "${released}")
  set(bill ${PROJECT_BINARY_DIR}/touchstone.spdx.json)
  execute_process(COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/bill_of_materials.py ${PROJECT_VERSION} ${released} ${bill}
                          ${packages} OUTPUT_VARIABLE sources COMMAND_ERROR_IS_FATAL ANY)
endif()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/copyright @ONLY CONTENT [[
touchstone @PROJECT_VERSION@ is under the Apache License 2.0: LICENSE, in this folder.

The program holds parts of these Debian packages; their notices are in the folder linked, and their sources at
https://snapshot.debian.org:
@sources@
GMP and MPFR are under the GNU Lesser General Public License, version 3 (linked/LGPL-3, linked/GPL-3). You may change them and link
the program anew: ./dev package in the sources of touchstone links whatever libgmp.a and libmpfr.a it finds.
]])

# Of the package, and of no other installation.
set(carried COMPONENT carried EXCLUDE_FROM_ALL)
install(PROGRAMS ${PROJECT_BINARY_DIR}/alone/touchstone DESTINATION ${CMAKE_INSTALL_BINDIR} ${carried})
install(FILES ${documentation}/touchstone.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 ${carried})
install(FILES ${documentation}/touchstone.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME touchstone ${carried})
install(FILES ${documentation}/_touchstone DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions ${carried})
install(DIRECTORY vectors DESTINATION ${data_dir} ${carried})
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} ${carried})
install(FILES ${PROJECT_BINARY_DIR}/copyright ${bill} DESTINATION ${CMAKE_INSTALL_DOCDIR} ${carried})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} ${carried} PATTERN __pycache__ EXCLUDE PATTERN node_modules EXCLUDE)
foreach(notice ${notices})
  string(REGEX REPLACE ".*/([^/]+)/copyright$" "\\1" package ${notice})
  install(FILES ${notice} DESTINATION ${CMAKE_INSTALL_DOCDIR}/linked RENAME ${package} ${carried})
endforeach()
install(FILES /usr/share/common-licenses/GPL-3 /usr/share/common-licenses/LGPL-3 DESTINATION ${CMAKE_INSTALL_DOCDIR}/linked ${carried}
        OPTIONAL)

set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};touchstone;carried;/")
set(CPACK_GENERATOR DEB TGZ)
if(NOT CPACK_PACKAGE_CONTACT)  # who publishes a package gives his own
  set(CPACK_PACKAGE_CONTACT "The touchstone authors <root@localhost>")
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_FILE_NAME touchstone-${PROJECT_VERSION}-Linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
if(CMAKE_CROSSCOMPILING)
  get_filename_component(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${TOUCHSTONE_LIBRARIES} NAME)
endif()
# The C library has to be as new as the newest symbol that is taken from it.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/depends.cmake @ONLY CONTENT [[
execute_process(COMMAND "@CMAKE_OBJDUMP@" -T "@PROJECT_BINARY_DIR@/alone/touchstone" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "GLIBC_[0-9.]+" versions "${symbols}")
list(SORT versions COMPARE NATURAL ORDER DESCENDING)
list(GET versions 0 newest)
string(REPLACE "GLIBC_" "" newest ${newest})
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libc6 (>= ${newest})")
]])
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/depends.cmake)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
include(CPack)
