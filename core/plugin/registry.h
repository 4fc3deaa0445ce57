// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/plugin/factory.h"

namespace gestalt {

/// A component that a loaded plugin offers.
struct ComponentInfo {
  std::string kind;
  std::string name;
  std::string version;
  std::string description;
  std::filesystem::path library;
};

/// A library that was found but not taken, with the reason in the loader's own words.
struct RejectedLibrary {
  std::filesystem::path library;
  std::string reason;
};

/// The components of all plugins in a list of directories, and of the program. Libraries are bound completely when they
/// are opened and never unloaded, so whatever a component makes may outlive the registry. Immutable once made; const
/// use from many threads is safe.
class GESTALT_EXPORT Registry {
 public:
  /// Opens every *.so of the directories, in order of directory, then of file name. A directory that does not exist is
  /// remembered as searched and is not an error. Throws PluginError when two libraries offer the same kind and name.
  explicit Registry(std::vector<std::filesystem::path> directories);

  /// Adds a component of the running program, such as one of another language, before the registry is used. info.kind
  /// is set; info.library is the origin that messages name. Throws PluginError when there is one of that name.
  template <class Kind>
  void add(ComponentInfo info, Factory<Kind> factory);

  const std::vector<std::filesystem::path>& searched() const { return searched_; }
  const std::vector<ComponentInfo>& components() const { return components_; }
  const std::vector<RejectedLibrary>& rejected() const { return rejected_; }

  /// Names of one kind, sorted.
  std::vector<std::string> names(std::string_view kind) const;

  /// Null when there is none.
  const ComponentInfo* find(std::string_view kind, std::string_view name) const;

  /// Declared parameters of a component. Throws PluginError as create() does.
  const std::vector<Parameter>& parameters(std::string_view kind, std::string_view name) const;

  /// Makes a component. Throws PluginError when there is none of that kind and name (the message says what was
  /// searched, what was rejected and why, and the closest names) or its factory throws, ConfigError for wrong values.
  template <class Kind>
  std::shared_ptr<const Kind> create(std::string_view name, const ParameterValues& values) const;

 private:
  const void* factory(std::string_view kind, std::string_view name) const;
  void open(const std::filesystem::path& library);
  void require_new(std::string_view kind, std::string_view name, const std::filesystem::path& library) const;
  void append(ComponentInfo info, std::shared_ptr<const void> factory);

  std::vector<std::filesystem::path> searched_;
  std::vector<ComponentInfo> components_;
  std::vector<std::shared_ptr<const void>> factories_;  // parallel to components_; those of plugins are theirs
  std::vector<RejectedLibrary> rejected_;
};

/// Directories in search order: those given (from the config), the entries of GESTALT_PLUGIN_PATH, and the plugin
/// directory beside the core library itself. Never the current directory; relative entries of the environment variable
/// are left out.
GESTALT_EXPORT std::vector<std::filesystem::path> plugin_search_path(
    const std::vector<std::filesystem::path>& from_config);

/// The file of the core library.
GESTALT_EXPORT std::filesystem::path core_library();

/// Where configs/ and models/ of this installation (or build tree) are, found from the core library itself.
GESTALT_EXPORT std::filesystem::path data_directory();

/// The fingerprint that plugins must have.
GESTALT_EXPORT std::string build_fingerprint();

}  // namespace gestalt
