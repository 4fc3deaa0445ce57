// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <unistd.h>

#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;

/// A scene folder `scene` that is sound until a test spoils it, and an output folder that must stay empty.
class BadInput : public testing::Test {
 protected:
  void SetUp() override { write_scene(scene, small_wall()); }

  Outcome segment(const fs::path& input, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"segment", input, "--output", out};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_gestalt(arguments);
  }

  /// Expects that the input is refused with one message, and that nothing is written.
  void refuse(const fs::path& input, int code, const std::vector<std::string>& words,
              const std::vector<std::string>& options = {}) const {
    expect_refused(segment(input, options), code, words);
    EXPECT_EQ(files_below(out), std::vector<std::string>{});
  }

  void set_camera(const std::string& text) const { std::ofstream(scene / "camera.yaml") << text; }

  /// An organized cloud of the wall, as ASCII, with one of its header's lines replaced.
  fs::path cloud_with(const std::string& line, const std::string& replacement) const {
    std::string text =
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\n"
        "POINTS 6\nDATA ascii\n0 0 1\n1 0 1\n2 0 1\n0 1 1\n1 1 1\n2 1 1\n";
    text.replace(text.find(line), line.size(), replacement);
    return folder.write("cloud.pcd", text);
  }

  TemporaryFolder folder;
  const fs::path scene = folder.path() / "scene", out = folder.path() / "out";
};

TEST_F(BadInput, TheSoundSceneIsSegmented) {
  expect_success(segment(scene));
  const cv::Mat labels = cv::imread(out / "scene" / "labels.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(labels.size(), cv::Size(small_width, small_height));
  EXPECT_EQ(labels.at<std::uint16_t>(30, 40), 1);
}

TEST_F(BadInput, WhatDoesNotExist) {
  refuse(folder.path() / "nothing", 3, {"nothing", "does not exist"});
  refuse(folder.path() / "nothing.pcd", 3, {"nothing.pcd", "does not exist"});
}

TEST_F(BadInput, WhatIsNoScene) {
  refuse(folder.write("notes.txt", "hello"), 3, {"notes.txt", "not a scene", ".pcd"});
  refuse(scene / "rgb.png", 3, {"rgb.png", "no depth image", "--depth"});
}

TEST_F(BadInput, ANameThatWouldLeaveTheOutputFolder) {
  const fs::path stranger = folder.path() / "stranger";
  fs::create_directory(stranger);
  folder.write("stranger/...pcd", pcd({{{0, 0, 1}, 0}}, 1, 1));
  fs::copy(scene / "camera.yaml", stranger);
  refuse(stranger, 3, {"contains no scene"});  // files whose names begin with a dot are passed over
  refuse(stranger / "...pcd", 3, {"...pcd", "has the name '..'", "rename it"});
  EXPECT_EQ(files_below(stranger).size(), 2u);
}

TEST_F(BadInput, FilesThatWouldFillTheMemory) {
  const auto grow = [&](const fs::path& file) {
    std::ofstream(file, std::ios::app).close();
    fs::resize_file(file, std::uintmax_t{1} << 33);  // takes no room on the disk
    return file;
  };
  for (const char* name : {"a.pcd", "a.ply", "a.npz"})
    refuse(grow(folder.path() / name), 3, {name, "8589934592 bytes"}, {"--camera", scene / "camera.yaml"});
  for (const char* name : {"depth.png", "rgb.png", "camera.yaml"}) {
    const fs::path spoilt = folder.path() / "spoilt";
    fs::copy(scene, spoilt);
    grow(spoilt / name);
    refuse(spoilt, 3, {name, "8589934592 bytes"});
    fs::remove_all(spoilt);
  }
  for (const char* name : {"a.json", "a.yaml"})
    expect_refused(run_gestalt({"info", grow(folder.path() / name)}), 3, {name, "8589934592 bytes"});
  refuse(scene, 2, {"a.json", "8589934592 bytes"}, {"--set", "model=" + (folder.path() / "a.json").string()});
}

TEST_F(BadInput, EmptyFolder) {
  fs::create_directory(folder.path() / "empty");
  refuse(folder.path() / "empty", 3, {"empty", "contains no scene", "depth.png"});
}

TEST_F(BadInput, UnreadableFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "root can read every file";
  fs::permissions(scene / "depth.png", fs::perms::none);
  refuse(scene, 3, {(scene / "depth.png").string(), "Permission denied"});
}

TEST_F(BadInput, UnwritableOutput) {
  if (::geteuid() == 0) GTEST_SKIP() << "root can write to every folder";
  fs::create_directory(out);
  fs::permissions(out, fs::perms::owner_read | fs::perms::owner_exec);
  refuse(scene, 1, {out.string(), "Permission denied", "--output"});
}

TEST_F(BadInput, MissingDepth) {
  fs::remove(scene / "depth.png");
  refuse(scene, 3,
         {scene.string(), "camera.yaml and rgb.png are there, but no depth image", "depth.png", "16-bit grey"});
}

TEST_F(BadInput, EmptyFile) {
  fs::resize_file(scene / "depth.png", 0);
  refuse(scene, 3, {(scene / "depth.png").string(), "empty"});
}

TEST_F(BadInput, TruncatedImages) {
  truncate(scene / "rgb.png", 0.7);
  refuse(scene, 3, {(scene / "rgb.png").string(), "truncated", "at byte"});
  truncate(scene / "depth.png", 0.5);
  refuse(scene, 3, {(scene / "depth.png").string(), "truncated", "at byte"});
}

TEST_F(BadInput, WhatOnlyHasTheNameOfAnImage) {
  std::ofstream(scene / "depth.png") << "not an image, however long the text may be";
  refuse(scene, 3, {(scene / "depth.png").string(), "is not an image that can be read", "PNG"});
}

TEST_F(BadInput, ColourOfAnotherSize) {
  write_image(scene / "rgb.png", cv::Mat(40, 40, CV_8UC3, cv::Scalar(1, 2, 3)));
  refuse(scene, 3, {(scene / "rgb.png").string(), "40x40", "80x60", "camera_color.yaml"});
}

TEST_F(BadInput, DepthOf8Bits) {
  write_image(scene / "depth.png", cv::Mat(small_height, small_width, CV_8UC1, cv::Scalar(100)));
  refuse(scene, 3, {(scene / "depth.png").string(), "8-bit", "16-bit", "depth_scale"});
}

TEST_F(BadInput, DepthInColours) {
  write_image(scene / "depth.png", cv::Mat(small_height, small_width, CV_16UC3, cv::Scalar(100, 100, 100)));
  refuse(scene, 3, {(scene / "depth.png").string(), "RGB", "16-bit grey"});
}

TEST_F(BadInput, DepthOfFloatsInColours) {
  fs::remove(scene / "depth.png");
  cv::imwrite(scene / "depth.tiff", cv::Mat(small_height, small_width, CV_32FC3, cv::Scalar(1, 1, 1)));
  fs::rename(scene / "depth.tiff", scene / "depth.png");
  refuse(scene, 3, {(scene / "depth.png").string(), "is float colour", "16-bit grey", "depth_scale"});
}

TEST_F(BadInput, NoValidDepth) {
  write_image(scene / "depth.png", cv::Mat_<std::uint16_t>::zeros(small_height, small_width));
  refuse(scene, 3, {(scene / "depth.png").string(), "no pixel has a measurement"});
}

TEST_F(BadInput, OneValidPixelIsSegmented) {
  cv::Mat_<std::uint16_t> depth = cv::Mat_<std::uint16_t>::zeros(small_height, small_width);
  depth(20, 30) = 900;
  write_image(scene / "depth.png", depth);
  expect_success(segment(scene));
  EXPECT_EQ(files_below(out / "scene").size(), 5u);
}

TEST_F(BadInput, OnePixelIsSegmented) {
  write_scene(scene, cv::Mat_<std::uint16_t>(1, 1, std::uint16_t{1000}));
  set_camera("width: 1\nheight: 1\nfx: 75\nfy: 75\ncx: 0\ncy: 0\n");
  expect_success(segment(scene));
  EXPECT_EQ(cv::imread(out / "scene" / "labels.png", cv::IMREAD_UNCHANGED).size(), cv::Size(1, 1));
}

TEST_F(BadInput, NoCamera) {
  fs::remove(scene / "camera.yaml");
  refuse(scene, 3, {scene.string(), "camera.yaml", "--camera", "--fx"});
  refuse(scene, 3, {"none.yaml", "does not exist"}, {"--camera", folder.path() / "none.yaml"});
  refuse(scene, 3, {"the given camera: its principal point (100, 29.5) lies outside"},
         {"--fx", "75", "--cx", "100", "--cy", "29.5"});
  expect_success(segment(scene, {"--fx", "75", "--cx", "39.5", "--cy", "29.5"}));
}

TEST_F(BadInput, IntrinsicsThatAreZeroNegativeOrNoNumber) {
  for (const char* fx : {"0", "-75", ".nan", ".inf", "wide"}) {
    set_camera(small_camera(fx));
    refuse(scene, 3, {(scene / "camera.yaml").string() + ":3:5", "fx", "focal length"});
  }
}

TEST_F(BadInput, IntrinsicsThatDoNotFitTheImage) {
  set_camera("width: 40\nheight: 40\nfx: 75\nfy: 75\ncx: 19.5\ncy: 14.5\n");
  refuse(scene, 3, {(scene / "camera.yaml").string(), "40x40", "80x60"});
  set_camera("width: 80\nheight: 60\nfx: 75\nfy: 75\ncx: 500\ncy: 29.5\n");
  refuse(scene, 3, {(scene / "camera.yaml").string() + ":5:5", "cx"});
}

TEST_F(BadInput, AllErrorsOfACameraFileAreToldTogether) {
  set_camera("width: 80\nheight: 60\nfx: 0\nfz: 75\ncx: 39.5\n");
  refuse(scene, 3, {"camera.yaml:3:5", "camera.yaml:4:1", "'fz'", "fy", "cy"});
}

TEST_F(BadInput, CloudsWithAWrongHeader) {
  refuse(cloud_with("VERSION 0.7", "VERSION 9"), 3, {"cloud.pcd:1: ", "0.7"});
  refuse(cloud_with("FIELDS x y z", "FIELDS x y q"), 3, {"cloud.pcd: ", "'z'"});
  refuse(cloud_with("SIZE 4 4 4", "SIZE 4 4"), 3, {"cloud.pcd:3: ", "SIZE"});
  refuse(cloud_with("TYPE F F F", "TYPE F F Q"), 3, {"cloud.pcd:4: ", "'Q'"});
  refuse(cloud_with("WIDTH 3", "WIDTH -3"), 3, {"cloud.pcd:6: ", "WIDTH"});
  refuse(cloud_with("WIDTH 3", "WIDTH 99999999999"), 3, {"cloud.pcd:6: ", "WIDTH"});
  refuse(cloud_with("POINTS 6", "POINTS 7"), 3, {"cloud.pcd:9: ", "POINTS"});
  refuse(cloud_with("DATA ascii", "DATA morse"), 3, {"cloud.pcd:10: ", "DATA"});
  refuse(folder.write("noise.pcd", std::string(5000, '\x80')), 3, {"noise.pcd", "header"});
}

TEST_F(BadInput, CloudsWithShortData) {
  refuse(cloud_with("2 1 1\n", ""), 3, {"cloud.pcd"});
  const fs::path binary = folder.write("binary.pcd", pcd(points_of(scene), small_width, small_height));
  truncate(binary, 0.9);
  refuse(binary, 3, {"binary.pcd"});
}

TEST_F(BadInput, ACloudWithoutAnyPoint) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<CloudPoint> points(std::size_t(small_width * small_height), CloudPoint{{none, none, none}, 0});
  refuse(folder.write("void.pcd", pcd(points, small_width, small_height)), 3, {"void.pcd"});
}

TEST_F(BadInput, AnUnorganizedCloudWithoutItsCamera) {
  const auto points = points_of(scene);
  const fs::path few = folder.write("points.pcd", pcd({points.begin(), points.begin() + 500}, 500, 1));
  refuse(few, 3, {few.string(), "unorganized", "--camera"});
  const fs::path cloud = folder.write("points.pcd", pcd(points, small_width * small_height, 1));
  expect_success(segment(cloud, {"--camera", scene / "camera.yaml"}));
}

TEST_F(BadInput, AnUnorganizedCloudOutsideItsCamera) {
  auto points = points_of(scene);
  for (CloudPoint& point : points) point.position[0] += 100;
  const fs::path cloud = folder.write("points.pcd", pcd(points, small_width * small_height, 1));
  refuse(cloud, 3, {cloud.string(), "camera.yaml"}, {"--camera", scene / "camera.yaml"});
}

TEST_F(BadInput, ConfigsThatAreWrong) {
  refuse(scene, 2, {"none.yaml"}, {"--config", folder.path() / "none.yaml"});
  refuse(scene, 2, {"broken.yaml:2:"}, {"--config", folder.write("broken.yaml", "schema_version: 1\n  a: [b\n")});
  refuse(scene, 2, {"structural.minimum_sise", "did you mean 'minimum_size'?"},
         {"--set", "structural.minimum_sise=50"});
  refuse(scene, 2, {"structural.minimum_size", "[1, 1000000]", "'0'"}, {"--set", "structural.minimum_size=0"});
  refuse(scene, 2, {"structural.minimum_size", "'many'"}, {"--set", "structural.minimum_size=many"});
}

TEST_F(BadInput, AMissingPlugin) {
  const fs::path config = folder.write("own.yaml",
                                       "schema_version: 1\n"
                                       "plugin_directories: [own]\n"
                                       "signal: {clusterer: norm_als}\n"
                                       "primitive: {fitters: [plane]}\n"
                                       "structural: {relations: [relative_size], classifier: svm}\n"
                                       "decision: {solver: graph_cut}\n");
  refuse(scene, 2, {"own.yaml:3:21", "norm_als", "did you mean 'normals'?"}, {"--config", config});
}

TEST_F(BadInput, APluginForAnotherInterface) {
  const fs::path library = fs::path(BROKEN_PLUGINS) / "old_interface" / "old_interface.so";
  ASSERT_TRUE(fs::exists(library)) << library << " is not built";
  const fs::path config = folder.write("old.yaml",
                                       "schema_version: 1\n"
                                       "plugin_directories: [" +
                                           library.parent_path().string() +
                                           "]\n"
                                           "signal: {clusterer: normals}\n"
                                           "primitive: {fitters: [plane]}\n"
                                           "structural: {relations: [relative_size], classifier: svm}\n"
                                           "decision: {solver: one_group}\n");
  refuse(scene, 2, {"old.yaml:6:20", "one_group", library.string(), "interface 0"}, {"--config", config});
  const Outcome list = run_gestalt({"plugins", "list", "--config", config});
  expect_success(list);
  EXPECT_GT(occurrences(library.string() + ": ", list.out), 0) << list.out;
}

TEST_F(BadInput, ModelsThatCannotBeUsed) {
  const auto with = [](const fs::path& model) { return std::vector<std::string>{"--set", "model=" + model.string()}; };
  refuse(scene, 2, {"none.json", "gestalt train"}, with(folder.path() / "none.json"));
  refuse(scene, 2, {"noise.json:1:1: ", "not a model"}, with(folder.write("noise.json", "\x01\x02\x03")));
  refuse(scene, 2, {"empty.json"}, with(folder.write("empty.json", "")));
  refuse(scene, 2, {"other.json", "not a model"}, with(folder.write("other.json", "{\"format\": \"other\"}")));
  refuse(scene, 2, {"names no model"}, {"--set", "model=none"});
  const fs::path model = folder.path() / "cut.json";
  expect_success(run_gestalt({"train", synthetic_scenes(), "--output", model}));
  truncate(model, 0.5);
  refuse(scene, 2, {"cut.json:1:", "gestalt train"}, with(model));
}

TEST_F(BadInput, SynthesisThatCannotBeWritten) {
  const fs::path file = folder.write("file", "content");
  expect_refused(run_gestalt({"synthesize", "--category", "boxes", "--width", "160", "--height", "120", "--output",
                              file / "scenes"}),
                 1, {file.string(), "cannot be written"});
  EXPECT_EQ(content(file), "content");
}

}  // namespace
}  // namespace gestalt::test
