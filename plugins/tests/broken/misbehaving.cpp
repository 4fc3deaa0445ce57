// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A solver that does whatever code of others may do.

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <new>
#include <thread>
#include <vector>

#include "gestalt/core/plugin/plugin.h"

namespace {

class Misbehaving final : public gestalt::Solver {
 public:
  struct Params {
    std::string how = "throw";
  };
  static const gestalt::Parameters<Params>& parameters() {
    static const auto declared = gestalt::Parameters<Params>().choice(
        "how", &Params::how,
        {"throw", "throw_number", "no_memory", "allocate", "segmentation_fault", "abort", "recurse", "exit",
         "quick_exit", "exit_elsewhere", "linger", "hang"},
        "what it does");
    return declared;
  }

  explicit Misbehaving(Params params) : how_(std::move(params.how)) {}

  std::vector<int> solve(const gestalt::Graph& graph) const override {
    if (how_ == "throw") throw std::logic_error("the moon is full");
    if (how_ == "throw_number") throw 7;
    if (how_ == "no_memory") throw std::bad_alloc();
    if (how_ == "allocate") allocate();
    if (how_ == "linger") std::this_thread::sleep_for(std::chrono::seconds(4));
    if (how_ == "hang") std::this_thread::sleep_for(std::chrono::hours(24));
    if (how_ == "linger" || how_ == "hang") return std::vector<int>(graph.sizes.size(), 0);
    if (how_ == "abort") std::abort();
    if (how_ == "exit") std::exit(0);
    if (how_ == "quick_exit") std::quick_exit(0);
    if (how_ == "exit_elsewhere") std::thread([] { std::exit(0); }).join();
    if (how_ == "recurse") return {deeper(int(graph.sizes.size()))};
    std::raise(SIGSEGV);
    return {};
  }

 private:
  static void allocate() {
    for (std::vector<std::vector<char>> all;;) all.emplace_back(std::size_t{64} << 20);
  }

  /// Never ends; the volatile array keeps the compiler from making a loop of it.
  static int deeper(int n) {  // NOLINT(misc-no-recursion)
    volatile char stack[4096] = {};
    stack[std::size_t(n) % sizeof stack] = char(n);
    return n < -1 ? 0 : deeper(n + 1) + stack[0];
  }

  std::string how_;
};

}  // namespace

GESTALT_PLUGIN(gestalt::component<Misbehaving>("misbehaving", "1.0.0", "Does what no plugin should"))
