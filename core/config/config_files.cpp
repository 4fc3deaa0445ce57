// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_files.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "config_yaml.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/suggest.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt::config {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_file = 1 << 20;  // bytes
constexpr std::size_t longest_chain = 16;

/// The text of a file. Throws ConfigError that says why there is none.
std::string read_text(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored))
    throw ConfigError("cannot read config '" + file.string() + "': it is a directory");
  // Opening a pipe would wait for its writer, and a device may have no end.
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
    throw ConfigError("cannot read config '" + file.string() + "': it is a pipe or device; copy it to a regular file");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string text(largest_file + 1, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  if (!stream.is_open() || stream.bad())
    throw ConfigError("cannot read config '" + file.string() + "': " + std::generic_category().message(errno));
  text.resize(std::size_t(stream.gcount()));
  if (text.size() > largest_file)
    throw ConfigError("cannot read config '" + file.string() + "': it is larger than 1 MiB, so it is not a config");
  return text;
}

/// The file, or where there is none the installed config of that name, which may lack its .yaml.
fs::path found(const fs::path& file, const fs::path& name) {
  std::error_code ignored;
  if (fs::exists(file, ignored)) return file;
  fs::path installed = data_directory() / "configs" / name;
  if (!name.has_extension()) installed.replace_extension(".yaml");
  return fs::exists(installed, ignored) ? installed : file;
}

/// Throws ConfigError where a name without folder is neither a file nor installed.
void require_known(const fs::path& file, const fs::path& name) {
  std::error_code ignored;
  if (name.has_parent_path() || name.empty() || fs::exists(file, ignored)) return;
  std::vector<std::string> installed;
  for (const auto& entry : fs::directory_iterator(data_directory() / "configs", ignored))
    if (entry.path().extension() == ".yaml") installed.push_back(entry.path().stem().string());
  std::sort(installed.begin(), installed.end());
  std::string names;
  for (const std::string& one : installed) names += (names.empty() ? "" : ", ") + one;
  throw ConfigError("there is no config '" + name.string() +
                    "' in this folder, and none of that name among those installed" +
                    (names.empty() ? "" : ", which are " + names) + did_you_mean(name.stem().string(), installed));
}

/// Refuses control characters: yaml-cpp takes one of them for the end of the file, and reads UTF-16 as well.
void check_characters(const std::string& text, const std::shared_ptr<const Source>& source, Problems& problems) {
  const auto bad = std::find_if(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
  });
  if (bad == text.end()) return;
  const auto line_start = std::find(std::make_reverse_iterator(bad), text.rend(), '\n').base();
  const Place place{source, 1 + int(std::count(text.begin(), bad, '\n')), 1 + int(bad - line_start)};
  problems.add(place, "", "control character; a config is a UTF-8 text file");
  problems.throw_if_any();
}

void check_root(Node& root, Problems& problems) {
  const Place start{root.place.source, 1, 1};
  const Node* version = root.find("schema_version");
  if (root.kind == Node::Kind::null) {
    problems.add(start, "", "the file is empty; a config begins with 'schema_version: 1'");
  } else if (root.kind != Node::Kind::mapping) {
    problems.add(start, "", "expected keys and values, got " + root.description());
    root.kind = Node::Kind::null;
  } else if (version == nullptr) {
    problems.add(start, "schema_version", "is missing; this program reads 'schema_version: 1'");
  } else if (version->quoted || version->text != "1") {
    problems.add(version->place, "schema_version",
                 "expected 1, the version this program reads, got " + version->description() +
                     (version->quoted ? " in quotes" : ""));
  }
}

/// A config and the files it extends, from it to the last of them.
class Chain {
 public:
  explicit Chain(Problems& problems) : problems_(problems) {}

  std::vector<Node> read(const fs::path& first) {
    const fs::path file = found(first, first);
    require_known(file, first);
    append(file, open(file));
    while (const Node* extends = extended()) {
      const fs::path base = found((files_.back().parent_path() / extends->text).lexically_normal(), extends->text);
      std::string text;
      try {
        text = open(base);
      } catch (const ConfigError& error) {
        problems_.add(extends->place, "extends", error.what());
        problems_.throw_if_any();
      }
      append(base, text);
    }
    return std::move(roots_);
  }

 private:
  std::string open(const fs::path& file) const {
    std::error_code ignored;
    for (const fs::path& other : files_)
      if (fs::weakly_canonical(other, ignored) == fs::weakly_canonical(file, ignored))
        throw ConfigError("the config extends itself: " + text(file));
    if (files_.size() == longest_chain)
      throw ConfigError("more than " + std::to_string(longest_chain) + " configs extend each other: " + text(file));
    return read_text(file);
  }

  void append(const fs::path& file, const std::string& content) {
    // Two files of one name are distinguished by their whole path.
    const bool known_name = std::any_of(files_.begin(), files_.end(),
                                        [&](const fs::path& other) { return other.filename() == file.filename(); });
    const auto source =
        std::make_shared<const Source>(Source{file.string(), known_name ? file.string() : file.filename().string(),
                                              fs::absolute(file).lexically_normal().parent_path(), true});
    files_.push_back(file);
    check_characters(content, source, problems_);
    roots_.push_back(parse_yaml(content, source, problems_));
    check_root(roots_.back(), problems_);
  }

  /// The name of the file that the last one extends; null when it extends none.
  const Node* extended() {
    const Node* extends = roots_.back().find("extends");
    if (extends == nullptr || extends->kind == Node::Kind::scalar) return extends;
    problems_.add(extends->place, "extends", "expected the name of one file, got " + extends->description());
    return nullptr;
  }

  std::string text(const fs::path& last) const {
    std::string text;
    for (const fs::path& file : files_) text += file.string() + " -> ";
    return text + last.string();
  }

  Problems& problems_;
  std::vector<fs::path> files_;
  std::vector<Node> roots_;
};

}  // namespace

std::vector<Node> read_files(const fs::path& file, Problems& problems) {
  std::vector<Node> roots = Chain(problems).read(file);
  std::reverse(roots.begin(), roots.end());
  return roots;
}

Node read_root(const std::string& name, const std::string& text, Problems& problems) {
  const auto source = std::make_shared<const Source>(Source{name, name, fs::current_path(), true});
  check_characters(text, source, problems);
  Node root = parse_yaml(text, source, problems);
  check_root(root, problems);
  if (const Node* extends = root.find("extends"))
    problems.add(extends->place, "extends", "'extends' is allowed only in a file");
  return root;
}

}  // namespace gestalt::config
