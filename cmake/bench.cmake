# SPDX-License-Identifier: Apache-2.0
# bench/NAME.cpp -> bench/NAME, beside the peers that it measures. TOUCHSTONE_BENCH=COMPILE: they shall keep compiling, and nothing is
# measured by them.

find_package(benchmark QUIET)
if(NOT benchmark_FOUND)
  message(STATUS "bench/ is left out: it needs Google Benchmark")
  return()
endif()
file(GLOB benches CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/*.cpp)
find_path(FCL_INCLUDE_DIR fcl/fcl.h)
find_library(FCL_LIBRARY fcl)
find_library(CCD_LIBRARY ccd)
find_path(EIGEN_INCLUDE_DIR Eigen/Core PATH_SUFFIXES eigen3)
if(NOT (FCL_INCLUDE_DIR AND FCL_LIBRARY AND CCD_LIBRARY AND EIGEN_INCLUDE_DIR))
  list(FILTER benches EXCLUDE REGEX "/distances[.]cpp$")  # which times FCL
endif()
foreach(source ${benches})
  cmake_path(GET source STEM name)
  add_executable(bench_${name} ${source})
  touchstone_own(bench_${name})
  if(TOUCHSTONE_BENCH STREQUAL COMPILE)
    target_compile_options(bench_${name} PRIVATE -O0)
  endif()
  target_link_libraries(bench_${name} PRIVATE touchstone_audit benchmark::benchmark MPFR::mpfr GMP::gmpxx)
  set_target_properties(bench_${name} PROPERTIES OUTPUT_NAME ${name}
                                                 RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bench)
endforeach()
if(TARGET bench_distances)
  target_include_directories(bench_distances SYSTEM PRIVATE ${FCL_INCLUDE_DIR} ${EIGEN_INCLUDE_DIR})
  target_link_libraries(bench_distances PRIVATE ${FCL_LIBRARY} ${CCD_LIBRARY})
endif()
if(TARGET bench_simulation)
  target_link_libraries(bench_simulation PRIVATE touchstone_module_simulate)
  foreach(peer bullet ode)
    if(TARGET engine_library_${peer})
      string(TOUPPER ${peer} macro)
      target_link_libraries(bench_simulation PRIVATE engine_library_${peer})
      target_compile_definitions(bench_simulation PRIVATE TOUCHSTONE_BENCH_${macro})
    endif()
  endforeach()
endif()
# One peer more, where it is there.
find_library(QHULL_R_LIBRARY qhull_r)
if(QHULL_R_LIBRARY AND TARGET bench_hulls)
  target_link_libraries(bench_hulls PRIVATE ${QHULL_R_LIBRARY})
endif()
# The naive formulas that decisions over arrays are compared with, in the lanes of each instruction set, contracted to FMA as users compile
# them.
if(TARGET bench_arrays)
  file(GLOB naive CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/isa/*.cpp)
  target_sources(bench_arrays PRIVATE ${naive})
  set(as_users_do -ffp-contract=fast -fno-rounding-math -Wno-unused-function)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/bench/isa/plain.cpp PROPERTIES COMPILE_OPTIONS "${as_users_do}")
  set_source_files_properties(${PROJECT_SOURCE_DIR}/bench/isa/avx2.cpp PROPERTIES COMPILE_OPTIONS "${as_users_do};-mavx2;-mfma")
  set_source_files_properties(
    ${PROJECT_SOURCE_DIR}/bench/isa/avx512.cpp
    PROPERTIES COMPILE_OPTIONS "${as_users_do};-mavx2;-mfma;-mavx512f;-mavx512bw;-mavx512dq;-mavx512vl;${quietly}")
endif()
