// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A file of twice the size may cost little more than twice as much, whatever is in it. Where that is not so by nature,
// the work is bounded. The table of docs/reliability.md is what this prints.

#include <fcntl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "counted_work.h"
#include "frame_queue.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/json_file.h"
#include "gestalt/io/result/parametric_surface.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/scene/associations.h"
#include "gestalt/io/scene/coco_labels.h"
#include "gestalt/io/scene/number_list.h"
#include "gestalt/io/scene/ply_body.h"
#include "gestalt/io/scene/ply_header.h"
#include "gestalt/io/scene/scene_names.h"
#include "gestalt/tests/environment/temporary_folder.h"
#include "line_source.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;

/// Work on an input of so many parts, made before the counting.
using Case = std::function<std::function<void()>(std::size_t parts)>;

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

class Doubling : public testing::Test {
 protected:
  /// n log n, and vectors that have just doubled, remain; n^1.5 does not.
  static constexpr double most_growth = 2.4;

  /// parts, and twice and four times as many.
  static void expect_linear(const char* what, std::size_t parts, const Case& make) {
    Work work[3];
    for (int i = 0; i < 3; ++i) work[i] = counted(make(parts << i));
    const auto growth = [&](auto of) {
      return std::sqrt(double(of(work[2])) / double(std::max<std::uint64_t>(of(work[0]), 1)));
    };
    const double steps = growth([](const Work&w) { return w.steps; }),
                 bytes = growth([](const Work&w) { return w.bytes; });
    std::printf("| %s | %zu | %llu | %.2f | %.2f |\n", what, parts << 2, static_cast<unsigned long long>(work[2].steps),
                steps, bytes);
    EXPECT_GT(work[0].steps, 0u) << what;
    EXPECT_LT(steps, most_growth) << what << ": steps " << work[0].steps << " to " << work[2].steps;
    EXPECT_LT(bytes, most_growth) << what << ": bytes " << work[0].bytes << " to " << work[2].bytes;
  }

  const TemporaryFolder folder;
};

TEST_F(Doubling, ListsOfRecordings) {
  const auto lists = [&](const std::function<std::string(std::size_t)>& time) {
    return [&, time](std::size_t parts) {
      std::string lines;
      for (std::size_t i = 0; i < parts; ++i) lines += time(i) + " image.png\n";
      folder.write("rgb.txt", lines);
      folder.write("depth.txt", lines);
      return [&, parts] { EXPECT_EQ(associated_images(folder.path()).size(), parts); };
    };
  };
  expect_linear("`rgb.txt` and `depth.txt`, times in order", 4000,
                lists([](std::size_t i) { return std::to_string(i); }));
  expect_linear("`rgb.txt` and `depth.txt`, all of one time", 4000, lists([](std::size_t) { return "1"; }));
  expect_linear("`rgb.txt` and `depth.txt`, all within 0.02 s", 4000,
                lists([](std::size_t i) { return std::to_string(double(i * 7919 % 16001) * 1e-6); }));
  expect_linear("`associations.txt`, all of one time", 4000, [&](std::size_t parts) {
    folder.write("associations.txt", repeated("1 rgb/a.png 1 depth/a.png\n", parts));
    return [&] { associated_images(folder.path()); };
  });
}

TEST_F(Doubling, HeadersAndBodiesOfClouds) {
  const auto ply = [&](const std::function<std::string(std::size_t)>& text) {
    return [&, text](std::size_t parts) {
      return [bytes = text(parts)] {
        const fs::path file = "a.ply";
        read_ply_body(file, parse_ply_header(file, bytes), bytes);
      };
    };
  };
  expect_linear("PLY, properties of a vertex", 4000, ply([](std::size_t parts) {
                  std::string header = "ply\nformat ascii 1.0\nelement vertex 1\n";
                  for (std::size_t i = 0; i < parts; ++i) header += "property float p" + std::to_string(i) + "\n";
                  return header + "end_header\n" + repeated("1 ", parts);
                }));
  expect_linear("PLY, elements before the vertices", 4000, ply([](std::size_t parts) {
                  return "ply\nformat ascii 1.0\n" + repeated("element e 60000000\n", parts) +
                         "element vertex 1\nproperty float x\nend_header\n1\n";
                }));
  expect_linear("PLY, vertices as text", 4000, ply([](std::size_t parts) {
                  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(parts) +
                         "\nproperty float x\nend_header\n" + repeated("\n\n 1.5\n", parts);
                }));
}

TEST_F(Doubling, Json) {
  const auto json = [&](const std::function<std::string(std::size_t)>& text) {
    return [&, text](std::size_t parts) { return [bytes = text(parts)] { parse_json("a.json", bytes); }; };
  };
  expect_linear("JSON, a list of numbers", 100'000,
                json([](std::size_t parts) { return "[" + repeated("1,", parts) + "1]"; }));
  expect_linear("JSON, an object of many keys", 20'000, json([](std::size_t parts) {
                  std::string text = "{";
                  for (std::size_t i = 0; i < parts; ++i) text += "\"key " + std::to_string(i) + "\":1,";
                  return text + "\"last\":1}";
                }));
  expect_linear("JSON, lists in each other", 50,
                json([](std::size_t parts) { return std::string(parts, '[') + std::string(parts, ']'); }));
}

TEST_F(Doubling, TextsOfNumbers) {
  expect_linear("numbers of a camera as text", 200, [&](std::size_t parts) {
    const fs::path file = folder.write("K.txt", repeated("1.5, [2]\n", parts));
    return [file] {
      try {
        read_numbers(file);
      } catch (const InputError&) {
      }
    };
  });
}

TEST_F(Doubling, NamesOfScenes) {
  expect_linear("names of scenes", 4000, [&](std::size_t parts) {
    std::vector<NamedScene> scenes;
    for (std::size_t i = 0; i < parts; ++i) scenes.push_back({"scenes/" + std::to_string(i), std::to_string(i)});
    return [scenes] { check_scene_names(scenes); };
  });
}

TEST_F(Doubling, Outlines) {
  const auto star = [](std::size_t parts) {
    TrimmingOutline outline;
    for (std::size_t i = 0; i < parts; ++i) {
      const double angle = 6.283185307179586 * double(i) / double(parts), radius = i % 2 ? 1 : 0.5;
      outline.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return outline;
  };
  expect_linear("outlines of many patches", 100, [&](std::size_t parts) {
    return [parts, outline = star(40)] {
      TriangulationBudget budget;
      for (std::size_t i = 0; i < parts; ++i) triangulate(std::vector{outline}, budget);
    };
  });
}

TEST_F(Doubling, Results) {
  const nlohmann::json patch{
      {"pixels", 9},
      {"rms", 0.001},
      {"surface", {{"type", "plane"}, {"centre", {0, 0, 1}}, {"across", {1, 0, 0}}, {"down", {0, 1, 0}}}},
      {"outlines", {{{"hole", false}, {"vertices", {{0, 0}, {1, 0}, {1, 1}}}}}}};
  expect_linear("result.json, patches and segments", 1000, [&](std::size_t parts) {
    nlohmann::json result{{"format", "gestalt-result"}, {"version", 2}, {"scene", "x"}};
    for (std::size_t i = 0; i < parts; ++i) {
      result["patches"].push_back(patch);
      result["segments"].push_back({{"label", i + 1}, {"patches", {i}}});
    }
    return [file = folder.write("r.json", result.dump())] { read_result(file); };
  });
}

/// An annotation of many polygons, on an image of 64x64 pixels.
TEST_F(Doubling, PolygonsOfCoco) {
  const auto coco = [&](const std::string& polygon, std::size_t count) {
    std::string polygons;
    for (std::size_t i = 0; i < count; ++i) polygons += (i > 0 ? "," : "") + polygon;
    return folder.write("coco.json", R"({"images":[{"id":1,"width":64,"height":64}],"annotations":[{"image_id":1,)"
                                     R"("segmentation":[)" +
                                         polygons + "]}]}");
  };
  const auto read = [](const fs::path& file) { read_coco_labels(file, {64, 64}, "x"); };
  const std::string whole = "[0,0,64,0,64,64,0,64]";
  expect_linear("COCO, polygons", 100,
                [&](std::size_t parts) { return [file = coco(whole, parts), read] { read(file); }; });
  expect_linear("COCO, corners of a polygon", 1000, [&](std::size_t parts) {
    return [file = coco("[0,0,64,0" + repeated(",64,64", parts) + "]", 1), read] { read(file); };
  });
  EXPECT_THROW(read(coco(whole, 300'000)), InputError) << "each draws every pixel";
}

/// Their work grows by the square, and has an end, whatever the size of the file.
TEST_F(Doubling, TangledOutlinesHaveABound) {
  TrimmingOutline tangled;
  for (std::size_t i = 0; i < 20'000; ++i)
    tangled.vertices.emplace_back(double(i * 7919 % 20'011), double(i * 104'729 % 20'021));
  const auto work = [&](std::size_t patches) {
    return counted([&] {
      TriangulationBudget budget;
      budget.tests /= 100;  // of which the work is a multiple
      try {
        for (std::size_t i = 0; i < patches; ++i) triangulate(std::vector{tangled}, budget);
        ADD_FAILURE() << "the budget sufficed";
      } catch (const InputError&) {
      }
    });
  };
  const Work few = work(100), many = work(200);
  std::printf("| tangled outlines, to their bound | | %llu | %.2f | %.2f |\n",
              static_cast<unsigned long long>(many.steps), double(many.steps) / double(few.steps),
              double(many.bytes) / double(few.bytes));
  EXPECT_EQ(many.steps, few.steps);
}

TEST_F(Doubling, ListsOfStreams) {
  const auto read = [&](std::size_t parts, std::optional<std::size_t> capacity) {
    const fs::path list = folder.write("list", repeated("scene\n", parts));
    return [list, parts, capacity] {
      app::LineSource source(::open(list.c_str(), O_RDONLY), "list", "folder");
      app::FrameQueue queue(capacity);
      std::size_t come = 0;
      while (const auto scenes = source.next(queue.wait_for_room({}))) {
        come += scenes->size();
        queue.put(*scenes);
        if (capacity)
          for (std::size_t i = 0; i < scenes->size(); ++i) queue.take();
      }
      EXPECT_EQ(come, parts);
    };
  };
  expect_linear("`stream`, a list", 4000, [&](std::size_t parts) { return read(parts, 8); });
  expect_linear("`stream --drop`, a list", 20'000, [&](std::size_t parts) { return read(parts, std::nullopt); });
  const std::uint64_t bytes = counted(read(400'000, std::nullopt)).bytes;
  EXPECT_LT(bytes, 4'000'000u) << "a list that is dropped is in memory";
}

}  // namespace
}  // namespace gestalt::test
