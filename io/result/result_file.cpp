// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/result/result_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/json_file.h"
#include "gestalt/core/pipeline/model_fields.h"
#include "gestalt/io/result/result_digests.h"

namespace gestalt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double largest_length = 1e4;        // m, of a coordinate
constexpr std::size_t most_vertices = 20000;  // of the outlines of one patch
constexpr const char* remedy = "; recreate it with `gestalt segment`";

[[noreturn]] void fail(const std::string& what) { throw ModelError(what); }  // gets its place from within()

/// Runs work, and puts the place in front of what is wrong there.
template <class Work>
auto within(const std::string& place, const Work& work) {
  try {
    return work();
  } catch (const ModelError& error) {
    throw ModelError(place + ": " + error.what());
  }
}

const json& list(const json& object, const std::string& key) {
  const json& value = field(object, key);
  if (!value.is_array()) fail("'" + key + "' must be a list");
  return value;
}

/// work(element, index) for each element of a list, with its place.
template <class Work>
void for_each(const json& object, const std::string& key, const Work& work) {
  const json& elements = list(object, key);
  for (std::size_t i = 0; i < elements.size(); ++i)
    within(key + "[" + std::to_string(i) + "]", [&] { work(elements[i], i); });
}

template <int size>
Eigen::Matrix<double, size, 1> vector_of(const json& value, double largest) {
  if (!value.is_array() || value.size() != size) fail("must be a list of " + std::to_string(size) + " numbers");
  Eigen::Matrix<double, size, 1> vector;
  for (int i = 0; i < size; ++i) {
    const json& number = value[std::size_t(i)];
    if (!number.is_number() || !(std::abs(number.get<double>()) <= largest))
      fail("must have numbers in [" + std::to_string(int(-largest)) + ", " + std::to_string(int(largest)) + "]");
    vector[i] = number.get<double>();
  }
  return vector;
}

Eigen::Vector3d point_field(const json& object, const std::string& key, double largest = largest_length) {
  return within(key, [&] { return vector_of<3>(field(object, key), largest); });
}

PlaneSurface read_plane(const json& object) {
  PlaneSurface plane{point_field(object, "centre"), point_field(object, "across", 1), point_field(object, "down", 1)};
  const auto is_unit = [](const Eigen::Vector3d& v) { return std::abs(v.norm() - 1) < 1e-3; };
  if (!is_unit(plane.across) || !is_unit(plane.down) || std::abs(plane.across.dot(plane.down)) > 1e-3)
    fail("'across' and 'down' must be perpendicular and of length 1");
  return plane;
}

std::vector<double> read_knots(const json& object, const std::string& key, int degree) {
  std::vector<double> knots = numbers_field(object, key);
  const std::size_t ends = std::size_t(degree) + 1;
  if (knots.size() < 2 * ends || knots.size() > 1000)
    fail("'" + key + "' must have " + std::to_string(2 * ends) + " to 1000 numbers for degree " +
         std::to_string(degree));
  if (!std::is_sorted(knots.begin(), knots.end())) fail("'" + key + "' must ascend");
  const auto zeros = std::count(knots.begin(), knots.end(), 0.0), ones = std::count(knots.begin(), knots.end(), 1.0);
  if (knots.front() != 0 || knots.back() != 1 || zeros != degree + 1 || ones != degree + 1)
    fail("'" + key + "' must begin with " + std::to_string(ends) + " times 0 and end with as many times 1");
  return knots;
}

BsplineSurface read_bspline(const json& object) {
  BsplineSurface surface;
  const std::size_t degree = count_field(object, "degree");
  if (degree < 1 || degree > std::size_t(BsplineBasis::largest_degree))
    fail("'degree' must be in [1, " + std::to_string(BsplineBasis::largest_degree) + "]");
  surface.degree = int(degree);
  surface.knots_xi = read_knots(object, "knots_xi", surface.degree);
  surface.knots_eta = read_knots(object, "knots_eta", surface.degree);
  const auto expect = [](const json& value, int count, const char* what) {
    if (!value.is_array() || value.size() != std::size_t(count))
      fail("must be a list of " + std::to_string(count) + " " + what + ", as many as the knots allow");
  };
  within("control_points", [&] { expect(field(object, "control_points"), surface.rows(), "rows"); });
  for_each(object, "control_points", [&](const json& row, std::size_t) {
    expect(row, surface.columns(), "points");
    for (const json& point : row) surface.points.push_back(vector_of<3>(point, largest_length));
  });
  return surface;
}

std::variant<PlaneSurface, BsplineSurface> read_shape(const json& object) {
  const std::string type = text_field(object, "type");
  if (type == "plane") return read_plane(object);
  if (type == "bspline") return read_bspline(object);
  fail("surfaces of type '" + type + "' are unknown here; only plane and bspline can be read");
}

}  // namespace

TrimmedSurface read_surface(const json& object) {
  TrimmedSurface patch;
  patch.shape = within("surface", [&] { return read_shape(field(object, "surface")); });
  patch.points = count_field(object, "pixels");
  patch.rms = number_field(object, "rms");
  if (patch.rms < 0 || patch.rms > largest_length) fail("'rms' must be metres in [0, 10000]");
  const double largest = std::holds_alternative<PlaneSurface>(patch.shape) ? largest_length : 1;
  std::size_t count = 0;
  for_each(object, "outlines", [&](const json& outline, std::size_t) {
    const json& hole = field(outline, "hole");
    if (!hole.is_boolean()) fail("'hole' must be true or false");
    patch.outlines.push_back({hole.get<bool>(), {}});
    for_each(outline, "vertices", [&](const json& vertex, std::size_t) {
      patch.outlines.back().vertices.push_back(vector_of<2>(vertex, largest));
      if (++count > most_vertices)
        fail("a patch must not have more than " + std::to_string(most_vertices) + " vertices");
    });
  });
  return patch;
}

namespace {

StoredResult::Segment read_segment(const json& object, std::size_t patches, std::set<int>& taken) {
  StoredResult::Segment segment;
  const std::size_t label = count_field(object, "label");
  if (label < 1 || label > 65535) fail("'label' must be in [1, 65535]");
  segment.label = int(label);
  if (object.contains("role")) {
    const std::string role = text_field(object, "role");
    if (role != "object" && role != "background") fail("'role' must be object or background, got '" + role + "'");
    segment.background = role == "background";
  }
  segment.patches = integers_field(object, "patches", 0, int(patches) - 1);
  for (const int patch : segment.patches)
    if (!taken.insert(patch).second) fail("patch " + std::to_string(patch) + " is already in a segment");
  return segment;
}

void check_format(const json& content) {
  if (!content.is_object() || !content.contains("format") || content["format"] != "gestalt-result")
    fail("is not a result of `gestalt segment`: it has no \"format\": \"gestalt-result\"");
  if (count_field(content, "version") != 2) fail("was written by another version of gestalt; its 'version' must be 2");
}

StoredResult read(const json& content) {
  StoredResult result;
  result.scene = text_field(content, "scene");
  for_each(content, "patches", [&](const json& patch, std::size_t) { result.patches.push_back(read_surface(patch)); });
  if (result.patches.size() > 1000000) fail("'patches' must not have more than 1000000 of them");
  std::set<int> taken, labels;
  for_each(content, "segments", [&](const json& segment, std::size_t) {
    result.segments.push_back(read_segment(segment, result.patches.size(), taken));
    if (!labels.insert(result.segments.back().label).second) fail("its label is a duplicate of another segment's");
  });
  return result;
}

/// Runs work, and says which file it is and what to do where something is wrong with it.
template <class Work>
auto of_file(const fs::path& file, const Work& work) {
  try {
    return work();
  } catch (const ModelError& problem) {
    throw InputError(file.string() + ": " + problem.what() + remedy);
  }
}

json parse(const fs::path& file) try { return read_json(file); } catch (const InputError& problem) {
  throw InputError(problem.what() + std::string(remedy));
}

}  // namespace

json read_result_content(const fs::path& file) {
  json content = parse(file);
  return of_file(file, [&] {
    check_format(content);
    return std::move(content);
  });
}

StoredResult read_result(const fs::path& file) {
  const json content = read_result_content(file);
  StoredResult result = of_file(file, [&] { return read(content); });
  result.warning = warning_of_foreign_files(file, content);
  return result;
}

Mesh triangulate(const StoredResult& result, const StoredResult::Segment& segment, double tolerance,
                 TriangulationBudget& budget) {
  Mesh mesh;
  for (const int patch : segment.patches) {
    Mesh surface;
    try {
      surface = triangulate(result.patches[std::size_t(patch)], tolerance, budget);
    } catch (const InputError& error) {
      throw InputError("patches[" + std::to_string(patch) + "]: " + error.what());
    }
    const int first = int(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), surface.vertices.begin(), surface.vertices.end());
    for (const auto& [a, b, c] : surface.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
  }
  return mesh;
}

}  // namespace gestalt
