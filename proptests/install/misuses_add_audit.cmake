# SPDX-License-Identifier: Apache-2.0
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/touchstone_add_audit.cmake)
separate_arguments(ARGUMENTS)
touchstone_add_audit(${ARGUMENTS})
