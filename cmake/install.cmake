# What is installed, in three components:
#   program    racebeam with manual page and completions, its own libraries, scenes, checksums of
#              the chip, what plug-ins include
#   rtl        the units in SystemVerilog, verilated when asked for, and how yosys counts their cells
#   hardware   the SystemC chip as a library, for find_package and pkg-config
# All paths are relative to the prefix: it may be moved.
set(RACEBEAM_DATADIR ${CMAKE_INSTALL_DATADIR}/racebeam)
set(RACEBEAM_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/racebeam)
include(CMakePackageConfigHelpers)

install(
  TARGETS racebeam
  EXPORT racebeam-program
  COMPONENT program)
set(LIBRARIES racebeam_images)
foreach(optional racebeam_window racebeam_search)
  if(TARGET ${optional})
    list(APPEND LIBRARIES ${optional})
  endif()
endforeach()
install(
  TARGETS ${LIBRARIES}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/racebeam
  COMPONENT program)
install(
  DIRECTORY scenes
  DESTINATION ${RACEBEAM_DATADIR}
  COMPONENT program
  FILES_MATCHING
  PATTERN "*.toml"
  PATTERN pictures EXCLUDE)
install(
  DIRECTORY tests/reference
  DESTINATION ${RACEBEAM_DATADIR}/tests
  COMPONENT program)
install(
  FILES tb/report/claims.toml
  DESTINATION ${RACEBEAM_DATADIR}/tb/report
  COMPONENT program)
install(
  FILES tb/signoff/waivers.toml
  DESTINATION ${RACEBEAM_DATADIR}/tb/signoff
  COMPONENT program)
install(
  DIRECTORY tb/signoff/coverage_waivers tb/signoff/proved
  DESTINATION ${RACEBEAM_DATADIR}/tb/signoff
  COMPONENT program)
install(
  DIRECTORY tb/twin/streams
  DESTINATION ${RACEBEAM_DATADIR}/tb/twin
  COMPONENT program)
install(
  FILES sc/swap/rtl_glue.cc.in sc/swap/rtl_coverage.cc.in sc/swap/rtl_coverage.h
        sc/swap/rtl_model.h sc/swap/rtl_power_up.h sc/swap/rtl_runtime.h
  DESTINATION ${RACEBEAM_DATADIR}/sc/swap
  COMPONENT program)

install(
  FILES cmake/copyright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/racebeam
  COMPONENT program)

# The manual page and the completions, which the program writes
set(WRITTEN ${CMAKE_BINARY_DIR}/written)
file(MAKE_DIRECTORY ${WRITTEN})
set(WRITE "$<TARGET_FILE:racebeam> --man | gzip -9n >racebeam.1.gz")
foreach(shell bash fish zsh)
  string(APPEND WRITE " && $<TARGET_FILE:racebeam> --completion ${shell} >${shell}")
endforeach()
add_custom_command(
  OUTPUT ${WRITTEN}/racebeam.1.gz ${WRITTEN}/bash ${WRITTEN}/fish ${WRITTEN}/zsh
  COMMAND bash -o pipefail -c "${WRITE}"
  DEPENDS racebeam
  WORKING_DIRECTORY ${WRITTEN}
  COMMENT "Writing the manual page and the completions"
  VERBATIM)
add_custom_target(racebeam_written ALL DEPENDS ${WRITTEN}/racebeam.1.gz)
install(
  FILES ${WRITTEN}/racebeam.1.gz
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
  COMPONENT program)
function(install_completion shell folder name)
  install(
    FILES ${WRITTEN}/${shell}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder}
    RENAME ${name}
    COMPONENT program)
endfunction()
install_completion(bash bash-completion/completions racebeam)
install_completion(fish fish/vendor_completions.d racebeam.fish)
install_completion(zsh zsh/site-functions _racebeam)

install(
  DIRECTORY rtl
  DESTINATION ${RACEBEAM_DATADIR}
  COMPONENT rtl)
install(
  PROGRAMS scripts/netlist scripts/timing scripts/strict.sh
  DESTINATION ${RACEBEAM_DATADIR}/scripts
  COMPONENT rtl)

install(
  TARGETS racebeam_hardware
  EXPORT racebeam-hardware
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT hardware)
install(
  DIRECTORY sc
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/racebeam
  COMPONENT hardware
  FILES_MATCHING
  PATTERN "*.h")

# --- find_package(racebeam) and pkg-config: with any component that they tell of ------------------
foreach(component program hardware)
  install(
    EXPORT racebeam-${component}
    NAMESPACE racebeam::
    DESTINATION ${RACEBEAM_CMAKEDIR}
    COMPONENT ${component})
endforeach()
configure_package_config_file(
  cmake/racebeam-config.cmake.in ${CMAKE_BINARY_DIR}/cmake/racebeam-config.cmake
  INSTALL_DESTINATION ${RACEBEAM_CMAKEDIR}
  PATH_VARS RACEBEAM_DATADIR
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/cmake/racebeam-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
file(RELATIVE_PATH UP ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/racebeam.pc.in ${CMAKE_BINARY_DIR}/cmake/racebeam.pc @ONLY)
foreach(component program hardware)
  install(
    FILES ${CMAKE_BINARY_DIR}/cmake/racebeam-config.cmake
          ${CMAKE_BINARY_DIR}/cmake/racebeam-config-version.cmake
    DESTINATION ${RACEBEAM_CMAKEDIR}
    COMPONENT ${component})
endforeach()
install(
  FILES ${CMAKE_BINARY_DIR}/cmake/racebeam.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT hardware)
