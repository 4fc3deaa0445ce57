# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause

# gestalt_room(OBJECT|STATIC [HEADERS <public header>...] [LIBRARIES <lib>...] [PRIVATE <lib>...] [TESTED_WITH <lib>...]
#              [THREADS])
#
# A room is a folder with headers, sources and tests side by side: core/scene is the target gestalt_core_scene, and its
# headers are included as gestalt/core/scene/<header>. Rooms of kind OBJECT are parts of a shared library
# (gestalt_shared_library). HEADERS are those that other libraries, plugins and users may include; they are installed.
# THREADS: the room has parallel loops, and its tests run under the thread sanitizer.
#
# Include folders hold links to headers alone, one folder for a room and one for what a shared library shows. So a target
# finds what it links and nothing else: a wrong include does not build.
function(gestalt_room kind)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "THREADS" "" "HEADERS;LIBRARIES;PRIVATE;TESTED_WITH")
  gestalt_room_name(room folder)
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  file(GLOB tests CONFIGURE_DEPENDS *_test.cpp)
  if(tests)
    list(REMOVE_ITEM sources ${tests})
  endif()
  add_library(${room} ${kind} ${sources})
  gestalt_show_headers(${room} ${folder})
  target_include_directories(${room} PUBLIC ${PROJECT_BINARY_DIR}/include/${room})
  target_link_libraries(${room} PUBLIC ${ARG_LIBRARIES} PRIVATE ${ARG_PRIVATE})

  if(ARG_HEADERS)
    string(REGEX REPLACE "/.*" "" library ${folder})
    set(shown ${PROJECT_BINARY_DIR}/include/gestalt_${library}/gestalt/${folder})
    file(REMOVE_RECURSE ${shown}) # with links to headers that are no more
    file(MAKE_DIRECTORY ${shown})
    foreach(header ${ARG_HEADERS})
      file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/${header} ${shown}/${header} SYMBOLIC)
    endforeach()
    install(FILES ${ARG_HEADERS} DESTINATION include/gestalt/${folder} COMPONENT dev)
  endif()

  if(tests AND BUILD_TESTING)
    add_executable(${room}_test ${tests})
    target_include_directories(${room}_test PRIVATE ${PROJECT_BINARY_DIR}/include/${room})
    if(kind STREQUAL STATIC)
      target_link_libraries(${room}_test PRIVATE ${room})
    endif()
    target_link_libraries(${room}_test PRIVATE ${ARG_TESTED_WITH} gestalt_test_environment gestalt::test_scenes GTest::gtest_main)
    add_test(NAME ${room} COMMAND ${room}_test)
    if(ARG_THREADS)
      gestalt_threaded_test(${room} ${room}_test)
    endif()
  endif()
endfunction()

# gestalt_shared_library(<library> ROOMS <room>... [LIBRARIES <lib>...])
#
# The shared library gestalt_<library>, gestalt::<library> for others, of the rooms <library>/<room>.
function(gestalt_shared_library library)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "ROOMS;LIBRARIES")
  set(target gestalt_${library})
  add_library(${target} SHARED)
  add_library(gestalt::${library} ALIAS ${target})
  foreach(room ${ARG_ROOMS})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_${room}>)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:${target}_${room}>)
  endforeach()
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include/${target}>
                                                 $<INSTALL_INTERFACE:include>)
  target_link_libraries(${target} PUBLIC ${ARG_LIBRARIES})
  set_target_properties(
    ${target} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${library} INSTALL_RPATH "$ORIGIN" VERSION ${PROJECT_VERSION}
                         SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_compile_features(${target} INTERFACE cxx_std_20)
  if(NOT GESTALT_SANITIZE) # whose functions are in the program
    target_link_options(${target} PRIVATE LINKER:-z,defs)
  endif()
  install(TARGETS ${target} EXPORT GestaltTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime
                                                          NAMELINK_COMPONENT dev)
endfunction()

# The target and the folder, from the root of the project, of the CMakeLists.txt that this is called in.
function(gestalt_room_name target folder)
  file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE / _ name ${path})
  set(${target} gestalt_${name} PARENT_SCOPE)
  set(${folder} ${path} PARENT_SCOPE)
endfunction()

# Makes <build>/include/<target>/gestalt/<folder> a link to this folder.
function(gestalt_show_headers target folder)
  get_filename_component(parent ${PROJECT_BINARY_DIR}/include/${target}/gestalt/${folder} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/include/${target}/gestalt/${folder} SYMBOLIC)
endfunction()

# gestalt_threaded_test(<test> <program>): the preset tsan builds and runs it.
function(gestalt_threaded_test test program)
  set_tests_properties(${test} PROPERTIES LABELS threads)
  set_property(GLOBAL APPEND PROPERTY GESTALT_THREADED_TESTS ${program})
endfunction()
