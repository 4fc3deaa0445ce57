// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "built_with.h"

#include <png.h>
#include <tbb/version.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/core/version.hpp>

#include "gestalt/core/plugin/manifest.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt::app {

namespace {

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

}  // namespace

std::string built_with() {
  return "gestalt " GESTALT_VERSION
         "\n"
         "compiler      " GESTALT_COMPILER
         "\n"
         "Eigen         " +
         dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION) +
         "\n"
         "OpenCV        " CV_VERSION
         "\n"
         "oneTBB        " +
         dotted(TBB_VERSION_MAJOR, TBB_VERSION_MINOR, TBB_VERSION_PATCH) +
         "\n"
         "Boost         " +
         dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100) +
         "\n"
         "yaml-cpp      " GESTALT_YAML_CPP
         "\n"
         "nlohmann-json " +
         dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH) +
         "\n"
         "libpng        " PNG_LIBPNG_VER_STRING
         "\n"
         "CLI11         " CLI11_VERSION
         "\n"
         "plugins       interface " +
         std::to_string(GESTALT_INTERFACE_VERSION) + ", " + build_fingerprint();
}

}  // namespace gestalt::app
