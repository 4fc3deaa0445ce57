// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/assignment.h"

#include <algorithm>
#include <limits>

namespace gestalt {

namespace {

constexpr int none = -1;

/// Assigns the rows of a cost matrix with at least as many columns as rows, one row at a time: each finds the cheapest
/// path of reassignments that ends at a free column (Dijkstra over costs reduced by the prices of rows and columns).
class AugmentingPaths {
 public:
  explicit AugmentingPaths(const Eigen::MatrixXd& costs)
      : costs_(costs),
        row_price_(Eigen::VectorXd::Zero(costs.rows())),
        column_price_(Eigen::VectorXd::Zero(costs.cols())),
        column_of_row_(std::size_t(costs.rows()), none),
        row_of_column_(std::size_t(costs.cols()), none) {}

  const std::vector<int>& assign() {
    for (int row = 0; row < int(costs_.rows()); ++row) reassign(row, find_path(row));
    return column_of_row_;
  }

 private:
  /// The tree of shortest paths from one row.
  struct Reached {
    std::vector<int> columns;     // whose distance is final, in the order they were reached
    Eigen::VectorXd distance;     // from the row to each column
    std::vector<int> row_before;  // of each column on its path
  };

  /// Distances grow until a free column is reached, which is the last of Reached::columns. Prices are updated.
  Reached find_path(int start) {
    const int n = int(costs_.cols());
    Reached reached{{},
                    Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity()),
                    std::vector<int>(std::size_t(n), none)};
    // The order in which columns are looked at decides between equal distances: from the last to the first, a column
    // that is taken out being replaced by the last of the list, as scipy has it.
    std::vector<int> open(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) open[std::size_t(i)] = n - 1 - i;

    double nearest = 0;
    for (int row = start; row != none;) {
      auto next = open.end();
      double shortest = std::numeric_limits<double>::infinity();
      for (auto column = open.begin(); column != open.end(); ++column) {
        double& distance = reached.distance[*column];
        const double through_row = nearest + costs_(row, *column) - row_price_[row] - column_price_[*column];
        if (through_row < distance) {
          distance = through_row;
          reached.row_before[std::size_t(*column)] = row;
        }
        const bool free = row_of_column_[std::size_t(*column)] == none;
        if (distance < shortest || (distance == shortest && free)) {
          shortest = distance;
          next = column;
        }
      }
      nearest = shortest;
      reached.columns.push_back(*next);
      row = row_of_column_[std::size_t(*next)];
      *next = open.back();
      open.pop_back();
    }
    update_prices(start, nearest, reached);
    return reached;
  }

  /// Keeps every reduced cost non-negative, and zero on assigned pairs.
  void update_prices(int start, double path_length, const Reached& reached) {
    row_price_[start] += path_length;
    for (const int column : reached.columns) {
      const double slack = path_length - reached.distance[column];
      const int row = row_of_column_[std::size_t(column)];
      if (row != none) row_price_[row] += slack;
      column_price_[column] -= slack;
    }
  }

  /// Moves every row on the path to the free column one step along it.
  void reassign(int start, const Reached& reached) {
    int column = reached.columns.back();
    for (int row = none; row != start;) {
      row = reached.row_before[std::size_t(column)];
      row_of_column_[std::size_t(column)] = row;
      std::swap(column, column_of_row_[std::size_t(row)]);
    }
  }

  const Eigen::MatrixXd& costs_;
  Eigen::VectorXd row_price_, column_price_;
  std::vector<int> column_of_row_, row_of_column_;
};

}  // namespace

std::vector<Assigned> largest_assignment(const Eigen::MatrixXd& weights) {
  const bool transposed = weights.cols() < weights.rows();
  const Eigen::MatrixXd costs = transposed ? Eigen::MatrixXd(-weights.transpose()) : Eigen::MatrixXd(-weights);
  const std::vector<int> columns = AugmentingPaths(costs).assign();
  std::vector<Assigned> pairs;
  for (int i = 0; i < int(columns.size()); ++i) {
    const int j = columns[std::size_t(i)];
    pairs.push_back(transposed ? Assigned{j, i} : Assigned{i, j});
  }
  std::sort(pairs.begin(), pairs.end(), [](const Assigned& a, const Assigned& b) { return a.row < b.row; });
  return pairs;
}

}  // namespace gestalt
