# SPDX-License-Identifier: Apache-2.0
# The package: find_package(touchstone COMPONENTS robust ...) gives touchstone::robust ..., and pkg-config touchstone-robust ...
# One include directory, for <touchstone/robust/lines/orientation.h>; what else users need is in share/touchstone and share/doc/touchstone.

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/touchstone)
set(data_dir ${CMAKE_INSTALL_DATADIR}/touchstone)

# What must be built before it can be installed.
add_custom_target(touchstone_package)
foreach(target ${touchstone_built})
  get_target_property(type touchstone_${target} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    add_dependencies(touchstone_package touchstone_${target})
  endif()
endforeach()
foreach(target touchstone_module_judge touchstone_module_program touchstone manual)
  if(TARGET ${target})
    add_dependencies(touchstone_package ${target})
  endif()
endforeach()

# Headers: written when the package is installed, for they may have changed since cmake ran.
list(JOIN touchstone_generate "\" \"" generate)
install(CODE "execute_process(COMMAND \"${generate}\" headers \"${PROJECT_SOURCE_DIR}\" \"${touchstone_generated}\"
                \"${PROJECT_BINARY_DIR}/include\" ${touchstone_built} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${PROJECT_BINARY_DIR}/include/touchstone DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# Those of C stand above it: <touchstone_record.h>, <touchstone_robust.h>, and with the component c <touchstone.h>.
install(FILES c/touchstone_record.h c/touchstone_record_log.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if("robust" IN_LIST touchstone_built)
  install(FILES ${touchstone_c_headers}/touchstone_robust.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
if("c" IN_LIST touchstone_built)
  install(FILES ${touchstone_c_headers}/touchstone.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()

# Libraries: each component has targets of its own, so that one is found without what the others need.
foreach(component ${touchstone_built})
  set(targets touchstone_${component})
  list(TRANSFORM touchstone_modules_of_${component} PREPEND touchstone_module_ OUTPUT_VARIABLE modules)
  list(APPEND targets ${modules})
  if(component STREQUAL audit)
    list(APPEND targets touchstone)
  endif()
  install(TARGETS ${targets} EXPORT touchstone-${component})
  install(EXPORT touchstone-${component} NAMESPACE touchstone:: DESTINATION ${package_dir})
endforeach()
configure_package_config_file(cmake/touchstone-config.cmake.in ${PROJECT_BINARY_DIR}/touchstone-config.cmake
                              INSTALL_DESTINATION ${package_dir} PATH_VARS data_dir CMAKE_INSTALL_DOCDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/touchstone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/touchstone-config.cmake ${PROJECT_BINARY_DIR}/touchstone-config-version.cmake
              cmake/components.cmake cmake/touchstone_add_audit.cmake cmake/touchstone_add_engine.cmake
              cmake/FindGMP.cmake cmake/FindMPFR.cmake
        DESTINATION ${package_dir})

# pkg-config: the libraries are static, so what they need is linked as well. From its own place, so that the package can be moved.
set(pkgconfig_of_GMP gmpxx gmp)
set(pkgconfig_of_MPFR mpfr)
set(pkgconfig_of_nlohmann_json nlohmann_json)
set(pkgconfig_of_fmt fmt)
set(pkgconfig_of_PNG libpng)
set(pkgconfig_of_ZLIB zlib)
set(pkgconfig_of_EXPAT expat)
file(RELATIVE_PATH to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
foreach(component ${touchstone_built})
  set(requires "")
  set(libs "")
  foreach(part ${touchstone_parts_of_${component}})
    list(APPEND requires "touchstone-${part} = ${PROJECT_VERSION}")
  endforeach()
  foreach(package ${touchstone_needs_of_${component}})
    list(APPEND requires ${pkgconfig_of_${package}})
  endforeach()
  get_target_property(type touchstone_${component} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    set(libs "-L\${libdir} -ltouchstone_${component}")
    if(component MATCHES "^(robust|c)$")  # which a C compiler may link
      string(APPEND libs " -lstdc++ -lm")
    endif()
  elseif(touchstone_modules_of_${component})
    set(libs "-L\${libdir}")
    foreach(module ${touchstone_modules_of_${component}})
      string(REPLACE "\${libdir}" "\${libdir} -ltouchstone_module_${module}" libs "${libs}")
    endforeach()
  endif()
  list(JOIN requires ", " requires)
  configure_file(cmake/touchstone.pc.in pkgconfig/touchstone-${component}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/touchstone-${component}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

# For other languages: test vectors with their schema, and the checker of certificates in Python.
install(DIRECTORY vectors DESTINATION ${data_dir})
install(DIRECTORY oracle/certificates/ DESTINATION ${data_dir}/certify
        FILES_MATCHING PATTERN "certify*.py" PATTERN claims EXCLUDE PATTERN __pycache__ EXCLUDE)
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN __pycache__ EXCLUDE PATTERN node_modules EXCLUDE)
