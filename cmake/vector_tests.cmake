# SPDX-License-Identifier: Apache-2.0
# What the vectors are for others: their schemas are strict, and each example finds what the textbook formulas get wrong. Once, whatever the
# compiler: agreement/draws asks both for the same questions, vectors/hold the other one for the same answers.
if(TOUCHSTONE_TEST_ROBUST_ALONE)
  return()
endif()
# The vectors are what the program writes, never edited by hand.
add_test(NAME vectors/are_as_written
         COMMAND sh -c "rm -rf written && $<TARGET_FILE:touchstone> vectors write written && diff -r written '${PROJECT_SOURCE_DIR}/vectors'"
         WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
find_program(NODE node)
add_test(NAME vectors/match_their_schemas
         COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/proptests/vector_schemas.py ${PROJECT_SOURCE_DIR}/vectors)
set_tests_properties(vectors/match_their_schemas PROPERTIES SKIP_RETURN_CODE 77)
function(touchstone_vector_consumer suffix)
  set(source ${PROJECT_SOURCE_DIR}/examples/vectors/consumer.${suffix})
  add_test(NAME vectors/consumer_${suffix}
           COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/proptests/vector_consumers.py ${PROJECT_SOURCE_DIR}/vectors ${source} ${ARGN})
endfunction()
add_executable(vector_consumer ${PROJECT_SOURCE_DIR}/examples/vectors/consumer.cpp)
target_link_libraries(vector_consumer PRIVATE nlohmann_json::nlohmann_json)
target_compile_options(vector_consumer PRIVATE -ffp-contract=off)
set_target_properties(vector_consumer PROPERTIES CXX_STANDARD 17)
touchstone_vector_consumer(cpp $<TARGET_FILE:vector_consumer>)
touchstone_vector_consumer(py ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/examples/vectors/consumer.py)
if(NODE)
  touchstone_vector_consumer(mjs ${NODE} ${PROJECT_SOURCE_DIR}/examples/vectors/consumer.mjs)
endif()
