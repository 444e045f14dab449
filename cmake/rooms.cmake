# SPDX-License-Identifier: Apache-2.0
# One library a component. reference, robust and oracle never see one another; audit sees them all.

include(components)
include(public_headers)

set(touchstone_asked ${TOUCHSTONE_COMPONENTS})
if("all" IN_LIST touchstone_asked)
  set(touchstone_asked ${touchstone_components})
endif()
set(touchstone_built "")
foreach(component ${touchstone_asked})
  if(NOT component IN_LIST touchstone_components)
    list(JOIN touchstone_components ", " known)
    message(FATAL_ERROR "TOUCHSTONE_COMPONENTS: ${component} is none of all, ${known}")
  endif()
  list(APPEND touchstone_built ${touchstone_parts_of_${component}} ${component})
endforeach()
list(REMOVE_DUPLICATES touchstone_built)
set(touchstone_needed "")
foreach(component ${touchstone_built})
  list(APPEND touchstone_needed ${touchstone_needs_of_${component}})
endforeach()
list(REMOVE_DUPLICATES touchstone_needed)
if(NOT PROJECT_IS_TOP_LEVEL)
  # Who links a library of ours in a directory above must see what it is linked with.
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL TRUE)
endif()
foreach(package ${touchstone_needed})
  find_package(${package} ${touchstone_version_of_${package}} REQUIRED)
endforeach()

# Users, of the installed package and of this source tree in a project of theirs, have one include directory, for <touchstone/...>. Our
# own sources are spelled from the root of the repository.
if(PROJECT_IS_TOP_LEVEL)
  set(touchstone_includes ${PROJECT_SOURCE_DIR})
else()
  set(touchstone_includes ${PROJECT_BINARY_DIR}/include)
  touchstone_write_headers(${PROJECT_SOURCE_DIR} ${touchstone_includes} ${touchstone_built})
  touchstone_public_headers(headers ${PROJECT_SOURCE_DIR} ${touchstone_built})
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${headers})
endif()

# touchstone_room(name sources...): touchstone::name, installed with the package.
function(touchstone_room room)
  if(NOT room IN_LIST touchstone_built)
    return()
  endif()
  set(target touchstone_${room})
  if(ARGN)
    add_library(${target} STATIC ${ARGN})
    touchstone_own(${target})
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(touchstone::${room} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${room})
  if(ARGN AND NOT PROJECT_IS_TOP_LEVEL AND NOT TOUCHSTONE_INSTALL)
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  endif()
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(
    ${target} ${scope} $<BUILD_INTERFACE:${touchstone_includes}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()

# touchstone_links(room PUBLIC|PRIVATE libraries...), also while a room has no sources yet.
function(touchstone_links room scope)
  if(NOT TARGET touchstone_${room})
    return()
  endif()
  get_target_property(type touchstone_${room} TYPE)
  if(type STREQUAL INTERFACE_LIBRARY)
    set(scope INTERFACE)
  endif()
  target_link_libraries(touchstone_${room} ${scope} ${ARGN})
endfunction()

file(GLOB_RECURSE robust_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/robust/*.cpp)
file(GLOB_RECURSE oracle_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/oracle/*.cpp)
file(GLOB_RECURSE audit_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/catalogue/*.cpp ${PROJECT_SOURCE_DIR}/audit/*.cpp
     ${PROJECT_SOURCE_DIR}/report/*.cpp ${PROJECT_SOURCE_DIR}/program/*.cpp)
set(certify_sources ${oracle_sources})
list(FILTER certify_sources INCLUDE REGEX "/oracle/certificates/(check[^/]*|named_file)\\.cpp$")
list(FILTER oracle_sources EXCLUDE REGEX "/oracle/certificates/(check[^/]*|named_file)\\.cpp$")

# Every check_NAME.cpp with a function checks_of_NAME is in the table of the checker.
set(declared "")
set(listed "")
foreach(source ${certify_sources})
  file(STRINGS ${source} found REGEX "^Checks checks_of_[a-z_]+\\(\\)" LIMIT_COUNT 1)
  if(found)
    string(REGEX MATCH "checks_of_[a-z_]+" found "${found}")
    string(APPEND declared "Checks ${found}();\n")
    list(APPEND listed ${found})
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  endif()
endforeach()
list(JOIN listed ", " listed)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/certify/check_files.h @ONLY CONTENT [[
#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {

@declared@
constexpr Checks (*checks_of_all_files[])() = {@listed@};

}  // namespace touchstone::certify
]])

list(FILTER audit_sources EXCLUDE REGEX "/program/main\\.cpp|/program/engines/")

# catalogue/rows/CHAPTER/*.h -> one translation unit that makes the operations of the chapter's rows: one for each row would take five times as
# long, because it is the headers that cost.
file(GLOB rows CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/catalogue/*/*.h)
list(FILTER rows EXCLUDE REGEX "^catalogue/(codec|families|judge)/")
set(row_chapters "")
foreach(row ${rows})
  cmake_path(GET row STEM name)
  cmake_path(GET row PARENT_PATH chapter)
  cmake_path(GET chapter FILENAME chapter)
  list(APPEND row_chapters ${chapter})
  string(APPEND includes_of_${chapter} "#include \"${row}\"\n")
  string(APPEND operations_of_${chapter} "template const Operation& operation_of_row<rows::${name}>();\n")
endforeach()
list(REMOVE_DUPLICATES row_chapters)
set(row_sources "")
foreach(chapter ${row_chapters})
  set(includes "${includes_of_${chapter}}")
  set(operations "${operations_of_${chapter}}")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/rows/${chapter}.cpp @ONLY CONTENT [[
#include "catalogue/operation/row_of.h"
@includes@
namespace touchstone::audit {
@operations@
}  // namespace touchstone::audit
]])
  list(APPEND row_sources ${PROJECT_BINARY_DIR}/rows/${chapter}.cpp)
endforeach()

touchstone_room(geometry)
touchstone_room(reference)
touchstone_room(robust ${robust_sources})
touchstone_room(oracle ${oracle_sources})
touchstone_room(certify ${certify_sources})
touchstone_room(audit ${audit_sources} ${row_sources})
touchstone_room(testing)

touchstone_links(reference PUBLIC touchstone_geometry)
touchstone_links(robust PUBLIC touchstone_geometry)
touchstone_links(robust PRIVATE MPFR::mpfr GMP::gmp)
if(robust_sources AND TARGET touchstone_robust)
  # The installed library takes nothing of CGAL that is under the GPL: its headers refuse to compile with this.
  target_compile_definitions(touchstone_robust PRIVATE CGAL_LICENSE_ERROR)
endif()
touchstone_links(oracle PUBLIC touchstone_geometry GMP::gmpxx)
touchstone_links(oracle PRIVATE MPFR::mpfr)
touchstone_links(certify PUBLIC nlohmann_json::nlohmann_json)
touchstone_links(certify PRIVATE GMP::gmpxx)
if(TARGET touchstone_certify)
  target_include_directories(touchstone_certify PRIVATE ${PROJECT_BINARY_DIR}/certify)
endif()
touchstone_links(audit PUBLIC touchstone_reference touchstone_robust touchstone_oracle touchstone_certify MPFR::mpfr
                 nlohmann_json::nlohmann_json)
touchstone_links(audit PRIVATE fmt::fmt PNG::PNG)
touchstone_links(testing PUBLIC touchstone_audit)

if(TOUCHSTONE_PCH AND TARGET touchstone_audit)
  target_precompile_headers(touchstone_audit PRIVATE <nlohmann/json.hpp> <gmpxx.h>)
endif()
