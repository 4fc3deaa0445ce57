// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "component_call.h"

#include <atomic>
#include <mutex>
#include <set>
#include <vector>

#include "gestalt/core/plugin/running_component.h"

namespace gestalt {

namespace {

thread_local ComponentName running = nullptr;
std::atomic<ComponentName> begun_last = nullptr;

/// What a thread works for, where other threads see it.
class Place {
 public:
  Place() {
    const std::lock_guard lock(mutex());
    all().insert(this);
  }
  ~Place() {
    const std::lock_guard lock(mutex());
    all().erase(this);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  void set(ComponentName name) { name_.store(name, std::memory_order_release); }

  static std::vector<ComponentName> taken() {
    const std::lock_guard lock(mutex());
    std::set<ComponentName> names;
    for (const Place* place : all())
      if (const ComponentName name = place->name_.load(std::memory_order_acquire)) names.insert(name);
    return {names.begin(), names.end()};
  }

 private:
  // Threads may end after static objects have.
  static std::mutex& mutex() {
    static auto& mutex = *new std::mutex;
    return mutex;
  }
  static std::set<const Place*>& all() {
    static auto& all = *new std::set<const Place*>;
    return all;
  }

  std::atomic<ComponentName> name_ = nullptr;
};

thread_local Place place;

}  // namespace

ComponentName component_name(const std::string& kind, const std::string& name) {
  static std::mutex mutex;
  static auto& names = *new std::set<std::string>;  // outlives what a signal may interrupt at the end of the process
  const std::lock_guard lock(mutex);
  return names.insert(kind + " '" + name + "'").first->c_str();
}

RunningComponent::RunningComponent(ComponentName name) noexcept : before_(running) {
  running = name;
  place.set(name);
  begun_last.store(name, std::memory_order_release);
}

RunningComponent::~RunningComponent() {
  running = before_;
  place.set(before_);
}

const char* running_component() noexcept { return running ? running : begun_last.load(std::memory_order_acquire); }

const char* own_component() noexcept { return running; }

std::vector<const char*> running_components() { return Place::taken(); }

}  // namespace gestalt
