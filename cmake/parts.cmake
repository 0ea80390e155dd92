# add_part(<folder> [LINKS <folder or library>...] [WITHOUT <file>...] [HEADERS <header>...])
#
# The sources of a folder, main.cpp left out, as one library. The folders that it links are those
# that it may include, with what they link in turn; all of them come before it, so that nothing
# runs in a circle. scripts/layers holds the include lines to these calls.
# HEADERS are parsed once for the folder; without them, <systemc> is shared by all.
function(add_part folder)
  cmake_parse_arguments(PARSE_ARGV 1 part "" "" "LINKS;WITHOUT;HEADERS")
  part_target(${folder} target)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
  list(TRANSFORM part_WITHOUT PREPEND ${CMAKE_SOURCE_DIR}/${folder}/)
  list(REMOVE_ITEM sources ${CMAKE_SOURCE_DIR}/${folder}/main.cpp ${part_WITHOUT})
  add_library(${target} STATIC ${sources})
  link_parts(${target} PUBLIC ${part_LINKS})
  if(part_HEADERS)
    target_precompile_headers(${target} PRIVATE ${part_HEADERS})
  else()
    share_systemc_header(${target})
  endif()
endfunction()

# part_target(<folder> <variable>): the library of a folder
function(part_target folder variable)
  string(REPLACE "/" "_" name ${folder})
  set(${variable} racebeam_${name} PARENT_SCOPE)
endfunction()

# link_parts(<target> <PUBLIC or PRIVATE> <folder or library>...)
function(link_parts target kind)
  foreach(link IN LISTS ARGN)
    if(link MATCHES "^(sc|tb)/")
      part_target(${link} library)
      if(NOT TARGET ${library})
        message(FATAL_ERROR "${target} links ${link}, which comes later or nowhere; a part links "
                            "parts before it")
      endif()
      set(link ${library})
    endif()
    target_link_libraries(${target} ${kind} ${link})
  endforeach()
endfunction()

# share_systemc_header(<target>): <systemc> is parsed once, for the first target
function(share_systemc_header target)
  get_property(first GLOBAL PROPERTY RACEBEAM_SYSTEMC_HEADER)
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PUBLIC <systemc>)
    set_property(GLOBAL PROPERTY RACEBEAM_SYSTEMC_HEADER ${target})
  endif()
endfunction()
