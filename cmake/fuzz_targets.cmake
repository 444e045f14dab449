# SPDX-License-Identifier: Apache-2.0
# fuzz/fuzz OP: one program for all operations. With libFuzzer, or with a driver that replays files, so that every compiler runs what
# fuzzing has found: ctest replays fuzz/corpus/OP and fuzz/findings/OP.

file(GLOB driver_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fuzz/driver/*.cpp)
set(replay_main ${PROJECT_SOURCE_DIR}/fuzz/driver/replay_main.cpp)
list(REMOVE_ITEM driver_sources ${replay_main})
# Objects, not an archive: libFuzzer asks for the mutator weakly, which would not pull it out of an archive.
add_library(touchstone_fuzz_driver OBJECT ${driver_sources})
touchstone_own(touchstone_fuzz_driver)
target_link_libraries(touchstone_fuzz_driver PUBLIC touchstone_audit)
touchstone_precompiled(touchstone_fuzz_driver)

add_executable(fuzz $<$<NOT:$<BOOL:${TOUCHSTONE_LIBFUZZER}>>:${replay_main}>)
touchstone_own(fuzz)
target_link_libraries(fuzz PRIVATE touchstone_audit touchstone_fuzz_driver)
target_link_options(fuzz PRIVATE $<$<BOOL:${TOUCHSTONE_LIBFUZZER}>:-fsanitize=fuzzer>)
set_target_properties(fuzz PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/fuzz LINKER_LANGUAGE CXX)

if(NOT TOUCHSTONE_LIBFUZZER)
  file(GLOB operations CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/fuzz/corpus ${PROJECT_SOURCE_DIR}/fuzz/corpus/*)
  foreach(name ${operations})
    set(known "")
    foreach(folder fuzz/corpus/${name} fuzz/findings/${name})
      file(GLOB inputs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*)
      if(inputs)
        list(APPEND known ${folder})
      endif()
    endforeach()
    if(known)
      add_test(NAME fuzz/replay/${name} COMMAND fuzz ${name} ${known} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    endif()
  endforeach()
endif()
