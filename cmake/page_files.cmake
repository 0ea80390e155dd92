# The files of tb/report/page as strings of the program: page_file() of tb/report, made anew when one
# has changed. Included it adds them to a target; run as a script it writes them.
if(CMAKE_SCRIPT_MODE_FILE)
  file(WRITE ${MADE}.new [[
#include <stdexcept>

#include "tb/report/page_files.h"

namespace racebeam {

std::string_view page_file(const std::string& name) {
]])
  string(REPLACE "|" ";" FILES "${FILES}")
  foreach(file IN LISTS FILES)
    file(READ ${FOLDER}/${file} text)
    # Source maps are not there, and nobody shall look for them
    string(REGEX REPLACE "//# sourceMappingURL=[^\n]*" "" text "${text}")
    if(text MATCHES "\\)page_file\"|</script")
      message(FATAL_ERROR "${file} has text that ends the string, or the script, that it stands in")
    endif()
    file(APPEND ${MADE}.new "  if (name == \"${file}\")\n    return R\"page_file(")
    file(APPEND ${MADE}.new "${text}")
    file(APPEND ${MADE}.new ")page_file\";\n")
  endforeach()
  file(APPEND ${MADE}.new [[
  throw std::out_of_range("no page file " + name);
}

}  // namespace racebeam
]])
  file(RENAME ${MADE}.new ${MADE})
  return()
endif()

function(add_page_files target)
  set(folder ${CMAKE_SOURCE_DIR}/tb/report/page)
  set(made ${CMAKE_BINARY_DIR}/cmake/page_files.cpp)
  file(GLOB files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.css ${folder}/*.js
       ${folder}/vega/*.js ${folder}/vega/LICENSE.*)
  set(sources ${files})
  list(TRANSFORM sources PREPEND ${folder}/)
  string(REPLACE ";" "|" files "${files}")
  add_custom_command(
    OUTPUT ${made}
    COMMAND ${CMAKE_COMMAND} -D FOLDER=${folder} -D FILES=${files} -D MADE=${made} -P
            ${CMAKE_SOURCE_DIR}/cmake/page_files.cmake
    DEPENDS ${sources} ${CMAKE_SOURCE_DIR}/cmake/page_files.cmake
    COMMENT "Putting the page of reports into the program"
    VERBATIM)
  target_sources(${target} PRIVATE ${made})
  set_source_files_properties(${made} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()
