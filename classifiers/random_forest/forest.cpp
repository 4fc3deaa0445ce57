// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "forest.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/model_fields.h"

namespace gestalt {

using nlohmann::json;

double Forest::probability(std::span<const double> values) const {
  double sum = 0;
  for (const int root : roots_) {
    const TreeNode* node = &nodes_[std::size_t(root)];
    while (node->variable >= 0) {
      // Trees are grown on single precision, so a value is compared in it too.
      const bool left = double(float(values[std::size_t(node->variable)])) <= node->value;
      node = left ? node + 1 : &nodes_[std::size_t(node->right)];
    }
    sum += node->value;
  }
  return sum / double(roots_.size());
}

json Forest::state() const {
  json variables = json::array(), rights = json::array(), values = json::array();
  for (const TreeNode& node : nodes_) {
    variables.push_back(node.variable);
    rights.push_back(node.right);
    values.push_back(node.value);
  }
  return {{"roots", roots_}, {"variables", variables}, {"rights", rights}, {"values", values}};
}

std::unique_ptr<Forest> read_forest(const json& state, std::size_t columns) {
  const std::vector<double> values = numbers_field(state, "values");
  if (values.empty() || values.size() > std::size_t(std::numeric_limits<int>::max()))
    throw ModelError("'values' must have one entry for each node");
  const int last = int(values.size()) - 1;
  const std::vector<int> variables = integers_field(state, "variables", -1, int(columns) - 1);
  const std::vector<int> rights = integers_field(state, "rights", 0, last);
  std::vector<int> roots = integers_field(state, "roots", 0, last);
  if (roots.empty()) throw ModelError("'roots' must name at least one tree");
  if (variables.size() != values.size() || rights.size() != values.size())
    throw ModelError("'variables', 'rights' and 'values' must have one entry for each node");

  std::vector<TreeNode> nodes;
  for (int i = 0; i <= last; ++i) {
    const TreeNode node{variables[std::size_t(i)], rights[std::size_t(i)], values[std::size_t(i)]};
    // Children lie behind their parent, so a walk always ends.
    if (node.variable >= 0 && node.right <= i + 1)
      throw ModelError("'rights': the right child of node " + std::to_string(i) + " must lie behind its left child");
    if (node.variable < 0 && !(node.value >= 0 && node.value <= 1))
      throw ModelError("'values': node " + std::to_string(i) + " is a leaf, its value must lie in [0, 1]");
    nodes.push_back(node);
  }
  return std::make_unique<Forest>(std::move(roots), std::move(nodes));
}

}  // namespace gestalt
