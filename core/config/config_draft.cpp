// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_draft.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string_view>

#include "config_keys.h"
#include "gestalt/core/base/suggest.h"

namespace gestalt::config {

namespace {

/// A key that a mapping may have, and what reads its value.
struct Key {
  std::string name;
  std::function<void(const Node& value, const std::string& path)> read;
};

/// What `on`, `off` and their synonyms ask for; nothing for any other node.
std::optional<bool> switch_state(const Node& node) {
  if (node.kind != Node::Kind::scalar || node.quoted) return {};
  for (const char* word : {"on", "true", "yes"})
    if (node.text == word) return true;
  for (const char* word : {"off", "false", "no"})
    if (node.text == word) return false;
  return {};
}

class Layer {
 public:
  explicit Layer(Draft& draft) : draft_(draft), problems_(draft.problems) {}

  void read(const Node& root) { read_mapping(root, "", config_keys(*this, draft_)); }

  // What config_keys() makes keys with.

  Key version(const char* name, const char*) { return left_alone(name); }
  Key base(const char* name, const char*) { return left_alone(name); }
  Key section(const char* name, const char*, const std::vector<Key>& keys) {
    return {name, [this, keys](const Node& n, const std::string& p) { read_mapping(n, p, keys); }};
  }
  Key directories(const char* name, const char*, std::vector<DirectoryDraft>&) {
    return {name, [this](const Node& n, const std::string& p) { read_directories(n, p); }};
  }
  Key component(const char* name, const char*, const char*, ComponentDraft& into) {
    return {name, [this, &into](const Node& n, const std::string& p) { read_component(into, n, p); }};
  }
  Key list(const char* name, const char*, const char*, ComponentListDraft& into) {
    return {name, [this, &into](const Node& n, const std::string& p) { read_list(into, n, p); }};
  }
  Key settings(const char* name, const char*, const std::vector<Parameter>&, Settings& into) {
    return settings(name, into);
  }
  Key value(const Parameter& declaration, std::optional<Node>& into) {
    return file(declaration.name.c_str(), "", into);
  }
  Key file(const char* name, const char*, std::optional<Node>& into) {
    return {name, [this, &into](const Node& n, const std::string& p) {
              if (n.kind == Node::Kind::list || n.kind == Node::Kind::mapping)
                problems_.add(n.place, p, "expected one value, got " + n.description());
              else
                into = n;
            }};
  }

 private:
  Key left_alone(const char* name) {
    return {name, [](const Node&, const std::string&) {}};
  }
  Key settings(const char* name, Settings& into) {
    return {name, [this, &into](const Node& n, const std::string& p) { read_settings(into, n, p); }};
  }

  /// Reads the values in the order of keys, not of the text: a plugin before its params.
  void read_mapping(const Node& node, const std::string& path, const std::vector<Key>& keys) {
    if (node.kind != Node::Kind::mapping) {
      problems_.add(node.place, path, "expected keys and values, got " + node.description());
      return;
    }
    std::vector<std::string> names;
    names.reserve(keys.size());
    for (const Key& key : keys) names.push_back(key.name);
    for (const Entry& entry : node.entries)
      if (std::find(names.begin(), names.end(), entry.key) == names.end())
        problems_.add(entry.place, join(path, entry.key), "unknown key" + did_you_mean(entry.key, names));
    for (const Key& key : keys)
      if (const Node* found = node.find(key.name)) key.read(*found, join(path, key.name));
  }

  void read_settings(Settings& settings, const Node& node, const std::string& path) {
    if (node.kind != Node::Kind::mapping) {
      problems_.add(node.place, path, "expected names and values, got " + node.description());
      return;
    }
    for (const Entry& entry : node.entries) {
      if (entry.value.kind == Node::Kind::scalar)
        settings.insert_or_assign(entry.key, entry);
      else
        problems_.add(entry.value.place, join(path, entry.key), "expected one value, got " + entry.value.description());
    }
  }

  /// Directories of this layer are searched before those of the layers below.
  void read_directories(const Node& node, const std::string& path) {
    if (node.kind != Node::Kind::list) {
      problems_.add(node.place, path, "expected a list of directories, got " + node.description());
      return;
    }
    std::vector<DirectoryDraft> directories;
    for (const Entry& item : node.entries) {
      if (item.value.kind == Node::Kind::scalar)
        directories.push_back(
            {(item.value.place.source->directory / item.value.text).lexically_normal(), item.value.place});
      else
        problems_.add(item.value.place, path, "expected a directory, got " + item.value.description());
    }
    auto& all = draft_.plugin_directories;
    all.insert(all.begin(), directories.begin(), directories.end());
  }

  void read_component(ComponentDraft& component, const Node& node, const std::string& path,
                      const std::vector<Key>& other_keys = {}) {
    component.place = node.place;
    if (node.kind == Node::Kind::scalar) {
      set_plugin(component, node, path);
    } else if (node.kind == Node::Kind::mapping) {
      std::vector<Key> keys{{"plugin", [&](const Node& n, const std::string& p) { set_plugin(component, n, p); }},
                            settings("params", component.params)};
      keys.insert(keys.end(), other_keys.begin(), other_keys.end());
      read_mapping(node, path, keys);
    } else {
      problems_.add(node.place, path,
                    "expected a plugin's name or {plugin: name, params: {...}}, got " + node.description());
    }
  }

  void set_plugin(ComponentDraft& component, const Node& node, const std::string& path) {
    if (node.kind != Node::Kind::scalar || switch_state(node)) {
      problems_.add(node.place, path,
                    "expected a plugin's name, got " + node.description() +
                        "; on and off are for a component of a list, as in 'relations: {name: off}'");
      return;
    }
    if (component.plugin && component.plugin->text != node.text) {
      component.params.clear();
      component.values.reset();
    }
    component.plugin = node;
  }

  void read_values(ComponentDraft& component, const Node& node, const std::string& path) {
    const auto is_scalar = [](const Entry& entry) { return entry.value.kind == Node::Kind::scalar; };
    const bool all = node.kind == Node::Kind::scalar && node.text == "all" && !node.quoted;
    const bool some = node.kind == Node::Kind::list && !node.entries.empty() &&
                      std::all_of(node.entries.begin(), node.entries.end(), is_scalar);
    if (all || some)
      component.values = node;
    else
      problems_.add(node.place, path,
                    "expected a list of the relation's values, as in [r_cu3], or all" +
                        (node.kind == Node::Kind::list ? "" : ", got " + node.description()));
  }

  /// The keys of a listed component beside those that every component has.
  std::vector<Key> listed_keys(const ComponentListDraft& list, ComponentDraft& component) {
    if (!list.relations) return {};
    return {{"values", [&](const Node& n, const std::string& p) { read_values(component, n, p); }}};
  }

  /// A list merges by name into what the layers below have: new names go to the end.
  void read_list(ComponentListDraft& list, const Node& node, const std::string& path) {
    list.place = node.place;
    if (node.kind == Node::Kind::list) {
      std::set<std::string> seen;
      for (std::size_t i = 0; i < node.entries.size(); ++i)
        read_item(list, node.entries[i].value, path, path + "[" + std::to_string(i) + "]", seen);
    } else if (node.kind == Node::Kind::mapping) {
      for (const Entry& entry : node.entries) read_named(list, entry, path);
    } else {
      problems_.add(node.place, path, "expected a list of components, got " + node.description());
    }
  }

  /// `gabor` or `{name: fine_gabor, plugin: gabor, params: {...}}`.
  void read_item(ComponentListDraft& list, const Node& item, const std::string& list_path, const std::string& item_path,
                 std::set<std::string>& seen) {
    const Node* name = &item;
    if (item.kind == Node::Kind::mapping) {
      name = item.find("name");
      if (name == nullptr) name = item.find("plugin");
      if (name == nullptr) {
        problems_.add(item.place, item_path, "expected a component with a 'plugin:', got none");
        return;
      }
    }
    if (!check_name(*name, item_path)) return;
    const std::string path = join(list_path, name->text);
    if (!seen.insert(name->text).second) {
      problems_.add(item.place, path, "duplicate name in the list; give one of the two another 'name:'");
      return;
    }
    ComponentDraft& component = switch_on(list, *name);
    std::vector<Key> keys = listed_keys(list, component);
    keys.push_back({"name", [](const Node&, const std::string&) {}});
    read_component(component, item, path, keys);
    if (!component.plugin) component.plugin = *name;
  }

  /// `gabor: on`, `gabor: off`, `fine_gabor: gabor` or `gabor: {plugin: gabor, params: {...}}`.
  void read_named(ComponentListDraft& list, const Entry& entry, const std::string& list_path) {
    const std::string path = join(list_path, entry.key);
    const Node name = scalar(entry.key, entry.place);
    if (!check_name(name, path)) return;
    const std::optional<bool> state = switch_state(entry.value);
    if (state == false) {
      switch_off(list, entry, path);
      return;
    }
    ComponentDraft& component = switch_on(list, name);
    if (!state) read_component(component, entry.value, path, listed_keys(list, component));
    if (!component.plugin) component.plugin = name;
  }

  /// Names are parts of the dotted paths of --set.
  bool check_name(const Node& name, const std::string& path) {
    const auto allowed = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    if (name.kind != Node::Kind::scalar || switch_state(name)) {
      problems_.add(name.place, path, "expected a component's name, got " + name.description());
      return false;
    }
    if (name.text.empty() || !std::all_of(name.text.begin(), name.text.end(), allowed)) {
      problems_.add(name.place, path,
                    "a component's name is of letters, digits, '_' and '-', got " + name.description());
      return false;
    }
    return true;
  }

  static ComponentDraft* find(ComponentListDraft& list, const std::string& name) {
    for (ComponentDraft& component : list.components)
      if (component.name == name) return &component;
    return nullptr;
  }

  ComponentDraft& switch_on(ComponentListDraft& list, const Node& name) {
    ComponentDraft* component = find(list, name.text);
    if (component == nullptr) {
      component = &list.components.emplace_back();
      component->name = name.text;
    }
    component->on = true;
    component->place = name.place;
    return *component;
  }

  void switch_off(ComponentListDraft& list, const Entry& entry, const std::string& path) {
    if (ComponentDraft* component = find(list, entry.key)) {
      component->on = false;
      component->place = entry.place;
      return;
    }
    std::vector<std::string> names;
    for (const ComponentDraft& component : list.components) names.push_back(component.name);
    problems_.add(entry.place, path, "the list has no component of this name" + did_you_mean(entry.key, names));
  }

  Draft& draft_;
  Problems& problems_;
};

}  // namespace

void merge(Draft& draft, const Node& root) {
  if (root.kind != Node::Kind::null) Layer(draft).read(root);
}

}  // namespace gestalt::config
