# What another project gets from find_package(racebeam):
#
#   racebeam_add_unit_rtl(NAME <name> UNIT <unit> SOURCES <file>... [PARAMETERS <Name=value>...])
#       verilates RTL that can stand in the place of a unit: a target rtl_<name>, whose property
#       PLUGIN is the plug-in's path, and the target `rtl` of all of them. SOURCES are files, lists
#       (.f) or folders, as `racebeam verilate` takes them; what they include is followed
#   racebeam::racebeam
#       the program: racebeam verify <unit>=<plug-in>
#   racebeam::hardware
#       the SystemC chip as a library: #include <sc/beam/tlm/tlm_chip.h> in a virtual platform, <sc/beam/chip.h>
#
# SOURCES have the module <unit>, with the ports of sc/beam/<unit>.h, or of sc/video/vga_timing.h.
#
# SPDX-FileCopyrightText: racebeam contributors
# SPDX-License-Identifier: Apache-2.0
get_filename_component(RACEBEAM_FOLDER ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)

get_filename_component(RACEBEAM_PROGRAM ${RACEBEAM_FOLDER}/../../bin/racebeam ABSOLUTE)
if(EXISTS ${RACEBEAM_PROGRAM} AND NOT TARGET racebeam::racebeam)
  add_executable(racebeam::racebeam IMPORTED)
  set_target_properties(racebeam::racebeam PROPERTIES IMPORTED_LOCATION ${RACEBEAM_PROGRAM})
endif()

get_filename_component(RACEBEAM_LIBRARY ${RACEBEAM_FOLDER}/../../lib/racebeam/libracebeam_hardware.a
                       ABSOLUTE)
if(EXISTS ${RACEBEAM_LIBRARY} AND NOT TARGET racebeam::hardware)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(SYSTEMC REQUIRED IMPORTED_TARGET systemc)
  add_library(racebeam::hardware STATIC IMPORTED)
  set_target_properties(
    racebeam::hardware
    PROPERTIES IMPORTED_LOCATION ${RACEBEAM_LIBRARY}
               INTERFACE_INCLUDE_DIRECTORIES ${RACEBEAM_FOLDER}
               INTERFACE_COMPILE_DEFINITIONS SC_INCLUDE_DYNAMIC_PROCESSES
               INTERFACE_COMPILE_FEATURES cxx_std_17
               INTERFACE_LINK_LIBRARIES "PkgConfig::SYSTEMC;${CMAKE_DL_LIBS}")
endif()

if(NOT TARGET rtl)
  add_custom_target(rtl ALL)
endif()

function(racebeam_add_unit_rtl)
  cmake_parse_arguments(PARSE_ARGV 0 rtl "" "NAME;UNIT" "SOURCES;PARAMETERS")
  foreach(needed NAME UNIT SOURCES)
    if(NOT rtl_${needed})
      message(FATAL_ERROR "racebeam_add_unit_rtl: ${needed} is missing; "
                          "it is called with NAME name UNIT unit SOURCES file...")
    endif()
  endforeach()
  if(rtl_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "racebeam_add_unit_rtl: what is ${rtl_UNPARSED_ARGUMENTS}?")
  endif()
  set(plugin ${CMAKE_BINARY_DIR}/rtl/${rtl_NAME}.so)
  set(sources)
  foreach(source IN LISTS rtl_SOURCES)
    get_filename_component(source ${source} ABSOLUTE)
    list(APPEND sources ${source})
  endforeach()
  list(TRANSFORM rtl_PARAMETERS PREPEND -G)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/rtl)
  add_custom_command(
    OUTPUT ${plugin}
    COMMAND ${CMAKE_COMMAND} -E env CXX=${CMAKE_CXX_COMPILER} $<TARGET_FILE:racebeam::racebeam>
            verilate ${rtl_UNIT} ${sources} -o ${plugin} --depfile ${plugin}.d ${rtl_PARAMETERS}
    DEPENDS ${sources} racebeam::racebeam
    DEPFILE ${plugin}.d
    COMMENT "Verilating ${rtl_NAME}"
    VERBATIM)
  add_custom_target(rtl_${rtl_NAME} DEPENDS ${plugin})
  set_property(TARGET rtl_${rtl_NAME} PROPERTY PLUGIN ${plugin})
  add_dependencies(rtl rtl_${rtl_NAME})
endfunction()
