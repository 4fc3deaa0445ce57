// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/registry.h"

#include <dlfcn.h>

#include <algorithm>
#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/dll/shared_library.hpp>
#include <cstdlib>
#include <sstream>

#include "gestalt/core/base/suggest.h"
#include "gestalt/core/plugin/component_call.h"
#include "gestalt/core/plugin/fingerprint.h"
#include "gestalt/core/plugin/manifest.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kinds(kind_names.begin(), kind_names.end());

// Bound completely at once, so that an undefined symbol is an error here and not a crash later; never unloaded, so that
// no object can outlive its code.
const auto load_mode = static_cast<boost::dll::load_mode::type>(RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);

std::string first_line(std::string text) { return text.substr(0, text.find('\n')); }

/// Why a manifest cannot be taken, or "". Looks at nothing behind a field that does not match.
std::string mismatch(const gestalt_manifest* manifest) {
  if (manifest == nullptr || manifest->magic != GESTALT_MANIFEST_MAGIC) return "its manifest is not a Gestalt manifest";
  if (manifest->interface_version != GESTALT_INTERFACE_VERSION)
    return "it was built for plugin interface " + std::to_string(manifest->interface_version) + ", this core has " +
           std::to_string(GESTALT_INTERFACE_VERSION) + "; rebuild it against this core";
  if (manifest->fingerprint == nullptr || manifest->fingerprint != build_fingerprint())
    return std::string("it was built as [") + (manifest->fingerprint ? manifest->fingerprint : "?") +
           "], this core as [" + build_fingerprint() + "]; rebuild it with the core's compiler flags and libraries";
  for (std::uint32_t i = 0; i < manifest->component_count; ++i) {
    const gestalt_component& c = manifest->components[i];
    if (!c.kind || !c.name || !c.version || !c.description || !c.factory) return "its manifest is incomplete";
    if (std::find(kinds.begin(), kinds.end(), c.kind) == kinds.end())
      return std::string("component '") + c.name + "' has the unknown kind '" + c.kind + "'" +
             did_you_mean(c.kind, kinds);
  }
  return "";
}

}  // namespace

fs::path core_library() { return fs::weakly_canonical(boost::dll::this_line_location().string()); }

Registry::Registry(std::vector<fs::path> directories) : searched_(std::move(directories)) {
  std::vector<fs::path> opened;
  for (const fs::path& directory : searched_) {
    std::vector<fs::path> libraries;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, error))
      if (entry.path().extension() == ".so") libraries.push_back(entry.path());
    std::sort(libraries.begin(), libraries.end());
    for (const fs::path& library : libraries) {
      // A directory that is listed twice is not a duplicate component.
      const fs::path canonical = fs::weakly_canonical(library, error);
      if (std::find(opened.begin(), opened.end(), canonical) != opened.end()) continue;
      opened.push_back(canonical);
      open(library);
    }
  }
}

void Registry::open(const fs::path& library) {
  const gestalt_manifest* manifest = nullptr;
  std::error_code ignored;
  if (!fs::is_regular_file(library, ignored)) {  // a pipe would be waited for without end
    rejected_.push_back({library, "it is not a regular file"});
    return;
  }
  try {
    boost::dll::shared_library handle(library.string(), load_mode);
    if (!handle.has(GESTALT_ENTRY_SYMBOL)) {
      rejected_.push_back({library, "it has no symbol " GESTALT_ENTRY_SYMBOL ", so it is not a plugin"});
      return;
    }
    manifest = handle.get<const gestalt_manifest*()>(GESTALT_ENTRY_SYMBOL)();
  } catch (const std::exception& error) {
    rejected_.push_back({library, first_line(error.what())});
    return;
  }
  if (const std::string reason = mismatch(manifest); !reason.empty()) {
    rejected_.push_back({library, reason});
    return;
  }
  for (std::uint32_t i = 0; i < manifest->component_count; ++i) {
    const gestalt_component& c = manifest->components[i];
    require_new(c.kind, c.name, library);
    const void* factory = nullptr;
    try {
      factory = c.factory();
    } catch (const std::exception& error) {
      rejected_.push_back({library, std::string("the factory of '") + c.name + "' failed: " + error.what()});
      continue;
    } catch (...) {
      rejected_.push_back({library, std::string("the factory of '") + c.name + "' failed"});
      continue;
    }
    if (factory == nullptr) {
      rejected_.push_back({library, std::string("the factory of '") + c.name + "' returned nothing"});
      continue;
    }
    append({c.kind, c.name, c.version, c.description, library},
           std::shared_ptr<const void>(std::shared_ptr<void>(), factory));
  }
}

void Registry::require_new(std::string_view kind, std::string_view name, const fs::path& library) const {
  if (const ComponentInfo* other = find(kind, name))
    throw PluginError("two plugins offer the " + other->kind + " '" + other->name + "': " + other->library.string() +
                      " and " + library.string() + "; remove one of them or its directory from the search path");
}

void Registry::append(ComponentInfo info, std::shared_ptr<const void> factory) {
  components_.push_back(std::move(info));
  factories_.push_back(std::move(factory));
}

template <class Kind>
void Registry::add(ComponentInfo info, Factory<Kind> factory) {
  info.kind = kind_name<Kind>;
  require_new(info.kind, info.name, info.library);
  append(std::move(info), std::make_shared<const Factory<Kind>>(std::move(factory)));
}

template GESTALT_EXPORT void Registry::add(ComponentInfo, Factory<Clusterer>);
template GESTALT_EXPORT void Registry::add(ComponentInfo, Factory<Fitter>);
template GESTALT_EXPORT void Registry::add(ComponentInfo, Factory<Relation>);
template GESTALT_EXPORT void Registry::add(ComponentInfo, Factory<Classifier>);
template GESTALT_EXPORT void Registry::add(ComponentInfo, Factory<Solver>);

std::vector<std::string> Registry::names(std::string_view kind) const {
  std::vector<std::string> names;
  for (const ComponentInfo& c : components_)
    if (c.kind == kind) names.push_back(c.name);
  std::sort(names.begin(), names.end());
  return names;
}

const ComponentInfo* Registry::find(std::string_view kind, std::string_view name) const {
  for (const ComponentInfo& c : components_)
    if (c.kind == kind && c.name == name) return &c;
  return nullptr;
}

const void* Registry::factory(std::string_view kind, std::string_view name) const {
  if (const ComponentInfo* found = find(kind, name)) return factories_[std::size_t(found - components_.data())].get();
  std::ostringstream message;
  message << "there is no " << kind << " '" << name << "'" << did_you_mean(name, names(kind)) << "\n  known:";
  for (const std::string& known : names(kind)) message << ' ' << known;
  message << "\n  searched:";
  for (const fs::path& directory : searched_) message << "\n    " << directory.string();
  if (!rejected_.empty()) message << "\n  rejected:";
  for (const RejectedLibrary& r : rejected_) message << "\n    " << r.library.string() << ": " << r.reason;
  throw PluginError(message.str());
}

namespace {

/// Calls f with the factory as its own type.
template <class F>
decltype(auto) with_kind(std::string_view kind, const void* factory, F f) {
  if (kind == kind_name<Clusterer>) return f(*static_cast<const Factory<Clusterer>*>(factory));
  if (kind == kind_name<Fitter>) return f(*static_cast<const Factory<Fitter>*>(factory));
  if (kind == kind_name<Relation>) return f(*static_cast<const Factory<Relation>*>(factory));
  if (kind == kind_name<Classifier>) return f(*static_cast<const Factory<Classifier>*>(factory));
  return f(*static_cast<const Factory<Solver>*>(factory));
}

}  // namespace

const std::vector<Parameter>& Registry::parameters(std::string_view kind, std::string_view name) const {
  return with_kind(kind, factory(kind, name),
                   [](const auto& typed) -> const std::vector<Parameter>& { return typed.parameters; });
}

template <class Kind>
std::shared_ptr<const Kind> Registry::create(std::string_view name, const ParameterValues& values) const {
  const auto* typed = static_cast<const Factory<Kind>*>(factory(kind_name<Kind>, name));
  const std::string who = std::string(kind_name<Kind>) + " '" + std::string(name) + "'";
  std::shared_ptr<const Kind> product;
  try {
    product = owned(component_name(kind_name<Kind>, std::string(name)), typed->create(values));
  } catch (const ConfigError& error) {
    throw ConfigError(who + ": " + error.what());
  } catch (const std::exception& error) {
    throw PluginError(who + " could not be created: " + error.what());
  } catch (...) {
    throw PluginError(who + " could not be created: its factory threw something other than an exception");
  }
  if (!product) throw PluginError(who + " could not be created: its factory returned nothing");
  return product;
}

template GESTALT_EXPORT std::shared_ptr<const Clusterer> Registry::create(std::string_view,
                                                                          const ParameterValues&) const;
template GESTALT_EXPORT std::shared_ptr<const Fitter> Registry::create(std::string_view, const ParameterValues&) const;
template GESTALT_EXPORT std::shared_ptr<const Relation> Registry::create(std::string_view,
                                                                         const ParameterValues&) const;
template GESTALT_EXPORT std::shared_ptr<const Classifier> Registry::create(std::string_view,
                                                                           const ParameterValues&) const;
template GESTALT_EXPORT std::shared_ptr<const Solver> Registry::create(std::string_view, const ParameterValues&) const;

std::vector<fs::path> plugin_search_path(const std::vector<fs::path>& from_config) {
  std::vector<fs::path> path = from_config;
  if (const char* variable = std::getenv("GESTALT_PLUGIN_PATH")) {
    std::stringstream entries(variable);
    for (std::string entry; std::getline(entries, entry, ':');)
      if (fs::path(entry).is_absolute()) path.emplace_back(entry);
  }
  path.push_back(core_library().parent_path() / "gestalt" / "plugins");
  return path;
}

fs::path data_directory() { return core_library().parent_path().parent_path() / "share" / "gestalt"; }

std::string build_fingerprint() { return GESTALT_BUILD_FINGERPRINT; }

}  // namespace gestalt
