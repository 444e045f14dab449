# SPDX-License-Identifier: Apache-2.0
# Toolchain of the presets of other platforms: Debian's cross compiler for TOUCHSTONE_TRIPLE, the libraries of that
# platform in TOUCHSTONE_LIBRARIES, which ./dev platforms puts there, and an emulator: qemu with the C library of the
# compiler, or Wine.

list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TOUCHSTONE_TRIPLE TOUCHSTONE_LIBRARIES)
string(REGEX MATCH "^[^-]+" CMAKE_SYSTEM_PROCESSOR "${TOUCHSTONE_TRIPLE}")
set(CMAKE_FIND_ROOT_PATH ${TOUCHSTONE_LIBRARIES})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()

if(TOUCHSTONE_TRIPLE MATCHES "mingw")
  set(CMAKE_SYSTEM_NAME Windows)
  set(CMAKE_CXX_COMPILER ${TOUCHSTONE_TRIPLE}-g++-posix)
  set(CMAKE_RC_COMPILER ${TOUCHSTONE_TRIPLE}-windres)
  # Objects may have more than 65,535 sections, the runtime of g++ is linked statically, and threads have as much stack as on Linux.
  set(CMAKE_CXX_FLAGS_INIT "-Wa,-mbig-obj")
  set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -Wl,--stack,8388608")
  set(CMAKE_CROSSCOMPILING_EMULATOR wine)
  return()
endif()

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_CXX_COMPILER ${TOUCHSTONE_TRIPLE}-g++)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)  # g++ notes what changed in its version 10
set(emulated ${CMAKE_SYSTEM_PROCESSOR})
if(CMAKE_SYSTEM_PROCESSOR STREQUAL i686)
  string(APPEND CMAKE_CXX_FLAGS_INIT " -msse2 -mfpmath=sse")  # x87 rounds twice
  set(emulated i386)
endif()
string(REPLACE powerpc64le ppc64le emulator ${emulated})
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-${emulator} -L /usr/${TOUCHSTONE_TRIPLE})
set(CMAKE_LIBRARY_ARCHITECTURE ${emulated}-linux-gnu)
string(APPEND CMAKE_CXX_FLAGS_INIT " -isystem ${TOUCHSTONE_LIBRARIES}/usr/include/${CMAKE_LIBRARY_ARCHITECTURE}")
