# SPDX-License-Identifier: Apache-2.0
# fuzz/CHAPTER/OP.cpp -> fuzz/OP. With libFuzzer, or with a driver that replays files, so that every compiler runs what
# fuzzing has found: ctest replays fuzz/corpus/OP and fuzz/findings/OP.

file(GLOB driver_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fuzz/driver/*.cpp)
set(replay_main ${PROJECT_SOURCE_DIR}/fuzz/driver/replay_main.cpp)
list(REMOVE_ITEM driver_sources ${replay_main})
if(driver_sources)
  # Objects, not an archive: libFuzzer asks for the mutator weakly, which would not pull it out of an archive.
  add_library(touchstone_fuzz_driver OBJECT ${driver_sources})
  touchstone_own(touchstone_fuzz_driver)
  target_link_libraries(touchstone_fuzz_driver PUBLIC touchstone_audit)
endif()

if(EXISTS ${replay_main} AND NOT TOUCHSTONE_LIBFUZZER)
  add_library(touchstone_fuzz_replay OBJECT ${replay_main})
  touchstone_own(touchstone_fuzz_replay)
  target_link_libraries(touchstone_fuzz_replay PUBLIC touchstone_audit)
endif()

file(GLOB targets CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fuzz/*/*.cpp)
list(FILTER targets EXCLUDE REGEX "/fuzz/driver/")
foreach(source ${targets})
  cmake_path(GET source STEM name)
  add_executable(fuzz_${name} ${source})
  touchstone_own(fuzz_${name})
  target_link_libraries(fuzz_${name} PRIVATE touchstone_audit $<TARGET_NAME_IF_EXISTS:touchstone_fuzz_driver>
                        $<TARGET_NAME_IF_EXISTS:touchstone_fuzz_replay>)
  touchstone_precompiled(fuzz_${name})
  target_link_options(fuzz_${name} PRIVATE $<$<BOOL:${TOUCHSTONE_LIBFUZZER}>:-fsanitize=fuzzer>)
  set_target_properties(fuzz_${name} PROPERTIES OUTPUT_NAME ${name}
                                                RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/fuzz)
  set(known "")
  foreach(folder fuzz/corpus/${name} fuzz/findings/${name})
    file(GLOB inputs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*)
    if(inputs)
      list(APPEND known ${folder})
    endif()
  endforeach()
  if(known AND NOT TOUCHSTONE_LIBFUZZER)
    add_test(NAME fuzz/replay/${name} COMMAND fuzz_${name} ${known} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  endif()
endforeach()
