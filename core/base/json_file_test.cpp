// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/json_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"

namespace gestalt {
namespace {

using nlohmann::json;

std::string complaint(const std::string& text) {
  try {
    parse_json("a.json", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string times(std::size_t count, const std::string& part) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += part;
  return text;
}

TEST(Json, GivesTheValuesThatTheLibraryGives) {
  for (const std::string text :
       {"null", "[]", "{}", "3", "-7", "18446744073709551615", "0.25", "\"a\\u00e9\"", "[1,[2,{}],\"\",[]]",
        "{\"b\":{\"c\":[true,false,null]},\"a\":[{\"x\":1},{\"x\":2}],\"\":-0.0}", " [ 1e3 , 2 ] \n"})
    EXPECT_EQ(parse_json("a.json", text), json::parse(text)) << text;
}

TEST(Json, TellsWhereItIsNone) {
  EXPECT_EQ(complaint("{\"a\": 1,\n  \"b\": oops}"), "a.json:2:8: is not valid JSON");
  EXPECT_EQ(complaint("{\"a\": 1} 2"), "a.json:1:10: is not valid JSON");
  EXPECT_NE(complaint(""), "");
  EXPECT_EQ(complaint("[1e999]"), "a.json:1:6: the number is out of range");
}

TEST(Json, IsAsDeepAsItMayBe) {
  for (const auto& [open, close] : {std::pair{"[", "]"}, {"{\"a\":", "}"}, {"[{\"a\":", "}]"}}) {
    const std::size_t each = std::string(open).starts_with("[{") ? 2 : 1;
    const auto nested = [&, &open = open, &close = close](std::size_t levels) {
      return times(levels, open) + "0" + times(levels, close);
    };
    EXPECT_EQ(complaint(nested(deepest_json / each)), "");
    for (const std::size_t levels : {deepest_json / each + 1, std::size_t{1'000'000}})
      EXPECT_NE(complaint(nested(levels)).find("has more than 200 nested levels"), std::string::npos) << open;
  }
  EXPECT_EQ(complaint("{\"levels\":{\"x\":[0," + times(300, "[") + "}"),
            "a.json: levels.x[1][0][0][0][0][0]...: has more than 200 nested levels of lists and objects");
}

TEST(Json, RefusesAKeyThatIsThereTwice) {
  EXPECT_EQ(complaint(R"({"a": [{"x": 1}, {"x": 1, "y": {}, "x": 2}]})"),
            "a.json: a[1].y: the key 'x' appears twice; keep the correct one");
  EXPECT_EQ(complaint(R"({"a": 1, "a": 1})"), "a.json: a: the key 'a' appears twice; keep the correct one");
}

// Counted, not measured: 24 MB of text would take 0.5 GB and more.
TEST(Json, RefusesWhatTakesMemoryFarBeyondItsSize) {
  for (const char* value : {"[],", "{},"})
    EXPECT_NE(complaint("[" + times(8'000'000, value) + "0]").find("has too many values for its 24000003 bytes"),
              std::string::npos);
  EXPECT_EQ(complaint("[" + times(8'000'000, "0,") + "0]"), "");
}

}  // namespace
}  // namespace gestalt
