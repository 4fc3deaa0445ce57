// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/version.hpp>

#define GESTALT_TEXT_(x) #x
#define GESTALT_TEXT(x) GESTALT_TEXT_(x)

#ifdef _GLIBCXX_DEBUG
#define GESTALT_LIBRARY_MODE_ "debug"
#else
#define GESTALT_LIBRARY_MODE_ "plain"
#endif

/// Everything that changes the layout of the types that cross the plugin boundary, as compiled into the including
/// file: core and plugin must have the same text.
#define GESTALT_BUILD_FINGERPRINT \
  "abi=" GESTALT_TEXT(__GXX_ABI_VERSION) " cxx11=" GESTALT_TEXT(_GLIBCXX_USE_CXX11_ABI)                             \
  " libstdc++=" GESTALT_LIBRARY_MODE_ " eigen=" GESTALT_TEXT(EIGEN_WORLD_VERSION) "." GESTALT_TEXT(                 \
      EIGEN_MAJOR_VERSION) "." GESTALT_TEXT(EIGEN_MINOR_VERSION) " eigen_align=" GESTALT_TEXT(EIGEN_MAX_ALIGN_BYTES) \
  " opencv=" CV_VERSION
