# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause

# What the public headers need; find_package(Gestalt) finds it too.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.10 REQUIRED)

# gestalt_library(<target> <header> [<file of the library>])
#
# PCL's and OpenCV's own config files pull in every component, VTK included; only what is used is looked for here. Folders
# of headers may carry a version, as pcl-1.13: the newest is taken.
function(gestalt_library target header)
  if(TARGET gestalt::${target})
    return()
  endif()
  set(versioned)
  foreach(prefix ${CMAKE_PREFIX_PATH} ${CMAKE_SYSTEM_PREFIX_PATH})
    file(GLOB found RELATIVE ${prefix}/include ${prefix}/include/pcl-* ${prefix}/include/vtk-*)
    list(APPEND versioned ${found})
  endforeach()
  list(SORT versioned COMPARE NATURAL ORDER DESCENDING)
  find_path(${target}_INCLUDE ${header} PATH_SUFFIXES opencv4 libsvm ${versioned} REQUIRED)
  find_library(${target}_FILE NAMES ${ARGN} ${target} REQUIRED)
  add_library(gestalt::${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(gestalt::${target} SYSTEM INTERFACE ${${target}_INCLUDE})
  target_link_libraries(gestalt::${target} INTERFACE ${${target}_FILE})
endfunction()

foreach(module core imgproc)
  gestalt_library(opencv_${module} opencv2/${module}.hpp)
endforeach()
