// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "drawing.h"
#include "gestalt/io/result/result.h"

namespace gestalt {

namespace {

constexpr int enlarge_graph = 2;

/// The pixel of a surface that is nearest to the mean of all, so that the node of an L lies on it.
cv::Point node(const Surface& surface, int width) {
  const auto place = [width](int pixel) { return cv::Point2d(pixel % width, pixel / width); };
  cv::Point2d mean;
  for (const int pixel : surface.pixels) mean += place(pixel);
  mean /= double(surface.pixels.size());
  const auto distance = [&](int pixel) {
    const cv::Point2d offset = place(pixel) - mean;
    return offset.dot(offset);
  };
  const int nearest = *std::min_element(surface.pixels.begin(), surface.pixels.end(),
                                        [&](int x, int y) { return distance(x) < distance(y); });
  return {enlarge_graph * (nearest % width) + enlarge_graph / 2, enlarge_graph * (nearest / width) + enlarge_graph / 2};
}

cv::Scalar probability_colour(double p) { return {0, 255 * std::min(1.0, 2 * p), 255 * std::min(1.0, 2 * (1 - p))}; }

std::vector<Edge> drawn_edges(const Graph& graph) {
  std::vector<Edge> edges = graph.edges;
  std::erase_if(edges, [](const Edge& e) { return e.level == Level::assembly && e.probability < 0.5; });
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& x, const Edge& y) { return x.probability < y.probability; });
  return edges;
}

}  // namespace

cv::Mat draw_graph(const Frame& frame, const SurfaceSet& surfaces, const Graph& graph) {
  cv::Mat picture;
  cv::resize(backdrop(frame), picture, {}, enlarge_graph, enlarge_graph, cv::INTER_NEAREST);
  picture *= 0.45;
  std::vector<cv::Point> nodes;
  for (const Surface& surface : surfaces.surfaces) nodes.push_back(node(surface, frame.width()));
  for (const Edge& edge : drawn_edges(graph))
    cv::line(picture, nodes[std::size_t(edge.a)], nodes[std::size_t(edge.b)], probability_colour(edge.probability),
             edge.level == Level::structural ? 4 : 2, cv::LINE_AA);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    cv::circle(picture, nodes[i], 6, {255, 255, 255}, cv::FILLED, cv::LINE_AA);
    cv::circle(picture, nodes[i], 4, segment_colour(int(i) + 1), cv::FILLED, cv::LINE_AA);
  }
  return picture;
}

}  // namespace gestalt
