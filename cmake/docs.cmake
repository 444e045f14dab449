# SPDX-License-Identifier: Apache-2.0
# The target `docs`: the contracts of reference/ and the headers beside them, as pages.

find_package(Doxygen REQUIRED)
set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_SOURCE_DIR}/build/docs)
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/README.md)
set(DOXYGEN_FILE_PATTERNS *.h)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_QUIET YES)
doxygen_add_docs(docs geometry reference robust oracle audit README.md)
