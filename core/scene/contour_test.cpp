// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gestalt {
namespace {

constexpr int width = 20, height = 15;

/// One surface of the pixels for which inside(u, v) holds.
template <class Inside>
SurfaceSet surface_where(const Inside& inside) {
  SurfaceSet set;
  set.labels = cv::Mat_<int>(height, width, 0);
  Surface& surface = set.surfaces.emplace_back();
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      if (inside(u, v)) {
        set.labels(v, u) = 1;
        surface.pixels.push_back(v * width + u);
      }
  return set;
}

std::set<int> pixels_of(const Contour& contour) { return {contour.pixels.begin(), contour.pixels.end()}; }

TEST(Contour, OfARectangleIsItsRim) {
  const auto contours = find_contours(surface_where([](int u, int v) { return u >= 3 && u <= 9 && v >= 2 && v <= 6; }));
  ASSERT_EQ(contours.at(0).size(), 1u);
  EXPECT_FALSE(contours[0][0].hole);
  EXPECT_EQ(contours[0][0].pixels.size(), 2u * 7 + 2u * 3);
  EXPECT_TRUE(pixels_of(contours[0][0]).contains(2 * width + 3));
  EXPECT_FALSE(pixels_of(contours[0][0]).contains(3 * width + 4));
}

TEST(Contour, GoesAroundHoles) {
  const auto contours = find_contours(surface_where(
      [](int u, int v) { return u >= 2 && u <= 12 && v >= 2 && v <= 12 && !(u >= 6 && u <= 8 && v >= 6 && v <= 8); }));
  ASSERT_EQ(contours.at(0).size(), 2u);
  const auto hole = std::find_if(contours[0].begin(), contours[0].end(), [](const Contour& c) { return c.hole; });
  ASSERT_NE(hole, contours[0].end());
  EXPECT_TRUE(pixels_of(*hole).contains(5 * width + 7)) << "the pixel above the hole, which is the surface's own";
}

TEST(Contour, OfSurfacesAtTheEdgeAndOfOnePixel) {
  EXPECT_EQ(find_contours(surface_where([](int, int) { return true; })).at(0).at(0).pixels.size(),
            2u * width + 2u * (height - 2));
  EXPECT_EQ(find_contours(surface_where([](int u, int v) { return u == 0 && v == height - 1; })).at(0).at(0).pixels,
            std::vector<int>{(height - 1) * width});
}

TEST(Contour, OfPiecesAreSeparate) {
  EXPECT_EQ(find_contours(surface_where([](int u, int v) { return v == 3 && u != 10; })).at(0).size(), 2u);
}

}  // namespace
}  // namespace gestalt
