// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "component_call.h"

#include <atomic>
#include <mutex>
#include <set>

#include "gestalt/running_component.h"

namespace gestalt {

namespace {

thread_local ComponentName running = nullptr;
std::atomic<ComponentName> begun_last = nullptr;

}  // namespace

ComponentName component_name(const std::string& kind, const std::string& name) {
  static std::mutex mutex;
  static auto& names = *new std::set<std::string>;  // outlives what a signal may interrupt at the end of the process
  const std::lock_guard lock(mutex);
  return names.insert(kind + " '" + name + "'").first->c_str();
}

RunningComponent::RunningComponent(ComponentName name) noexcept : before_(running) {
  running = name;
  begun_last.store(name, std::memory_order_relaxed);
}

RunningComponent::~RunningComponent() { running = before_; }

const char* running_component() noexcept { return running ? running : begun_last.load(std::memory_order_relaxed); }

}  // namespace gestalt
