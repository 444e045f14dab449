# SPDX-License-Identifier: Apache-2.0
# GMP::gmp (C) and GMP::gmpxx (the C++ classes).

if(TARGET GMP::gmp)  # TOUCHSTONE_ARITHMETIC=OWN
  set(GMP_FOUND TRUE)
  return()
endif()
find_path(GMP_INCLUDE_DIR gmpxx.h)
find_library(GMP_LIBRARY gmp)
find_library(GMPXX_LIBRARY gmpxx)
mark_as_advanced(GMP_INCLUDE_DIR GMP_LIBRARY GMPXX_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GMP REQUIRED_VARS GMP_LIBRARY GMPXX_LIBRARY GMP_INCLUDE_DIR)

if(GMP_FOUND AND NOT TARGET GMP::gmp)
  add_library(GMP::gmp UNKNOWN IMPORTED)
  set_target_properties(GMP::gmp PROPERTIES IMPORTED_LOCATION ${GMP_LIBRARY}
                                            INTERFACE_INCLUDE_DIRECTORIES ${GMP_INCLUDE_DIR})
  add_library(GMP::gmpxx UNKNOWN IMPORTED)
  set_target_properties(GMP::gmpxx PROPERTIES IMPORTED_LOCATION ${GMPXX_LIBRARY}
                                              INTERFACE_INCLUDE_DIRECTORIES ${GMP_INCLUDE_DIR}
                                              INTERFACE_LINK_LIBRARIES GMP::gmp)
endif()
