// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/plugin/classifier.h"

namespace gestalt {

/// A node of a decision tree. The trees of a forest lie one after the other, each in preorder: the left child of node i
/// is i + 1.
struct TreeNode {
  int variable;  ///< column that decides, -1 for a leaf
  int right;     ///< index of the right child; 0 for a leaf
  double value;  ///< goes left when the column's value is at most this; of a leaf, the share of positive samples
};

/// A grown forest. Throws nothing and always ends, for any nodes that read_forest() accepts.
class Forest final : public Predictor {
 public:
  Forest(std::vector<int> roots, std::vector<TreeNode> nodes) : roots_(std::move(roots)), nodes_(std::move(nodes)) {}

  double probability(std::span<const double> values) const override;
  nlohmann::json state() const override;

 private:
  std::vector<int> roots_;
  std::vector<TreeNode> nodes_;
};

/// Throws ModelError unless the state is a complete forest for rows of that many columns: trees one after the other, of
/// which each node is reached once, no more and no deeper ones than training grows.
std::unique_ptr<Forest> read_forest(const nlohmann::json& state, std::size_t columns);

}  // namespace gestalt
