# What Debian has elsewhere than others, in the folder that cpack packs.
if(NOT CPACK_GENERATOR STREQUAL DEB)
  return()
endif()
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)
file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)

string(TIMESTAMP today "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(
  WRITE ${share}/doc/racebeam/changelog
  "racebeam (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
  "  * Packaged as it is: its CHANGELOG.md tells what is new.\n\n"
  " -- ${CPACK_PACKAGE_CONTACT}  ${today}\n")
execute_process(COMMAND gzip -9n ${share}/doc/racebeam/changelog COMMAND_ERROR_IS_FATAL ANY)
