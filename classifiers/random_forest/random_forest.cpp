// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "random_forest.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <opencv2/ml.hpp>

#include "forest.h"
#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

/// OpenCV draws from a generator of the calling thread; gives it a seed for a while and then its old state back.
class SeededGenerator {
 public:
  explicit SeededGenerator(int seed) : before_(cv::theRNG()) { cv::theRNG() = cv::RNG(std::uint64_t(seed)); }
  ~SeededGenerator() { cv::theRNG() = before_; }
  SeededGenerator(const SeededGenerator&) = delete;
  SeededGenerator& operator=(const SeededGenerator&) = delete;

 private:
  cv::RNG before_;
};

/// Appends the subtree at an index of OpenCV's nodes in preorder.
void append_subtree(const cv::ml::DTrees& trees, int index, std::vector<TreeNode>& nodes) {
  const cv::ml::DTrees::Node& node = trees.getNodes()[std::size_t(index)];
  if (node.split < 0) {
    nodes.push_back({-1, 0, std::clamp(node.value, 0.0, 1.0)});  // a mean of zeros and ones, but for rounding
    return;
  }
  const cv::ml::DTrees::Split& split = trees.getSplits()[std::size_t(node.split)];
  const std::size_t self = nodes.size();
  nodes.push_back({split.varIdx, 0, double(split.c)});
  append_subtree(trees, node.left, nodes);
  nodes[self].right = int(nodes.size());
  append_subtree(trees, node.right, nodes);
}

}  // namespace

const Parameters<RandomForest::Params>& RandomForest::parameters() {
  static const auto p =
      Parameters<Params>()
          .integer("trees", &Params::trees, 1, 2000, "", "number of trees")
          .integer("depth", &Params::depth, 1, 25, "", "largest depth of a tree")
          .integer("minimum_samples", &Params::minimum_samples, 2, 10000, "pairs", "a smaller node is not split")
          .integer("variables", &Params::variables, 0, 1000, "",
                   "relation values tried at each split; 0: square root of their number")
          .integer("seed", &Params::seed, 0, std::numeric_limits<int>::max(), "",
                   "of the random choice of pairs and values");
  return p;
}

std::unique_ptr<Predictor> RandomForest::train(const Samples& samples) const {
  require_both_classes(samples);
  cv::Mat_<float> values(int(samples.rows()), int(samples.columns));
  std::copy(samples.values.begin(), samples.values.end(), values.begin());
  cv::Mat_<float> responses(int(samples.rows()), 1);  // floating point makes OpenCV regress
  std::copy(samples.positive.begin(), samples.positive.end(), responses.begin());

  const auto forest = cv::ml::RTrees::create();
  forest->setMaxDepth(params_.depth);
  forest->setMinSampleCount(params_.minimum_samples);
  forest->setActiveVarCount(std::min(params_.variables, int(samples.columns)));
  forest->setTermCriteria({cv::TermCriteria::MAX_ITER, params_.trees, 0});
  try {
    const SeededGenerator generator(params_.seed);
    forest->train(cv::ml::TrainData::create(values, cv::ml::ROW_SAMPLE, responses));
  } catch (const cv::Exception& error) {
    throw ModelError(std::string("OpenCV cannot grow the forest: ") + error.what());
  }

  std::vector<int> roots;
  std::vector<TreeNode> nodes;
  for (const int root : forest->getRoots()) {
    roots.push_back(int(nodes.size()));
    append_subtree(*forest, root, nodes);
  }
  return std::make_unique<Forest>(std::move(roots), std::move(nodes));
}

std::unique_ptr<Predictor> RandomForest::restore(const nlohmann::json& state, std::size_t columns) const {
  return read_forest(state, columns);
}

}  // namespace gestalt
