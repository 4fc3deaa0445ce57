// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "forest.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/model_fields.h"

namespace gestalt {

using nlohmann::json;

namespace {

// A pair's walk takes a step for each level of each tree: these bound it, whatever the size of the file. Training grows
// no tree that is deeper and no more trees (RandomForest::parameters()).
constexpr std::size_t most_trees = 2000;
constexpr int deepest_tree = 25;

/// Where the tree ends whose root is at a place: the nodes from there to it must be that tree, each reached once.
int end_of_tree(const std::vector<TreeNode>& nodes, int root) {
  struct Subtree {
    int root, depth;
  };
  std::vector<Subtree> to_come;  // right of the path to the node
  Subtree at{root, 0};
  while (true) {
    const std::string place = "node " + std::to_string(at.root) + " of the tree at " + std::to_string(root);
    if (std::size_t(at.root) >= nodes.size())
      throw ModelError("'roots': the tree at " + std::to_string(root) + " has no end");
    if (at.depth > deepest_tree)
      throw ModelError("'rights': " + place + " is deeper than " + std::to_string(deepest_tree) + " levels");
    const TreeNode& node = nodes[std::size_t(at.root)];
    if (node.variable >= 0) {
      to_come.push_back({node.right, at.depth + 1});
      at = {at.root + 1, at.depth + 1};
      continue;
    }
    if (to_come.empty()) return at.root + 1;
    const int end = at.root + 1;
    at = to_come.back();
    to_come.pop_back();
    if (at.root != end)
      throw ModelError("'rights': in the tree at " + std::to_string(root) + ", the right child " +
                       std::to_string(at.root) + " must come right after its left brother's last node, at " +
                       std::to_string(end));
  }
}

/// Trees lie one after the other, from the first node to the last one.
void check_trees(const std::vector<int>& roots, const std::vector<TreeNode>& nodes) {
  if (roots.empty()) throw ModelError("'roots' must name at least one tree");
  if (roots.size() > most_trees)
    throw ModelError("'roots' must name at most " + std::to_string(most_trees) + " trees, they are " +
                     std::to_string(roots.size()));
  int end = 0;
  for (const int root : roots) {
    if (root != end)
      throw ModelError("'roots': the tree at " + std::to_string(root) + " must begin where the one before ends, at " +
                       std::to_string(end));
    end = end_of_tree(nodes, root);
  }
  if (std::size_t(end) != nodes.size())
    throw ModelError("'roots': the nodes from " + std::to_string(end) + " on belong to no tree");
}

}  // namespace

double Forest::probability(std::span<const double> values) const {
  // Trees are grown on single precision, so a value is compared in it too.
  std::vector<double> compared(std::max<std::size_t>(values.size(), 1));
  std::transform(values.begin(), values.end(), compared.begin(), [](double value) { return double(float(value)); });
  // A step waits for the node that the one before led to: some trees at once wait together.
  constexpr std::size_t together = 6;
  double sum = 0;
  for (std::size_t first = 0; first < roots_.size(); first += together) {
    const std::size_t count = std::min(together, roots_.size() - first);
    std::array<int, together> at{};
    std::copy_n(roots_.begin() + std::ptrdiff_t(first), count, at.begin());
    for (bool all_leaves = false; !all_leaves;) {
      all_leaves = true;
      for (std::size_t i = 0; i < count; ++i) {
        const TreeNode& node = nodes_[std::size_t(at[i])];
        const bool inner = node.variable >= 0;
        const bool left = compared[std::size_t(inner ? node.variable : 0)] <= node.value;
        at[i] = inner ? (left ? at[i] + 1 : node.right) : at[i];
        all_leaves &= !inner;
      }
    }
    for (std::size_t i = 0; i < count; ++i) sum += nodes_[std::size_t(at[i])].value;
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
  if (variables.size() != values.size() || rights.size() != values.size())
    throw ModelError("'variables', 'rights' and 'values' must have one entry for each node");

  std::vector<TreeNode> nodes;
  for (int i = 0; i <= last; ++i) {
    const TreeNode node{variables[std::size_t(i)], rights[std::size_t(i)], values[std::size_t(i)]};
    if (node.variable < 0 && !(node.value >= 0 && node.value <= 1))
      throw ModelError("'values': node " + std::to_string(i) + " is a leaf, its value must lie in [0, 1]");
    nodes.push_back(node);
  }
  check_trees(roots, nodes);
  return std::make_unique<Forest>(std::move(roots), std::move(nodes));
}

}  // namespace gestalt
