// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "svm.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "gestalt/core/base/error.h"

namespace gestalt {
namespace {

/// Points in [-1, 1]^2, positive inside the circle around 0 that has half the square's area: no line separates them.
Samples disc(int count, unsigned seed = 3) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return 2.0 * double(random()) / double(std::mt19937::max()) - 1; };
  Samples samples{2, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate();
    samples.values.insert(samples.values.end(), {x, y});
    samples.positive.push_back(x * x + y * y < 2 / M_PI);
  }
  return samples;
}

std::vector<double> probabilities(const Predictor& predictor, const Samples& samples) {
  std::vector<double> p;
  for (std::size_t i = 0; i < samples.rows(); ++i) p.push_back(predictor.probability(samples.row(i)));
  return p;
}

TEST(Svm, LearnsWhatNoLineSeparates) {
  const auto predictor = Svm({}).train(disc(400));
  const Samples unseen = disc(400, 4);
  int right = 0;
  for (std::size_t i = 0; i < unseen.rows(); ++i)
    right += (predictor->probability(unseen.row(i)) > 0.5) == bool(unseen.positive[i]);
  EXPECT_GT(right, 370);
  EXPECT_GT(predictor->probability(std::vector{0.0, 0.0}), 0.9);
  EXPECT_LT(predictor->probability(std::vector{1.0, 1.0}), 0.1);
}

TEST(Svm, GivesTheSameWhicheverClassComesFirst) {
  Samples samples = disc(200);
  std::size_t negative = 0;
  while (samples.positive[negative]) ++negative;
  const auto move_to_front = [&](std::size_t i) {
    std::swap(samples.positive[0], samples.positive[i]);
    for (std::size_t c = 0; c < 2; ++c) std::swap(samples.values[c], samples.values[2 * i + c]);
  };
  move_to_front(negative);
  EXPECT_GT(Svm({}).train(samples)->probability(std::vector{0.0, 0.0}), 0.9);
  std::size_t positive = 0;
  while (!samples.positive[positive]) ++positive;
  move_to_front(positive);
  EXPECT_GT(Svm({}).train(samples)->probability(std::vector{0.0, 0.0}), 0.9);
}

TEST(Svm, ARestoredMachineIsTheTrainedOneToTheLastBit) {
  const Samples samples = disc(300);
  const auto trained = Svm({}).train(samples);
  const auto restored = Svm({}).restore(nlohmann::json::parse(trained->state().dump()), 2);
  EXPECT_EQ(probabilities(*trained, samples), probabilities(*restored, samples));
}

TEST(Svm, TrainsTheSameWhileOtherThreadsTrain) {
  const Samples samples = disc(200);
  const auto first = Svm({}).train(samples)->state();
  std::vector<nlohmann::json> states(4);
  std::vector<std::thread> threads;
  threads.reserve(states.size());
  for (auto& state : states) threads.emplace_back([&] { state = Svm({}).train(samples)->state(); });
  for (auto& thread : threads) thread.join();
  for (const auto& state : states) EXPECT_EQ(state, first);
}

// What other plugins with libsvm in them do, and a host that draws.
TEST(Svm, SharesNoRandomNumbersWithTheProcess) {
  using Rand = int (*)();
  const auto program_rand = reinterpret_cast<Rand>(dlsym(RTLD_DEFAULT, "rand"));
  ASSERT_TRUE(program_rand);
  std::srand(5);
  const int drawn = program_rand();
  const Samples samples = disc(200);
  const auto first = Svm({}).train(samples)->state();

  std::atomic<bool> done{false};
  std::thread other([&] {
    while (!done) std::srand(7), program_rand();
  });
  for (int i = 0; i < 20; ++i) EXPECT_EQ(Svm({}).train(samples)->state(), first);
  done = true;
  other.join();

  std::srand(5);
  Svm({.seed = 9}).train(samples);
  EXPECT_EQ(program_rand(), drawn);
}

TEST(Svm, TheSeedMovesTheSigmoidOnly) {
  const Samples samples = disc(200);
  const auto a = Svm({.seed = 1}).train(samples)->state(), b = Svm({.seed = 2}).train(samples)->state();
  EXPECT_EQ(a["coefficients"], b["coefficients"]);
  EXPECT_NE(a["prob_a"], b["prob_a"]);
}

TEST(Svm, GammaZeroIsOneOverTheNumberOfValues) {
  const auto state = Svm({}).train(disc(50))->state();
  EXPECT_EQ(state["gamma"], 0.5);
}

// Forty negatives and four positives in one place: the kernel sum is the same for all, so the balance decides.
TEST(Svm, ClassWeightsLiftTheRareClass) {
  Samples samples{1, std::vector<double>(44, 0.0), std::vector<std::uint8_t>(44, 0)};
  for (std::size_t i = 0; i < 44; ++i) samples.values[i] = 0.001 * double(i);
  for (const std::size_t i : {5u, 15u, 25u, 35u}) samples.positive[i] = 1;
  const auto bound = [&](bool weights) {
    const auto state = Svm({.class_weights = weights}).train(samples)->state();
    double largest = 0;
    for (const double c : state["coefficients"]) largest = std::max(largest, std::abs(c));
    return largest;
  };
  EXPECT_NEAR(bound(false), 1, 1e-6);              // C
  EXPECT_NEAR(bound(true), 44.0 / (2 * 4), 1e-6);  // C n / (2 n_positive)
}

TEST(Svm, RefusesSamplesOfOneClassAndNone) {
  Samples samples = disc(20);
  std::fill(samples.positive.begin(), samples.positive.end(), 1);
  EXPECT_THROW(Svm({}).train(samples), ModelError);
  EXPECT_THROW(Svm({}).train({2, {}, {}}), ModelError);
}

TEST(Svm, RefusesAStateThatIsNotConsistent) {
  const auto state = Svm({}).train(disc(60))->state();
  const auto refused = [&](const char* key, const nlohmann::json& value) {
    auto wrong = state;
    wrong[key] = value;
    EXPECT_THROW(Svm({}).restore(wrong, 2), ModelError) << key << " = " << value;
  };
  EXPECT_NO_THROW(Svm({}).restore(state, 2));
  EXPECT_THROW(Svm({}).restore(state, 3), ModelError);
  refused("gamma", -1);
  refused("labels", {1, 1});
  refused("labels", {1});
  refused("labels", {1, 2});
  refused("counts", {-1, 1});
  refused("counts", {2147483647, 2147483647});
  refused("coefficients", nlohmann::json::array());
  refused("coefficients", {1, 2, 3});
  refused("support_vectors", {0.5});
  refused("rho", nullptr);
}

}  // namespace
}  // namespace gestalt
