// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <sstream>

#include "gestalt/core/base/digest.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/scene/input.h"
#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::vector<std::string> result_files{"labels.png", "objects.png", "overlay.png", "patches.png", "result.json"};

cv::Mat image(const fs::path& file) { return cv::imread(file, cv::IMREAD_UNCHANGED); }

cv::Mat_<std::uint16_t> labels_in(const fs::path& result) { return image(result / "labels.png"); }

/// result.json without what a run's speed decides.
json result_in(const fs::path& result) {
  json all = json::parse(content(result / "result.json"));
  all.erase("milliseconds");
  return all;
}

bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

/// Every test has an empty folder for its results.
class Segment : public testing::Test {
 protected:
  Outcome segment(std::vector<std::string> arguments, const Surroundings& surroundings = {}) const {
    arguments.insert(arguments.begin(), "segment");
    arguments.insert(arguments.end(), {"--output", out});
    return run_gestalt(arguments, surroundings);
  }

  TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
};

TEST_F(Segment, WritesEveryResultOfAScene) {
  const Outcome outcome = segment({synthetic_scene()});
  expect_success(outcome);
  const fs::path result = out / "mixed_objects_1_000";
  EXPECT_TRUE(outcome.out.starts_with(result.string() + ": ")) << outcome.out;
  EXPECT_EQ(occurrences("\n", outcome.out), 1);
  EXPECT_EQ(files_below(result), result_files);
  const cv::Size size(320, 240);
  EXPECT_EQ(image(result / "labels.png").type(), CV_16UC1);
  for (const char* name : {"labels.png", "overlay.png", "patches.png"}) EXPECT_EQ(image(result / name).size(), size);
}

TEST_F(Segment, DebugImagesShowWhatEachLevelFound) {
  expect_success(segment({synthetic_scene(), "--debug-images"}));
  const fs::path result = out / "mixed_objects_1_000";
  std::vector<std::string> files = result_files;
  for (const char* name : {"graph.png", "lines.png", "normals.png", "signal_patches.png", "surfaces.png"})
    files.emplace_back(name);
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files_below(result), files);
  for (const char* name : {"normals.png", "signal_patches.png", "surfaces.png"})
    EXPECT_EQ(image(result / name).size(), cv::Size(320, 240)) << name;
  EXPECT_EQ(image(result / "graph.png").size(), cv::Size(640, 480));
  const cv::Mat lines = image(result / "lines.png");
  ASSERT_EQ(lines.type(), CV_8UC3);
  EXPECT_EQ(lines.size(), cv::Size(640, 480)) << "twice the frame's size";
  // The outer boundaries of objects before the table are drawn in green.
  cv::Mat green;
  cv::inRange(lines, cv::Scalar(0, 190, 0), cv::Scalar(140, 255, 140), green);
  EXPECT_GT(cv::countNonZero(green), 100);
}

TEST_F(Segment, LabelsAreTheSegmentsOfTheResult) {
  expect_success(segment({synthetic_scene()}));
  std::map<int, int> pixels;
  for (const std::uint16_t label : labels_in(out / "mixed_objects_1_000")) ++pixels[label];
  pixels.erase(0);
  const json segments = result_in(out / "mixed_objects_1_000").at("segments");
  ASSERT_GT(segments.size(), 5u);
  ASSERT_EQ(segments.size(), pixels.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    EXPECT_EQ(segments[i].at("label"), i + 1);
    EXPECT_EQ(segments[i].at("pixels"), pixels.at(int(i + 1)));
  }
}

TEST_F(Segment, SegmentsAreMadeOfThePatchesAndPairsOfTheResult) {
  expect_success(segment({synthetic_scene()}));
  const json result = result_in(out / "mixed_objects_1_000");
  const json &patches = result.at("patches"), &pairs = result.at("pairs");
  for (std::size_t i = 0; i < patches.size(); ++i) {
    EXPECT_EQ(patches[i].at("patch"), i);
    EXPECT_FALSE(patches[i].at("surface").empty());
  }
  std::set<std::size_t> used;
  for (const json& segment : result.at("segments")) {
    std::size_t pixels = 0;
    for (const std::size_t patch : segment.at("patches")) {
      EXPECT_TRUE(used.insert(patch).second) << "patch " << patch << " is in two segments";
      pixels += patches.at(patch).at("pixels").get<std::size_t>();
    }
    EXPECT_EQ(segment.at("pixels"), pixels);
  }
  EXPECT_EQ(used.size(), patches.size());

  const std::set<std::string> names{"r_co", "r_rs", "r_tr", "r_ga", "r_fo", "r_co3", "r_cu3", "r_di2", "r_vd2", "r_th"};
  const std::set<std::string> assembly_names{"r_co", "r_md", "r_nm", "r_ex", "r_go", "r_gl", "r_hb",
                                             "r_ho", "r_hn", "r_hh", "r_th", "r_cc", "r_cd", "r_sp"};
  ASSERT_FALSE(pairs.empty());
  std::set<std::string> levels;
  for (const json& pair : pairs) {
    EXPECT_LT(pair.at("a"), pair.at("b"));
    EXPECT_LT(pair.at("b"), patches.size());
    EXPECT_GE(pair.at("p"), 0.0);
    EXPECT_LE(pair.at("p"), 1.0);
    std::set<std::string> found;
    for (const auto& [name, value] : pair.at("relations").items()) {
      EXPECT_TRUE(value.is_number()) << name;
      found.insert(name);
    }
    levels.insert(pair.at("level"));
    EXPECT_EQ(found, pair.at("level") == "structural" ? names : assembly_names);
  }
  EXPECT_EQ(levels, (std::set<std::string>{"structural", "assembly"}));
}

TEST_F(Segment, WarnsOfAModelTrainedWithOtherParameters) {
  const Outcome outcome = segment({synthetic_scene(), "--set", "structural.minimum_size=40"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(occurrences("warning", outcome.err), 1) << outcome.err;
  EXPECT_EQ(occurrences("default.json", outcome.err), 1) << outcome.err;
}

TEST_F(Segment, TheResultTellsHowItWasMade) {
  expect_success(segment({synthetic_scene(), "--set", "decision.solver.params.assembly_weight=0.9"}));
  const json result = json::parse(content(out / "mixed_objects_1_000" / "result.json"));
  const Camera camera = read_camera(synthetic_scenes() / "camera.yaml").camera;
  EXPECT_EQ(result.at("scene"), "mixed_objects_1_000");
  EXPECT_EQ(result.at("input"), synthetic_scene().string());
  EXPECT_EQ(result.at("camera"), (json{{"width", 320},
                                       {"height", 240},
                                       {"fx", camera.fx},
                                       {"fy", camera.fy},
                                       {"cx", camera.cx},
                                       {"cy", camera.cy}}));
  double sum = 0;
  for (const char* level : {"signal", "primitive", "structural", "assembly", "decision"}) {
    EXPECT_GE(result.at("milliseconds").at(level), 0.0);
    sum += result.at("milliseconds").at(level).get<double>();
  }
  EXPECT_NEAR(result.at("milliseconds").at("total"), sum, 1e-6);
  EXPECT_EQ(result.at("config").at("values").at("decision").at("solver").at("params").at("assembly_weight"), 0.9);
  const json& provenance = result.at("config").at("provenance");
  EXPECT_EQ(provenance.at("decision.solver.params.assembly_weight"), "--set");
  EXPECT_GT(occurrences("default.yaml:", provenance.at("decision.solver.plugin")), 0) << provenance.dump(1);
  EXPECT_FALSE(result.at("gestalt").get<std::string>().empty());
  EXPECT_FALSE(result.at("build").get<std::string>().empty());
}

TEST_F(Segment, OptionsSayWhatIsBackground) {
  const auto objects = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{synthetic_scene()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_success(segment(arguments));
    return cv::countNonZero(image(out / "mixed_objects_1_000" / "objects.png"));
  };
  const auto value = [&](const char* section, const char* key) {
    const json values = result_in(out / "mixed_objects_1_000").at("config").at("values");
    return values.at(json::json_pointer(section)).at(key);
  };
  EXPECT_GT(objects({}), 0);
  EXPECT_EQ(objects({"--max-depth", "0.2"}), 0);
  EXPECT_EQ(value("/decision/figure_ground", "max_depth"), 0.2);
  EXPECT_EQ(objects({"--min-object", "100000"}), 0);
  EXPECT_GT(objects({"--min-object", "100000", "--set", "decision.figure_ground.min_object=1"}), 0);
  objects({"--sensor", "realsense"});
  EXPECT_EQ(value("/sensor", "noise"), "realsense");
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--max-depth", "-1"}, std::vector<std::string>{"--sensor", "kinect_v9"}}) {
    const Outcome outcome = segment({synthetic_scene(), wrong[0], wrong[1]});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(occurrences(wrong[0] + ":", outcome.err), 1) << outcome.err;
    EXPECT_GT(occurrences(wrong[1] + " not in", outcome.err) + occurrences("'-1' is not a number from 0", outcome.err),
              0)
        << outcome.err;
  }
}

TEST_F(Segment, TheTableIsOneSegment) {
  expect_success(segment({synthetic_scene()}));
  const cv::Mat_<std::uint16_t> labels = labels_in(out / "mixed_objects_1_000");
  const cv::Mat truth = image(synthetic_scene() / "label.png"), depth = image(synthetic_scene() / "depth.png");
  const cv::Mat table = (truth > 0) & (truth < 10) & (depth > 0), first = labels == 1;
  EXPECT_GT(cv::countNonZero(table & first), 0.95 * cv::countNonZero(table));
  EXPECT_GT(cv::countNonZero(table & first), 0.95 * cv::countNonZero(first));
}

TEST_F(Segment, TakesAFolderOfScenesAndSeveralInputs) {
  expect_success(segment({synthetic_scenes()}));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(files_below(out / synthetic_scene(i).filename()), result_files);
  fs::remove_all(out);
  const Outcome outcome = segment({synthetic_scene(3), synthetic_scene(1).string() + "/"});
  expect_success(outcome);
  EXPECT_LT(outcome.out.find("mixed_objects_1_003"), outcome.out.find("mixed_objects_1_001")) << outcome.out;
  EXPECT_EQ(files_below(out).size(), 2 * result_files.size());
}

TEST_F(Segment, IsEqualForAnyNumberOfThreadsAndAnyRun) {
  struct Run {
    const char* name;
    const char* threads;
  };
  constexpr std::array runs{Run{"one", "1"}, Run{"eight", "8"}, Run{"again", "8"}};
  for (const auto& [name, threads] : runs)
    expect_success(run_gestalt({"segment", synthetic_scenes(), "--output", out / name, "--threads", threads}));
  for (int i = 0; i < 4; ++i)
    for (const char* name : {"eight", "again"}) {
      const fs::path scene = synthetic_scene(i).filename();
      for (const char* file : {"labels.png", "overlay.png", "patches.png"})
        EXPECT_EQ(content(out / name / scene / file), content(out / "one" / scene / file)) << file;
      EXPECT_EQ(result_in(out / name / scene), result_in(out / "one" / scene));
    }
}

TEST_F(Segment, ACloudOfTheSameViewGivesTheSameSegments) {
  const auto points = points_of(synthetic_scene());
  const fs::path cloud = folder.write("view.pcd", pcd(points, 320, 240));
  expect_success(segment({cloud, synthetic_scene(), "--camera", synthetic_scenes() / "camera.yaml"}));
  EXPECT_EQ(files_below(out / "view"), result_files);
  EXPECT_TRUE(equal(labels_in(out / "view"), labels_in(out / "mixed_objects_1_000")));
}

TEST_F(Segment, FitsTheCameraOfAnOrganizedCloudThatComesWithoutOne) {
  const fs::path cloud = folder.write("view.pcd", pcd(points_of(synthetic_scene()), 320, 240));
  expect_success(segment({cloud}));
  const json camera = result_in(out / "view").at("camera");
  const Camera truth = read_camera(synthetic_scenes() / "camera.yaml").camera;
  EXPECT_NEAR(camera.at("fx"), truth.fx, 0.1);
  EXPECT_NEAR(camera.at("cy"), truth.cy, 0.1);
}

/// x y z label of a binary PCD as Gestalt writes it.
struct LabelledPoint {
  std::array<float, 3> position;
  std::uint32_t label;
};

std::vector<LabelledPoint> labelled_points(const fs::path& file) {
  const std::string bytes = content(file), end = "DATA binary\n";
  EXPECT_GT(occurrences("FIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\n", bytes), 0) << bytes.substr(0, 200);
  const std::size_t body = bytes.find(end) + end.size();
  std::vector<LabelledPoint> points((bytes.size() - body) / sizeof(LabelledPoint));
  EXPECT_EQ(points.size() * sizeof(LabelledPoint), bytes.size() - body);
  std::memcpy(points.data(), bytes.data() + body, points.size() * sizeof(LabelledPoint));
  return points;
}

TEST_F(Segment, EveryPointOfAnUnorganizedCloudGetsTheLabelOfItsPixel) {
  const auto grid = points_of(synthetic_scene());
  std::vector<CloudPoint> points;
  std::vector<int> pixels;
  for (int i = int(grid.size()) - 1; i >= 0; --i)
    if (grid[std::size_t(i)].position[2] > 0) {
      points.push_back(grid[std::size_t(i)]);
      pixels.push_back(i);
    }
  points.push_back({points[0].position * 2.0f, 0});  // hidden behind the first one
  pixels.push_back(pixels[0]);
  points.push_back({{0, 0, -1}, 0});  // behind the camera
  pixels.push_back(-1);
  const fs::path cloud = folder.write("points.pcd", pcd(points, int(points.size()), 1));
  expect_success(segment({cloud, "--camera", synthetic_scenes() / "camera.yaml"}));

  const cv::Mat_<std::uint16_t> labels = labels_in(out / "points");
  const auto labelled = labelled_points(out / "points" / "labels.pcd");
  ASSERT_EQ(labelled.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(labelled[i].position[std::size_t(axis)], points[i].position[axis]) << i;
    EXPECT_EQ(labelled[i].label, pixels[i] < 0 ? 0 : labels.ptr<std::uint16_t>()[pixels[i]]) << i;
  }
}

TEST_F(Segment, ColourIsNotNeededByAConfigWithoutColourRelations) {
  const fs::path scenes = folder.path() / "scenes";
  fs::copy(synthetic_scenes(), scenes, fs::copy_options::recursive);
  for (int i = 0; i < 4; ++i) fs::remove(scenes / synthetic_scene(i).filename() / "rgb.png");
  const fs::path scene = scenes / "mixed_objects_1_000";
  expect_refused(segment({scene, "--config", "default.yaml"}), 3,
                 {"mixed_objects_1_000", "no colour", "colour_histogram", "rgb.png"});
  EXPECT_EQ(files_below(out), std::vector<std::string>{});

  const fs::path config = folder.write("shape.yaml",
                                       "schema_version: 1\n"
                                       "signal: {clusterer: normals}\n"
                                       "primitive: {fitters: [plane]}\n"
                                       "structural:\n"
                                       "  relations: [relative_size, border_curvature, border_depth]\n"
                                       "  classifier: svm\n"
                                       "model: shape.json\n"
                                       "decision: {solver: graph_cut}\n");
  expect_refused(segment({scene, "--config", config}), 2, {"shape.json", "gestalt train"});
  expect_success(run_gestalt({"train", scenes, "--config", config, "--output", folder.path() / "shape.json"}));
  expect_success(segment({scene, "--config", config}));
  EXPECT_EQ(files_below(out / "mixed_objects_1_000"), result_files);
  EXPECT_EQ(image(out / "mixed_objects_1_000" / "overlay.png").size(), cv::Size(320, 240));
  EXPECT_EQ(result_in(out / "mixed_objects_1_000").at("pairs").at(0).at("relations").size(), 5u);
}

TEST_F(Segment, ASceneThatFailsDoesNotStopTheOthers) {
  const fs::path scenes = folder.path() / "scenes";
  fs::copy(synthetic_scenes(), scenes, fs::copy_options::recursive);
  truncate(scenes / "mixed_objects_1_001" / "depth.png", 0.5);
  const Outcome outcome = segment({scenes});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(occurrences("gestalt: error: ", outcome.err), 1) << outcome.err;
  EXPECT_EQ(occurrences("mixed_objects_1_001/depth.png: is truncated", outcome.err), 1) << outcome.err;
  EXPECT_EQ(occurrences("1 of 4 scenes failed", outcome.err), 1) << outcome.err;
  EXPECT_EQ(occurrences("\n", outcome.out), 3) << outcome.out;
  EXPECT_EQ(files_below(out).size(), 3 * result_files.size());
  EXPECT_FALSE(fs::exists(out / "mixed_objects_1_001"));
}

TEST_F(Segment, LinesAndErrorsAreInTheOrderOfTheScenes) {
  // Slow scenes before fast ones, which are done first, and one that fails at once.
  std::vector<std::string> scenes;
  for (int i = 0; i < 4; ++i) {
    scenes.push_back(synthetic_scene(i));
    scenes.push_back(write_scene(folder.path() / ("wall" + std::to_string(i)), small_wall()));
  }
  truncate(scenes[3] + "/depth.png", 0.5);
  const Outcome outcome = segment(joined(scenes, {"--threads", "4"}));
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(occurrences("wall1/depth.png: is truncated", outcome.err), 1) << outcome.err;
  std::string names;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);)
    names += fs::path(line.substr(0, line.find(": "))).filename().string() + " ";
  EXPECT_EQ(names,
            "mixed_objects_1_000 wall0 mixed_objects_1_001 mixed_objects_1_002 wall2 mixed_objects_1_003 wall3 ");
}

TEST_F(Segment, NothingIsWrittenWhenAResultCannotBe) {
  fs::create_directories(out / "mixed_objects_1_000" / "result.json");
  expect_refused(segment({synthetic_scene()}), 1, {(out / "mixed_objects_1_000" / "result.json").string(), "--output"});
  EXPECT_EQ(files_below(out), std::vector<std::string>{});
}

TEST_F(Segment, TheOutputMustBeAFolder) {
  folder.write("out", "a file");
  expect_refused(segment({synthetic_scene()}), 1, {out.string(), "cannot be written", "--output"});
  EXPECT_EQ(content(out), "a file");
  expect_refused(run_gestalt({"segment", synthetic_scene(), "--output", "/proc/gestalt"}), 1,
                 {"/proc/gestalt", "cannot be written"});
}

TEST_F(Segment, TheOutputMayBeTheFolderOfTheScenes) {
  fs::create_directory(out);
  fs::copy(synthetic_scene(), out / "scene", fs::copy_options::recursive);
  fs::copy(synthetic_scenes() / "camera.yaml", out);
  const std::string truth = content(out / "scene" / "label.png");
  expect_success(segment({out}));
  expect_success(segment({out}));
  EXPECT_EQ(files_below(out / "scene"),
            (std::vector<std::string>{"depth.png", "label.png", "labels.png", "objects.json", "objects.png",
                                      "overlay.png", "patches.png", "result.json", "rgb.png"}));
  EXPECT_EQ(content(out / "scene" / "label.png"), truth);
}

TEST_F(Segment, TwoScenesOfOneNameAreRefused) {
  expect_refused(segment({synthetic_scene(), synthetic_scene().string() + "/"}), 3, {"same name"});
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Segment, ASceneMayHaveAnyName) {
  for (const std::string name : {"two words", "q'uo\"te;$x", "gr\xc3\xbcn", "no\xff utf8", "-dash", "dot.ted.pcd"}) {
    fs::copy(synthetic_scene(), folder.path() / name, fs::copy_options::recursive);
    fs::copy(synthetic_scenes() / "camera.yaml", folder.path() / name);
    expect_success(segment({folder.path() / name}));
    EXPECT_EQ(files_below(out / name), result_files) << name;
    EXPECT_FALSE(result_in(out / name).at("scene").get<std::string>().empty());
  }
}

// A stranger's scenes, with links among them, may lie where the results go.
TEST_F(Segment, LinksBelowTheOutputFolderAreNotFollowed) {
  const fs::path scene = folder.path() / "scenes" / "a", mine = folder.write("mine.txt", "mine");
  fs::create_directory(folder.path() / "scenes");
  fs::copy(synthetic_scene(), scene, fs::copy_options::recursive);
  fs::copy(synthetic_scenes() / "camera.yaml", scene);
  for (const char* name : {"labels.png", "result.json"}) fs::create_symlink(mine, scene / name);
  expect_success(run_gestalt({"segment", scene, "--output", folder.path() / "scenes"}));
  EXPECT_EQ(content(mine), "mine");
  for (const char* name : {"labels.png", "result.json"}) EXPECT_FALSE(fs::is_symlink(scene / name)) << name;

  fs::create_directory(out);
  fs::create_directory(folder.path() / "elsewhere");
  fs::create_directory_symlink(folder.path() / "elsewhere", out / "a");
  expect_refused(segment({scene}), 1, {"a: is a symbolic link", "outside the output folder"});
  EXPECT_EQ(files_below(folder.path() / "elsewhere"), Texts{});
}

TEST_F(Segment, AnInterruptedRunLeavesWholeScenesOnly) {
  constexpr int count = 40;  // enough to be interrupted in
  fs::create_directories(folder.path() / "scenes");
  fs::copy(synthetic_scenes() / "camera.yaml", folder.path() / "scenes");
  for (int i = 0; i < count; ++i)
    fs::create_directory_symlink(synthetic_scene(), folder.path() / "scenes" / std::to_string(i));
  const Outcome outcome = segment({folder.path() / "scenes"}, {.interrupt_after = out / "1" / "result.json"});
  EXPECT_EQ(outcome.code, 128 + SIGINT) << outcome.err;
  EXPECT_EQ(files_below(out / "1"), result_files);
  EXPECT_FALSE(fs::exists(out / std::to_string(count - 1)));
  for (int i = 0; i < count; ++i) {
    const fs::path result = out / std::to_string(i);
    for (const char* name : {"labels.png", "overlay.png", "patches.png"})
      if (fs::exists(result / name)) {
        EXPECT_EQ(image(result / name).size(), cv::Size(320, 240));
      }
    if (fs::exists(result / "result.json")) {
      EXPECT_FALSE(result_in(result).empty());
    }
  }
}

TEST_F(Segment, FailsWhenStandardOutputIsFull) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const Outcome outcome = segment({synthetic_scene()}, {.standard_output = "/dev/full"});
  expect_refused(outcome, 1, {"standard output"});
}

// They would look as if they were of the run whose result.json lies beside them.
TEST_F(Segment, FilesOfAnEarlierRunWithOtherOptionsAreRemoved) {
  expect_success(segment({synthetic_scene(), "--debug-images", "--also", "pcd,ply,coco"}));
  const fs::path results = out / synthetic_scene().filename();
  for (const std::string& file : files_below(results)) EXPECT_TRUE(result_names().contains(file)) << file;
  std::ofstream(results / "coco.json") << "changed by hand";
  std::ofstream(results / "notes.txt") << "mine";
  expect_success(segment({synthetic_scene()}));
  EXPECT_EQ(files_below(results), (Texts{"coco.json", "labels.png", "notes.txt", "objects.png", "overlay.png",
                                         "patches.png", "result.json"}));
}

// The result.json of a stranger's scene may name what is not of results.
TEST_F(Segment, AnOldResultRemovesNoOtherFile) {
  const fs::path scene = folder.path() / "scene";
  fs::copy(synthetic_scene(), scene);
  fs::copy(synthetic_scenes() / "camera.yaml", scene / "camera.yaml");
  std::ofstream(scene / "result.json") << json{
      {"format", "gestalt-result"}, {"version", 2}, {"files", {{"label.png", file_digest(scene / "label.png")}}}};
  expect_success(run_gestalt({"segment", scene, "--output", folder.path()}));
  EXPECT_TRUE(fs::exists(scene / "label.png"));
}

// As ground truth, which coco.json is in a scene's own folder, a result would score 100 %.
TEST_F(Segment, InstancesAreNotWrittenAmongTheFilesOfTheScene) {
  const fs::path scene = folder.path() / "scene";
  fs::copy(synthetic_scene(), scene);
  fs::copy(synthetic_scenes() / "camera.yaml", scene / "camera.yaml");
  expect_refused(run_gestalt({"segment", scene, "--output", folder.path(), "--also", "coco"}), 1,
                 {"coco.json", "ground truth", "--output"});
  EXPECT_FALSE(fs::exists(scene / "coco.json"));
}

}  // namespace
}  // namespace gestalt::test
