// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/config/config_schema.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "config_keys.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

namespace config {

namespace {

using Json = nlohmann::ordered_json;

const Json truth_values{true, false, "on", "off", "yes", "no"};

Json reference(const std::string& definition) { return {{"$ref", "#/definitions/" + definition}}; }

Json parameter_schema(const Parameter& p) {
  Json schema;
  switch (p.type) {
    case Parameter::Type::boolean:
      schema["enum"] = truth_values;
      break;
    case Parameter::Type::choice:
      schema["enum"] = p.choices;
      break;
    case Parameter::Type::integer:
    case Parameter::Type::real:
      const bool whole = p.type == Parameter::Type::integer;
      const auto bound = [&](double value) { return whole ? Json(std::int64_t(value)) : Json(value); };
      schema["type"] = whole ? "integer" : "number";
      if (std::isfinite(p.minimum)) schema["minimum"] = bound(p.minimum);
      if (std::isfinite(p.maximum)) schema["maximum"] = bound(p.maximum);
  }
  std::visit([&](const auto& value) { schema["default"] = value; }, p.default_value);
  schema["description"] = p.text + (p.unit.empty() ? "" : " (" + p.unit + ")");
  return schema;
}

Json settings_schema(const std::vector<Parameter>& parameters) {
  Json schema{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
  for (const Parameter& p : parameters) schema["properties"][p.name] = parameter_schema(p);
  return schema;
}

/// A condition on one key of an object.
Json where(const char* key, const std::string& value) {
  return {{"required", {key}}, {"properties", {{key, {{"const", value}}}}}};
}

Json without(const char* key) { return {{"not", {{"required", {key}}}}}; }

Json when(const Json& condition, const Json& properties) {
  return {{"if", condition}, {"then", {{"properties", properties}}}};
}

/// What the components of one kind are, as definitions that the keys refer to.
class Kind {
 public:
  Kind(const Registry& registry, const std::string& kind, Json& definitions)
      : registry_(registry), kind_(kind), names_(registry.names(kind)) {
    if (definitions.contains(kind + ".plugin")) return;
    define(definitions);
  }

 private:
  void define(Json& definitions) {
    Json descriptions = Json::array(), any_params = Json::array(), any_values = Json::array();
    for (const std::string& name : names_) {
      descriptions.push_back(registry_.find(kind_, name)->description);
      definitions[kind_ + "." + name + ".params"] = settings_schema(registry_.parameters(kind_, name));
      any_params.push_back(reference(kind_ + "." + name + ".params"));
      if (!relations()) continue;
      definitions[kind_ + "." + name + ".values"] = values_schema(name);
      any_values.push_back(reference(kind_ + "." + name + ".values"));
    }
    definitions[kind_ + ".plugin"] = {{"enum", names_}, {"enumDescriptions", std::move(descriptions)}};
    // A kind of which there is no plugin takes nothing.
    definitions[kind_ + ".any.params"] = names_.empty() ? Json(false) : Json{{"anyOf", std::move(any_params)}};
    if (relations())
      definitions[kind_ + ".any.values"] = names_.empty() ? Json(false) : Json{{"anyOf", std::move(any_values)}};
    definitions[kind_] = {{"anyOf", {reference(kind_ + ".plugin"), object(false)}}};
    definitions[kind_ + ".item"] = {{"anyOf", {reference(kind_ + ".plugin"), object(true)}}};
    definitions[kind_ + ".list"] = {{"anyOf", {items(), by_name()}}};
  }

  bool relations() const { return kind_ == kind_name<Relation>; }

  Json values_schema(const std::string& name) const {
    Json names = Json::array();
    for (const RelationValue& value : registry_.create<Relation>(name, {})->values()) names.push_back(value.name);
    return {{"anyOf", {{{"const", "all"}}, {{"type", "array"}, {"minItems", 1}, {"items", {{"enum", names}}}}}},
            {"description", "the values that the level has of this relation"}};
  }

  Json own(const std::string& name) const {
    Json properties{{"params", reference(kind_ + "." + name + ".params")}};
    if (relations()) properties["values"] = reference(kind_ + "." + name + ".values");
    return properties;
  }

  /// {plugin: gabor, params: {...}}; in a list with a name, which is the plugin's where none is given.
  Json object(bool listed) const {
    Json properties{{"plugin", reference(kind_ + ".plugin")}, {"params", {{"type", "object"}}}};
    if (relations()) properties["values"] = {{"type", {"array", "string"}}};
    if (listed) properties["name"] = name_schema();
    Json schema{{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
    if (listed) schema["anyOf"] = {{{"required", {"plugin"}}}, {{"required", {"name"}}}};
    Json rules = Json::array();
    for (const std::string& name : names_) rules.push_back(when(where("plugin", name), own(name)));
    rules.push_back(when(without("plugin"), own("any")));
    schema["allOf"] = std::move(rules);
    return schema;
  }

  static Json name_schema() {
    return {{"type", "string"},
            {"pattern", "^[A-Za-z0-9_-]+$"},
            {"not", {{"enum", truth_values}}},
            {"description", "the name under which lists merge; left out: the plugin's"}};
  }

  Json items() const { return {{"type", "array"}, {"items", reference(kind_ + ".item")}}; }

  /// `gabor: off`, `coarse: gabor` or `coarse: {plugin: gabor, params: {...}}`.
  Json by_name() const {
    const Json component{{"anyOf", {{{"enum", truth_values}}, reference(kind_)}}};
    Json properties;
    for (const std::string& name : names_) {
      properties[name] = component;
      properties[name]["description"] = registry_.find(kind_, name)->description;
      // A name that is a plugin's is that plugin where nothing else is said.
      properties[name]["if"] = without("plugin");
      properties[name]["then"] = {{"properties", own(name)}};
    }
    Json schema{{"type", "object"}, {"additionalProperties", component}, {"propertyNames", name_schema()}};
    if (!properties.empty()) schema["properties"] = std::move(properties);
    return schema;
  }

  const Registry& registry_;
  std::string kind_;
  std::vector<std::string> names_;
};

/// Makes the properties of a schema of config_keys().
class Writer {
 public:
  struct Property {
    std::string name;
    Json schema;
    Json needed = nullptr;  ///< what a config that extends none needs here; null: nothing
  };

  explicit Writer(const Registry& registry) : registry_(registry) {}

  Json write() {
    Draft unused;
    const std::vector<Property> keys = config_keys(*this, unused);
    Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Config of Gestalt"}};
    schema.update(object(keys));
    schema["required"] = {"schema_version"};
    schema["if"] = without("extends");
    schema["then"] = needed(keys);
    schema["definitions"] = std::move(definitions_);
    return schema;
  }

  Property version(const char* name, const char* text) { return {name, {{"const", 1}, {"description", text}}}; }
  Property base(const char* name, const char* text) { return {name, {{"type", "string"}, {"description", text}}}; }
  Property directories(const char* name, const char* text, std::vector<DirectoryDraft>&) {
    return {name, {{"type", "array"}, {"items", {{"type", "string"}}}, {"description", text}}};
  }
  Property value(const Parameter& declaration, std::optional<Node>&) {
    return {declaration.name, parameter_schema(declaration)};
  }
  Property file(const char* name, const char* text, std::optional<Node>&) {
    return {name, {{"type", {"string", "null"}}, {"description", text}}};
  }
  Property settings(const char* name, const char* text, const std::vector<Parameter>& parameters, Settings&) {
    Json schema = settings_schema(parameters);
    schema["description"] = text;
    return {name, std::move(schema)};
  }
  Property component(const char* name, const char* kind, const char* text, ComponentDraft&) {
    return described(name, text, kind, kind);
  }
  Property list(const char* name, const char* kind, const char* text, ComponentListDraft&) {
    return described(name, text, kind, std::string(kind) + ".list");
  }
  Property section(const char* name, const char* text, const std::vector<Property>& keys) {
    Json schema = object(keys);
    schema["description"] = text;
    return {name, std::move(schema), needed(keys)};
  }

 private:
  Property described(const char* name, const char* text, const char* kind, const std::string& definition) {
    const Kind define(registry_, kind, definitions_);
    // Beside $ref everything else is left out of account.
    return {name, {{"description", text}, {"allOf", {reference(definition)}}}, true};
  }

  static Json object(const std::vector<Property>& keys) {
    Json schema{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
    for (const Property& key : keys) schema["properties"][key.name] = key.schema;
    return schema;
  }

  static Json needed(const std::vector<Property>& keys) {
    Json schema{{"required", Json::array()}, {"properties", Json::object()}};
    for (const Property& key : keys) {
      if (key.needed.is_null() || key.name == name_of(Level::assembly)) continue;
      schema["required"].push_back(key.name);
      schema["properties"][key.name] = key.needed;
    }
    return schema;
  }

  const Registry& registry_;
  Json definitions_;
};

}  // namespace

}  // namespace config

nlohmann::ordered_json config_schema(const Registry& registry) { return config::Writer(registry).write(); }

}  // namespace gestalt
