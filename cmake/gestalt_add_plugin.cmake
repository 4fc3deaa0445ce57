# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause

# gestalt_add_plugin(<name> KIND <kind> SOURCES <algorithm sources> [LIBRARIES <lib>...] [TEST <test source>...])
#
# Makes the plugin <kind>_<name>.so of plugin.cpp and the algorithm. The algorithm is a static library, so its unit tests
# need no loader: with TEST, and BUILD_TESTING on, they are a test that links it and gestalt::test_scenes.
# Outside of Gestalt's own tree the plugin goes to <build>/plugins: name that folder in plugin_directories or
# GESTALT_PLUGIN_PATH. There the conformance suite is a second test; inside, it runs over all plugins at once.
function(gestalt_add_plugin name)
  cmake_parse_arguments(ARG "" "KIND" "SOURCES;LIBRARIES;TEST" ${ARGN})
  set(target ${ARG_KIND}_${name})
  set(folder ${PROJECT_BINARY_DIR}/plugins)
  if(CMAKE_LIBRARY_OUTPUT_DIRECTORY)
    set(folder ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/gestalt/plugins)
  endif()

  add_library(${target}_algorithm STATIC ${ARG_SOURCES})
  target_include_directories(${target}_algorithm PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  set_target_properties(
    ${target}_algorithm PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
                                   CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON)
  target_link_libraries(${target}_algorithm PUBLIC gestalt::core ${ARG_LIBRARIES})

  add_library(${target} MODULE plugin.cpp)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON)
  target_link_libraries(${target} PRIVATE ${target}_algorithm)
  target_link_options(${target} PRIVATE LINKER:-z,now)
  if(NOT GESTALT_SANITIZE) # whose functions are in the program
    target_link_options(${target} PRIVATE LINKER:-z,defs)
  endif()
  set_target_properties(${target} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${folder} INSTALL_RPATH "$ORIGIN/../..")
  set_property(GLOBAL APPEND PROPERTY GESTALT_PLUGINS ${target})
  install(TARGETS ${target} DESTINATION ${CMAKE_INSTALL_LIBDIR}/gestalt/plugins COMPONENT runtime)

  if(NOT ARG_TEST OR NOT BUILD_TESTING)
    return()
  endif()
  if(NOT TARGET GTest::gtest_main)
    find_package(GTest REQUIRED)
  endif()
  add_executable(${target}_test ${ARG_TEST})
  set_target_properties(${target}_test PROPERTIES CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON)
  target_link_libraries(${target}_test PRIVATE ${target}_algorithm gestalt::test_scenes GTest::gtest_main)
  add_test(NAME ${target} COMMAND ${target}_test)
  if(TARGET gestalt::plugin_conformance)
    add_test(NAME ${target}_conformance COMMAND gestalt::plugin_conformance --plugins ${folder}
                                                --gtest_filter=*/${target})
  endif()
endfunction()
