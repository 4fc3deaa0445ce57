// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "gestalt/io/scene/scene_format.h"
#include "gestalt/tests/environment/temporary_folder.h"
#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(Usage, HelpAndVersion) {
  const Outcome version = run_gestalt({"--version"});
  expect_success(version);
  EXPECT_TRUE(version.out.starts_with("gestalt 0.")) << version.out;
  for (const char* library : {"compiler", "Eigen", "OpenCV", "oneTBB", "Boost", "yaml-cpp", "interface"})
    EXPECT_GT(occurrences(library, version.out), 0) << version.out;
  for (const std::vector<std::string>& command : {std::vector<std::string>{},
                                                  {"segment"},
                                                  {"stream"},
                                                  {"train"},
                                                  {"evaluate"},
                                                  {"ablate"},
                                                  {"reproduce"},
                                                  {"synthesize"},
                                                  {"convert"},
                                                  {"export"},
                                                  {"calibrate-noise"},
                                                  {"completion"},
                                                  {"new-plugin"},
                                                  {"plugins"},
                                                  {"models"},
                                                  {"models", "list"},
                                                  {"models", "info"},
                                                  {"config"},
                                                  {"info"},
                                                  {"plugins", "list"},
                                                  {"plugins", "describe"},
                                                  {"config", "check"},
                                                  {"config", "print"},
                                                  {"config", "schema"}}) {
    auto arguments = command;
    arguments.push_back("--help");
    const Outcome outcome = run_gestalt(arguments);
    expect_success(outcome);
    EXPECT_GT(occurrences("Usage: gestalt", outcome.out), 0) << outcome.out;
    EXPECT_GT(occurrences("Example", outcome.out), 0) << outcome.out;
  }
}

TEST(Usage, HelpAndVersionAreSubcommandsToo) {
  EXPECT_EQ(run_gestalt({"help"}).out, run_gestalt({"--help"}).out);
  EXPECT_EQ(run_gestalt({"help", "config", "print"}).out, run_gestalt({"config", "print", "--help"}).out);
  for (const char* word : {"version", "-v"}) EXPECT_EQ(run_gestalt({word}).out, run_gestalt({"--version"}).out);
}

TEST(Usage, InstalledConfigsAreKnownByName) {
  EXPECT_EQ(run_gestalt({"config", "print", "realtime"}).out, run_gestalt({"config", "print", "realtime.yaml"}).out);
  expect_success(run_gestalt({"config", "check", "--config", "realtime"}));
  for (const char* name : {"realtme", "realtme.yaml"})
    expect_refused(run_gestalt({"config", "print", name}), 2,
                   {"there is no config 'realtme", "did you mean 'realtime'?", "which are default, ", ", paper, "});
}

TEST(Usage, NothingButTheNameGetsTheHelp) {
  const std::string help = run_gestalt({"--help"}).out;
  const Outcome outcome = run_gestalt({});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(outcome.err.starts_with(help)) << outcome.err;
}

TEST(Usage, AReaderThatHasReadEnoughIsNoFailure) {
  const TemporaryFolder folder;
  const std::string err = folder.path() / "err";
  // The pipe is closed before the first line is printed.
  const std::string script =
      std::string("set -o pipefail; { sleep 1; exec ") + GESTALT_COMMAND + " config print 2>" + err + "; } | true";
  EXPECT_EQ(std::system(("bash -c '" + script + "'").c_str()), 0);
  EXPECT_EQ(fs::file_size(err), 0u);
}

/// What bash offers for the last of some words.
std::set<std::string> completed(const std::vector<std::string>& words) {
  const TemporaryFolder folder;
  std::string script = run_gestalt({"completion", "bash"}).out + "COMP_WORDS=(";
  for (const std::string& word : words) script += " '" + word + "'";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) + "\n_gestalt\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  const std::string file = folder.write("script.bash", script);
  std::unique_ptr<FILE, int (*)(FILE*)> bash(popen(("bash '" + file + "'").c_str(), "r"), pclose);
  std::set<std::string> offered;
  for (std::array<char, 256> line{}; fgets(line.data(), line.size(), bash.get());) {
    std::string word = line.data();
    word.pop_back();
    if (!word.empty()) offered.insert(word);
  }
  return offered;
}

TEST(Usage, BashCompletesCommandsAndOptions) {
  using Words = std::set<std::string>;
  EXPECT_EQ(completed({"gestalt", "seg"}), Words{"segment"});
  EXPECT_EQ(completed({"gestalt", "--v"}), Words{"--version"});
  EXPECT_EQ(completed({"gestalt", "plugins", "de"}), Words{"describe"});
  EXPECT_EQ(completed({"gestalt", "segment", "scene", "--out"}), Words{"--output"});
  EXPECT_EQ(completed({"gestalt", "stream", "scene", "--dr"}), Words{"--drop"});
  EXPECT_EQ(completed({"gestalt", "segment", "exampl"}), Words{});  // the shell's turn: a file
}

TEST(Usage, CompletionKnowsThreeShells) {
  EXPECT_GT(occurrences("bashcompinit", run_gestalt({"completion", "zsh"}).out), 0);
  const std::string fish = run_gestalt({"completion", "fish"}).out;
  EXPECT_GT(occurrences("complete -c gestalt", fish), 20);
  EXPECT_GT(occurrences("-l cross-validate", fish), 0);
  EXPECT_EQ(run_gestalt({"completion", "tcsh"}).code, 2);
}

TEST(Usage, WrongUsageIsNamedAndHasExitCode2) {
  struct Wrong {
    std::vector<std::string> arguments;
    std::string word;
  };
  const std::string scene = synthetic_scene();
  for (const auto& [arguments, word] :
       {Wrong{{}, "subcommand is required"},
        Wrong{{"segmnt", scene}, "did you mean 'segment'?"},
        Wrong{{"plugins"}, "subcommand is required"},
        Wrong{{"models"}, "subcommand is required"},
        Wrong{{"models", "info"}, "NAME"},
        Wrong{{"models", "info", "realtme"}, "did you mean 'realtime'?"},
        Wrong{{"models", "info", "mine.json"}, "gestalt info FILE"},
        Wrong{{"config"}, "subcommand is required"},
        Wrong{{"segment"}, "inputs"},
        Wrong{{"segment", scene, "--outptu", "x"}, "unknown option '--outptu'; did you mean '--output'?"},
        Wrong{{"segment", scene, "--outptu=x"}, "did you mean '--output'?"},
        Wrong{{"segment", scene, "--outptu", "x"}, "See gestalt segment --help"},
        Wrong{{"--verison"}, "did you mean '--version'?"},
        Wrong{{"config", "prnt"}, "did you mean 'print'?"},
        Wrong{{"train", scene, "--outptu", "x"}, "did you mean '--output'?"},
        Wrong{{"export", "a", "b", "--output", "c"}, "unexpected argument 'b'"},
        Wrong{{"segment", scene, "--output"}, "--output"},
        Wrong{{"segment", scene, "--output", ""}, "--output"},
        Wrong{{"segment", scene, "--threads", "-1"}, "--threads"},
        Wrong{{"segment", scene, "--threads", "many"}, "--threads"},
        Wrong{{"segment", scene, "--set", "structural.minimum_size"}, "--set"},
        Wrong{{"train"}, "scenes"},
        Wrong{{"train", scene}, "--output"},
        Wrong{{"train", scene, "--output", ""}, "--output"},
        Wrong{{"evaluate"}, "scenes"},
        Wrong{{"evaluate", scene, "--cross-validate", "1"}, "--cross-validate"},
        Wrong{{"evaluate", scene, "--cross-validate", "2", "--predictions", "x"}, "--predictions"},
        Wrong{{"evaluate", scene, "--seed", "1"}, "--cross-validate"},
        Wrong{{"evaluate", scene, "--leave-one-out", "scene"}, "{category,set}"},
        Wrong{{"evaluate", scene, "--leave-one-out", "set", "--cross-validate", "2"}, "--leave-one-out"},
        Wrong{{"evaluate", scene, "--leave-one-out", "set", "--predictions", "x"}, "--leave-one-out"},
        Wrong{{"evaluate", scene, "--rule", "best"}, "majority"},
        Wrong{{"synthesize", "--category", "boxes"}, "--output"},
        Wrong{{"synthesize", "--category", "boxes", "--output", ""}, "--output"},
        Wrong{{"synthesize", "--category", "nothing", "--output", "unused"}, "nothing"},
        Wrong{{"synthesize", "--category", "boxes", "--output", "unused", "--width", "0"}, "--width"},
        Wrong{{"synthesize", "--category", "boxes", "--output", "unused", "--sensor", "radar"}, "radar"},
        Wrong{{"synthesize", "--category", "boxes", "--output", "unused", "--camera", "a.yaml", "--width", "64"},
              "--camera"},
        Wrong{{"plugins", "describe"}, "component"},
        Wrong{{"plugins", "describe", "gabro"}, "did you mean 'gabor'?"},
        Wrong{{"plugins", "describe", "relatoin", "gabor"}, "did you mean 'relation'?"},
        Wrong{{"segment", scene, "--fx", "75"}, "--cx"},
        Wrong{{"segment", scene, "--camera", "a.yaml", "--fx", "75", "--cx", "1", "--cy", "1"}, "--camera"},
        Wrong{{"info"}, "--depth and --rgb"}}) {
    const Outcome outcome = run_gestalt(arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_GT(occurrences(word, outcome.err), 0) << word << "\nnot in\n" << outcome.err;
  }
  EXPECT_FALSE(fs::exists("unused"));
}

/// What the command prints on a terminal.
std::string on_terminal(const std::string& arguments) {
  const std::string script =
      std::string("script --quiet --command \"") + GESTALT_COMMAND + " " + arguments + "\" /dev/null";
  std::unique_ptr<FILE, int (*)(FILE*)> terminal(popen(script.c_str(), "r"), pclose);
  std::string printed;
  for (std::array<char, 256> part{}; fgets(part.data(), part.size(), terminal.get());) printed += part.data();
  return printed;
}

TEST(Usage, ATerminalIsToldTheNextCommand) {
  const TemporaryFolder folder;
  const std::string scene = synthetic_scene(), model = folder.path() / "a model.json", out = folder.path() / "out";
  const std::string segmented = on_terminal("segment '" + scene + "' --output " + out);
  const std::string result = fs::path(out) / fs::path(scene).filename();
  EXPECT_GT(occurrences("See why in a browser: gestalt inspect " + result + " --output page.html", segmented), 0)
      << segmented;
  expect_success(run_gestalt({"inspect", result, "--output", folder.path() / "page.html"}));
  // inspect would need the camera, too.
  EXPECT_EQ(occurrences("inspect", on_terminal("segment '" + scene + "' --fx 525 --cx 320 --cy 240 --output " + out)),
            0);
  EXPECT_EQ(run_gestalt({"segment", scene, "--output", out}).err, "");

  const std::string trained = on_terminal("train '" + scene + "' --config realtime --output '" + model + "'");
  EXPECT_GT(occurrences("gestalt segment INPUT --config realtime --set 'model=" + model + "'", trained), 0) << trained;
}

TEST(Models, EachInstalledFileIsListedWithItsDataLicenceAndConfig) {
  const Outcome text = run_gestalt({"models", "list"}), outcome = run_gestalt({"models", "list", "--json"});
  expect_success(text);
  expect_success(outcome);
  std::set<std::string> listed, installed;
  fs::path folder;
  for (const json& model : json::parse(outcome.out)) {
    const std::string name = model.at("name");
    folder = fs::path(model.at("file").get<std::string>()).parent_path();
    listed.insert(name);
    EXPECT_GT(occurrences(name, text.out), 0) << text.out;
    EXPECT_FALSE(model.at("licence").get<std::string>().empty());
    EXPECT_FALSE(model.at("score_percent").empty()) << name;
    // Its config takes it.
    expect_success(run_gestalt({"config", "check", model.at("config"), "--set", "model=" + name + ".json"}));
    const Outcome info = run_gestalt({"models", "info", name});
    expect_success(info);
    EXPECT_EQ(json::parse(run_gestalt({"models", "info", name + ".json", "--json"}).out), model);
    const json content = json::parse(run_gestalt({"info", model.at("file"), "--json"}).out);
    std::size_t scenes = 0;
    for (const json& data : model.at("training_data")) {
      scenes += data.at("scenes").get<std::size_t>();
      EXPECT_GT(occurrences(data.at("text"), info.out), 0) << info.out;
      EXPECT_GT(occurrences(data.at("licence"), info.out), 0) << info.out;
    }
    EXPECT_EQ(content.at("structural").at("training_scenes").size(), scenes) << name;
  }
  for (const auto& file : fs::directory_iterator(folder))
    if (file.path().extension() == ".json") installed.insert(file.path().stem());
  EXPECT_EQ(listed, installed);
}

TEST(Plugins, ListNamesEveryComponentOfTheDefaultConfig) {
  const Outcome text = run_gestalt({"plugins", "list"}), outcome = run_gestalt({"plugins", "list", "--json"});
  expect_success(text);
  expect_success(outcome);
  const json list = json::parse(outcome.out);
  EXPECT_TRUE(list.at("rejected").empty()) << list.at("rejected");
  std::set<std::string> found;
  for (const json& component : list.at("components")) {
    EXPECT_TRUE(fs::exists(component.at("library").get<std::string>()));
    EXPECT_FALSE(component.at("description").get<std::string>().empty());
    found.insert(component.at("kind").get<std::string>() + " " + component.at("name").get<std::string>());
    EXPECT_GT(occurrences(component.at("name"), text.out), 0) << text.out;
  }
  for (const char* name : {"clusterer normals", "fitter plane", "relation gabor", "relation relative_size",
                           "classifier svm", "classifier random_forest", "solver graph_cut", "solver threshold"})
    EXPECT_TRUE(found.contains(name)) << name;
}

TEST(Plugins, DescribeTellsParametersAndValues) {
  const Outcome outcome = run_gestalt({"plugins", "describe", "relation", "gabor", "--json"});
  expect_success(outcome);
  const json described = json::parse(outcome.out);
  EXPECT_EQ(described.at("needs_colour"), true);
  EXPECT_EQ(described.at("values").at(0).at("name"), "r_ga");
  ASSERT_FALSE(described.at("parameters").empty());
  const Outcome text = run_gestalt({"plugins", "describe", "gabor"});
  expect_success(text);
  for (const json& parameter : described.at("parameters")) {
    EXPECT_EQ(parameter.at("range").size(), 2u);
    EXPECT_GT(occurrences(parameter.at("name"), text.out), 0) << text.out;
  }
}

TEST(Plugins, ARejectedLibraryIsListedAndHindersNobody) {
  const fs::path library = fs::path(BROKEN_PLUGINS) / "old_interface" / "old_interface.so";
  const Surroundings path{.variables = {"GESTALT_PLUGIN_PATH=" + library.parent_path().string()}};
  const Outcome list = run_gestalt({"plugins", "list"}, path);
  expect_success(list);
  EXPECT_EQ(occurrences(library.string() + ": ", list.out), 1) << list.out;
  EXPECT_GT(occurrences("interface 0", list.out), 0) << list.out;
  expect_success(run_gestalt({"config", "check"}, path));
}

TEST(Plugins, APipeInAFolderOfPluginsIsNotWaitedFor) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "relation_pipe.so";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const Outcome list =
      run_gestalt({"plugins", "list"}, {.variables = {"GESTALT_PLUGIN_PATH=" + folder.path().string()}});
  expect_success(list);
  EXPECT_EQ(occurrences(pipe.string() + ": it is not a regular file", list.out), 1) << list.out;
}

TEST(Configs, WhatIsPrintedReadsBackToTheSame) {
  const TemporaryFolder folder;
  const Outcome printed =
      run_gestalt({"config", "print", "--set", "structural.minimum_size=77", "--set", "structural.relations.gabor=off",
                   "--set", "structural.classifier=random_forest"});
  expect_success(printed);
  const fs::path file = folder.write("printed.yaml", printed.out);
  const Outcome check = run_gestalt({"config", "check", file});
  expect_success(check);
  EXPECT_GT(occurrences("valid", check.out), 0) << check.out;
  const Outcome first = run_gestalt({"config", "print", "--json", "--set", "structural.minimum_size=77", "--set",
                                     "structural.relations.gabor=off", "--set", "structural.classifier=random_forest"});
  const Outcome second = run_gestalt({"config", "print", file, "--json"});
  expect_success(second);
  const json values = json::parse(first.out).at("values");
  EXPECT_EQ(values, json::parse(second.out).at("values"));
  EXPECT_EQ(values.at("structural").at("minimum_size"), 77);
}

TEST(Configs, TheDefaultIsFoundFromAnyFolder) {
  const TemporaryFolder folder;
  const Outcome outcome = run_gestalt({"config", "check"}, {.folder = folder.path()});
  expect_success(outcome);
  EXPECT_GT(occurrences("default.yaml: valid", outcome.out), 0) << outcome.out;
}

TEST(Configs, CheckTellsEveryErrorAtOnce) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("wrong.yaml",
                                     "schema_version: 1\n"
                                     "signal: {clusterer: normals}\n"
                                     "primitive: {fitters: [plane]}\n"
                                     "structural:\n"
                                     "  relations: [gabro, relative_size]\n"
                                     "  classifier: svm\n"
                                     "  minimum_size: 0\n"
                                     "  minimum_sise: 30\n"
                                     "decision: {solver: graph_cut}\n");
  const Outcome outcome = run_gestalt({"config", "check", file});
  expect_refused(outcome, 2,
                 {"wrong.yaml:5:15: ", "did you mean 'gabor'?", "wrong.yaml:7:17: ", "[1, 1000000]",
                  "wrong.yaml:8:3: ", "did you mean 'minimum_size'?"});
}

TEST(Info, SaysWhatAFileIs) {
  const TemporaryFolder folder;
  expect_success(run_gestalt({"segment", synthetic_scene(), "--output", folder.path()}));
  const fs::path cloud = folder.write("view.pcd", pcd(points_of(synthetic_scene()), 320, 240));
  const fs::path config = folder.write("config.yaml", run_gestalt({"config", "print"}).out);
  struct File {
    fs::path path;
    std::string kind;
  };
  for (const auto& [path, kind] :
       {File{synthetic_scene(), "scene folder"}, File{synthetic_scenes(), "folder of scenes"},
        File{cloud, "organized cloud"}, File{synthetic_scenes() / "camera.yaml", "camera file"}, File{config, "config"},
        File{folder.path() / "mixed_objects_1_000" / "result.json", "result of gestalt segment"}}) {
    const Outcome text = run_gestalt({"info", path}), outcome = run_gestalt({"info", path, "--json"});
    expect_success(text);
    expect_success(outcome);
    EXPECT_EQ(json::parse(outcome.out).at("kind"), kind);
    EXPECT_TRUE(text.out.starts_with("kind: " + kind + "\n")) << text.out;
  }
  expect_refused(run_gestalt({"info", folder.path() / "nothing"}), 3, {"nothing", "does not exist"});
  expect_refused(run_gestalt({"info", folder.write("notes.md", "x")}), 3,
                 {"an unknown kind", scene_extensions(" and ")});
  expect_refused(run_gestalt({"info", folder.write("notes.txt", "x")}), 3, {"is not a camera file"});
  expect_refused(run_gestalt({"info", synthetic_scene() / "rgb.png"}), 3, {"rgb.png", "no depth image", "--depth"});
}

TEST(Info, TellsEachFormatOfScenes) {
  const TemporaryFolder folder;
  for (const SceneFormat& format : scene_formats()) {
    SCOPED_TRACE(format.name);
    const fs::path out = folder.path() / format.name;
    fs::path scene = synthetic_scene();
    if (format.encode) {
      expect_success(run_gestalt({"convert", synthetic_scene(), "--to", format.name, "--output", out}));
      scene = out / "scenes" / (scene_name(synthetic_scene()) + format.extension);
    } else if (format.name == "frame") {
      scene /= "depth.png";
    }
    const Outcome outcome = run_gestalt({"info", scene, "--json"});
    expect_success(outcome);
    const json told = json::parse(outcome.out);
    EXPECT_NE(told.at("kind").get<std::string>().find(format.kind), std::string::npos) << told;
    EXPECT_EQ(told.at("width"), 320);
    if (format.name == "ply") {  // which cannot tell its camera
      EXPECT_EQ(told.at("camera_from"), (out / "scenes" / "camera.yaml").string());
    }
  }
  const Outcome wrong = run_gestalt({"convert", synthetic_scene(), "--to", "zip", "--output", folder.path() / "zip"});
  EXPECT_EQ(wrong.code, 2);
  for (const SceneFormat& format : scene_formats())
    if (format.encode || format.name == "scene") {
      EXPECT_GT(occurrences(format.name, wrong.err), 0) << wrong.err;
    }
}

// A script's variable that is not set.
TEST(Usage, AnEmptyValueIsRefused) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"segment", ""},
                                             {"segment", "x", "--camera", ""},
                                             {"segment", "x", "--config", ""},
                                             {"info", ""},
                                             {"inspect", "x", "--scene", ""},
                                             {"evaluate", "x", "--predictions", ""},
                                             {"config", "check", ""}}) {
    const Outcome outcome = run_gestalt(words);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(occurrences("is empty", outcome.err), 1) << outcome.err;
  }
}

TEST(Usage, WhatIsNoNumberOfTheRangeIsRefused) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"segment", "x", "--depth-scale", "nan"},
           {"segment", "x", "--depth-scale", "0"},
           {"segment", "x", "--max-depth", "nan"},
           {"stream", "x", "--idle", "nan"},
           {"stream", "x", "--queue", "-1"},
           {"evaluate", "x", "--cross-validate", "2", "--seed", "-1"},
           {"ablate", "x", "--output", "y", "--seed", "99999999999999999999"},
           {"synthesize", "--category", "boxes", "--output", "y", "--seed", "-1"},
           {"synthesize", "--category", "boxes", "--output", "y", "--focal-length", "nan"},
           {"segment", "x", "--threads", "1e3"}}) {
    const Outcome outcome = run_gestalt(words);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_GT(occurrences("'" + words.back() + "' is not a ", outcome.err), 0) << outcome.err;
    EXPECT_EQ(occurrences("0.000000", outcome.err), 0) << outcome.err;
  }
}

TEST(Usage, OneFileIsNotDepthAndColour) {
  const fs::path depth = synthetic_scene() / "depth.png";
  const Outcome outcome = run_gestalt({"info", "--depth", depth, "--rgb", depth});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(occurrences("--rgb: is the file of --depth", outcome.err), 1) << outcome.err;
}

TEST(Info, APictureOfAnotherFormatIsRefused) {
  const TemporaryFolder folder;
  const fs::path picture = folder.path() / "x.jpg";
  const Outcome outcome = run_gestalt({"info", synthetic_scene(), "--picture", picture});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(occurrences("ends in .png", outcome.err), 1) << outcome.err;
  EXPECT_FALSE(fs::exists(picture));
}

TEST(Info, AResultOfAnotherVersionIsRefused) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("r.json", R"({"format": "gestalt-result", "version": 3, "segments": []})");
  expect_refused(run_gestalt({"info", file}), 3, {"r.json", "another version", "gestalt segment"});
}

TEST(Usage, AFileThatIsReadIsNotReplaced) {
  const TemporaryFolder folder;
  const fs::path scene = folder.path() / "scene";
  fs::copy(synthetic_scene(), scene);
  fs::copy(synthetic_scenes() / "camera.yaml", scene / "camera.yaml");
  expect_success(run_gestalt({"segment", scene, "--output", folder.path()}));
  const fs::path result = scene / "result.json";
  const auto expect_kept = [](const std::vector<std::string>& words, const fs::path& file) {
    const std::string before = content(file);
    expect_refused(run_gestalt(words), 2, {file.string(), "is read"});
    EXPECT_EQ(content(file), before);
  };
  expect_kept({"train", scene, "--output", scene / "label.png"}, scene / "label.png");
  expect_kept({"train", scene, "--output", scene / "camera.yaml"}, scene / "camera.yaml");
  expect_kept({"info", scene, "--picture", scene / "depth.png"}, scene / "depth.png");
  expect_kept({"export", result, "--output", result}, result);
  expect_kept({"inspect", result, "--output", result}, result);
  expect_kept({"inspect", result, "--output", scene / "rgb.png"}, scene / "rgb.png");
}

}  // namespace
}  // namespace gestalt::test
