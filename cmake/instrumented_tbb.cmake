# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause

# The thread sanitizer has to see how TBB passes work from thread to thread, or it takes every loop for a race. So the
# build has a libtbb of its own with the sanitizer in it, made from the source of Debian's package, whose headers fit it.
include(ExternalProject)
set(version 2021.8.0)
if(NOT TBB_VERSION VERSION_EQUAL version)
  message(FATAL_ERROR "cmake/instrumented_tbb.cmake has TBB ${version}, but the headers are of ${TBB_VERSION}: change the former")
endif()
# The source lies beside the binary packages of wherever apt has them from, and apt knows the way there.
execute_process(COMMAND apt-get download --print-uris libtbb-dev OUTPUT_VARIABLE uris)
if(NOT uris MATCHES "'([^']*/)libtbb-dev_")
  message(FATAL_ERROR "apt-get does not tell where libtbb-dev comes from, and so not where its source is: run apt-get update")
endif()
set(source ${PROJECT_BINARY_DIR}/onetbb_${version}.orig.tar.xz)
set(digest 7e9111b8bb59c8800bf6d0b06afe7b0891937443d2dae1ee1101c8e2ede6a7ef)
if(NOT EXISTS ${source})
  execute_process(COMMAND /usr/lib/apt/apt-helper download-file ${CMAKE_MATCH_1}onetbb_${version}.orig.tar.xz ${source}
                          SHA256:${digest} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "the source of libtbb cannot be fetched from where apt has libtbb-dev from")
  endif()
endif()
set(folder ${PROJECT_BINARY_DIR}/instrumented_tbb)
set(libtbb ${folder}/build/lib_relwithdebinfo/libtbb.so.12)
ExternalProject_Add(
  instrumented_tbb
  URL ${source}
  URL_HASH SHA256=${digest}
  PREFIX ${folder}
  BINARY_DIR ${folder}/build
  CMAKE_ARGS -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DTBB_SANITIZE=thread -DTBB_TEST=OFF
             -DTBBMALLOC_BUILD=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON -DTBB_OUTPUT_DIR_BASE=lib
  BUILD_BYPRODUCTS ${libtbb}
  INSTALL_COMMAND "")
get_target_property(configuration TBB::tbb IMPORTED_CONFIGURATIONS)
set_target_properties(TBB::tbb PROPERTIES IMPORTED_LOCATION_${configuration} ${libtbb})
add_dependencies(TBB::tbb instrumented_tbb)
