# SPDX-License-Identifier: Apache-2.0
# find_package(touchstone): touchstone::{geometry,reference,robust,oracle}, and touchstone::{certify,audit} where
# the libraries that these need are found. <touchstone/robust/lines/orientation.h> and "geometry/points.h" both resolve.

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/touchstone)

install(TARGETS touchstone_geometry touchstone_reference touchstone_robust touchstone_oracle
        EXPORT touchstone-rooms)
install(TARGETS touchstone_certify touchstone_audit EXPORT touchstone-audit)
install(EXPORT touchstone-rooms NAMESPACE touchstone:: DESTINATION ${package_dir})
install(EXPORT touchstone-audit NAMESPACE touchstone:: DESTINATION ${package_dir})

foreach(room geometry reference robust oracle catalogue audit report program)
  install(DIRECTORY ${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/touchstone FILES_MATCHING PATTERN "*.h"
          PATTERN robust/stages EXCLUDE PATTERN robust/rings EXCLUDE PATTERN robust/hulls EXCLUDE)
endforeach()

configure_package_config_file(cmake/touchstone-config.cmake.in ${PROJECT_BINARY_DIR}/touchstone-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/touchstone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/touchstone-config.cmake ${PROJECT_BINARY_DIR}/touchstone-config-version.cmake
              cmake/FindGMP.cmake cmake/FindMPFR.cmake
        DESTINATION ${package_dir})
