// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/io/scene/input.h"
#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;

/// An OSD release of two scenes of 80x60 pixels.
class Convert : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string name : {"learn25", "test54"}) write_release_scene(name);
    folder.write("small.yaml", small_camera());
  }
  void write_release_scene(const std::string& name) const {
    for (const char* kind : {"disparity", "image_color", "annotation"}) fs::create_directories(release / kind);
    cv::Mat_<std::uint8_t> annotation(small_height, small_width, std::uint8_t{0});
    annotation(cv::Rect(10, 10, 20, 20)) = 1;
    annotation(cv::Rect(40, 10, 20, 20)) = 2;
    write_image(release / "disparity" / (name + ".png"), small_wall());
    write_image(release / "image_color" / (name + ".png"), cv::Mat(small_wall().size(), CV_8UC3, cv::Scalar(9, 8, 7)));
    write_image(release / "annotation" / (name + ".png"), annotation);
  }
  Outcome convert(const fs::path& input, const std::string& from, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"convert", input, "--from", from, "--output", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gestalt(arguments);
  }
  const TemporaryFolder folder;
  const fs::path release = folder.path() / "release", out = folder.path() / "out";
  const std::string camera = folder.path() / "small.yaml";
};

TEST_F(Convert, AReleaseBecomesLearnAndTestScenes) {
  const Outcome outcome = convert(release, "osd", {"--camera", camera});
  expect_success(outcome);
  EXPECT_EQ(files_below(out),
            (std::vector<std::string>{"learn.csv", "learn/learn25/camera.yaml", "learn/learn25/depth.png",
                                      "learn/learn25/label.png", "learn/learn25/rgb.png", "test.csv",
                                      "test/test54/camera.yaml", "test/test54/depth.png", "test/test54/label.png",
                                      "test/test54/rgb.png"}));
  EXPECT_EQ(content(out / "learn.csv"), "scene,category\nlearn25,occluded_objects\n");
  EXPECT_EQ(content(out / "test.csv"), "scene,category\ntest54,mixed_objects\n");
  EXPECT_GT(occurrences("learn25: 2 objects, occluded_objects", outcome.out), 0) << outcome.out;

  const Input scene = read_scene(out / "learn" / "learn25");
  EXPECT_EQ(scene.frame.camera.fx, 75);
  EXPECT_EQ(scene.frame.depth(5, 5), 1.0f);
  EXPECT_EQ(scene.ground_truth(5, 5), 1);
  EXPECT_EQ(scene.ground_truth(15, 15), 20);
  EXPECT_EQ(scene.ground_truth(15, 45), 30);
}

TEST_F(Convert, ASceneThatLacksAnImageIsNamedAndLeavesNothing) {
  fs::remove(release / "annotation" / "learn25.png");
  const Outcome outcome = convert(release, "osd", {"--camera", camera});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(occurrences((release / "annotation" / "learn25.png").string(), outcome.err), 1) << outcome.err;
  EXPECT_FALSE(fs::exists(out / "learn"));
  EXPECT_FALSE(fs::exists(out / "learn.csv"));
  EXPECT_TRUE(fs::exists(out / "test" / "test54" / "depth.png"));
}

TEST_F(Convert, LinksBelowTheOutputFolderAreNotFollowed) {
  const std::string header = "scene,category\n";
  const fs::path mine = folder.write("mine.csv", header), elsewhere = folder.path() / "elsewhere";
  fs::create_directories(out / "learn");
  fs::create_directory(elsewhere);
  fs::create_directory_symlink(elsewhere, out / "learn" / "learn25");
  fs::create_symlink(mine, out / "test.csv");
  const Outcome outcome = convert(release, "osd", {"--camera", camera});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(occurrences("learn25: is a symbolic link", outcome.err), 1) << outcome.err;
  EXPECT_EQ(files_below(elsewhere), Texts{});
  EXPECT_EQ(content(mine), header);
  EXPECT_EQ(occurrences("test54,", content(out / "test.csv")), 1);
}

TEST_F(Convert, ALinkInPlaceOfAFolderBelowTheOutputIsNotFollowed) {
  const fs::path elsewhere = folder.path() / "elsewhere";
  fs::create_directory(elsewhere);
  fs::create_directory(out);
  fs::create_directory_symlink(elsewhere, out / "learn");
  for (const char* format : {"scene", "npz"}) {
    const Outcome outcome = convert(release, "osd", {"--camera", camera, "--to", format});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(occurrences("out/learn: is a symbolic link", outcome.err), 1) << outcome.err;
  }
  EXPECT_EQ(files_below(elsewhere), Texts{});
  fs::remove(out / "learn");
  fs::create_directory_symlink(elsewhere, folder.path() / "named");  // by the user: that is followed
  expect_success(run_gestalt({"convert", release, "--output", folder.path() / "named", "--camera", camera}));
  EXPECT_TRUE(fs::exists(elsewhere / "learn" / "learn25" / "depth.png"));
}

/// A sequence of TUM whose depth images have these names.
fs::path tum_sequence(const TemporaryFolder& folder, const Texts& depth) {
  std::string colours, depths;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const std::string colour = "rgb/" + std::to_string(i) + ".png";
    colours += std::to_string(i) + " " + colour + "\n";
    depths += std::to_string(i) + " " + depth[i] + "\n";
    for (const std::string& file : {colour, depth[i]})
      fs::create_directories((folder.path() / "tum" / file).parent_path());
    write_image(folder.path() / "tum" / colour, cv::Mat(small_wall().size(), CV_8UC3, cv::Scalar(9, 8, 7)));
    write_image(folder.path() / "tum" / depth[i], small_wall());
  }
  folder.write("tum/rgb.txt", colours);
  folder.write("tum/depth.txt", depths);
  return folder.path() / "tum";
}

TEST_F(Convert, ScenesOfOneNameAreRefused) {
  expect_refused(convert(tum_sequence(folder, {"a/1.png", "b/1.png"}), "tum", {"--camera", camera}), 3,
                 {"b/1.png: has the same name as ", "a/1.png, '1'", "rename one"});
  expect_refused(convert(tum_sequence(folder, {"a/1.png", "a/1.png"}), "tum", {"--camera", camera}), 3,
                 {"a/1.png: is given twice"});
  expect_refused(convert(tum_sequence(folder, {"a/...png"}), "tum", {"--camera", camera}), 3,
                 {"...png: has the name '..'", "rename it"});
  for (const char* sequence : {"ocid/a_b/c", "ocid/a/b_c"}) {
    for (const char* kind : {"depth", "label", "rgb"}) fs::create_directories(folder.path() / sequence / kind);
    write_image(folder.path() / sequence / "depth" / "1.png", small_wall());
    write_image(folder.path() / sequence / "label" / "1.png", small_wall());
    write_image(folder.path() / sequence / "rgb" / "1.png", cv::Mat(small_wall().size(), CV_8UC3, cv::Scalar(9, 8, 7)));
  }
  expect_refused(convert(folder.path() / "ocid", "ocid", {"--camera", camera}), 3,
                 {"has the same name as ", "a_b_c_1"});
  folder.write("bop/scene_camera.json", R"({"0": {"cam_K": [75,0,39.5,0,75,29.5,0,0,1]},
                                           "000000": {"cam_K": [75,0,39.5,0,75,29.5,0,0,1]}})");
  fs::create_directories(folder.path() / "bop" / "depth");
  write_image(folder.path() / "bop" / "depth" / "000000.png", small_wall());
  expect_refused(convert(folder.path() / "bop", "bop"), 3, {"scene_camera.json: 0: has two cameras"});
  fs::create_directories(folder.path() / "bop" / "rgb");
  write_image(folder.path() / "bop" / "rgb" / "000000.png", cv::Mat(small_wall().size(), CV_8UC3, cv::Scalar(9, 8, 7)));
  for (const char* k : {"[75,9,39.5,0,75,29.5,0,0,1]", "[75,0,39.5,9,75,29.5,0,0,1]", "[75,0,39.5,0,75,29.5,0,0,2]"}) {
    folder.write("bop/scene_camera.json", std::string(R"({"0": {"cam_K": )") + k + "}}");
    expect_refused(convert(folder.path() / "bop", "bop"), 3, {"scene_camera.json: 0: cam_K "});
  }
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Convert, ListsMayBeginWithAMarkButHaveNoNul) {
  using namespace std::string_literals;
  const fs::path sequence = tum_sequence(folder, {"a/1.png"});
  const std::string list = content(sequence / "depth.txt");
  folder.write("tum/depth.txt", "\xef\xbb\xbf" + list);
  EXPECT_EQ(convert(sequence, "tum", {"--camera", camera}).code, 0);
  EXPECT_TRUE(fs::exists(out / "scenes" / "1" / "depth.png"));
  fs::remove_all(out);
  folder.write("tum/depth.txt", "# times\n" + list.substr(0, list.size() - 1) + "\0.png\n"s);
  expect_refused(convert(sequence, "tum", {"--camera", camera}), 3, {"depth.txt:2: contains a NUL character"});
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Convert, BadInputIsRefused) {
  expect_refused(convert(folder.path(), "osd"), 3, {"disparity", "OSD release"});
  expect_refused(convert(folder.path() / "nowhere", "pcd"), 3, {"nowhere", "does not exist"});
  expect_refused(convert(synthetic_scene(), "pcd"), 3, {"already a scene folder"});
  fs::remove_all(release / "disparity" / "test54.png");
  for (const char* kind : {"image_color", "annotation"}) fs::remove(release / kind / "test54.png");
  expect_refused(convert(release, "osd"), 3, {"learn25.png", "80x60", "--camera"});
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Convert, WrongUsageIsRefused) {
  EXPECT_EQ(convert(release, "zip").code, 2);
  EXPECT_EQ(convert(release, "osd", {"--labels", "objects"}).code, 2);
  EXPECT_EQ(run_gestalt({"convert", release, "--from", "osd"}).code, 2);
  EXPECT_FALSE(fs::exists(out));
}

/// A cloud of 2x2 points with labels.
std::string labelled_cloud(const std::string& labels) {
  std::string text =
      "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 2\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n";
  const std::vector<std::string> points{"-0.5 -0.5 1 ", "0.5 -0.5 1 ", "-0.5 0.5 1 ", "0.5 0.5 1 "};
  for (std::size_t i = 0; i < points.size(); ++i) text += points[i] + labels[i] + "\n";
  return text;
}

TEST_F(Convert, LabelledCloudsBecomeScenes) {
  folder.write("clouds/learn3.pcd", labelled_cloud("0112"));
  folder.write("clouds/mine.pcd", labelled_cloud("0111"));
  folder.write("clouds/camera.yaml", "width: 2\nheight: 2\nfx: 1\nfy: 1\ncx: 0.5\ncy: 0.5\n");
  expect_refused(convert(folder.path() / "clouds" / "mine.pcd", "pcd"), 3, {"mine.pcd", "--labels objects"});
  expect_success(convert(folder.path() / "clouds", "pcd", {"--labels", "objects"}));
  EXPECT_EQ(files_below(out),
            (std::vector<std::string>{"learn.csv", "learn/learn3/camera.yaml", "learn/learn3/depth.png",
                                      "learn/learn3/label.png", "scenes/mine/camera.yaml", "scenes/mine/depth.png",
                                      "scenes/mine/label.png"}));
  EXPECT_EQ(read_label_image(out / "learn" / "learn3" / "label.png")(1, 1), 30);
}

}  // namespace
}  // namespace gestalt::test
