// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// p = 1 / 2 + weight * first value / 2: enough to see what reaches a classifier.
class FirstValue final : public Classifier {
 public:
  class Line final : public Predictor {
   public:
    explicit Line(double weight) : weight_(weight) {}
    double probability(std::span<const double> values) const override { return 0.5 + 0.5 * weight_ * values[0]; }
    json state() const override { return {{"weight", weight_}}; }

   private:
    double weight_;
  };

  std::unique_ptr<Predictor> train(const Samples& samples) const override {
    seen = samples;
    return std::make_unique<Line>(0.7);
  }
  std::unique_ptr<Predictor> restore(const json& state, std::size_t) const override {
    return std::make_unique<Line>(state.at("weight").get<double>());
  }

  mutable Samples seen;
};

const Samples samples{2, {10, 3, 20, 3, 30, 3}, {0, 1, 1}};
const std::vector<std::string> names{"r_co", "r_rs"};

class ModelFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::temp_directory_path() / ("gestalt_model_test" + std::to_string(::getpid()));
  fs::path file_ = folder_ / "model.json";
  FirstValue classifier_;
  Model model_ = train_model(classifier_, "first_value", names, samples, {{"learn0", "learn1"}, 2, 1}, "abc");

  void write(const std::string& text) { std::ofstream(file_) << text; }

  /// What read_models() says, or "" when it accepts the file.
  std::string complaint(const std::vector<std::string>& wanted = names, const std::string& plugin = "first_value") {
    try {
      read_models(file_, {classifier_, plugin, wanted}, {});
    } catch (const ModelError& error) {
      return error.what();
    }
    return "";
  }
};

TEST(Scaling, MapsTheRangeOfTrainingToMinusOneToOne) {
  const Scaling scaling = Scaling::of(samples);
  EXPECT_EQ(scaling.low, (std::vector<double>{10, 3}));
  EXPECT_EQ(scaling.high, (std::vector<double>{30, 3}));
  std::vector<double> scaled(2);
  for (const auto& [value, expected] : {std::pair{10, -1.0}, {15, -0.5}, {30, 1.0}, {31, 1.0}, {-5, -1.0}}) {
    scaling.apply(std::vector{double(value), 3.0}, scaled);
    EXPECT_DOUBLE_EQ(scaled[0], expected);
    EXPECT_EQ(scaled[1], 0);  // was constant
  }
}

TEST(Scaling, OfNoSampleIsDefined) {
  std::vector<double> scaled{9};
  Scaling::of({1, {}, {}}).apply(std::vector{5.0}, scaled);
  EXPECT_EQ(scaled[0], 0);
}

TEST_F(ModelFile, TrainsOnScaledValues) {
  EXPECT_EQ(classifier_.seen.values, (std::vector<double>{-1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(classifier_.seen.positive, samples.positive);
  EXPECT_DOUBLE_EQ(model_.probability(std::vector{30.0, 3.0}), 0.85);
}

TEST_F(ModelFile, ReadsWhatItWrote) {
  write_models(file_, {model_, {}});
  const Model read = read_models(file_, {classifier_, "first_value", names}, {}).structural;
  EXPECT_EQ(read.names, names);
  EXPECT_EQ(read.scaling.low, model_.scaling.low);
  EXPECT_EQ(read.scaling.high, model_.scaling.high);
  EXPECT_EQ(read.classifier, "first_value");
  EXPECT_EQ(read.config_hash, "abc");
  EXPECT_EQ(read.training.scenes, (std::vector<std::string>{"learn0", "learn1"}));
  EXPECT_EQ(read.training.positive_pairs, 2u);
  EXPECT_EQ(read.training.negative_pairs, 1u);
  for (const double value : {10.0, 12.3, 30.0})
    EXPECT_EQ(read.probability(std::vector{value, 3.0}), model_.probability(std::vector{value, 3.0}));
}

TEST_F(ModelFile, HoldsAModelForEachLevel) {
  Model other = model_;
  other.names = {"r_md", "r_cs"};
  write_models(file_, {model_, other});
  const ExpectedModel structural{classifier_, "first_value", names};
  EXPECT_FALSE(read_models(file_, structural, {}).assembly);
  const ExpectedModel assembly{classifier_, "first_value", other.names};
  EXPECT_EQ(read_models(file_, structural, assembly).assembly.value().names, other.names);
  try {
    read_models(file_, structural, structural);
    FAIL();
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("assembly level: was trained on the relation values r_md, r_cs"),
              std::string::npos)
        << error.what();
  }
  write_models(file_, {model_, {}});
  try {
    read_models(file_, structural, assembly);
    FAIL();
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("has no model of the assembly level"), std::string::npos) << error.what();
  }
}

TEST_F(ModelFile, WritesASceneNameThatIsNoUtf8) {
  model_.training.scenes = {"caf\xe9"};
  write_models(file_, {model_, {}});
  EXPECT_EQ(complaint(), "");
}

TEST_F(ModelFile, TellsWhichValuesTheConfigAndTheModelLack) {
  write_models(file_, {model_, {}});
  const std::string text = complaint({"r_co", "r_ga"});
  EXPECT_NE(text.find(file_.string()), std::string::npos) << text;
  EXPECT_NE(text.find("the config lacks r_rs"), std::string::npos) << text;
  EXPECT_NE(text.find("the model lacks r_ga"), std::string::npos) << text;
  EXPECT_NE(text.find("gestalt train"), std::string::npos) << text;
  EXPECT_EQ(complaint({"r_co"}).find("the model lacks"), std::string::npos);
}

TEST_F(ModelFile, TellsThatTheOrderDiffers) {
  write_models(file_, {model_, {}});
  EXPECT_NE(complaint({"r_rs", "r_co"}).find("the order differs: the config has r_rs, r_co"), std::string::npos);
}

TEST_F(ModelFile, TellsThatAnotherClassifierMadeIt) {
  write_models(file_, {model_, {}});
  const std::string text = complaint(names, "svm");
  EXPECT_NE(text.find("'first_value'"), std::string::npos) << text;
  EXPECT_NE(text.find("'svm'"), std::string::npos) << text;
}

TEST_F(ModelFile, GivesThePlaceWhereItIsNoJson) {
  write("{\"format\": \"gestalt-model\",\n  \"version\": oops}\n");
  EXPECT_NE(complaint().find(file_.string() + ":2:14: "), std::string::npos) << complaint();
  write("");
  EXPECT_NE(complaint().find("is empty"), std::string::npos) << complaint();
  write("{\"version\": 1e999}");
  EXPECT_NE(complaint().find("out of range"), std::string::npos) << complaint();
}

TEST_F(ModelFile, RefusesEveryTruncation) {
  write_models(file_, {model_, {}});
  std::string text((std::istreambuf_iterator<char>(std::ifstream(file_).rdbuf())), {});
  while (text.back() != '}') text.pop_back();
  while (!text.empty()) {
    text.pop_back();
    write(text);
    EXPECT_NE(complaint(), "") << text;
  }
}

TEST_F(ModelFile, RefusesOtherFormatsAndVersions) {
  write("[]");
  EXPECT_NE(complaint().find("'format'"), std::string::npos);
  write(R"({"format": "onnx"})");
  EXPECT_NE(complaint().find("'format'"), std::string::npos);
  write(R"({"format": "gestalt-model", "version": 99})");
  EXPECT_NE(complaint().find("version 99"), std::string::npos);
}

TEST_F(ModelFile, RefusesDamagedFields) {
  write_models(file_, {model_, {}});
  const json good = json::parse(std::ifstream(file_));
  const auto refuses_without = [&](const json::json_pointer& parent) {
    for (const auto& [key, value] : good.at(parent).items()) {
      json damaged = good;
      damaged[parent][key] = nullptr;
      write(damaged.dump());
      EXPECT_NE(complaint(), "") << key;
      damaged[parent].erase(key);
      write(damaged.dump());
      EXPECT_NE(complaint(), "") << key;
    }
  };
  refuses_without(json::json_pointer(""));
  refuses_without(json::json_pointer("/levels"));
  refuses_without(json::json_pointer("/levels/structural"));
  json document = good;
  json& damaged = document["levels"]["structural"];
  damaged["scaling"]["low"] = {1};
  write(document.dump());
  EXPECT_NE(complaint().find("'scaling'"), std::string::npos);
  damaged["scaling"]["low"] = {40, 3};
  write(document.dump());
  EXPECT_NE(complaint().find("low above its high"), std::string::npos);
}

TEST_F(ModelFile, WhatTheClassifierThrowsIsToldWithTheFile) {
  write_models(file_, {model_, {}});
  json damaged = json::parse(std::ifstream(file_));
  damaged["levels"]["structural"]["state"] = {{"wait", 1}};
  write(damaged.dump());
  EXPECT_NE(complaint().find(file_.string() + ": is damaged: the state of its classifier"), std::string::npos);
}

TEST_F(ModelFile, RefusesWhatIsNoFile) {
  EXPECT_NE(complaint().find("does not exist; check the path, or train a model with `gestalt train`"),
            std::string::npos);
  file_ = folder_;
  EXPECT_NE(complaint().find("is a folder"), std::string::npos);
}

TEST_F(ModelFile, RefusesAFileThatIsTooLarge) {
  write("{}");
  fs::resize_file(file_, largest_json + 1);  // sparse
  EXPECT_NE(complaint().find("has 268435457 bytes, more than the limit of 268435456"), std::string::npos);
}

TEST_F(ModelFile, TrainingNeedsBothClasses) {
  const auto train = [&](const Samples& s) { train_model(classifier_, "first_value", {"r_co"}, s, {}, ""); };
  try {
    train({1, {1, 2, 3}, {1, 1, 1}});
    FAIL();
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("3 positive and 0 negative"), std::string::npos) << error.what();
  }
  EXPECT_THROW(train({1, {}, {}}), ModelError);
  EXPECT_THROW(train({2, {1, 2, 3, 4}, {1, 0}}), ModelError);  // two columns, one name
  for (const double value : {1e101, -1.7e308, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(train({1, {0, value}, {1, 0}}), ModelError) << value;
}

}  // namespace
}  // namespace gestalt
