# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause

# What makes find_package(Gestalt) work from the installation and from the build tree.
include(CMakePackageConfigHelpers)
set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/Gestalt)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/GestaltConfig.cmake.in ${PROJECT_BINARY_DIR}/GestaltConfig.cmake
                              INSTALL_DESTINATION ${destination})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/GestaltConfigVersion.cmake COMPATIBILITY SameMinorVersion)
foreach(file dependencies gestalt_add_plugin)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${file}.cmake ${PROJECT_BINARY_DIR}/${file}.cmake COPYONLY)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/GestaltConfig.cmake ${PROJECT_BINARY_DIR}/GestaltConfigVersion.cmake
              cmake/dependencies.cmake cmake/gestalt_add_plugin.cmake DESTINATION ${destination} COMPONENT dev)
set(exports GestaltTargets)
if(BUILD_TESTING)
  list(APPEND exports GestaltPluginSdkTargets)
endif()
foreach(targets ${exports})
  export(EXPORT ${targets} NAMESPACE gestalt:: FILE ${PROJECT_BINARY_DIR}/${targets}.cmake)
  install(EXPORT ${targets} NAMESPACE gestalt:: DESTINATION ${destination} COMPONENT dev)
endforeach()

# Debian packages: `cpack --config build/CPackConfig.cmake` makes one of each component.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME gestalt)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The Gestalt authors <gestalt@example.org>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

get_cmake_property(CPACK_COMPONENTS_ALL COMPONENTS)
list(REMOVE_ITEM CPACK_COMPONENTS_ALL Unspecified)
set(same_version "(= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME gestalt)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Segments unknown objects in RGB-D frames
 The gestalt command, its library, plugins, configs and trained models.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libgestalt-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "gestalt ${same_version}, libeigen3-dev (>= 3.4), nlohmann-json3-dev (>= 3.11),
  libopencv-core-dev, libopencv-imgproc-dev, cmake (>= 3.22)")
string(REGEX REPLACE "\n *" " " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${CPACK_DEBIAN_DEV_PACKAGE_DEPENDS}")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "libgtest-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Gestalt for other programs and for plugins
 Headers, CMake package and the conformance suite for plugins.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gestalt)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
get_directory_property(python DIRECTORY ${PROJECT_SOURCE_DIR}/python DEFINITION Python_VERSION_MINOR)
if(python)  # the module is for this interpreter alone
  math(EXPR next_python "${python} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "gestalt ${same_version}, python3 (>= 3.${python}), python3 (<< 3.${next_python}), python3-numpy")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-distributed")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Gestalt in Python
 The segmenter on numpy arrays, components written in Python, batches by Dask.")

set(CPACK_DEBIAN_VIEWER_PACKAGE_NAME gestalt-view)
set(CPACK_DEBIAN_VIEWER_PACKAGE_SECTION science)
set(CPACK_DEBIAN_VIEWER_PACKAGE_DEPENDS "gestalt ${same_version}")
set(CPACK_COMPONENT_VIEWER_DESCRIPTION "Gestalt's results in PCL's viewer
 What gestalt segment --view opens.")

# Each package says what it is made of, where dpkg and Ninja know.
find_program(DPKG_QUERY dpkg-query)
if(DPKG_QUERY AND CMAKE_GENERATOR STREQUAL Ninja)
  set(CPACK_GESTALT_BUILD ${PROJECT_BINARY_DIR})
  set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package_sbom.cmake)
endif()

include(CPack)
