// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "number_text.h"

namespace gestalt {

namespace {

/// An SVG document as it is written. Coordinates are pixels, y down.
class Drawing {
 public:
  Drawing(double width, std::string title) : width_(width), title_(std::move(title)) {
    write(12, 20, title_, "start", "title");
  }

  void line(double x1, double y1, double x2, double y2, const std::string& kind) {
    body_ += "<line class=\"" + kind + "\" x1=\"" + text(x1) + "\" y1=\"" + text(y1) + "\" x2=\"" + text(x2) +
             "\" y2=\"" + text(y2) + "\"/>\n";
  }
  void rectangle(double x, double y, double width, double height, const std::string& kind) {
    body_ += "<rect class=\"" + kind + "\" x=\"" + text(x) + "\" y=\"" + text(y) + "\" width=\"" + text(width) +
             "\" height=\"" + text(height) + "\"/>\n";
  }
  /// tip is shown under the mouse.
  void dot(double x, double y, const std::string& kind, const std::string& tip) {
    body_ += "<circle class=\"" + kind + "\" cx=\"" + text(x) + "\" cy=\"" + text(y) + "\" r=\"3.5\"><title>" +
             escape_xml(tip) + "</title></circle>\n";
  }
  /// anchor: start, middle or end.
  void write(double x, double y, const std::string& words, const std::string& anchor, const std::string& kind = "") {
    body_ += "<text" + (kind.empty() ? "" : " class=\"" + kind + "\"") + " x=\"" + text(x) + "\" y=\"" + text(y) +
             "\" text-anchor=\"" + anchor + "\">" + escape_xml(words) + "</text>\n";
  }
  void write_upwards(double x, double y, const std::string& words) {
    body_ += "<text transform=\"translate(" + text(x) + " " + text(y) + ") rotate(-90)\" text-anchor=\"middle\">" +
             escape_xml(words) + "</text>\n";
  }

  /// Of the given height, which is known when all is drawn.
  std::string document(double height) const {
    const std::string size = "width=\"" + text(width_) + "\" height=\"" + text(height) + "\"";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + text(width_) + " " + text(height) + "\" " +
           size + " role=\"img\">\n<title>" + escape_xml(title_) + "</title>\n" + style + "<rect class=\"paper\" " +
           size + "/>\n" + body_ + "</svg>\n";
  }

 private:
  static std::string text(double value) { return number_text(value, 1); }

  // Okabe and Ito's colours, which the colour-blind tell apart; blue, vermilion and green first.
  static constexpr const char* style = R"(<style>
svg{font:12px system-ui,"DejaVu Sans",sans-serif;color-scheme:light dark}
text{fill:#222;stroke:#fff;stroke-width:2.5px;paint-order:stroke}.title{font-size:14px;font-weight:bold}.small{font-size:10px}
.paper{fill:#fff}.grid{stroke:#ddd}.axis{stroke:#666;fill:none}
.c0{fill:#0072b2}.c1{fill:#d55e00}.c2{fill:#009e73}.c3{fill:#cc79a7}.c4{fill:#e69f00}.c5{fill:#56b4e9}
.l0{stroke:#0072b2}.l1{stroke:#d55e00}.l2{stroke:#009e73}.l0,.l1,.l2{stroke-dasharray:4 3}
circle{fill-opacity:.55}
@media (prefers-color-scheme:dark){text{fill:#eee;stroke:#1b1b1b}.paper{fill:#1b1b1b}.grid{stroke:#444}.axis{stroke:#aaa}
.c0{fill:#4da6dd}.l0{stroke:#4da6dd}.c1{fill:#ff8a3d}.l1{stroke:#ff8a3d}.c2{fill:#2ec79b}.l2{stroke:#2ec79b}}
</style>
)";
  double width_;
  std::string title_;
  std::string body_;
};

/// Pixels that a text takes at most, about: SVG cannot be asked.
double width_of(const std::string& words) {
  // Bytes that continue a UTF-8 character take no place of their own.
  return 7.2 * double(std::count_if(words.begin(), words.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string colour(std::size_t series) { return "c" + std::to_string(series % 6); }

constexpr double legend_line = 18;

/// Names of series, in as many lines as they need. Gives the row below the last line.
template <class Series>
double draw_legend(Drawing& drawing, const std::vector<Series>& all, double left, double right, double y) {
  double x = left;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const double width = 35 + width_of(all[s].name);
    if (x > left && x + width > right) x = left, y += legend_line;
    drawing.rectangle(x, y - 9, 10, 10, colour(s));
    drawing.write(x + 15, y, all[s].name, "start");
    x += width;
  }
  return y;
}

/// A range of values with round ends and steps.
struct Axis {
  double low;
  double high;
  double step;
};

/// Holds 0, as bars start there.
Axis axis_for(double smallest, double largest) {
  smallest = std::min(smallest, 0.0), largest = std::max(largest, 0.0);
  if (smallest == largest) largest = 1;
  const double rough = (largest - smallest) / 5, power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double digit : {5.0, 2.0, 1.0})
    if (digit * power >= rough) step = digit * power;
  return {std::floor(smallest / step) * step, std::ceil(largest / step) * step, step};
}

int decimals_of(double step) { return std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9); }

Axis value_axis(const BarChart& chart) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const BarSeries& series : chart.series)
    for (const double value : series.values)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  return low > high ? axis_for(0, 1) : axis_for(low, high);
}

/// One square of a scatter plot, showing [low, 1]^2.
struct Square {
  double x, y;  // of the upper left corner
  double side;
  double low;

  double column(double value) const { return x + side * (value - low) / (1 - low); }
  double row(double value) const { return y + side * (1 - (value - low) / (1 - low)); }
};

/// Grid, numbers and frame.
void draw_axes(Drawing& drawing, const Square& square) {
  constexpr int steps = 5;
  for (int i = 0; i <= steps; ++i) {
    const double value = square.low + (1 - square.low) * i / steps;
    const std::string label = number_text(value, square.low > 0 ? 3 : 1);
    drawing.line(square.column(value), square.y, square.column(value), square.y + square.side, "grid");
    drawing.line(square.x, square.row(value), square.x + square.side, square.row(value), "grid");
    drawing.write(square.column(value), square.y + square.side + 16, label, "middle", "small");
    drawing.write(square.x - 6, square.row(value) + 4, label, "end", "small");
  }
  drawing.rectangle(square.x, square.y, square.side, square.side, "axis");
}

void draw_square(Drawing& drawing, const ScatterPlot& plot, const Square& square) {
  draw_axes(drawing, square);
  drawing.write(square.x + square.side / 2, square.y + square.side + 34, plot.x_name, "middle");
  for (std::size_t s = 0; s < plot.series.size(); ++s)
    for (const auto& [x, y] : plot.series[s].points)
      if (x >= square.low && y >= square.low && x <= 1 && y <= 1)
        drawing.dot(square.column(x), square.row(y), colour(s),
                    plot.series[s].name + ": " + plot.x_name + " " + number_text(x, 3) + ", " + plot.y_name + " " +
                        number_text(y, 3));
}

}  // namespace

std::string svg(const BarChart& chart) {
  constexpr double bar = 11, gap = 9, plot_width = 460, margin = 12;
  double longest = 0;
  for (const std::string& label : chart.labels) longest = std::max(longest, width_of(label));
  const double left = margin + longest + 8, width = left + plot_width + 60;
  const double group = bar * double(chart.series.size()) + gap;
  const Axis axis = value_axis(chart);
  const auto column = [&](double value) { return left + plot_width * (value - axis.low) / (axis.high - axis.low); };

  Drawing drawing(width, chart.title);
  const double top = 12 + draw_legend(drawing, chart.series, margin, width, 40);
  const double bottom = top + group * double(chart.labels.size());
  const int steps = int(std::lround((axis.high - axis.low) / axis.step));
  for (int i = 0; i <= steps; ++i) {
    const double value = axis.low + i * axis.step;
    drawing.line(column(value), top, column(value), bottom, "grid");
    drawing.write(column(value), bottom + 16, number_text(value, decimals_of(axis.step)), "middle", "small");
  }
  if (chart.compare_with_first && !chart.labels.empty())
    for (std::size_t s = 0; s < chart.series.size(); ++s)
      if (const double value = chart.series[s].values.at(0); std::isfinite(value))
        drawing.line(column(value), top, column(value), bottom, "l" + std::to_string(s % 3));
  for (std::size_t i = 0; i < chart.labels.size(); ++i) {
    const double y = top + gap / 2 + group * double(i);
    drawing.write(left - 8, y + (group - gap) / 2 + 4, chart.labels[i], "end");
    for (std::size_t s = 0; s < chart.series.size(); ++s) {
      const double value = chart.series[s].values.at(i), row = y + bar * double(s);
      if (!std::isfinite(value)) continue;
      const double from = column(std::min(value, 0.0)), to = column(std::max(value, 0.0));
      drawing.rectangle(from, row, to - from, bar - 1, colour(s));
      drawing.write(to + 4, row + bar - 2, number_text(value, chart.decimals), "start", "small");
    }
  }
  drawing.line(column(0), top, column(0), bottom, "axis");
  return drawing.document(bottom + 28);
}

std::string svg(const ScatterPlot& plot) {
  constexpr double side = 300, left = 60, between = 70, width = left + 2 * side + between + 20;
  Drawing drawing(width, plot.title);
  const double top = 18 + draw_legend(drawing, plot.series, 12, width, 42);
  drawing.write_upwards(18, top + side / 2, plot.y_name);
  draw_square(drawing, plot, {left, top, side, 0});
  draw_square(drawing, plot, {left + side + between, top, side, plot.zoom});
  return drawing.document(top + side + 46);
}

std::string svg(const ReliabilityDiagram& diagram) {
  constexpr double side = 360, left = 60, width = left + side + 30, decade = 14;
  Drawing drawing(width, diagram.title);
  const double top = 18 + draw_legend(drawing, diagram.series, 12, width, 42);
  const Square square{left, top, side, 0};
  draw_axes(drawing, square);
  drawing.write(left + side / 2, top + side + 34, "predicted probability", "middle");
  drawing.write_upwards(18, top + side / 2, "share of positive pairs");
  drawing.line(left, top + side, left + side, top, "axis");

  std::int64_t most = 1;
  for (const ReliabilitySeries& series : diagram.series)
    for (const ReliabilityBin& bin : series.bins) most = std::max(most, bin.samples);
  const int decades = 1 + int(std::log10(double(most)));
  const double floor = top + side + 50 + decade * decades;
  for (int i = 0; i <= decades; ++i) {
    drawing.line(left, floor - decade * i, left + side, floor - decade * i, "grid");
    drawing.write(left - 6, floor - decade * i + 4, i == 0 ? "1" : "10^" + std::to_string(i), "end", "small");
  }
  drawing.write_upwards(18, floor - decade * decades / 2, "pairs");
  for (std::size_t s = 0; s < diagram.series.size(); ++s) {
    const ReliabilitySeries& series = diagram.series[s];
    const ReliabilityBin* last = nullptr;
    for (const ReliabilityBin& bin : series.bins) {
      if (bin.samples == 0) continue;
      const double x = square.column(bin.probability), y = square.row(bin.positive);
      if (last)
        drawing.line(square.column(last->probability), square.row(last->positive), x, y, "l" + std::to_string(s % 3));
      drawing.dot(x, y, colour(s),
                  series.name + ": " + number_text(bin.probability, 3) + " predicted, " + number_text(bin.positive, 3) +
                      " of " + std::to_string(bin.samples));
      const double height = std::max(1.0, decade * std::log10(double(bin.samples)));
      drawing.rectangle(x - 4 + 3 * double(s), floor - height, 3, height, colour(s));
      last = &bin;
    }
  }
  drawing.line(left, floor, left + side, floor, "axis");
  return drawing.document(floor + 14);
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (c == '\'')
      escaped += "&#39;";
    else if (byte < 0x20 && c != '\n' && c != '\t')
      escaped += "\xEF\xBF\xBD";
    else
      escaped += c;
  }
  return escaped;
}

}  // namespace gestalt
