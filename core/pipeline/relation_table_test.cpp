// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/relation_table.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

/// Gives a + 100 b as r_x, or a fixed value.
class Numbered final : public Relation {
 public:
  explicit Numbered(std::string name, double fixed = -1) : values_{{std::move(name), 0, 1000, ""}}, fixed_(fixed) {}
  const std::vector<RelationValue>& values() const override { return values_; }
  std::unique_ptr<Measure> bind(const Scene&) const override {
    ++bound;
    return std::make_unique<Value>(fixed_);
  }

  mutable std::atomic<int> bound = 0;

 private:
  struct Value final : Measure {
    explicit Value(double value) : fixed(value) {}
    void operator()(const SurfacePair& pair, std::span<double> out) const override {
      out[0] = fixed == -1 ? pair.a + 100 * pair.b : fixed;
    }
    double fixed;
  };
  std::vector<RelationValue> values_;
  double fixed_;
};

NamedRelation numbered(const std::string& name, double fixed = -1) {
  return {name, std::make_shared<Numbered>("r_" + name, fixed)};
}

/// Gives a, b and a + b.
class Several final : public Relation {
 public:
  const std::vector<RelationValue>& values() const override { return values_; }
  std::unique_ptr<Measure> bind(const Scene&) const override {
    struct Value final : Measure {
      void operator()(const SurfacePair& pair, std::span<double> out) const override {
        out[0] = pair.a;
        out[1] = pair.b;
        out[2] = pair.a + pair.b;
      }
    };
    return std::make_unique<Value>();
  }

 private:
  std::vector<RelationValue> values_{{"r_a", 0, 9, ""}, {"r_b", 0, 9, ""}, {"r_sum", 0, 9, ""}};
};

/// Three squares in a row, 1 and 2 touching in space, 2 and 3 only in the image.
test::KnownScene row() {
  return test::render({{{100, 100, 20, 20}, {0, 0, 1}, {0, 0, -1}},
                       {{120, 100, 20, 20}, {0, 0, 1}, {0, 0, -1}},
                       {{140, 100, 20, 20}, {0, 0, 1.5f}, {0, 0, -1}}});
}

RelationTable relate_all(const test::KnownScene& known, const std::vector<SurfacePair>& pairs,
                         const std::vector<NamedRelation>& relations) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  return relate(pairs, relations, Measures(scene, relations));
}

TEST(RelationTable, HoldsTheValuesOfAllRelations) {
  const auto known = row();
  const RelationTable table = relate_all(known, neighbour_pairs(known.surfaces, 1), {numbered("x"), numbered("y", 7)});
  EXPECT_EQ(table.names, (std::vector<std::string>{"r_x", "r_y"}));
  ASSERT_EQ(table.pairs.size(), 1u);
  EXPECT_EQ(table.row(0)[0], 100);
  EXPECT_EQ(table.row(0)[1], 7);
}

TEST(RelationTable, HoldsTheValuesThatALevelHasOfARelation) {
  const auto known = row();
  const NamedRelation part{"part", std::make_shared<Several>(), "several", {"r_a", "r_sum"}};
  const RelationTable table =
      relate_all(known, non_neighbour_pairs(known.surfaces, 1), {numbered("x", 7), part, numbered("y", 8)});
  EXPECT_EQ(table.names, (std::vector<std::string>{"r_x", "r_a.part", "r_sum.part", "r_y"}));
  ASSERT_EQ(table.pairs.size(), 2u);
  EXPECT_EQ(table.values, (std::vector<double>{7, 0, 2, 8, 7, 1, 3, 8}));
}

TEST(RelationTable, ARelationOfBothLevelsIsBoundOnce) {
  const auto known = row();
  const Scene scene(known.frame, known.patches, known.surfaces);
  const auto relation = std::make_shared<Numbered>("r_x");
  const NamedRelation shared{"x", relation};
  const Measures measures(scene, {shared, numbered("y"), shared});
  EXPECT_EQ(relation->bound, 1);
  EXPECT_EQ(relate(non_neighbour_pairs(known.surfaces, 1), {shared}, measures).row(0)[0], 200);
}

TEST(Pairs, OfTheStructuralLevelAreNeighboursIn3D) {
  const auto known = row();
  const auto pairs = neighbour_pairs(known.surfaces, 1);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].a, 0);
  EXPECT_EQ(pairs[0].b, 1);
  EXPECT_FALSE(pairs[0].border->border_3d.empty());
}

/// Single pixels in a row, far from each other, of which every hundredth has a size of 20.
SurfaceSet dots(std::size_t count) {
  SurfaceSet surfaces;
  surfaces.labels = cv::Mat_<int>(1, int(count));
  surfaces.surfaces.resize(count);
  for (std::size_t i = 0; i < count; ++i) surfaces.surfaces[i].pixels.assign(i % 100 ? 10 : 20, int(i));
  return surfaces;
}

// The number of pairs is bounded, whatever the number of surfaces.
TEST(Pairs, OfTheAssemblyLevelAreThoseOfTheNearestAndTheLargest) {
  for (const std::size_t count : {100, 632}) {
    EXPECT_EQ(non_neighbour_pairs(dots(count), 10).size(), count * (count - 1) / 2);
    EXPECT_EQ(omitted_pairs(dots(count), 10), 0u);
  }
  for (const std::size_t count : {std::size_t{634}, std::size_t{1500}, most_paired_surfaces, std::size_t{6000}}) {
    const auto pairs = non_neighbour_pairs(dots(count), 10);
    EXPECT_LE(pairs.size(), most_assembly_pairs);
    EXPECT_GE(pairs.size(), most_assembly_pairs / 2);
    EXPECT_EQ(omitted_pairs(dots(count), 10), count * (count - 1) / 2 - pairs.size());
    std::set<std::pair<int, int>> all;
    for (const SurfacePair& pair : pairs) {
      EXPECT_LT(pair.a, pair.b);
      all.insert({pair.a, pair.b});
    }
    EXPECT_EQ(all.size(), pairs.size());
    EXPECT_EQ(all.count({0, int(count - 1) / 100 * 100}), 1u) << "large ones, far apart";
    for (int i = 0; i + 10 < int(std::min(count, most_paired_surfaces - 100)); ++i)
      EXPECT_EQ(all.count({i, i + 10}), 1u) << "small ones, near each other";
  }
}

TEST(Pairs, OfTheAssemblyLevelAreAllOthers) {
  const auto known = row();
  const auto pairs = non_neighbour_pairs(known.surfaces, 1);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(std::pair(pairs[0].a, pairs[0].b), std::pair(0, 2));
  EXPECT_EQ(pairs[0].border, nullptr);
  EXPECT_EQ(std::pair(pairs[1].a, pairs[1].b), std::pair(1, 2));
  ASSERT_NE(pairs[1].border, nullptr) << "they touch in the image";
  EXPECT_TRUE(pairs[1].border->border_3d.empty());
}

TEST(Pairs, OfTheAssemblyLevelAreOfTwoObjectsWhereRolesAreGiven) {
  const auto known = row();
  const std::vector<Role> roles{Role::background, Role::object, Role::object};
  const auto pairs = non_neighbour_pairs(known.surfaces, 1, roles);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(std::pair(pairs[0].a, pairs[0].b), std::pair(1, 2));
}

TEST(Pairs, OfTheBackgroundDoNotCountTowardsTheBound) {
  std::vector<Role> roles(1200, Role::background);
  std::fill(roles.begin(), roles.begin() + 600, Role::object);
  EXPECT_EQ(non_neighbour_pairs(dots(1200), 10, roles).size(), 600u * 599 / 2);
  EXPECT_EQ(omitted_pairs(dots(1200), 10, roles), 0u);
  std::fill(roles.begin(), roles.begin() + 700, Role::object);
  EXPECT_EQ(omitted_pairs(dots(1200), 10, roles), 700u * 699 / 2 - non_neighbour_pairs(dots(1200), 10, roles).size());
}

TEST(Pairs, AreOfPatchesThatAreLargeEnough) {
  const auto known = row();
  EXPECT_EQ(neighbour_pairs(known.surfaces, 400).size(), 1u);
  EXPECT_TRUE(neighbour_pairs(known.surfaces, 401).empty());
  EXPECT_EQ(non_neighbour_pairs(known.surfaces, 400).size(), 2u);
  EXPECT_TRUE(non_neighbour_pairs(known.surfaces, 401).empty());
}

TEST(RelationTable, NamesTheRelationThatBreaksItsPromise) {
  const auto known = row();
  for (const double wrong : {std::nan(""), HUGE_VAL, 1001.0, -0.5}) {
    try {
      relate_all(known, neighbour_pairs(known.surfaces, 1), {numbered("x"), numbered("wrong", wrong)});
      FAIL() << wrong;
    } catch (const PluginError& error) {
      EXPECT_NE(std::string(error.what()).find("'wrong'"), std::string::npos) << error.what();
    }
  }
}

TEST(RelationTable, RefusesTwoValuesOfOneName) {
  EXPECT_THROW(value_names({numbered("x"), numbered("x")}), ConfigError);
}

TEST(RelationTable, TellsTwoUsesOfOnePluginApart) {
  NamedRelation coarse = numbered("x");
  coarse.name = "coarse";
  EXPECT_EQ(value_names({numbered("x"), coarse}), (std::vector<std::string>{"r_x", "r_x.coarse"}));
}

TEST(LearningSet, LabelsPairsByTheMajorityObject) {
  const auto known = test::render({{{0, 0, 10, 10}, {0, 0, 1}, {0, 0, -1}},
                                   {{10, 0, 10, 10}, {0, 0, 1}, {0, 0, -1}},
                                   {{20, 0, 10, 10}, {0, 0, 1}, {0, 0, -1}},
                                   {{30, 0, 10, 10}, {0, 0, 1}, {0, 0, -1}},
                                   {{40, 0, 10, 10}, {0, 0, 1}, {0, 0, -1}}},
                                  test::kinect(64, 48));
  // Patches: object 1 (part 20), object 1 (part 21), object 2, background, no ground truth.
  cv::Mat_<std::uint16_t> truth(48, 64, std::uint16_t{0});
  truth(cv::Rect(0, 0, 10, 10)) = 20;
  truth(cv::Rect(0, 0, 4, 10)) = 1;  // a minority
  truth(cv::Rect(10, 0, 10, 10)) = 21;
  truth(cv::Rect(20, 0, 10, 10)) = 30;
  truth(cv::Rect(30, 0, 10, 10)) = 2;
  EXPECT_EQ(surface_objects(known.surfaces, truth), (std::vector<int>{2, 2, 3, 1, 0}));

  const RelationTable table{{"r_x"}, {{0, 1}, {0, 2}, {0, 3}, {1, 4}, {3, 4}}, {1, 2, 3, 4, 5}};
  const Samples samples = labelled_pairs(table, surface_objects(known.surfaces, truth));
  EXPECT_EQ(samples.positive, (std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_EQ(samples.values, (std::vector<double>{1, 2, 3}));
}

TEST(LearningSet, LeavesOutPairsOfTwoBackgroundPatches) {
  EXPECT_EQ(labelled_pairs({{"r_x"}, {{0, 1}}, {1}}, {1, 1}).rows(), 0u);
}

TEST(LearningSet, TheAssemblyLevelLearnsFromPairsThatTheStructuralLevelLeavesApart) {
  LearningScene scene;
  scene.percept.assembly = {{"r_x"}, {{0, 1}, {0, 2}, {1, 2}}, {1, 2, 3}};
  scene.percept.roles = {Role::object, Role::object, Role::object};
  scene.objects = {2, 2, 3};
  const Samples samples = assembly_pairs(scene, {0, 0, 1});
  EXPECT_EQ(samples.values, (std::vector<double>{2, 3}));
  EXPECT_EQ(samples.positive, (std::vector<std::uint8_t>{0, 0}));
  scene.percept.roles[0] = Role::background;
  EXPECT_EQ(assembly_pairs(scene, {0, 0, 1}).values, std::vector<double>{3});
  scene.percept.separate = false;  // as the paper has it
  EXPECT_EQ(assembly_pairs(scene, {0, 0, 1}).values, (std::vector<double>{2, 3}));
}

TEST(LearningSet, RefusesGroundTruthOfAnotherSize) {
  EXPECT_THROW(surface_objects(row().surfaces, cv::Mat_<std::uint16_t>(10, 10, std::uint16_t{1})), InputError);
}

}  // namespace
}  // namespace gestalt
