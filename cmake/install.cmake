# What is installed, in three components:
#   program    racebeam, its picture library, scenes, checksums of the chip, what plug-ins include
#   rtl        the units in SystemVerilog, verilated when asked for
#   hardware   the SystemC chip as a library, for find_package and pkg-config
# All paths are relative to the prefix: it may be moved.
set(RACEBEAM_DATADIR ${CMAKE_INSTALL_DATADIR}/racebeam)
set(RACEBEAM_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/racebeam)
include(CMakePackageConfigHelpers)

install(
  TARGETS racebeam
  EXPORT racebeam-program
  COMPONENT program)
install(
  TARGETS racebeam_images
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/racebeam
  COMPONENT program)
install(
  DIRECTORY scenes
  DESTINATION ${RACEBEAM_DATADIR}
  COMPONENT program)
install(
  DIRECTORY tests/reference
  DESTINATION ${RACEBEAM_DATADIR}/tests
  COMPONENT program)
install(
  FILES sc/swap/rtl_glue.cc.in sc/swap/rtl_model.h sc/swap/rtl_runtime.h
  DESTINATION ${RACEBEAM_DATADIR}/sc/swap
  COMPONENT program)

install(
  DIRECTORY rtl
  DESTINATION ${RACEBEAM_DATADIR}
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
