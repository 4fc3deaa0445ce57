# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause

# For the builds under sanitizers, of which CI makes two from nothing: the headers of others that most sources read are read
# once for all of them, and once more with GoogleTest for the tests. Not for releases: a precompiled header of g++ is 220 MB, and loading it
# costs a source as much as it saves on average; g++ 12 also warns of the standard library's own code where it is precompiled.
set(headers <Eigen/Geometry> <algorithm> <cmath> <filesystem> <functional> <map> <memory> <nlohmann/json.hpp> <opencv2/core.hpp>
            <optional> <set> <string> <tbb/parallel_for.h> <vector>)
add_library(gestalt_precompiled OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompile.cpp)
target_link_libraries(gestalt_precompiled PRIVATE Eigen3::Eigen gestalt::opencv_core nlohmann_json::nlohmann_json TBB::tbb)
target_precompile_headers(gestalt_precompiled PRIVATE ${headers})
if(BUILD_TESTING)
  add_library(gestalt_precompiled_test OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompile.cpp)
  target_link_libraries(gestalt_precompiled_test PRIVATE Eigen3::Eigen gestalt::opencv_core nlohmann_json::nlohmann_json TBB::tbb
                                                         GTest::gtest)
  target_precompile_headers(gestalt_precompiled_test PRIVATE ${headers} <gtest/gtest.h>)
endif()

# gestalt_precompile(<folder>): all targets of a folder and of those below it, but for what has no source in C++.
function(gestalt_precompile folder)
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below ${folders})
    gestalt_precompile(${below})
  endforeach()
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    get_target_property(sources ${target} SOURCES)
    if(NOT type MATCHES "EXECUTABLE|_LIBRARY" OR type STREQUAL INTERFACE_LIBRARY OR NOT sources MATCHES "\\.cpp" OR target MATCHES
                                                                                                          "^gestalt_precompiled")
      continue()
    endif()
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(libraries MATCHES "GTest::")
      target_precompile_headers(${target} REUSE_FROM gestalt_precompiled_test)
      set_target_properties(${target} PROPERTIES UNITY_BUILD OFF) # their files may use the same names
    else()
      target_precompile_headers(${target} REUSE_FROM gestalt_precompiled)
    endif()
    if(type STREQUAL EXECUTABLE) # as the precompiled headers are
      target_compile_options(${target} PRIVATE -fPIC)
    endif()
  endforeach()
endfunction()
