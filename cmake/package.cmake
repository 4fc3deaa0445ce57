# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause

# What makes find_package(Gestalt) work from the installation and from the build tree.
include(CMakePackageConfigHelpers)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/GestaltConfig.cmake.in ${PROJECT_BINARY_DIR}/GestaltConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Gestalt)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/GestaltConfigVersion.cmake COMPATIBILITY SameMinorVersion)
foreach(file dependencies gestalt_add_plugin)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${file}.cmake ${PROJECT_BINARY_DIR}/${file}.cmake COPYONLY)
endforeach()
export(EXPORT GestaltTargets NAMESPACE gestalt:: FILE ${PROJECT_BINARY_DIR}/GestaltTargets.cmake)
install(EXPORT GestaltTargets NAMESPACE gestalt:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Gestalt)
install(FILES ${PROJECT_BINARY_DIR}/GestaltConfig.cmake ${PROJECT_BINARY_DIR}/GestaltConfigVersion.cmake
              cmake/dependencies.cmake cmake/gestalt_add_plugin.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Gestalt)
