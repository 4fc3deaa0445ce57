// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <locale>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command.h"
#include "gestalt/apps/number_in.h"
#include "gestalt/apps/output_check.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/scene/scene_path.h"

namespace gestalt::app::export_command {

namespace {

namespace fs = std::filesystem;

constexpr std::array formats{"ply", "obj", "json"};

struct Options {
  fs::path result, output;
  std::string format;  ///< empty: by the output's extension
  bool all = false;
  double tolerance = 0.5;  ///< mm
};

/// What a segment's surfaces need instead of its points.
struct Storage {
  std::size_t points = 0;
  std::size_t planes = 0, bsplines = 0;
  std::size_t bytes = 0;
  double squared_error = 0;  ///< m^2, sum over the points

  void add(const TrimmedSurface& surface) {
    points += surface.points;
    ++(std::holds_alternative<PlaneSurface>(surface.shape) ? planes : bsplines);
    bytes += surface.bytes();
    squared_error += double(surface.points) * surface.rms * surface.rms;
  }
  void add(const Storage& other) {
    points += other.points;
    planes += other.planes;
    bsplines += other.bsplines;
    bytes += other.bytes;
    squared_error += other.squared_error;
  }
  std::size_t raw_bytes() const { return 12 * points; }
  double ratio() const { return bytes ? double(raw_bytes()) / double(bytes) : 0; }
  double rms() const { return points ? std::sqrt(squared_error / double(points)) : 0; }
};

struct Object {
  int label;
  Mesh mesh;
  Storage storage;
};

Object reconstruct(const Options& options, const StoredResult& result, const StoredResult::Segment& segment,
                   TriangulationBudget& budget) {
  Object object{segment.label, {}, {}};
  try {
    object.mesh = triangulate(result, segment, options.tolerance / 1000, budget);
  } catch (const InputError& error) {
    throw InputError(options.result.string() + ": " + error.what());
  }
  for (const int patch : segment.patches) object.storage.add(result.patches[std::size_t(patch)]);
  return object;
}

/// A stream that writes numbers the same in every country: six decimals, micrometres.
std::ostringstream text_stream() {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(6);
  return out;
}

std::string ply(const std::vector<Object>& objects) {
  std::size_t vertices = 0, triangles = 0;
  for (const Object& object : objects) {
    vertices += object.mesh.vertices.size();
    triangles += object.mesh.triangles.size();
  }
  std::ostringstream out = text_stream();
  out << "ply\nformat ascii 1.0\nelement vertex " << vertices
      << "\nproperty float x\nproperty float y\nproperty float z"
         "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face "
      << triangles << "\nproperty list uchar int vertex_indices\nproperty int label\nend_header\n";
  for (const Object& object : objects) {
    const cv::Vec3b colour = segment_colour(object.label);
    for (const Eigen::Vector3d& p : object.mesh.vertices)
      out << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << int(colour[2]) << ' ' << int(colour[1]) << ' '
          << int(colour[0]) << '\n';
  }
  std::size_t first = 0;
  for (const Object& object : objects) {
    for (const auto& triangle : object.mesh.triangles) {
      out << 3;
      for (const int vertex : triangle) out << ' ' << first + std::size_t(vertex);
      out << ' ' << object.label << '\n';
    }
    first += object.mesh.vertices.size();
  }
  return out.str();
}

std::string obj(const std::vector<Object>& objects) {
  std::ostringstream out = text_stream();
  out << "# metres, camera frame: x right, y down, z forward\n";
  std::size_t first = 1;
  for (const Object& object : objects) {
    out << "o segment_" << object.label << '\n';
    for (const Eigen::Vector3d& p : object.mesh.vertices) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& triangle : object.mesh.triangles) {
      out << 'f';
      for (const int vertex : triangle) out << ' ' << first + std::size_t(vertex);
      out << '\n';
    }
    first += object.mesh.vertices.size();
  }
  return out.str();
}

std::string json(const std::vector<Object>& objects, const std::string& scene) {
  nlohmann::ordered_json segments = nlohmann::ordered_json::array();
  for (const Object& object : objects) {
    nlohmann::ordered_json vertices = nlohmann::ordered_json::array();
    for (const Eigen::Vector3d& p : object.mesh.vertices) vertices.push_back({p.x(), p.y(), p.z()});
    segments.push_back(
        {{"label", object.label}, {"vertices", std::move(vertices)}, {"triangles", object.mesh.triangles}});
  }
  const nlohmann::ordered_json content{
      {"format", "gestalt-mesh"}, {"version", 1}, {"scene", scene}, {"segments", std::move(segments)}};
  return content.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void print(const std::string& name, const Storage& storage) {
  std::ostringstream line = text_stream();
  line << name << ": " << storage.points << " points, " << storage.planes << " planes, " << storage.bsplines
       << " B-splines, " << storage.raw_bytes() << " bytes as points, " << storage.bytes << " as surfaces, ratio "
       << std::setprecision(1) << storage.ratio() << ", RMS error " << std::setprecision(2) << 1000 * storage.rms()
       << " mm\n";
  std::cout << line.str();
}

/// What --format says, else the extension of --output, else ply. Throws ConfigError for an extension of another format.
std::string format_of(const Options& options) {
  if (!options.format.empty()) return options.format;
  const std::string extension = lower_extension(options.output);
  if (extension.empty()) return "ply";
  for (const char* format : formats)
    if (extension.substr(1) == format) return format;
  throw ConfigError("--output " + options.output.string() + ": meshes are written as .ply, .obj or .json, not as " +
                    extension + "; change the name, or add --format ply to keep it");
}

int export_surfaces(Options options) {
  const std::string format = format_of(options);
  std::error_code ignored;
  if (fs::is_directory(options.result, ignored)) options.result /= "result.json";
  require_not_read("--output", options.output, {options.result});
  const StoredResult result = read_result(options.result);
  if (!result.warning.empty()) std::cerr << "gestalt: warning: " << result.warning << '\n';
  TriangulationBudget budget;
  std::vector<Object> objects;
  for (const StoredResult::Segment& segment : result.segments)
    if (options.all || !segment.background) objects.push_back(reconstruct(options, result, segment, budget));
  write_file(options.output, format == "ply"   ? ply(objects)
                             : format == "obj" ? obj(objects)
                                               : json(objects, result.scene));
  Storage total;
  for (const Object& object : objects) {
    print("segment " + std::to_string(object.label), object.storage);
    total.add(object.storage);
  }
  print("all " + std::to_string(objects.size()), total);
  return success;
}

void add_export(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("export", "Write the surfaces of a result as a mesh; print their size and error");
  command->add_option("RESULT", options->result, "result.json of a scene, or the folder with it")->required();
  command->add_option("--output", options->output, "Mesh file to write")->required()->type_name("FILE");
  command
      ->add_option("--format", options->format, "Format of the mesh (default: by the extension of --output, else ply)")
      ->check(CLI::IsMember(std::vector<std::string>(formats.begin(), formats.end())));
  command->add_flag("--all", options->all, "Background as well as objects");
  command
      ->add_option("--tolerance", options->tolerance,
                   "Largest distance of a triangle's edge to its surface, millimetres")
      ->check(number_in(0.01, 1000.0))
      ->capture_default_str();
  command->footer("Example: gestalt export out/demo_scene/result.json --format ply --output demo.ply");
  command->callback([options, &run] { run = [options] { return export_surfaces(*options); }; });
}

const Subcommand subcommand(120, add_export);

}  // namespace

}  // namespace gestalt::app::export_command
