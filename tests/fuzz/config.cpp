// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A config, and one that it may extend; resolved against the plugins, printed, and read again as printed.

#include "gestalt/core/config/config.h"

#include <iostream>

#include "gestalt/core/plugin/registry.h"
#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  static const Registry registry(plugin_search_path({}));
  const std::vector<std::string_view> parts = parts_of(text_of(data, size), 3);
  scratch.write("base.yaml", parts[0]);
  const std::filesystem::path file = scratch.write("config.yaml", parts[1]);
  const std::vector<std::string> overrides =
      parts[2].empty() ? std::vector<std::string>{} : std::vector{std::string(parts[2])};
  return expect_result_or_error([&] {
    const ConfigTree tree(file, overrides);
    const std::string printed = tree.print(registry);
    const ConfigTree again = ConfigTree::from_text("printed", printed, {});
    if (canonical(again.resolve(registry)) == canonical(tree.resolve(registry))) return;
    std::cerr << "what is printed is another config:\n" << printed;
    std::abort();
  });
}
