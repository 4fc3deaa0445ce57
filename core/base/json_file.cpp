// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/json_file.h"

#include <algorithm>
#include <new>
#include <nlohmann/json.hpp>
#include <vector>

#include "gestalt/core/base/error.h"

namespace gestalt {

using nlohmann::json;

namespace {

/// Bytes that values may take for each byte of text, and beside that. A list of numbers of one digit takes 8, results
/// and models take 4; lists without a value take 20 and more.
constexpr std::size_t memory_per_byte = 12;
constexpr std::size_t memory_beside = std::size_t{64} << 20;

/// Of one value, and what a list and a member of an object take beside it.
constexpr std::size_t value_memory = sizeof(json), list_memory = 48, member_memory = 80;

/// "3:17" of the byte of a text, counted from 1.
std::string place_of(std::size_t byte, std::string_view text) {
  const std::string_view before = text.substr(0, std::min(text.size(), std::max<std::size_t>(byte, 1) - 1));
  const std::size_t line_begin = before.rfind('\n') + 1;  // of npos: 0
  return std::to_string(1 + std::count(before.begin(), before.end(), '\n')) + ":" +
         std::to_string(before.size() - line_begin + 1);
}

/// Makes the values that the parser tells of one after the other, without recursion.
class Builder {
 public:
  Builder(const std::string& name, std::string_view text, std::size_t deepest)
      : name_(name), text_(text), deepest_(deepest), most_memory_(memory_beside + memory_per_byte * text.size()) {}

  json take() { return std::move(root_); }

  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(json::number_integer_t value) { return put(value); }
  bool number_unsigned(json::number_unsigned_t value) { return put(value); }
  bool number_float(json::number_float_t value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(json::binary_t&) { return false; }  // no text has any
  bool start_object(std::size_t) { return open(json::object()); }
  bool start_array(std::size_t) { return open(json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& key) {
    take_memory(member_memory + key.size());
    const auto [member, is_new] = open_.back()->get_ref<json::object_t&>().emplace(std::move(key), nullptr);
    if (!is_new) fail("the key '" + member->first.substr(0, 80) + "' appears twice; keep the correct one");
    member_ = &*member;
    keys_.back() = &member->first;
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const json::exception& problem) {
    const std::string place = name_ + ":" + place_of(byte, text_) + ": ";
    if (dynamic_cast<const json::out_of_range*>(&problem)) throw InputError(place + "the number is out of range");
    throw InputError(place + "is not valid JSON");
  }

 private:
  /// Where the value belongs that comes next.
  json& place() {
    if (open_.empty()) return root_;
    if (open_.back()->is_object()) return member_->second;
    return open_.back()->get_ref<json::array_t&>().emplace_back();
  }

  template <class Value>
  bool put(Value&& value) {
    take_memory(value_memory);
    place() = std::forward<Value>(value);
    return true;
  }

  bool open(json value) {
    take_memory(value_memory + list_memory);
    json& here = place();
    here = std::move(value);
    open_.push_back(&here);
    keys_.push_back(nullptr);
    if (open_.size() > deepest_)
      fail("has more than " + std::to_string(deepest_) + " nested levels of lists and objects");
    return true;
  }

  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  void take_memory(std::size_t bytes) {
    memory_ += bytes;
    if (memory_ > most_memory_)
      fail("has too many values for its " + std::to_string(text_.size()) + " bytes, most of them empty");
  }

  /// Names the place as "levels.structural.roots[3]", as far as it is of use.
  [[noreturn]] void fail(const std::string& what) const {
    constexpr std::size_t told = 8;
    std::string path;
    for (std::size_t i = 0; i < open_.size() && i < told; ++i)
      if (open_[i]->is_array())
        path += "[" + std::to_string(open_[i]->size() - std::min<std::size_t>(open_[i]->size(), 1)) + "]";
      else if (keys_[i])
        path += (path.empty() ? "" : ".") + keys_[i]->substr(0, 80);
    if (open_.size() > told) path += "...";
    throw InputError(name_ + ": " + (path.empty() ? "" : path + ": ") + what);
  }

  const std::string& name_;
  const std::string_view text_;
  const std::size_t deepest_;
  const std::size_t most_memory_;
  std::size_t memory_ = 0;
  json root_;
  std::vector<json*> open_;               ///< lists and objects around the place; none moves while it is open
  std::vector<const std::string*> keys_;  ///< of each, the member that is at its turn
  std::pair<const std::string, json>* member_ = nullptr;
};

}  // namespace

json parse_json(const std::string& name, std::string_view text, std::size_t deepest) try {
  Builder builder(name, text, deepest);
  json::sax_parse(text, &builder);
  return builder.take();
} catch (const std::bad_alloc&) {
  throw InputError(name + ": its " + std::to_string(text.size()) +
                   " bytes take more memory than this process may use; raise its memory limit, or check the path");
}

json read_json(const std::filesystem::path& file, std::uintmax_t most) {
  return parse_json(file.string(), read_bytes(file, most));
}

}  // namespace gestalt
