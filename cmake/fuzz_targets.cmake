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

set(fuzzing_engine ${TOUCHSTONE_FUZZING_ENGINE})
if(TOUCHSTONE_LIBFUZZER)
  set(fuzzing_engine -fsanitize=fuzzer)
endif()
if(fuzzing_engine)
  unset(replay_main)
endif()
separate_arguments(fuzzing_engine)
add_executable(fuzz ${replay_main})
touchstone_own(fuzz)
target_link_libraries(fuzz PRIVATE touchstone_audit touchstone_fuzz_driver)
target_link_libraries(fuzz PRIVATE ${fuzzing_engine})
set_target_properties(fuzz PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/fuzz LINKER_LANGUAGE CXX)

if(NOT fuzzing_engine)
  file(GLOB operations CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/fuzz/corpus ${PROJECT_SOURCE_DIR}/fuzz/corpus/*)
  set(mutations 125)
  if(TOUCHSTONE_TESTS STREQUAL FULL)
    set(mutations 500)
  endif()
  foreach(name ${operations})
    set(known "")
    foreach(folder fuzz/corpus/${name} fuzz/findings/${name})
      file(GLOB inputs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*)
      if(inputs)
        list(APPEND known ${folder})
      endif()
    endforeach()
    if(known)
      add_test(NAME fuzz/replay/${name} COMMAND fuzz ${name} --mutations ${mutations} ${known}
               WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    endif()
  endforeach()
endif()

if(TOUCHSTONE_TESTS STREQUAL FULL AND TARGET touchstone_alone AND NOT fuzzing_engine AND NOT TOUCHSTONE_COVERAGE)
  add_test(NAME fuzz/service COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/proptests/fuzzing_service.py ${PROJECT_SOURCE_DIR}
                                     ${PROJECT_BINARY_DIR} $<TARGET_OBJECTS:touchstone_fuzz_driver> COMMAND_EXPAND_LISTS)
  set_tests_properties(fuzz/service PROPERTIES SKIP_RETURN_CODE 77)
endif()
