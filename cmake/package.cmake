# cpack --config build/CPackConfig.cmake: racebeam_VERSION_ARCHITECTURE.deb, of all that is
# installed. What the program needs of Debian is read from its libraries, and from scripts/setup.

# debian_packages(<who> <variable>): those that scripts/setup has for them
function(debian_packages who variable)
  execute_process(COMMAND ${CMAKE_SOURCE_DIR}/scripts/setup --list ${who} OUTPUT_VARIABLE packages
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" packages "${packages}")
  set(${variable} ${packages} PARENT_SCOPE)
endfunction()
debian_packages(base DEPENDS)
debian_packages(more RECOMMENDS)
list(REMOVE_ITEM RECOMMENDS ${DEPENDS})

set(RACEBEAM_MAINTAINER "racebeam contributors <racebeam@example.org>"
    CACHE STRING "who answers for the Debian package")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME racebeam)
set(CPACK_PACKAGE_VENDOR "racebeam contributors")
set(CPACK_PACKAGE_CONTACT ${RACEBEAM_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "model of a chip that ray-traces ahead of the VGA beam")
set(CPACK_PACKAGE_DESCRIPTION
    "A SystemC model of a taped-out chip that ray-traces box rooms just ahead of
the VGA beam, without a frame buffer, and a SystemVerilog twin of each unit.
It renders pictures, flights and sound, shows every clock in a viewer or as
waveforms, and verifies RTL of your own in the place of a unit. The chip is
there as a TLM-2.0 component, too, for virtual platforms.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
list(JOIN DEPENDS ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
list(JOIN RECOMMENDS ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/package_as_debian.cmake)
include(CPack)
