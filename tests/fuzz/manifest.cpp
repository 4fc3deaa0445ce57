// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// What a plugin says of itself: any magic, interface, fingerprint and components, with names that are missing or of any
// bytes. (What cannot be refused is a pointer into nowhere: a plugin is code.)

#include "gestalt/core/plugin/manifest.h"

#include <dlfcn.h>
#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <deque>

#include "gestalt/core/plugin/registry.h"
#include "scratch.h"

namespace {

const void* no_factory() { return nullptr; }
const void* throwing_factory() { throw std::runtime_error("made to fail"); }
const void* strangely_throwing_factory() { throw 7; }

/// The strings of one manifest.
class Texts {
 public:
  explicit Texts(FuzzedDataProvider& provider) : provider_(provider) {}

  const char* any_of(std::initializer_list<const char*> likely) {
    const auto choice = provider_.ConsumeIntegralInRange<std::size_t>(0, likely.size() + 1);
    if (choice < likely.size()) return *(likely.begin() + choice);
    if (choice == likely.size()) return nullptr;
    return kept_.emplace_back(provider_.ConsumeRandomLengthString(40)).c_str();
  }

 private:
  FuzzedDataProvider& provider_;
  std::deque<std::string> kept_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  static const std::filesystem::path plugins =
      std::filesystem::read_symlink("/proc/self/exe").replace_filename("plugins");
  static void* plugin = dlopen((plugins / "told.so").c_str(), RTLD_NOW);
  static auto* told = static_cast<const gestalt_manifest**>(plugin ? dlsym(plugin, "told_manifest") : nullptr);
  if (told == nullptr) std::abort();
  static const std::string fingerprint = build_fingerprint();
  FuzzedDataProvider provider(data, size);
  Texts texts(provider);
  std::array<gestalt_component, 3> components{};
  for (gestalt_component& component : components)
    component = {texts.any_of({"relation", "solver", "fitter", "clusterer", "classifier"}), texts.any_of({"a", "b"}),
                 texts.any_of({"1.0.0"}), texts.any_of({"a component"}),
                 provider.PickValueInArray({&no_factory, &throwing_factory, &strangely_throwing_factory})};
  const gestalt_manifest manifest{
      provider.PickValueInArray({GESTALT_MANIFEST_MAGIC, 0U}),
      provider.PickValueInArray({GESTALT_INTERFACE_VERSION, 0U, 99U}), texts.any_of({fingerprint.c_str()}),
      provider.ConsumeIntegralInRange<std::uint32_t>(0, components.size()), components.data()};
  *told = provider.ConsumeIntegralInRange(0, 20) == 0 ? nullptr : &manifest;
  return fuzz::expect_result_or_error([] { Registry({plugins}); });
}
