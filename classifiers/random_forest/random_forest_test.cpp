// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "random_forest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/ml.hpp>
#include <random>

#include "gestalt/core/base/error.h"

namespace gestalt {
namespace {

/// Points in [-1, 1]^3, positive where x y > 0; the third value is noise.
Samples quadrants(int count, unsigned seed = 3) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return 2.0 * double(random()) / double(std::mt19937::max()) - 1; };
  Samples samples{3, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate();
    samples.values.insert(samples.values.end(), {x, y, coordinate()});
    samples.positive.push_back(x * y > 0);
  }
  return samples;
}

TEST(RandomForest, LearnsWhatNoSingleValueTells) {
  const auto predictor = RandomForest({}).train(quadrants(600));
  const Samples unseen = quadrants(400, 4);
  int right = 0;
  for (std::size_t i = 0; i < unseen.rows(); ++i)
    right += (predictor->probability(unseen.row(i)) > 0.5) == bool(unseen.positive[i]);
  EXPECT_GT(right, 360);
}

// The walk over the stored trees is OpenCV's own prediction.
TEST(RandomForest, PredictsAsOpenCvDoes) {
  const Samples samples = quadrants(200);
  cv::Mat_<float> values(200, 3), classes(200, 1);
  std::copy(samples.values.begin(), samples.values.end(), values.begin());
  std::copy(samples.positive.begin(), samples.positive.end(), classes.begin());
  const auto reference = cv::ml::RTrees::create();
  reference->setMaxDepth(6);
  reference->setMinSampleCount(4);
  reference->setTermCriteria({cv::TermCriteria::MAX_ITER, 20, 0});
  cv::theRNG() = cv::RNG(7);
  reference->train(cv::ml::TrainData::create(values, cv::ml::ROW_SAMPLE, classes));

  const auto forest = RandomForest({.trees = 20, .depth = 6, .minimum_samples = 4, .seed = 7}).train(samples);
  const Samples unseen = quadrants(200, 9);
  cv::Mat_<float> row(1, 3);
  for (std::size_t i = 0; i < unseen.rows(); ++i) {
    std::copy(unseen.row(i).begin(), unseen.row(i).end(), row.begin());
    EXPECT_NEAR(forest->probability(unseen.row(i)), double(reference->predict(row)), 1e-6);
  }
}

// A value that tells nothing: a leaf's share is the share of positives, 3 in 4.
TEST(RandomForest, GivesTheShareOfPositivesWhereNothingTellsThemApart) {
  Samples samples{1, std::vector<double>(400, 0.5), {}};
  for (int i = 0; i < 400; ++i) samples.positive.push_back(i % 4 != 0);
  EXPECT_NEAR(RandomForest({}).train(samples)->probability(std::vector{0.5}), 0.75, 0.01);
}

TEST(RandomForest, ARestoredForestIsTheTrainedOneToTheLastBit) {
  const Samples samples = quadrants(200);
  const auto trained = RandomForest({}).train(samples);
  const auto restored = RandomForest({}).restore(nlohmann::json::parse(trained->state().dump()), 3);
  for (std::size_t i = 0; i < samples.rows(); ++i)
    EXPECT_EQ(trained->probability(samples.row(i)), restored->probability(samples.row(i)));
}

TEST(RandomForest, DependsOnTheSeedAndOnNoOtherDraw) {
  const Samples samples = quadrants(100);
  const RandomForest::Params params{.trees = 10, .seed = 1}, other{.trees = 10, .seed = 2};
  const auto first = RandomForest(params).train(samples)->state();
  const auto drawn = cv::theRNG().next();
  EXPECT_EQ(RandomForest(params).train(samples)->state(), first);
  EXPECT_NE(RandomForest(other).train(samples)->state(), first);
  cv::RNG undisturbed(0);
  undisturbed.state = drawn;
  cv::theRNG() = undisturbed;
  RandomForest(params).train(samples);
  EXPECT_EQ(cv::theRNG().state, undisturbed.state);
}

TEST(RandomForest, RefusesSamplesOfOneClassAndNone) {
  Samples samples = quadrants(20);
  std::fill(samples.positive.begin(), samples.positive.end(), 0);
  EXPECT_THROW(RandomForest({}).train(samples), ModelError);
  EXPECT_THROW(RandomForest({}).train({3, {}, {}}), ModelError);
}

TEST(RandomForest, RefusesAStateThatWouldNotEndOrLeadsOut) {
  const nlohmann::json good{
      {"roots", {0}}, {"variables", {0, -1, -1}}, {"rights", {2, 0, 0}}, {"values", {0.25, 0.0, 1.0}}};
  const auto forest = RandomForest({}).restore(good, 1);
  EXPECT_EQ(forest->probability(std::vector{0.25}), 0.0);
  EXPECT_EQ(forest->probability(std::vector{0.26}), 1.0);

  const auto refused = [&](const char* key, const nlohmann::json& value) {
    auto wrong = good;
    wrong[key] = value;
    EXPECT_THROW(RandomForest({}).restore(wrong, 1), ModelError) << key << " = " << value;
  };
  refused("roots", nlohmann::json::array());
  refused("roots", {3});
  refused("roots", {-1});
  refused("variables", {1, -1, -1});
  refused("variables", {0, -1});
  refused("variables", {0, -1, 0});
  refused("rights", {0, 0, 0});
  refused("rights", {1, 0, 0});
  refused("rights", {3, 0, 0});
  refused("values", {0.25, 0.0, 1.5});
  refused("values", {0.25, 0.0, nullptr});
}

/// The message for a forest of leaves of one half and nodes of variable 0.
std::string complaint(const std::vector<int>& roots, const std::vector<int>& variables,
                      const std::vector<int>& rights) {
  const nlohmann::json state{{"roots", roots},
                             {"variables", variables},
                             {"rights", rights},
                             {"values", std::vector<double>(variables.size(), 0.5)}};
  try {
    RandomForest({}).restore(state, 1);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "";
}

// A walk's steps are bounded by the number of trees and their depth; neither follows from the size of the file.
TEST(RandomForest, RefusesTreesThatShareNodesOrAreDeeperThanTrainingGrows) {
  const std::vector<int> two{0, -1, -1, 0, -1, -1}, rights{2, 0, 0, 5, 0, 0};
  EXPECT_EQ(complaint({0, 3}, two, rights), "");
  EXPECT_EQ(complaint({0, 0}, two, rights), "'roots': the tree at 0 must begin where the one before ends, at 3");
  EXPECT_EQ(complaint({3, 0}, two, rights), "'roots': the tree at 3 must begin where the one before ends, at 0");
  EXPECT_EQ(complaint({0}, two, rights), "'roots': the nodes from 3 on belong to no tree");
  EXPECT_EQ(complaint({0, 3}, two, {5, 0, 0, 5, 0, 0}),
            "'rights': in the tree at 0, the right child 5 must come right after its left brother's last node, at 2");
  EXPECT_EQ(complaint({0}, {0}, {0}), "'roots': the tree at 0 has no end");

  const auto chain = [](int splits, bool to_the_right) {
    std::vector<int> variables, children;
    for (int i = 0; i < splits; ++i) {
      variables.push_back(0);
      if (to_the_right) variables.push_back(-1);
      children.push_back(to_the_right ? 2 * i + 2 : 2 * splits - i);
      if (to_the_right) children.push_back(0);
    }
    variables.resize(std::size_t(2 * splits + 1), -1);
    children.resize(variables.size(), 0);
    return complaint({0}, variables, children);
  };
  for (const bool to_the_right : {false, true}) {
    EXPECT_EQ(chain(25, to_the_right), "");
    EXPECT_NE(chain(26, to_the_right).find("is deeper than 25 levels"), std::string::npos);
    EXPECT_NE(chain(100'000, to_the_right).find("is deeper than 25 levels"), std::string::npos);
  }

  std::vector<int> roots(2001);
  for (int i = 0; i <= 2000; ++i) roots[std::size_t(i)] = i;
  EXPECT_EQ(complaint(roots, std::vector<int>(2001, -1), std::vector<int>(2001, 0)),
            "'roots' must name at most 2000 trees, they are 2001");
}

}  // namespace
}  // namespace gestalt
