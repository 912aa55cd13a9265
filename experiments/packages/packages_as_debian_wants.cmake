# SPDX-License-Identifier: BSD-3-Clause
# Run by cpack on the files of all packages before it packs them: Debian has man pages packed, a changelog
# in each package (Debian Policy 12.1, 12.7), and no notes of the compiler in binaries (dh_strip).
find_program(gzip gzip REQUIRED)
find_program(strip strip REQUIRED)

function(pack file)
  execute_process(COMMAND ${gzip} --best --no-name --force ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} name)
  set(prefix ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX})
  file(GLOB_RECURSE binaries ${prefix}/bin/* ${prefix}/lib/*.a ${prefix}/lib/*.so ${prefix}/lib/*_worker)
  foreach(binary IN LISTS binaries)
    execute_process(COMMAND ${strip} --strip-debug --enable-deterministic-archives
                            --remove-section=.comment --remove-section=.note ${binary}
                    COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  set(share ${prefix}/share)
  file(GLOB pages ${share}/man/man*/*.1)
  foreach(page IN LISTS pages)
    pack(${page})
  endforeach()
  set(changelog ${share}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME}/changelog)
  file(WRITE ${changelog} "gmapping-spa (${CPACK_DEBIAN_PACKAGE_VERSION}) unstable; urgency=medium

  * Changes are told in CHANGELOG.md.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${CPACK_GMAPPING_SPA_DATE}
")
  pack(${changelog})
endforeach()
