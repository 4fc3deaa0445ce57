// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "drawing.h"
#include "gestalt/io/result/result.h"

namespace gestalt {

namespace {

constexpr int enlarge_lines = 2;

cv::Point at(const Eigen::Vector2f& p) {
  return {int(std::lround((p.x() + 0.5f) * enlarge_lines)), int(std::lround((p.y() + 0.5f) * enlarge_lines))};
}

cv::Scalar line_colour(const BoundaryLine& line) {
  if (!line.own()) return {120, 120, 120};
  return line.beyond == Beyond::level ? cv::Scalar(255, 200, 60) : cv::Scalar(60, 230, 60);
}

/// Where much is found by chance, a picture of all of it shows nothing.
std::vector<LineLink> surest_between_surfaces(std::vector<LineLink> links, const std::vector<BoundaryLine>& lines) {
  constexpr std::size_t shown = 80;
  std::erase_if(links, [&](const LineLink& link) {
    return lines[std::size_t(link.from)].surface == lines[std::size_t(link.to)].surface;
  });
  std::stable_sort(links.begin(), links.end(), [](const LineLink& x, const LineLink& y) { return x.cost < y.cost; });
  links.resize(std::min(links.size(), shown));
  return links;
}

/// Closures lie over each other: the cheapest are drawn last, and only as many as can be told apart.
void draw_closures(cv::Mat& picture, const std::vector<Closure>& closures) {
  constexpr std::size_t shown = 12;
  for (std::size_t i = std::min(shown, closures.size()); i-- > 0;) {
    std::vector<cv::Point> outline;
    for (const Eigen::Vector2f& p : closures[i].outline) outline.push_back(at(p));
    cv::Mat area(picture.size(), CV_8U, cv::Scalar(0));
    cv::fillPoly(area, std::vector{outline}, 255);
    cv::Mat tinted(picture.size(), CV_8UC3, cv::Scalar(segment_colour(int(i) + 1)));
    cv::addWeighted(picture, 0.8, tinted, 0.2, 0, tinted);
    tinted.copyTo(picture, area);
    cv::polylines(picture, outline, true, segment_colour(int(i) + 1), 1, cv::LINE_AA);
  }
}

}  // namespace

cv::Mat draw_boundary_lines(const Scene& scene) {
  cv::Mat picture;
  cv::resize(backdrop(scene.frame()), picture, {}, enlarge_lines, enlarge_lines, cv::INTER_NEAREST);
  picture *= 0.45;
  const BoundaryLines& all = scene.boundary_lines();
  draw_closures(picture, scene.closures());
  for (const BoundaryLine& line : all.lines)
    cv::line(picture, at(line.ends[0]), at(line.ends[1]), line_colour(line), 1, cv::LINE_AA);

  for (const LineLink& link : surest_between_surfaces(all.collinearities, all.lines))
    cv::line(picture, at(all.lines[std::size_t(link.from)].ends[1]), at(all.lines[std::size_t(link.to)].ends[0]),
             {220, 60, 220}, 1, cv::LINE_AA);
  for (const LineLink& link : surest_between_surfaces(all.junctions, all.lines))
    cv::circle(picture, at(link.meeting), 2, {60, 160, 255}, cv::FILLED, cv::LINE_AA);
  for (const TJunction& t : all.t_junctions)
    cv::drawMarker(picture, at(t.at), {60, 60, 255}, cv::MARKER_TILTED_CROSS, 9, 1, cv::LINE_AA);
  return picture;
}

}  // namespace gestalt
