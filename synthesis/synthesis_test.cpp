// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/synthesis/synthesis.h"
#include "gestalt/io/scene/scene_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/thread_limit.h"
#include "ground_truth.h"
#include "layout.h"
#include "render.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class Written : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("gestalt_synthesis_" + std::string(test->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  static std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
  fs::path folder_;
};

bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a.reshape(1), b.reshape(1), cv::NORM_INF) == 0;
}

/// Pixels of each object of a scene.
std::map<int, int> objects_of(const SyntheticScene& scene) {
  std::map<int, int> pixels;
  for (const int label : scene.ground_truth)
    if (label >= 10) ++pixels[label / 10];
  return pixels;
}

class EveryCategory : public testing::TestWithParam<std::string> {};

TEST_P(EveryCategory, HasItsNumberOfVisibleObjects) {
  static const std::map<std::string, std::pair<int, int>> counts{{"boxes", {1, 4}},
                                                                 {"stacked_boxes", {2, 5}},
                                                                 {"occluded_objects", {2, 4}},
                                                                 {"cylindric_objects", {2, 6}},
                                                                 {"mixed_objects", {5, 9}},
                                                                 {"complex_scene", {15, 20}},
                                                                 {"packages", {2, 40}},
                                                                 {"groceries", {4, 24}},
                                                                 {"bin", {2, 20}},
                                                                 {"thin_and_small", {3, 14}},
                                                                 {"shelf", {3, 20}}};
  const auto [fewest, most] = counts.at(GetParam());
  for (int index = 0; index < 3; ++index) {
    const auto objects = objects_of(synthesize(category_of(GetParam()), 5, index));
    EXPECT_GE(int(objects.size()), fewest) << index;
    EXPECT_LE(int(objects.size()), most) << index;
    int number = 2;
    for (const auto& [object, pixels] : objects) {
      EXPECT_EQ(object, number++) << index;
      EXPECT_GE(pixels, 300) << index;
    }
  }
}

TEST_P(EveryCategory, HasALabelWhereverThereIsDepth) {
  const SyntheticScene scene = synthesize(category_of(GetParam()), 6, 0, kinect_camera(320, 240));
  EXPECT_EQ(scene.category, GetParam());
  EXPECT_EQ(scene.frame.name, GetParam() + "_6_000");
  EXPECT_EQ(scene.frame.colour.size(), cv::Size(320, 240));
  EXPECT_TRUE(equal(scene.frame.depth > 0, scene.ground_truth > 0));
  EXPECT_GT(cv::countNonZero((scene.ground_truth > 0) & (scene.ground_truth < 10)), 320 * 240 / 10);
}

TEST_P(EveryCategory, GivesTheSameSceneAgainAndOthersForOtherSeeds) {
  const Camera camera = kinect_camera(160, 120);
  const Category category = category_of(GetParam());
  const SyntheticScene scene = synthesize(category, 1, 0, camera), again = synthesize(category, 1, 0, camera);
  EXPECT_TRUE(equal(scene.frame.colour, again.frame.colour));
  EXPECT_TRUE(equal(scene.frame.depth, again.frame.depth));
  EXPECT_TRUE(equal(scene.ground_truth, again.ground_truth));
  EXPECT_FALSE(equal(scene.frame.depth, synthesize(category, 2, 0, camera).frame.depth));
  EXPECT_FALSE(equal(scene.frame.depth, synthesize(category, 1, 1, camera).frame.depth));
}

TEST_P(EveryCategory, IsSeenByEverySensor) {
  for (const std::string& name : sensor_model_names()) {
    const SensorModel sensor = sensor_model_of(name);
    const SyntheticScene scene = synthesize(category_of(GetParam()), 7, 1, kinect_camera(320, 240), sensor);
    EXPECT_EQ(scene.frame.name, GetParam() + (sensor == SensorModel::structured_light ? "" : "_" + name) + "_7_001");
    EXPECT_TRUE(equal(scene.frame.depth > 0, scene.ground_truth > 0)) << name;
    int number = 2;
    for (const auto& [object, pixels] : objects_of(scene)) {
      EXPECT_EQ(object, number++) << name;
      EXPECT_GE(pixels, 75) << name;
    }
    EXPECT_GT(number, 2) << name;
    for (const int label : scene.ground_truth) ASSERT_FALSE(label >= 10 && label < 20) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Synthesis, EveryCategory, testing::ValuesIn(category_names()),
                         [](const auto& category) { return category.param; });

TEST(Synthesis, OccludedObjectsAreCutInTwo) {
  for (int index = 0; index < 4; ++index) {
    const SyntheticScene scene = synthesize(Category::occluded_objects, 9, index);
    EXPECT_GE(cv::countNonZero(scene.ground_truth == 20), 100) << index;
    EXPECT_GE(cv::countNonZero(scene.ground_truth == 21), 30) << index;
  }
}

TEST(Synthesis, StackedBoxesTouch) {
  // The box on top, label 30, meets the one below without a gap of table: some pixel of it has 20 within 5 rows below.
  const SyntheticScene scene = synthesize(Category::stacked_boxes, 4, 0);
  bool touch = false;
  for (int v = 0; v + 5 < 480; ++v)
    for (int u = 0; u < 640; ++u)
      if (scene.ground_truth(v, u) / 10 == 3)
        for (int below = 1; below <= 5; ++below) touch |= scene.ground_truth(v + below, u) / 10 == 2;
  EXPECT_TRUE(touch);
}

/// A scene whose bytes were taken before there were other sensors and rooms.
TEST(Synthesis, TableTopsAreWhatTheyWere) {
  const SyntheticScene scene = synthesize(Category::mixed_objects, 1, 0, kinect_camera(160, 120));
  const auto digest_of = [](const cv::Mat& image) {
    return digest({reinterpret_cast<const char*>(image.data), image.total() * image.elemSize()});
  };
  EXPECT_EQ(digest_of(scene.ground_truth), "b0e00259002fc303ce62344cc1a51d03");
  EXPECT_EQ(digest_of(depth_in_millimetres(scene.frame)), "421f79a8383b4d4dc21f03a15a946b0d");
}

TEST(Synthesis, FlushPackagesTouch) {
  // Every package has a neighbour or carries one: another whose bounds, grown by 1.6 mm, meet its own.
  int flush = 0, packages = 0;
  for (int index = 0; index < 6; ++index) {
    synthesis::Random random(std::uint64_t(index) + 1);
    const auto arrangement = synthesis::lay_out(Category::packages, kinect_camera(), random);
    if (!arrangement) continue;
    const auto corners_of = [](const synthesis::Body& body, const Eigen::Isometry3d& to) {
      Eigen::AlignedBox3d bounds;
      for (const auto& vertex : body.mesh.vertices) bounds.extend(to * body.pose * vertex.position.cast<double>());
      return bounds;
    };
    const auto& things = arrangement->things;
    const Eigen::Isometry3d to_block = Eigen::Isometry3d(things[0].pose.linear()).inverse();
    for (std::size_t i = 0; i < 2; ++i) {
      ++packages;
      const Eigen::AlignedBox3d own = corners_of(things[i], to_block);
      for (std::size_t j = 0; j < things.size(); ++j)
        if (i != j && own.exteriorDistance(corners_of(things[j], to_block)) < 0.0016) {
          ++flush;
          break;
        }
    }
  }
  EXPECT_GE(packages, 4);
  EXPECT_EQ(flush, packages);
}

TEST(Synthesis, WallsOfABinAreBackground) {
  for (int index = 0; index < 8; ++index) {
    synthesis::Random random(std::uint64_t(index) + 1);
    const auto arrangement = synthesis::lay_out(Category::bin, kinect_camera(), random);
    if (!arrangement) continue;
    const synthesis::IdealView view = synthesis::render(*arrangement);
    cv::Mat_<std::uint16_t> depth;
    view.depth.convertTo(depth, CV_16U, 1000);
    const cv::Mat_<std::uint16_t> labels = synthesis::label_parts(depth, view.body);
    const cv::Mat walls = view.body <= synthesis::IdealView::first_furniture;
    EXPECT_GT(cv::countNonZero(walls), 1000);
    EXPECT_EQ(cv::countNonZero(walls & (labels >= 10)), 0);
    EXPECT_EQ(cv::countNonZero((view.body > 0) & (labels < 20)), 0);
    return;
  }
  FAIL() << "no layout";
}

TEST(Synthesis, ThreadsDoNotMatter) {
  const ThreadLimit one(1);
  const SyntheticScene alone =
      synthesize(Category::groceries, 3, 0, kinect_camera(160, 120), SensorModel::time_of_flight);
  const ThreadLimit two(2);
  const SyntheticScene shared =
      synthesize(Category::groceries, 3, 0, kinect_camera(160, 120), SensorModel::time_of_flight);
  EXPECT_TRUE(equal(alone.frame.depth, shared.frame.depth));
  EXPECT_TRUE(equal(alone.frame.colour, shared.frame.colour));
}

TEST(Synthesis, UnknownSensorSuggestsTheNearest) {
  EXPECT_EQ(sensor_model_of("active_stereo"), SensorModel::active_stereo);
  EXPECT_THROW(sensor_model_of("active_stero"), ConfigError);
}

TEST(Synthesis, NarrowViewIsRefused) {
  Camera camera = kinect_camera(64, 48);
  camera.fx = camera.fy = 80;
  EXPECT_THROW(synthesize(Category::mixed_objects, 1, 0, camera), InputError);
}

TEST(Synthesis, UnknownCategorySuggestsTheNearest) {
  EXPECT_EQ(category_of("complex_scene"), Category::complex_scene);
  EXPECT_EQ(name_of(Category::boxes), "boxes");
  try {
    category_of("mixed_object");
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'mixed_objects'"), std::string::npos) << error.what();
  }
}

TEST(Synthesis, CameraIsAKinectOfAnyWidth) {
  EXPECT_EQ(kinect_camera().fx, 525);
  EXPECT_EQ(kinect_camera().cx, 319.5);
  EXPECT_EQ(kinect_camera(320, 240).fy, 262.5);
  EXPECT_EQ(smallest_object(kinect_camera()), 300);
  EXPECT_EQ(smallest_object(kinect_camera(320, 240)), 75);
  EXPECT_EQ(smallest_object(kinect_camera(4, 3)), 1);
}

TEST_F(Written, NothingIsLeftOfASceneThatCannotBe) {
  const SyntheticScene scene = synthesize(Category::boxes, 7, 0);
  const fs::path place = folder_ / scene.frame.name;
  fs::create_directories(place / "depth.png");  // where the image would be
  EXPECT_THROW(write_scene(scene, folder_), OutputError);
  EXPECT_FALSE(fs::exists(place / "objects.json"));
  EXPECT_FALSE(fs::exists(place / "rgb.png"));
}

TEST(Synthesis, ObjectsAreInTheBoxesThatAreTold) {
  for (const Category category : {Category::boxes, Category::cylindric_objects, Category::packages}) {
    const SyntheticScene scene = synthesize(category, 7, 0);
    std::vector<int> points(scene.objects.size(), 0), inside(scene.objects.size(), 0);
    for (int pixel = 0; pixel < int(scene.ground_truth.total()); ++pixel) {
      const int label = scene.ground_truth.ptr<std::uint16_t>()[pixel];
      if (label < 20 || !scene.frame.valid(pixel)) continue;
      const auto object = std::size_t(label / 10 - 2);
      ASSERT_LT(object, scene.objects.size());
      const SyntheticObject& told = scene.objects[object];
      const Eigen::Vector3d place = told.pose.inverse() * scene.frame.point(pixel).cast<double>();
      constexpr double noise = 0.015;  // m
      ++points[object];
      inside[object] += (place.cwiseAbs() - told.size / 2).maxCoeff() < noise;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_GT(points[i], 0);
      EXPECT_GT(inside[i], 0.95 * points[i]) << name_of(category) << ", object " << i;
    }
    if (category == Category::boxes) {
      for (const SyntheticObject& told : scene.objects) EXPECT_EQ(told.shape, ShapeKind::box);
    }
  }
}

TEST_F(Written, SceneReadsBackAsItWas) {
  const SyntheticScene scene = synthesize(Category::boxes, 1, 0, kinect_camera(160, 120));
  write_scene(scene, folder_);
  const fs::path place = folder_ / "boxes_1_000";
  EXPECT_TRUE(equal(cv::imread((place / "rgb.png").string()), scene.frame.colour));
  EXPECT_TRUE(equal(cv::imread((place / "label.png").string(), cv::IMREAD_UNCHANGED), scene.ground_truth));
  EXPECT_TRUE(fs::exists(place / "objects.json"));
  const cv::Mat millimetres = cv::imread((place / "depth.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(millimetres.type(), CV_16UC1);
  cv::Mat metres;
  millimetres.convertTo(metres, CV_32F, 0.001);
  EXPECT_LT(cv::norm(metres, scene.frame.depth, cv::NORM_INF), 1e-6);
}

TEST(Sequence, BeginsWithTheSceneAndMovesCameraAndThings) {
  const Camera camera = kinect_camera(160, 120);
  const SyntheticScene alone = synthesize(Category::mixed_objects, 1, 0, camera);
  const std::vector<SyntheticScene> frames = synthesize_sequence(Category::mixed_objects, 1, 0, 11, camera);
  ASSERT_EQ(frames.size(), 11u);
  EXPECT_TRUE(equal(frames[0].frame.colour, alone.frame.colour));
  EXPECT_TRUE(equal(frames[0].ground_truth, alone.ground_truth));
  EXPECT_EQ(frames[0].frame.name, "0000");
  EXPECT_EQ(frames[10].frame.name, "0010");
  const auto in_world = [](const SyntheticScene& scene, std::size_t i) {
    return Eigen::Vector3d((scene.camera_pose * scene.objects[i].pose).translation());
  };
  std::size_t carried = 0;
  for (std::size_t i = 0; i < alone.objects.size(); ++i) {
    const double moved = (in_world(frames[10], i) - in_world(frames[0], i)).norm();
    EXPECT_TRUE(moved < 1e-9 || std::abs(moved - std::hypot(0.12, 0.1) / 2) < 1e-9) << moved;
    carried += moved > 0.01;
  }
  EXPECT_EQ(carried, std::max<std::size_t>(1, alone.objects.size() / 3));
  const Eigen::AngleAxisd turned(frames[10].camera_pose.linear() * frames[0].camera_pose.linear().transpose());
  EXPECT_NEAR(turned.angle(), CV_PI / 18 * std::sin(CV_PI / 3), 1e-9);
}

TEST_F(Written, ASequenceHasPosesByTheNamesOfItsFrames) {
  write_sequence(synthesize_sequence(Category::boxes, 1, 0, 2, kinect_camera(160, 120)), folder_);
  EXPECT_TRUE(fs::exists(folder_ / "0000" / "depth.png"));
  EXPECT_TRUE(fs::exists(folder_ / "0001" / "label.png"));
  std::istringstream poses(text_of(folder_ / "poses.txt"));
  std::string comment, name;
  std::getline(poses, comment);
  for (const std::string expected : {"0000", "0001"}) {
    double numbers[7];
    poses >> name;
    for (double& number : numbers) poses >> number;
    EXPECT_TRUE(poses) << expected;
    EXPECT_EQ(name, expected);
    EXPECT_NEAR(Eigen::Quaterniond(numbers[6], numbers[3], numbers[4], numbers[5]).norm(), 1, 1e-5);
  }
}

TEST_F(Written, CameraIsWrittenOnceAndNotMixed) {
  write_camera(kinect_camera(), folder_);
  write_camera(kinect_camera(), folder_);
  EXPECT_NE(text_of(folder_ / "camera.yaml").find("width: 640\nheight: 480\nfx: 525\nfy: 525\ncx: 319.5\ncy: 239.5\n"),
            std::string::npos);
  EXPECT_THROW(write_camera(kinect_camera(320, 240), folder_), OutputError);
}

TEST_F(Written, CategoriesOfOtherScenesAreKept) {
  const fs::path file = folder_ / "scenes.csv";
  merge_categories(file, {{"b", "boxes"}, {"c", "boxes"}});
  merge_categories(file, {{"a", "complex_scene"}, {"c", "mixed_objects"}});
  EXPECT_EQ(text_of(file), "scene,category\na,complex_scene\nb,boxes\nc,mixed_objects\n");
}

TEST_F(Written, TableOfAnotherKindIsRefusedAndKept) {
  const fs::path file = folder_ / "scenes.csv";
  for (const std::string text : {"name;kind\n", "scene,category\nno comma\n", "scene,category\n,boxes\n"}) {
    std::ofstream(file) << text;
    EXPECT_THROW(merge_categories(file, {{"a", "boxes"}}), InputError) << text;
    EXPECT_EQ(text_of(file), text);
  }
}

}  // namespace
}  // namespace gestalt
