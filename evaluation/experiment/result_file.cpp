// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "result_file.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/json_file.h"
#include "gestalt/core/base/output_file.h"

namespace gestalt {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* format_name = "gestalt-experiment";

/// JSON knows no numbers that are not finite.
Json number_json(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

double number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::string& text = json.get_ref<const std::string&>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return infinity;
  if (text == "-inf") return -infinity;
  throw Error("'" + text + "' is not a number");
}

// One function for each type says which members it has under which names; writing and reading go through it.

struct Writer {
  Json& json;
  void operator()(const char* name, const std::string& value) const { json[name] = value; }
  void operator()(const char* name, std::int64_t value) const { json[name] = value; }
  void operator()(const char* name, double value) const { json[name] = number_json(value); }
};

struct Reader {
  const Json& json;
  void operator()(const char* name, std::string& value) const { value = json.at(name).get<std::string>(); }
  void operator()(const char* name, std::int64_t& value) const { value = json.at(name).get<std::int64_t>(); }
  void operator()(const char* name, double& value) const { value = number_of(json.at(name)); }
};

void visit(const auto& go, auto& score) requires requires { score.overlap_f; }
{
  go("category", score.category);
  go("images", score.images);
  go("objects", score.objects);
  go("precision", score.precision);
  go("recall", score.recall);
  go("overlap_f", score.overlap_f);
  go("boundary_f", score.boundary_f);
  go("detected", score.detected);
}

void visit(const auto& go, auto& object) requires requires { object.scene; }
{
  go("scene", object.scene);
  go("category", object.category);
  go("precision", object.precision);
  go("recall", object.recall);
}

void visit(const auto& go, auto& value) requires requires { value.f_score; }
{
  go("name", value.name);
  go("f_score", value.f_score);
}

void visit(const auto& go, auto& count) requires requires { count.structural_pairs; }
{
  go("category", count.category);
  go("images", count.images);
  go("objects", count.objects);
  go("structural_pairs", count.structural_pairs);
  go("structural_same", count.structural_same);
  go("assembly_pairs", count.assembly_pairs);
  go("assembly_same", count.assembly_same);
}

void visit(const auto& go, auto& errors) requires requires { errors.balanced_error; }
{
  go("positive", errors.positive);
  go("negative", errors.negative);
  go("balanced_error", errors.balanced_error);
}

template <class Part>
Json part_json(const Part& part) {
  Json json;
  visit(Writer{json}, part);
  return json;
}

template <class Part>
Json list_json(const std::vector<Part>& parts) {
  Json json = Json::array();
  for (const Part& part : parts) json.push_back(part_json(part));
  return json;
}

template <class Part>
void read_part(const Json& json, Part& part) {
  visit(Reader{json}, part);
}

template <class Part>
void read_list(const Json& json, std::vector<Part>& parts) {
  for (const Json& entry : json) read_part(entry, parts.emplace_back());
}

ExperimentResult result_of(const Json& json) {
  ExperimentResult result;
  read_list(json.at("scores"), result.scores);
  read_part(json.at("structural"), result.structural);
  read_part(json.at("assembly"), result.assembly);
  read_list(json.at("structural_values"), result.structural_values);
  read_list(json.at("assembly_values"), result.assembly_values);
  read_list(json.at("learn"), result.learn);
  read_list(json.at("test"), result.test);
  read_list(json.at("objects"), result.objects);
  read_list(json.at("further"), result.further);
  if (result.scores.empty()) throw Error("it holds no scores");
  return result;
}

}  // namespace

Json to_json(const std::vector<CategoryScore>& scores) { return list_json(scores); }

Json to_json(const ExperimentResult& result) {
  return {{"scores", list_json(result.scores)},
          {"structural", part_json(result.structural)},
          {"assembly", part_json(result.assembly)},
          {"structural_values", list_json(result.structural_values)},
          {"assembly_values", list_json(result.assembly_values)},
          {"learn", list_json(result.learn)},
          {"test", list_json(result.test)},
          {"objects", list_json(result.objects)},
          {"further", list_json(result.further)}};
}

ResultFile::ResultFile(const OutputPath& store, std::string key)
    : key_(std::move(key)), file_(store / (digest(key_) + ".json")) {}

std::optional<ExperimentResult> ResultFile::read(const std::function<void(const std::string&)>& warning) const {
  const std::filesystem::path file = file_.path();
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  try {
    const std::string text = read_bytes(file, largest_json);
    parse_json(file.string(), text);
    const Json json = Json::parse(text);  // in its order, which the checksum is of
    if (json.at("format") != format_name) throw Error("it is not the result of an experiment");
    if (json.at("key") != key_) throw Error("it belongs to another experiment");
    if (json.at("checksum") != digest(json.at("result").dump())) throw Error("its checksum is wrong");
    return result_of(json.at("result"));
  } catch (const std::exception& reason) {
    if (warning) warning(file.string() + ": is damaged and will be computed again: " + reason.what());
    return std::nullopt;
  }
}

void ResultFile::write(const ExperimentResult& result) const {
  const Json json = to_json(result);
  const Json content{{"format", format_name}, {"key", key_}, {"checksum", digest(json.dump())}, {"result", json}};
  write_files({{file_, content.dump(1) + "\n"}});
}

}  // namespace gestalt
