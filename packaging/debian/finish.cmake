# cpack runs this before it packs: gives each package its licence and changelog in Debian's form, a folder of
# documents of its own name, compressed man pages, and what lintian is to pass over.
cmake_policy(VERSION 3.21)
set(overrides ${CMAKE_CURRENT_LIST_DIR}/lintian)
file(STRINGS ${CPACK_PUPFLOW_SOURCE}/LICENSE copyright REGEX "^Copyright \\(c\\) ")
string(REPLACE "Copyright (c) " "" copyright "${copyright}")
file(READ ${CPACK_PUPFLOW_SOURCE}/LICENSE license)
string(REGEX REPLACE ".*\n(Permission is .*)" "\\1" license "${license}")
string(STRIP "${license}" license)
string(REPLACE "\n" "\n " license "${license}")
string(REPLACE "\n \n" "\n .\n" license "${license}")

# The day of the release, or of the newest change.
file(STRINGS ${CPACK_PUPFLOW_SOURCE}/CHANGELOG.md heading REGEX "^## \\[${CPACK_PACKAGE_VERSION}\\] - [0-9-]+$")
if(heading MATCHES "([0-9]+-[0-9]+-[0-9]+)$")
  set(day ${CMAKE_MATCH_1})
else()
  file(TIMESTAMP ${CPACK_PUPFLOW_SOURCE}/CHANGELOG.md day "%Y-%m-%d" UTC)
endif()
execute_process(COMMAND date --utc --rfc-email --date=${day} OUTPUT_VARIABLE day OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)

# compress(FILE): replaces it by FILE.gz, the same for the same bytes.
function(compress file)
  execute_process(COMMAND gzip --best --no-name --force ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} key)
  set(package ${CPACK_DEBIAN_${key}_PACKAGE_NAME})
  set(prefix ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX})
  set(doc ${prefix}/share/doc/${package})
  if(EXISTS ${prefix}/share/doc/pupflow AND NOT package MATCHES "^pupflow(-doc)?$")
    file(RENAME ${prefix}/share/doc/pupflow ${doc})
  endif()
  file(REMOVE ${doc}/LICENSE ${doc}/CHANGELOG.md)  # as `copyright` and `changelog.gz`

  file(CONFIGURE OUTPUT ${doc}/copyright @ONLY CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: pupflow

Files: *
Copyright: @copyright@
License: Expat
 @license@
")
  file(MAKE_DIRECTORY ${doc}/licences)
  foreach(part ${CPACK_PUPFLOW_${key}_CONTAINS})
    file(COPY_FILE /usr/share/doc/${part}/copyright ${doc}/licences/${part})
  endforeach()
  file(COPY_FILE ${CPACK_PUPFLOW_SOURCE}/CHANGELOG.md ${doc}/changelog)
  file(CONFIGURE OUTPUT ${doc}/changelog.Debian @ONLY CONTENT
"pupflow (@CPACK_PACKAGE_VERSION@-@CPACK_DEBIAN_PACKAGE_RELEASE@) unstable; urgency=medium

  * Version @CPACK_PACKAGE_VERSION@; changelog.gz has what is new.

 -- @CPACK_PACKAGE_CONTACT@  @day@
")
  compress(${doc}/changelog)
  compress(${doc}/changelog.Debian)
  file(GLOB pages ${prefix}/share/man/man1/*.1)
  foreach(page ${pages})
    compress(${page})
  endforeach()
  file(READ ${overrides}/every override)
  if(EXISTS ${overrides}/${component})
    file(READ ${overrides}/${component} own)
    string(APPEND override "${own}")
  endif()
  file(WRITE ${prefix}/share/lintian/overrides/${package} "${override}")
endforeach()
