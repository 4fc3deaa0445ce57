// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;
using Labels = cv::Mat_<std::uint16_t>;

struct Area {
  cv::Rect pixels;
  int label;
};

/// An image of one label with rectangles of others on it.
Labels paint(int ground, const std::vector<Area>& areas, cv::Size size = {40, 40}) {
  Labels image(size, std::uint16_t(ground));
  for (const auto& [pixels, label] : areas) image(pixels).setTo(label);
  return image;
}

const OverlapBoundary& values(const ImageScore& score, BackgroundRule rule) {
  return score.overlap_boundary[std::size_t(rule)];
}

void expect_values(const OverlapBoundary& actual, const std::array<double, 7>& expected) {
  EXPECT_DOUBLE_EQ(actual.overlap_precision, expected[0]);
  EXPECT_DOUBLE_EQ(actual.overlap_recall, expected[1]);
  EXPECT_DOUBLE_EQ(actual.overlap_f, expected[2]);
  EXPECT_DOUBLE_EQ(actual.boundary_precision, expected[3]);
  EXPECT_DOUBLE_EQ(actual.boundary_recall, expected[4]);
  EXPECT_DOUBLE_EQ(actual.boundary_f, expected[5]);
  EXPECT_DOUBLE_EQ(actual.detected, expected[6]);
}

// Two objects of 10 x 10 pixels on a table.
const cv::Rect first_object(5, 5, 10, 10), second_object(20, 20, 10, 10);
Labels two_objects() { return paint(1, {{first_object, 20}, {second_object, 30}}); }

TEST(ScoreImage, OfTheGroundTruthItselfIsOneWhateverTheIds) {
  const ImageScore score = score_image(two_objects(), paint(60000, {{first_object, 7}, {second_object, 259}}));
  EXPECT_EQ(score.pooled.true_positive, 200);
  EXPECT_EQ(score.pooled.false_positive, 0);
  EXPECT_EQ(score.pooled.region, 200);
  EXPECT_EQ(score.regions, 2);
  EXPECT_EQ(score.segments, 3);
  for (const auto rule : {BackgroundRule::table, BackgroundRule::largest, BackgroundRule::majority})
    expect_values(values(score, rule), {1, 1, 1, 1, 1, 1, 1});
  EXPECT_DOUBLE_EQ(score.object_parts.weighted_overlap, 1);
  EXPECT_DOUBLE_EQ(score.object_parts.over_segmentation, 0);
  EXPECT_DOUBLE_EQ(score.object_parts.under_segmentation, 0);
}

TEST(ScoreImage, OfAShiftedObjectFollowsFromArithmetic) {
  // The first segment lies 2 pixels to the right: 80 pixels of the object, 20 of the table.
  const ImageScore score =
      score_image(two_objects(), paint(1, {{first_object + cv::Point(2, 0), 2}, {second_object, 3}}));
  EXPECT_EQ(score.pooled.true_positive, 180);
  EXPECT_EQ(score.pooled.false_positive, 20);
  EXPECT_EQ(score.pooled.region, 200);
  EXPECT_DOUBLE_EQ(score.pooled.precision(), 0.9);
  EXPECT_DOUBLE_EQ(score.pooled.recall(), 0.9);

  ASSERT_EQ(score.each.size(), 2u);
  EXPECT_DOUBLE_EQ(score.each[0].precision(), 0.8);
  EXPECT_DOUBLE_EQ(score.each[0].recall(), 0.8);
  EXPECT_EQ(score.each[1].true_positive, 100);
  EXPECT_EQ(score.each[1].false_positive, 0);

  // The tolerance is 1 pixel. Of the 36 boundary pixels, 9 of either horizontal side have a partner (those on the other
  // boundary and one past its corner), and the 2 of the inner vertical side that touch the horizontal ones.
  const double boundary = (20.0 + 36.0) / 72.0;
  expect_values(values(score, BackgroundRule::table), {0.9, 0.9, 0.9, boundary, boundary, boundary, 1});

  EXPECT_DOUBLE_EQ(score.object_parts.weighted_overlap, (80.0 / 120.0 + 1) / 2);
  EXPECT_DOUBLE_EQ(score.object_parts.over_segmentation, 1 - 180.0 / 200.0);
  EXPECT_DOUBLE_EQ(score.object_parts.under_segmentation, 20.0 / 200.0);
  // The table's 1400 pixels are all but 20 in its segment, which holds 20 pixels of the object.
  const double table = 1380.0 / 1420.0;
  EXPECT_DOUBLE_EQ(score.all_parts.weighted_overlap, (1400 * table + 100 * (80.0 / 120.0) + 100) / 1600);
  EXPECT_DOUBLE_EQ(score.all_parts.over_segmentation, 1 - 1560.0 / 1600.0);
  EXPECT_DOUBLE_EQ(score.all_parts.under_segmentation, 40.0 / 1600.0);
}

TEST(ScoreImage, OfAnUndersegmentedImageCountsTheSegmentForEveryObject) {
  const ImageScore score = score_image(two_objects(), paint(1, {}));
  EXPECT_EQ(score.pooled.true_positive, 200);
  EXPECT_EQ(score.pooled.false_positive, 1500 + 1500);
  // The one segment is the table, and nothing is left for the objects ...
  expect_values(values(score, BackgroundRule::table), {1, 0, 0, 1, 0, 0, 0});
  // ... or it is matched to the object of either F = 200 / 1700: 100 of its pixels are that object's.
  const OverlapBoundary& all = values(score, BackgroundRule::none);
  EXPECT_DOUBLE_EQ(all.overlap_precision, 100.0 / 1600.0);
  EXPECT_DOUBLE_EQ(all.overlap_recall, 0.5);
  EXPECT_DOUBLE_EQ(all.boundary_precision, 0);
  EXPECT_DOUBLE_EQ(all.detected, 0);
}

TEST(ScoreImage, MatchesOneSegmentToARegion) {
  // The first object is in two halves; one is matched, both are foreground.
  const ImageScore score =
      score_image(two_objects(), paint(1, {{{5, 5, 6, 10}, 2}, {{11, 5, 4, 10}, 3}, {second_object, 4}}));
  EXPECT_EQ(score.pooled.true_positive, 160);
  EXPECT_EQ(score.pooled.false_positive, 0);
  const OverlapBoundary& table = values(score, BackgroundRule::table);
  EXPECT_DOUBLE_EQ(table.overlap_precision, 160.0 / 200.0);
  EXPECT_DOUBLE_EQ(table.overlap_recall, 160.0 / 200.0);
  EXPECT_DOUBLE_EQ(table.detected, 0.5);  // 2 * 60 / 160 = 0.75 is not more than 0.75
}

TEST(ScoreImage, WithoutSegmentsIsPreciseAndRecallsNothing) {
  const ImageScore score = score_image(two_objects(), paint(0, {}));
  EXPECT_EQ(score.segments, 0);
  EXPECT_EQ(score.pooled.true_positive, 0);
  EXPECT_EQ(score.pooled.false_positive, 0);
  EXPECT_DOUBLE_EQ(score.pooled.precision(), 1);
  EXPECT_DOUBLE_EQ(score.pooled.recall(), 0);
  for (const OverlapBoundary& rule : score.overlap_boundary) expect_values(rule, {1, 0, 0, 1, 0, 0, 0});
  EXPECT_DOUBLE_EQ(score.all_parts.weighted_overlap, 0);
  EXPECT_DOUBLE_EQ(score.all_parts.over_segmentation, 1);
  EXPECT_DOUBLE_EQ(score.all_parts.under_segmentation, 0);
}

TEST(ScoreImage, WithoutObjectsDependsOnTheBackgroundRule) {
  const ImageScore score = score_image(paint(1, {}), paint(3, {}));
  EXPECT_EQ(score.regions, 0);
  EXPECT_DOUBLE_EQ(score.pooled.precision(), 1);
  EXPECT_DOUBLE_EQ(score.pooled.recall(), 1);
  expect_values(values(score, BackgroundRule::table), {1, 1, 1, 1, 1, 1, 1});
  expect_values(values(score, BackgroundRule::none), {0, 1, 0, 0, 1, 0, 0});
  EXPECT_DOUBLE_EQ(score.all_parts.weighted_overlap, 1);
  EXPECT_TRUE(std::isnan(score.object_parts.weighted_overlap));
}

TEST(ScoreImage, WithoutGroundTruthCountsNothing) {
  const ImageScore score = score_image(paint(0, {}), paint(3, {}));
  EXPECT_EQ(score.segments, 0);
  for (const OverlapBoundary& rule : score.overlap_boundary) expect_values(rule, {1, 1, 1, 1, 1, 1, 1});
  EXPECT_TRUE(std::isnan(score.all_parts.weighted_overlap));
}

TEST(ScoreImage, OfOnePixel) {
  const ImageScore score = score_image(paint(20, {}, {1, 1}), paint(1, {}, {1, 1}));
  expect_values(values(score, BackgroundRule::table), {1, 1, 1, 1, 1, 1, 1});
  expect_values(values(score, BackgroundRule::largest), {1, 0, 0, 1, 0, 0, 0});
}

TEST(ScoreImage, DropsSegmentsOutsideTheGroundTruth) {
  Labels ground_truth = two_objects();
  ground_truth.rowRange(0, 5).setTo(0);
  const ImageScore score =
      score_image(ground_truth, paint(1, {{{5, 0, 10, 15}, 2}, {second_object, 3}, {{0, 0, 5, 3}, 4}}));
  EXPECT_EQ(score.segments, 3);
  expect_values(values(score, BackgroundRule::table), {1, 1, 1, 1, 1, 1, 1});
}

TEST(ScoreImage, IgnoredPixelsCountNeitherWay) {
  // What a segment covers of pixels that nobody annotated, label 0, is not an error; the rest of it is scored as it is.
  Labels ground_truth = two_objects();
  ground_truth(cv::Rect(15, 0, 5, 20)).setTo(0);
  const ImageScore score = score_image(ground_truth, paint(1, {{{5, 5, 15, 10}, 2}, {second_object, 3}}));
  EXPECT_EQ(score.pooled.false_positive, 0);
  for (const auto rule : {BackgroundRule::table, BackgroundRule::majority})
    expect_values(values(score, rule), {1, 1, 1, 1, 1, 1, 1});
}

TEST(ScoreImage, TakesSegmentsForBackgroundByRule) {
  // An object and the table beside it, 900 pixels each, both found.
  const Labels ground_truth = paint(1, {{{0, 0, 30, 30}, 20}}, {60, 30});
  const Labels prediction = paint(1, {{{0, 0, 30, 30}, 2}}, {60, 30});
  // Of equal segments the one with the smaller id is the largest: here the table's.
  const ImageScore score = score_image(ground_truth, prediction);
  expect_values(values(score, BackgroundRule::largest), {1, 1, 1, 1, 1, 1, 1});
  // With the ids exchanged it is the object's. The strict rule drops it, the others do not.
  const ImageScore changed = score_image(ground_truth, 3 - prediction);
  EXPECT_DOUBLE_EQ(values(changed, BackgroundRule::largest).overlap_f, 0);
  EXPECT_DOUBLE_EQ(values(changed, BackgroundRule::table).overlap_precision, 0.5);
  expect_values(values(changed, BackgroundRule::majority), {1, 1, 1, 1, 1, 1, 1});
}

TEST(ScoreImage, HalfOnBackgroundIsForeground) {
  const ImageScore score = score_image(paint(1, {{{0, 0, 20, 40}, 20}}), paint(5, {}));
  EXPECT_DOUBLE_EQ(values(score, BackgroundRule::majority).overlap_precision, 0.5);
  EXPECT_DOUBLE_EQ(values(score, BackgroundRule::table).overlap_recall, 1);
}

TEST(ScoreImage, TellsPartsOfAnObjectApartWhenAsked) {
  const Labels ground_truth = paint(1, {{{5, 5, 5, 10}, 20}, {{10, 5, 5, 10}, 21}});
  const Labels prediction = paint(1, {{{5, 5, 10, 10}, 2}});
  EXPECT_EQ(score_image(ground_truth, prediction).regions, 1);
  EXPECT_EQ(score_image(ground_truth, prediction).pooled.false_positive, 0);
  EXPECT_EQ(score_image(ground_truth, prediction, RegionKind::parts).regions, 2);
  EXPECT_EQ(score_image(ground_truth, prediction, RegionKind::parts).pooled.false_positive, 100);
}

TEST(ScoreImage, RefusesImagesOfDifferentSize) {
  EXPECT_THROW(score_image(two_objects(), paint(1, {}, {20, 40})), InputError);
  EXPECT_THROW(score_image(Labels(), Labels()), InputError);
}

// Two images of one object each: one all found, one not at all.
std::vector<ImageScore> found_and_missed() {
  const Labels small = paint(1, {{{5, 5, 10, 10}, 20}}), large = paint(1, {{{5, 5, 30, 10}, 20}});
  return {score_image(small, paint(1, {{{5, 5, 10, 10}, 2}})), score_image(large, paint(0, {}))};
}

TEST(Summarise, PoolsPixelsAndAveragesTheRest) {
  const std::vector<ScoreRow> rows = summarise(found_and_missed(), {"boxes", ""});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].category, "boxes");
  EXPECT_EQ(rows[0].images, 1);
  EXPECT_EQ(rows[1].category, "all");
  EXPECT_EQ(rows[1].images, 2);
  EXPECT_EQ(rows[1].regions, 2);
  EXPECT_DOUBLE_EQ(rows[1].segments, 1);
  EXPECT_DOUBLE_EQ(rows[1].precision, 1);
  EXPECT_DOUBLE_EQ(rows[1].recall, 100.0 / 400.0);
  EXPECT_DOUBLE_EQ(rows[1].overlap_boundary[0].overlap_f, 0.5);
  EXPECT_DOUBLE_EQ(rows[1].object_parts.weighted_overlap, 0.5);
}

TEST(Summarise, KeepsTheOrderOfFirstAppearance) {
  auto scores = found_and_missed();
  scores.push_back(scores[0]);
  const std::vector<ScoreRow> rows = summarise(scores, {"stacked", "boxes", "stacked"});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].category, "stacked");
  EXPECT_EQ(rows[0].images, 2);
  EXPECT_EQ(rows[1].category, "boxes");
}

TEST(WithMean, CountsCategoriesAlikeWhateverTheirImages) {
  auto scores = found_and_missed();
  scores.push_back(scores[1]);
  const std::vector<ScoreRow> rows = with_mean(summarise(scores, {"boxes", "bowls", "bowls"}));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[2].category, "mean");
  EXPECT_EQ(rows[2].images, 3);
  EXPECT_EQ(rows[2].regions, 3);
  EXPECT_DOUBLE_EQ(rows[2].segments, 1);  // two and none
  EXPECT_DOUBLE_EQ(rows[2].recall, 0.5);
  EXPECT_DOUBLE_EQ(rows[2].overlap_boundary[0].detected, 0.5);
  EXPECT_DOUBLE_EQ(rows[2].object_parts.weighted_overlap, 0.5);
  EXPECT_EQ(rows[3].category, "all");
  EXPECT_DOUBLE_EQ(rows[3].recall, 100.0 / 700.0);
  EXPECT_DOUBLE_EQ(rows[3].overlap_boundary[0].detected, 1.0 / 3);
}

TEST(WithMean, NeedsTwoCategories) {
  EXPECT_EQ(with_mean(summarise(found_and_missed(), {"boxes", "boxes"})).size(), 2u);
  EXPECT_EQ(with_mean(summarise(found_and_missed(), {"", ""})).size(), 1u);
}

TEST(FormatTables, AlignsPercentages) {
  const std::vector<ScoreRow> rows = summarise(found_and_missed(), {"", ""});
  const std::string first = format_tables(rows, RegionKind::objects, BackgroundRule::table);
  const auto objects = first.find(
      "category             images    F>.75       oF       bF\n"
      "all                       2    50.00    50.00    50.00\n");
  const auto pooled = first.find(
      "category             images  regions segs/img        P        R\n"
      "all                       2        2      1.0   100.00    25.00\n");
  EXPECT_LT(objects, pooled) << first;
  EXPECT_NE(pooled, std::string::npos) << first;
  const std::string text = format_other_tables(rows, RegionKind::objects);
  EXPECT_NE(text.find("category                 oP       oR       oF       bP       bR       bF    F>.75\n"
                      "all                  100.00    50.00    50.00   100.00    50.00    50.00    50.00\n"),
            std::string::npos)
      << text;
}

TEST(FormatTables, TheFirstIsOfTheRuleAskedFor) {
  // One segment of table and object, most of it table.
  const std::vector<ScoreRow> rows = summarise({score_image(two_objects(), paint(1, {}))}, {""});
  const auto has = [&](BackgroundRule rule, const std::string& line) {
    return format_tables(rows, RegionKind::objects, rule).find(line) != std::string::npos;
  };
  EXPECT_TRUE(has(BackgroundRule::majority, "all                       1     0.00     0.00     0.00\n"));
  EXPECT_TRUE(has(BackgroundRule::none, "all                       1     0.00    11.11     0.00\n"));
}

TEST(FormatTables, LongNamesWidenTheColumn) {
  const std::string name = "other_sensors/anygrasp_tracking";
  const std::string text =
      format_tables(summarise(found_and_missed(), {name, name}), RegionKind::objects, BackgroundRule::none);
  EXPECT_NE(text.find("\n" + name + "        2    50.00"), std::string::npos) << text;
  EXPECT_NE(text.find("\nall" + std::string(name.size() - 3, ' ') + "        2    50.00"), std::string::npos) << text;
}

TEST(FormatTables, PrintsWhatIsUndefinedAsNan) {
  const std::string text =
      format_other_tables(summarise({score_image(paint(1, {}), paint(3, {}))}, {""}), RegionKind::parts);
  EXPECT_NE(text.find("all                  100.00     0.00     0.00      nan      nan      nan\n"), std::string::npos)
      << text;
}

TEST(ToJson, GivesFractionsByCategory) {
  const auto json = to_json(summarise(found_and_missed(), {"boxes", "boxes"}));
  EXPECT_EQ(json.size(), 2u);
  EXPECT_EQ(json.at("boxes").at("images"), 2);
  EXPECT_DOUBLE_EQ(json.at("all").at("R"), 0.25);
  EXPECT_DOUBLE_EQ(json.at("all").at("table:F>.75"), 0.5);
  EXPECT_DOUBLE_EQ(json.at("all").at("parts_objects:F_os"), 0.5);
}

class EvaluationFiles : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
};

TEST_F(EvaluationFiles, LabelImagesHave8Or16Bits) {
  for (const int type : {CV_8U, CV_16U}) {
    cv::Mat image(2, 3, type, cv::Scalar(type == CV_8U ? 255 : 60000));
    cv::imwrite((folder_.path() / "labels.png").string(), image);
    const Labels labels = read_label_image(folder_.path() / "labels.png");
    EXPECT_EQ(labels.size(), cv::Size(3, 2));
    EXPECT_EQ(labels(1, 2), type == CV_8U ? 255 : 60000);
  }
}

TEST_F(EvaluationFiles, OtherImagesAreRefused) {
  cv::imwrite((folder_.path() / "colour.png").string(), cv::Mat(2, 3, CV_8UC3, cv::Scalar::all(1)));
  EXPECT_THROW(read_label_image(folder_.path() / "colour.png"), InputError);
  EXPECT_THROW(read_label_image(folder_.path() / "missing.png"), InputError);
  EXPECT_THROW(read_label_image(folder_.write("text.png", "not an image")), InputError);
}

TEST_F(EvaluationFiles, CategoriesAreReadByColumnName) {
  const auto categories =
      read_categories(folder_.write("scenes.csv", "category,note,scene\r\nboxes,,learn1\r\nbowls,x,learn2\r\n\r\n"));
  EXPECT_EQ(categories, (std::map<std::string, std::string>{{"learn1", "boxes"}, {"learn2", "bowls"}}));
  EXPECT_TRUE(read_categories(folder_.path() / "missing.csv").empty());
}

TEST_F(EvaluationFiles, WrongCategoryFilesAreRefusedWithTheLine) {
  EXPECT_THROW(read_categories(folder_.write("two.csv", "scene,category\na,boxes\na,bowls\n")), InputError);
  EXPECT_EQ(read_categories(folder_.write("twice.csv", "scene,category\na,boxes\na,boxes\n")).size(), 1u);
  EXPECT_THROW(read_categories(folder_.write("head.csv", "learn1,boxes\n")), InputError);
  const fs::path file = folder_.write("short.csv", "scene,category\nlearn1,boxes\nlearn2\n");
  try {
    read_categories(file);
    FAIL() << "a short line was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("short.csv:3:"), std::string::npos) << error.what();
  }
}

TEST(DealFolds, SpreadsEveryCategory) {
  std::vector<std::string> categories(7, "boxes");
  categories.insert(categories.end(), 4, "bowls");
  for (const std::uint64_t seed : {0, 1, 2}) {
    const std::vector<int> fold = deal_folds(categories, 3, seed);
    for (int f = 0; f < 3; ++f) {
      EXPECT_GE(std::count(fold.begin(), fold.begin() + 7, f), 2);
      EXPECT_GE(std::count(fold.begin() + 7, fold.end(), f), 1);
      EXPECT_GE(std::count(fold.begin(), fold.end(), f), 3);
    }
    EXPECT_EQ(deal_folds(categories, 3, seed), fold);
  }
  EXPECT_EQ(deal_folds({"a", "a", "a", "a"}, 2, 0), (std::vector<int>{0, 1, 0, 1}));
  EXPECT_NE(deal_folds(categories, 3, 1), deal_folds(categories, 3, 2));
}

TEST(DealFolds, NeedsASceneForEachFold) {
  EXPECT_THROW(deal_folds({"a", "b"}, 1, 0), ConfigError);
  EXPECT_THROW(deal_folds({"a", "b"}, 3, 0), ConfigError);
}

TEST(PairDecisions, BalanceTheErrorsOfBothKinds) {
  PairDecisions pairs;
  for (int i = 0; i < 10; ++i) pairs.count(true, i < 9);
  EXPECT_TRUE(std::isnan(pairs.balanced_error()));
  for (int i = 0; i < 4; ++i) pairs.count(false, i < 1);
  EXPECT_EQ(pairs.true_positive, 9);
  EXPECT_EQ(pairs.false_negative, 1);
  EXPECT_EQ(pairs.false_positive, 1);
  EXPECT_EQ(pairs.true_negative, 3);
  EXPECT_DOUBLE_EQ(pairs.balanced_error(), (1.0 / 4 + 1.0 / 10) / 2);
  EXPECT_NE(format_pairs(pairs, "structural").find("17.50"), std::string::npos);
}

TEST(PairDecisions, CalibrationComparesProbabilitiesWithShares) {
  PairDecisions pairs;
  EXPECT_TRUE(std::isnan(pairs.calibration_error()));
  for (int i = 0; i < 4; ++i) pairs.count(i == 0, 0.25);  // as said: one of four
  pairs.count(true, 1);
  EXPECT_DOUBLE_EQ(pairs.calibration_error(), 0);
  EXPECT_DOUBLE_EQ(pairs.brier_score(), (3 * 0.0625 + 0.5625) / 5);
  pairs.count(false, 1);
  EXPECT_DOUBLE_EQ(pairs.calibration_error(), 1.0 / 6);
  EXPECT_EQ(pairs.bins[2].pairs, 4);
  EXPECT_EQ(pairs.bins[9].pairs, 2);
}

}  // namespace
}  // namespace gestalt
