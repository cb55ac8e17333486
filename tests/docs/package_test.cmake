# Installs the engine alone into a fresh folder, looks at what is there, compiles each header alone
# and builds the documentation's example against it.
# Takes SOURCE, BUILD, EXAMPLE, WORK, CONFIG, GENERATOR, FLAGS and COMPILER.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --component engine --config ${CONFIG} --prefix ${WORK}/prefix)

# The public headers, the library and the package's files; nothing else of the engine.
file(GLOB headers RELATIVE ${SOURCE}/engine/include ${SOURCE}/engine/include/pupflow/*.h)
file(GLOB_RECURSE installed RELATIVE ${WORK}/prefix ${WORK}/prefix/*)
list(FILTER installed EXCLUDE REGEX "/cmake/pupflow/pupflow[A-Za-z-]*\\.cmake$")
list(FILTER installed EXCLUDE REGEX "/libpupflow\\.(a|so)$")
list(FILTER installed EXCLUDE REGEX "/pkgconfig/pupflow\\.pc$")
list(TRANSFORM installed REPLACE "^include/" "")
list(SORT headers)
list(SORT installed)
if(NOT headers STREQUAL installed)
  message(FATAL_ERROR "the engine's headers are\n${headers}\nbut installed are\n${installed}")
endif()

function(build project)
  run(${CMAKE_COMMAND} -S ${project} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
  run(${CMAKE_COMMAND} --build ${WORK}/build)
endfunction()

# A file for each header, which includes nothing else.
set(files "")
foreach(header ${headers})
  string(MAKE_C_IDENTIFIER ${header} name)
  file(WRITE ${WORK}/headers/${name}.cpp "#include <${header}>\n#include <${header}>\n")
  string(APPEND files " ${name}.cpp")
endforeach()
file(WRITE ${WORK}/headers/CMakeLists.txt "cmake_minimum_required(VERSION 3.21)
project(headers LANGUAGES CXX)
find_package(pupflow REQUIRED)
add_library(headers OBJECT${files})
target_compile_options(headers PRIVATE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror)
target_link_libraries(headers PRIVATE pupflow::engine)
")
build(${WORK}/headers)

file(REMOVE_RECURSE ${WORK}/build)
build(${EXAMPLE})
run(${WORK}/build/warm_or_cold)
if(NOT output MATCHES "T_a = 0.2: huddling 0")
  message(FATAL_ERROR "the example printed:\n${output}")
endif()

# The same by pkg-config.
file(GLOB_RECURSE pc ${WORK}/prefix/*/pupflow.pc)
get_filename_component(pc_folder ${pc} DIRECTORY)
execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc_folder}
  pkg-config --cflags --libs pupflow OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
separate_arguments(own UNIX_COMMAND "${FLAGS}")
run(${COMPILER} -std=c++20 ${own} ${EXAMPLE}/warm_or_cold.cpp -o ${WORK}/by_pkg_config ${flags})

# The shared library is a component of its own: asked for without it, the package says so.
file(WRITE ${WORK}/shared/CMakeLists.txt "cmake_minimum_required(VERSION 3.21)
project(shared LANGUAGES CXX)
find_package(pupflow REQUIRED COMPONENTS shared)
add_executable(shared ${EXAMPLE}/warm_or_cold.cpp)
target_link_libraries(shared PRIVATE pupflow::engine_shared)
")
file(GLOB library ${BUILD}/engine/libpupflow.so.*)
if(library)
  file(REMOVE_RECURSE ${WORK}/build)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/shared -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE words)
  if(NOT result OR NOT words MATCHES "libpupflow\\.so[.0-9]*[ \n]+is[ \n]+missing")  # CMake breaks lines
    message(FATAL_ERROR "without the shared library, asking for it gave:\n${words}")
  endif()
  run(${CMAKE_COMMAND} --install ${BUILD} --component library --config ${CONFIG} --prefix ${WORK}/prefix)
  file(REMOVE_RECURSE ${WORK}/build)
  build(${WORK}/shared)
  run(${WORK}/build/shared)
  if(NOT output MATCHES "T_a = 0.2: huddling 0")
    message(FATAL_ERROR "the example with the shared library printed:\n${output}")
  endif()
endif()
