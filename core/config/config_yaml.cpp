// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "config_yaml.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "gestalt/core/base/error.h"

namespace gestalt::config {

namespace {

constexpr std::size_t deepest = 32;
constexpr std::size_t most_values = 10000;

std::size_t size(const Node& node) {
  std::size_t count = 1;
  for (const Entry& entry : node.entries) count += size(entry.value);
  return count;
}

/// Builds nodes from the parser's events. yaml-cpp's own document keeps the first of two equal keys in silence, gives
/// no place for a missing one and reads 010 as 8; its events have everything that is needed to do better.
class Builder final : public YAML::EventHandler {
 public:
  Builder(const std::shared_ptr<const Source>& source, Problems& problems) : source_(source), problems_(problems) {}

  Node take() { return std::move(root_); }

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) {
    problems_.add(place(mark), path(), message);
    problems_.throw_if_any();
    throw ConfigError(message);  // not reached: there is a problem
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (document_seen_) fail(mark, "second YAML document; a config file holds one document");
    document_seen_ = true;
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    Node node;
    node.place = place(mark);
    // The parser places a missing value where it noticed that, which may be lines below its key.
    if (!open_.empty() && open_.back().key) node.place = open_.back().key->place;
    count(1, mark);
    add(std::move(node), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = complete_.find(anchor);
    if (found == complete_.end()) fail(mark, "the alias refers to a value that contains it");
    count(size(found->second), mark);
    add(found->second, YAML::NullAnchor);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    Node node = scalar(value, place(mark));
    node.quoted = tag == "!";
    if (tag != "!") refuse(tag, mark);
    count(1, mark);
    add(std::move(node), anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    begin(Node::Kind::list, mark, tag, anchor);
  }
  void OnSequenceEnd() override { end(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(Node::Kind::mapping, mark, tag, anchor);
  }
  void OnMapEnd() override { end(); }

 private:
  /// A list or mapping whose end has not been met.
  struct Open {
    Node node;
    YAML::anchor_t anchor;
    std::optional<Entry> key;  ///< mapping: the key whose value comes next
  };

  Place place(const YAML::Mark& mark) const {
    return {source_, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1};
  }

  std::string path() const {
    std::string path;
    for (const Open& open : open_) {
      if (open.node.kind == Node::Kind::list) path += "[" + std::to_string(open.node.entries.size()) + "]";
      if (open.key) path = join(path, open.key->key);
    }
    return path;
  }

  void refuse(const std::string& tag, const YAML::Mark& mark) {
    if (!tag.empty() && tag != "?") problems_.add(place(mark), path(), "tags like '" + tag + "' are not supported");
  }

  void begin(Node::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    refuse(tag, mark);
    count(1, mark);
    if (open_.size() == deepest) fail(mark, "values are nested deeper than " + std::to_string(deepest) + " levels");
    Node node;
    node.kind = kind;
    node.place = place(mark);
    open_.push_back({std::move(node), anchor, {}});
  }

  void end() {
    Open closed = std::move(open_.back());
    open_.pop_back();
    add(std::move(closed.node), closed.anchor);
  }

  /// Aliases of aliases can stand for billions of values.
  void count(std::size_t values, const YAML::Mark& mark) {
    values_ += values;
    if (values_ > most_values) fail(mark, "more than " + std::to_string(most_values) + " values");
  }

  /// Puts a complete node where it belongs.
  void add(Node node, YAML::anchor_t anchor) {
    if (anchor != YAML::NullAnchor) complete_[anchor] = node;
    if (open_.empty()) {
      root_ = std::move(node);
    } else if (Open& parent = open_.back(); parent.node.kind == Node::Kind::list) {
      parent.node.entries.push_back({"", node.place, std::move(node)});
    } else if (!parent.key) {
      add_key(parent, std::move(node));
    } else {
      add_value(parent, std::move(node));
    }
  }

  void add_key(Open& parent, Node key) {
    if (key.kind != Node::Kind::scalar)
      problems_.add(key.place, path(), "a key must be plain text, got " + key.description());
    parent.key = {std::move(key.text), key.place, {}};
  }

  void add_value(Open& parent, Node value) {
    Entry& key = *parent.key;
    std::vector<Entry>& entries = parent.node.entries;
    const auto first = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key.key; });
    if (key.key == "<<") {
      problems_.add(key.place, path(), "YAML's merge keys are not supported; include another file with 'extends:'");
    } else if (first != entries.end()) {
      problems_.add(key.place, path(), "duplicate key, first at line " + std::to_string(first->place.line));
    } else {
      key.value = std::move(value);
      entries.push_back(std::move(key));
    }
    parent.key.reset();
  }

  std::shared_ptr<const Source> source_;
  Problems& problems_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Node> complete_;
  std::size_t values_ = 0;
  bool document_seen_ = false;
  Node root_;
};

}  // namespace

Node parse_yaml(const std::string& text, const std::shared_ptr<const Source>& source, Problems& problems) {
  Builder builder(source, problems);
  std::istringstream stream(text);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    builder.fail(error.mark, "not valid YAML: " + error.msg);
  }
  Node root = builder.take();
  if (root.place.source == nullptr) root.place.source = source;
  return root;
}

}  // namespace gestalt::config
