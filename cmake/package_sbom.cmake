# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause

# CPack runs this when the files of all packages are in place: stripped, as they will be installed.
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} key)
  set(prefix ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX})
  execute_process(
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/../scripts/sbom --build ${CPACK_GESTALT_BUILD} --installed ${prefix}
            --output ${prefix}/share/doc/${CPACK_DEBIAN_${key}_PACKAGE_NAME}/sbom.spdx.json
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
