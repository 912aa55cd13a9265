# SPDX-License-Identifier: BSD-3-Clause
# Read by cpack before it makes packages. Until a version is tagged vX.Y.Z, packages come before it: their
# versions have the time of the commit, so that later ones replace earlier ones.
set(CPACK_DEBIAN_PACKAGE_VERSION ${CPACK_PACKAGE_VERSION})
cmake_path(GET CPACK_GMAPPING_SPA_SOURCE PARENT_PATH parent)
set(git ${CMAKE_COMMAND} -E env GIT_CEILING_DIRECTORIES=${parent} TZ=UTC
        git -C ${CPACK_GMAPPING_SPA_SOURCE})
execute_process(
  COMMAND ${git} tag --points-at HEAD --list v${CPACK_PACKAGE_VERSION}
  OUTPUT_VARIABLE tag OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(
  COMMAND ${git} show --no-patch --date=format-local:%a,\ %d\ %b\ %Y\ %H:%M:%S\ +0000 --format=%cd HEAD
  OUTPUT_VARIABLE CPACK_GMAPPING_SPA_DATE OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(
  COMMAND ${git} show --no-patch --date=format-local:%Y%m%d.%H%M%S --format=%cd.%h HEAD
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  message(STATUS "There is no repository: the packages do not tell their commit")
  string(TIMESTAMP CPACK_GMAPPING_SPA_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, where it is set
elseif(tag STREQUAL "")
  string(APPEND CPACK_DEBIAN_PACKAGE_VERSION "~git${commit}")
endif()
execute_process(COMMAND ${git} diff --quiet HEAD ERROR_QUIET RESULT_VARIABLE status)
if(status EQUAL 1)
  string(APPEND CPACK_DEBIAN_PACKAGE_VERSION "+changed")
endif()

set(runtime "gmapping-spa (= ${CPACK_DEBIAN_PACKAGE_VERSION})")
foreach(component IN ITEMS DEV PYTHON)
  list(JOIN CPACK_GMAPPING_SPA_${component}_DEPENDS ", " depends)
  set(CPACK_DEBIAN_${component}_PACKAGE_DEPENDS "${runtime}, ${depends}")
endforeach()
