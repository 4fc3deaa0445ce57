// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "gestalt/core/plugin/factory.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt {

/// For GoogleTest, which looks for it where the type is.
inline void PrintTo(const ComponentInfo& info, std::ostream* out) {
  *out << info.kind << " '" << info.name << "' of " << info.library.string();
}

}  // namespace gestalt

namespace gestalt::conformance {

/// Loads the plugins that are to be checked. Once, before any other function here.
void load_subjects(std::vector<std::filesystem::path> directories);

const Registry& subjects();

/// Components of a kind, or of all kinds for "".
std::vector<ComponentInfo> subjects_of(std::string_view kind);

inline std::string test_name(const testing::TestParamInfo<ComponentInfo>& info) {
  return info.param.kind + "_" + info.param.name;
}

/// A test of one component of a kind, made with its default parameters.
template <class Kind>
class SubjectTest : public testing::TestWithParam<ComponentInfo> {
 protected:
  std::shared_ptr<const Kind> subject_ = subjects().create<Kind>(GetParam().name, {});
};

/// What f gives when TBB may use that many threads, however many the machine has.
template <class F>
auto with_threads(int count, F f) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(count));
  return tbb::task_arena(count).execute(f);
}

}  // namespace gestalt::conformance

/// Runs a suite over every subject of its kind.
#define GESTALT_CONFORMANCE(suite, kind)                                                               \
  INSTANTIATE_TEST_SUITE_P(Plugins, suite, testing::ValuesIn(gestalt::conformance::subjects_of(kind)), \
                           gestalt::conformance::test_name);                                           \
  GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(suite)
