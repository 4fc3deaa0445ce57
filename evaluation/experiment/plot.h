// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gestalt {

// Plots as SVG documents: text is text, colours follow the reader's light or dark scheme. Values that are not finite
// are left out. Results depend on nothing but the arguments.

/// Values of one kind, one for each bar of a group.
struct BarSeries {
  std::string name;
  std::vector<double> values;  ///< parallel to BarChart::labels
};

/// Horizontal bars: a group for each label, in it a bar for each series with its value beside it.
struct BarChart {
  std::string title;
  std::vector<std::string> labels;
  std::vector<BarSeries> series;  ///< at most three; more would not be told apart
  int decimals = 1;               ///< of the values
  /// The first label's values are drawn as a thin line across all groups.
  bool compare_with_first = false;
};

std::string svg(const BarChart& chart);

struct ScatterPoint {
  double x;  ///< in [0, 1]
  double y;
};

struct ScatterSeries {
  std::string name;
  std::vector<ScatterPoint> points;
};

/// Points in the unit square, and beside it the square [zoom, 1]^2 alone.
struct ScatterPlot {
  std::string title;
  std::string x_name;
  std::string y_name;
  std::vector<ScatterSeries> series;  ///< at most six
  double zoom = 0.9;                  ///< in [0, 1)
};

std::string svg(const ScatterPlot& plot);

/// The samples whose probabilities fall in one bin.
struct ReliabilityBin {
  double probability;    ///< mean, in [0, 1]
  double positive;       ///< share, in [0, 1]
  std::int64_t samples;  ///< a bin without any is left out
};

struct ReliabilitySeries {
  std::string name;
  std::vector<ReliabilityBin> bins;  ///< by ascending probability
};

/// Share of positive samples over predicted probability, which is the diagonal for a calibrated classifier; below it
/// the number of samples of each bin, on a logarithmic scale.
struct ReliabilityDiagram {
  std::string title;
  std::vector<ReliabilitySeries> series;  ///< at most three
};

std::string svg(const ReliabilityDiagram& diagram);

/// Text as it may stand in XML and HTML, in attributes too. What XML cannot hold at all (control characters) becomes
/// U+FFFD.
std::string escape_xml(std::string_view text);

}  // namespace gestalt
