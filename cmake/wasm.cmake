# SPDX-License-Identifier: Apache-2.0
# The C interface as a WebAssembly module, and the npm package around it: what `./dev wasm` builds, with emscripten's toolchain file.

# touchstone_find_headers(package): of the host's headers a folder of links, for the compiler must not see the rest of /usr/include.
function(touchstone_find_headers package)
  set(folder_of_nlohmann_json nlohmann)
  set(folder_of_fmt fmt)
  set(folder ${folder_of_${package}})
  find_path(TOUCHSTONE_HEADERS_OF_${package} ${folder} PATHS /usr/include /usr/local/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH
            REQUIRED)
  mark_as_advanced(TOUCHSTONE_HEADERS_OF_${package})
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/headers)
  file(CREATE_LINK ${TOUCHSTONE_HEADERS_OF_${package}}/${folder} ${PROJECT_BINARY_DIR}/headers/${folder} SYMBOLIC)
  add_library(${package}::${package} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${package}::${package} SYSTEM INTERFACE ${PROJECT_BINARY_DIR}/headers)
  target_compile_definitions(${package}::${package} INTERFACE FMT_HEADER_ONLY=1)
endfunction()

# touchstone_add_npm_package(target folder source): builds the npm package in this folder, with the C interface as its module. The source
# may define what the libraries define, too, and is taken instead.
function(touchstone_add_npm_package target folder source)
  file(STRINGS ${PROJECT_SOURCE_DIR}/c/touchstone.h declared REGEX "^(int|void) touchstone_[a-z_]+\\(")
  list(TRANSFORM declared REPLACE "^[a-z]+ (touchstone_[a-z_]+).*" "_\\1")
  list(JOIN declared "," exported)
  set(module ${target}_module)
  add_executable(${module} EXCLUDE_FROM_ALL ${source})
  target_link_libraries(${module} PRIVATE touchstone_c)
  target_link_options(
    ${module} PRIVATE --no-entry -Wl,--strip-all -sMODULARIZE -sEXPORT_ES6 -sUSE_ES6_IMPORT_META -sENVIRONMENT=web,worker
    -sWASM_BIGINT -sALLOW_MEMORY_GROWTH -sALLOW_TABLE_GROWTH -sINITIAL_MEMORY=16MB -sFILESYSTEM=0
    -sEXPORTED_FUNCTIONS=${exported},_malloc,_free
    -sEXPORTED_RUNTIME_METHODS=UTF8ToString,stringToUTF8,lengthBytesUTF8,getValue,setValue,addFunction,removeFunction)
  set_target_properties(${module} PROPERTIES OUTPUT_NAME module SUFFIX .mjs RUNTIME_OUTPUT_DIRECTORY ${folder})

  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/js/*.mjs ${PROJECT_SOURCE_DIR}/js/*.d.ts ${PROJECT_SOURCE_DIR}/js/README.md)
  list(FILTER files EXCLUDE REGEX "/types\\.mjs$")
  foreach(file ${files})
    cmake_path(GET file FILENAME name)
    configure_file(${file} ${folder}/${name} COPYONLY)
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/js/package.json.in ${folder}/package.json @ONLY)
  configure_file(${PROJECT_SOURCE_DIR}/LICENSE ${folder}/LICENSE COPYONLY)
  # The notices of what is linked, as the Debian packages that it came from have them.
  foreach(linked emscripten nlohmann-json3-dev libfmt-dev)
    configure_file(/usr/share/doc/${linked}/copyright ${folder}/licenses/${linked} COPYONLY)
  endforeach()
  find_program(TOUCHSTONE_NODE node REQUIRED)
  mark_as_advanced(TOUCHSTONE_NODE)
  add_custom_target(${target} COMMAND ${TOUCHSTONE_NODE} ${PROJECT_SOURCE_DIR}/js/types.mjs ${folder} DEPENDS ${module})
endfunction()

# touchstone_packages_for_npm(): the package in PROJECT_BINARY_DIR/package, and smaller ones in chapters/CHAPTER, whose catalogue lists the
# operations of that chapter alone, so the linker leaves out what none of them needs.
function(touchstone_packages_for_npm)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/module.cpp CONTENT "")
  touchstone_add_npm_package(touchstone_npm ${PROJECT_BINARY_DIR}/package ${PROJECT_BINARY_DIR}/module.cpp)
  set_target_properties(touchstone_npm PROPERTIES EXCLUDE_FROM_ALL OFF)
  set(catalogue ${PROJECT_SOURCE_DIR}/catalogue/catalogue.cpp)
  set_source_files_properties(
    ${catalogue} TARGET_DIRECTORY touchstone_module_catalogue PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  foreach(chapter ${touchstone_chapters})
    set(declared ${PROJECT_BINARY_DIR}/declared/${chapter})
    touchstone_declare_rows(${declared} ${touchstone_rows_of_${chapter}})
    touchstone_add_npm_package(touchstone_npm_${chapter} ${PROJECT_BINARY_DIR}/chapters/${chapter} ${catalogue})
    touchstone_own(touchstone_npm_${chapter}_module)
    target_link_libraries(touchstone_npm_${chapter}_module PRIVATE touchstone_module_catalogue)
    target_include_directories(touchstone_npm_${chapter}_module BEFORE PRIVATE ${declared} ${touchstone_includes})
  endforeach()
endfunction()
