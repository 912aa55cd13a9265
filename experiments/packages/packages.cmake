# SPDX-License-Identifier: BSD-3-Clause
# Settings of CPack: a Debian package for each component. What depends on the time of packaging is in
# packages_at_cpack_time.cmake.
file(STRINGS ${PROJECT_SOURCE_DIR}/CITATION.cff maintainer REGEX "^  - name: ")
string(REGEX REPLACE "^  - name: " "" maintainer "${maintainer}")
# Who packages for others says who, as Debian's tools are told.
set(maintainer_address "gmapping-spa@packages.invalid")  # that there is none: RFC 2606
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(maintainer $ENV{DEBFULLNAME})
  set(maintainer_address $ENV{DEBEMAIL})
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gmapping-spa)
set(CPACK_PACKAGE_VENDOR "${maintainer}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_SOURCE_DIR}/packages_at_cpack_time.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/packages_as_debian_wants.cmake)
set(CPACK_GMAPPING_SPA_SOURCE ${PROJECT_SOURCE_DIR})

set(CPACK_COMPONENTS_ALL runtime dev)
if(TARGET gmapping_spa_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${maintainer} <${maintainer_address}>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "2D lidar SLAM with interchangeable pose-graph back ends")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME gmapping-spa)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "GMapping, the particle filter, with a pose graph that interchangeable back
ends optimize while it runs, and whose result corrects the particles. Maps for
ROS, trajectories and pose graphs (.g2o) from laser logs; an optimizer of pose
graphs; a simulator; metrics of maps and trajectories.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS bash-completion)

# The static libraries are linked by whoever links these, and find_package looks for what they use.
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libgmapping-spa-dev)
set(CPACK_COMPONENT_DEV_DESCRIPTION
  "For development: headers, static libraries and the CMake package
gmapping_spa, for programs that do SLAM or optimize pose graphs, and for back
ends. With examples.")
set(CPACK_GMAPPING_SPA_DEV_DEPENDS
  libboost-dev libbz2-dev libeigen3-dev libgoogle-glog-dev liblz4-dev libmetis-dev libsqlite3-dev
  libsuitesparse-dev libyaml-cpp-dev libzstd-dev pkg-config)

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gmapping-spa)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "The Python module gmapping_spa: scans as NumPy arrays in, poses, maps and pose
graphs out.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-matplotlib)  # for the example
# An extension is for one version of Python.
execute_process(
  COMMAND python3 -c "import sys; a, b = sys.version_info[:2]; print(f'python3 (>= {a}.{b}~);python3 (<< {a}.{b + 1})')"
  OUTPUT_VARIABLE python_versions OUTPUT_STRIP_TRAILING_WHITESPACE)
set(CPACK_GMAPPING_SPA_PYTHON_DEPENDS ${python_versions} python3-numpy)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  ${CMAKE_CURRENT_SOURCE_DIR}/python/postinst ${CMAKE_CURRENT_SOURCE_DIR}/python/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)

include(CPack)
