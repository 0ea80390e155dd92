# From which sources the program was built, and how: source_commit() and compiler_text() of
# tb/sweep, looked at in each build. Included it adds them to a target; run as a script it writes
# them.
if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(
    COMMAND git describe --always --dirty=-changed --abbrev=12
    WORKING_DIRECTORY ${ROOT}
    OUTPUT_VARIABLE commit
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(CONFIGURE OUTPUT ${MADE} @ONLY CONTENT [[
#include "tb/sweep/build_origin.h"
namespace racebeam {
const char* source_commit() { return "@commit@"; }
const char* compiler_text() { return "@COMPILER@"; }
}  // namespace racebeam
]])
  return()
endif()

function(add_build_origin target)
  set(made ${CMAKE_BINARY_DIR}/cmake/build_origin.cpp)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  set(compiler "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_CXX_FLAGS_${type}}")
  add_custom_target(
    racebeam_build_origin
    COMMAND ${CMAKE_COMMAND} -D ROOT=${CMAKE_SOURCE_DIR} -D MADE=${made} -D COMPILER=${compiler} -P
            ${CMAKE_SOURCE_DIR}/cmake/build_origin.cmake
    BYPRODUCTS ${made}
    COMMENT "Asking from which commit this is"
    VERBATIM)
  target_sources(${target} PRIVATE ${made})
  set_source_files_properties(${made} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  add_dependencies(${target} racebeam_build_origin)
endfunction()
