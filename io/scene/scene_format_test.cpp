// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/scene_format.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/scene_path.h"
#include "gestalt/tests/environment/temporary_folder.h"

namespace gestalt {
namespace {

namespace fs = std::filesystem;

/// 4x3 pixels of a slope, with colour and labels.
ConvertedScene slope() {
  ConvertedScene scene;
  scene.camera = {4, 3, 4, 4, 1.5, 1};
  scene.images.depth = cv::Mat_<std::uint16_t>(3, 4);
  scene.images.label = cv::Mat_<std::uint16_t>(3, 4, std::uint16_t{20});
  scene.images.colour = cv::Mat(3, 4, CV_8UC3, cv::Scalar(10, 20, 30));
  for (int i = 0; i < 12; ++i) scene.images.depth(i / 4, i % 4) = std::uint16_t(1000 + 10 * i);
  return scene;
}

class SceneFormats : public testing::Test {
 protected:
  /// The scene of the format, with its camera where the format needs one beside.
  fs::path write(const SceneFormat& format) const {
    const fs::path folder = folder_.path() / format.name;
    if (!format.encode) {
      write_scene_folder(folder / "slope", slope().images, slope().camera);
      return folder / "slope";
    }
    if (format.camera != CameraPlace::scene) {
      fs::create_directories(folder);
      write_camera(slope().camera, folder);
    }
    return folder_.write(folder / ("slope" + format.extension), format.encode(slope()));
  }

  const test::TemporaryFolder folder_;
};

TEST_F(SceneFormats, EachIsFoundAndRead) {
  for (const SceneFormat& format : scene_formats()) {
    SCOPED_TRACE(format.name);
    if (format.name == "frame") continue;  // tests/formats/frames_test.py
    const fs::path scene = write(format);
    EXPECT_EQ(scene_format_of(scene), &format);
    EXPECT_EQ(find_scene_format(format.name), &format);
    EXPECT_EQ(find_scenes({scene.parent_path()}), std::vector<fs::path>{scene});
    EXPECT_EQ(find_scenes({scene}), std::vector<fs::path>{scene});
    const Input input = read_scene(scene);
    EXPECT_EQ(input.path, scene);
    EXPECT_EQ(input.frame.name, "slope");
    const ConvertedScene again = converted(input), expected = slope();
    EXPECT_EQ(cv::norm(again.images.depth, expected.images.depth, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(again.images.label, expected.images.label, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(again.images.colour, expected.images.colour, cv::NORM_INF), 0);
    EXPECT_EQ(again.objects, 1);
  }
}

TEST_F(SceneFormats, EachHasANameAndAnExtensionOfItsOwnAndWords) {
  std::set<std::string> names, extensions;
  for (const SceneFormat& format : scene_formats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_TRUE(format.extension.empty() || extensions.insert(format.extension).second) << format.extension;
    EXPECT_EQ(format.extension, lower_extension("x" + format.extension));
    EXPECT_EQ(format.extension.empty(), format.recognises != nullptr) << format.name;
    EXPECT_FALSE(format.summary.empty() || format.kind.empty()) << format.name;
  }
}

TEST_F(SceneFormats, FactsOfAFileAreToldWithoutReadingItAsAScene) {
  for (const SceneFormat& format : scene_formats()) {
    if (!format.facts) continue;
    const auto facts = format.facts(write(format), ReadOptions());
    EXPECT_FALSE(facts.value("kind", format.kind).empty()) << format.name;
    EXPECT_FALSE(facts.contains("camera_from")) << format.name;
  }
}

TEST_F(SceneFormats, MessagesNameEach) {
  std::string message;
  try {
    find_scenes({folder_.write("notes.txt", "x")});
  } catch (const InputError& error) {
    message = error.what();
  }
  for (const SceneFormat& format : scene_formats()) EXPECT_NE(message.find(format.extension), message.npos) << message;
  EXPECT_EQ(scene_extensions(" or "), ".pcd, .ply or .npz");
}

TEST_F(SceneFormats, TheDocumentNamesEach) {
  const std::string document = test::content(FORMATS_DOCUMENT);
  for (const SceneFormat& format : scene_formats()) {
    const std::string row =
        "\n| `" + format.name + "` | " + (format.extension.empty() ? "folder" : "`" + format.extension + "`") + " | ";
    EXPECT_NE(document.find(row), document.npos) << "docs/formats.md has no line '" << row.substr(1) << "'";
  }
}

}  // namespace
}  // namespace gestalt
