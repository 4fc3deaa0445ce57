// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "committee.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "gestalt/core/base/error.h"
#include "random_forest.h"
#include "svm.h"

namespace gestalt {
namespace {

/// Points in [-1, 1]^2, positive right of a noisy border.
Samples halves(int count, unsigned seed = 3) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return 2.0 * double(random()) / double(std::mt19937::max()) - 1; };
  Samples samples{2, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double x = coordinate();
    samples.values.insert(samples.values.end(), {x, coordinate()});
    samples.positive.push_back(x + 0.3 * coordinate() > 0);
  }
  return samples;
}

TEST(Committee, GivesTheWeightedMeanOfItsMembers) {
  const Samples samples = halves(200), unseen = halves(50, 4);
  const auto svm = Svm({.cost = 3, .gamma = 0.7, .class_weights = true, .seed = 5}).train(samples);
  const auto forest = RandomForest({.trees = 20, .depth = 4, .minimum_samples = 8, .seed = 5}).train(samples);
  for (const double share : {0.0, 0.25, 1.0}) {
    const Committee committee({.svm_share = share,
                               .cost = 3,
                               .gamma = 0.7,
                               .class_weights = true,
                               .trees = 20,
                               .depth = 4,
                               .minimum_samples = 8,
                               .seed = 5});
    const auto mean = committee.train(samples);
    for (std::size_t i = 0; i < unseen.rows(); ++i)
      EXPECT_DOUBLE_EQ(mean->probability(unseen.row(i)),
                       share * svm->probability(unseen.row(i)) + (1 - share) * forest->probability(unseen.row(i)));
  }
}

TEST(Committee, ARestoredOneIsTheTrainedOneToTheLastBit) {
  const Samples samples = halves(100);
  const auto trained = Committee({.trees = 10}).train(samples);
  const auto restored = Committee({}).restore(nlohmann::json::parse(trained->state().dump()), 2);
  for (std::size_t i = 0; i < samples.rows(); ++i)
    EXPECT_EQ(trained->probability(samples.row(i)), restored->probability(samples.row(i)));
}

TEST(Committee, RefusesSamplesOfOneClass) {
  Samples samples = halves(20);
  std::fill(samples.positive.begin(), samples.positive.end(), std::uint8_t{1});
  EXPECT_THROW(Committee({}).train(samples), ModelError);
}

TEST(Committee, RefusesAStateThatIsNotComplete) {
  const auto state = Committee({.trees = 10}).train(halves(100))->state();
  const Committee committee({});
  EXPECT_NO_THROW(committee.restore(state, 2));
  EXPECT_THROW(committee.restore(state, 1), ModelError);
  EXPECT_THROW(committee.restore(nullptr, 2), ModelError);
  for (const char* key : {"svm_share", "svm", "random_forest"}) {
    auto broken = state;
    broken.erase(key);
    EXPECT_THROW(committee.restore(broken, 2), ModelError) << key;
    broken[key] = "x";
    EXPECT_THROW(committee.restore(broken, 2), ModelError) << key;
  }
  for (const double share : {-0.1, 1.1}) {
    auto broken = state;
    broken["svm_share"] = share;
    EXPECT_THROW(committee.restore(broken, 2), ModelError) << share;
  }
}

}  // namespace
}  // namespace gestalt
