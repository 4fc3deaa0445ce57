// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <new>
#include <string>

#include "gestalt/core/base/error.h"

namespace gestalt {

/// What messages call a component: "relation 'gabor'". The text lives as long as the process.
using ComponentName = const char*;
ComponentName component_name(const std::string& kind, const std::string& name);

/// While it lives, running_component() gives the name on this thread.
class RunningComponent {
 public:
  explicit RunningComponent(ComponentName name) noexcept;
  ~RunningComponent();
  RunningComponent(const RunningComponent&) = delete;
  RunningComponent& operator=(const RunningComponent&) = delete;

 private:
  ComponentName before_;
};

/// Turns an exception of a component that is not an Error into a PluginError with its name.
template <class Work>
auto blame_component(ComponentName name, const Work& work) {
  try {
    return work();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw PluginError(std::string(name) + " failed: it ran out of memory");
  } catch (const std::exception& error) {
    throw PluginError(std::string(name) + " failed: " + error.what());
  } catch (...) {
    throw PluginError(std::string(name) + " failed with an exception that has no message");
  }
}

/// The same, and has running_component() give its name.
template <class Work>
auto call_component(ComponentName name, const Work& work) {
  const RunningComponent running(name);
  return blame_component(name, work);
}

/// A component, or what it made: its destructor is code of others, too.
template <class T>
std::shared_ptr<T> owned(ComponentName name, std::unique_ptr<T> product) {
  if (!product) return nullptr;
  return {product.release(), [name](T* last) {
            const RunningComponent running(name);
            delete last;
          }};
}

}  // namespace gestalt
