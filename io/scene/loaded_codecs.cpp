// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "loaded_codecs.h"

#include <dlfcn.h>

#include <filesystem>

namespace gestalt {

namespace {

using Decode = const char* (*)(const char* bytes, std::size_t size, cv::Mat* image);

struct Codecs {
  Decode decode = nullptr, exr_depth = nullptr;
  std::string problem;
};

Codecs load() {
  Dl_info own{};
  if (dladdr(reinterpret_cast<const void*>(&decode_with_opencv), &own) == 0)
    return {nullptr, nullptr, "no codecs are found"};
  std::error_code ignored;
  const std::filesystem::path library =
      std::filesystem::weakly_canonical(own.dli_fname, ignored).parent_path() / "gestalt" / "image_codecs.so";
  void* const codecs = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  void* const decode = codecs ? dlsym(codecs, "gestalt_decode_image") : nullptr;
  void* const exr_depth = codecs ? dlsym(codecs, "gestalt_decode_exr_depth") : nullptr;
  if (!decode || !exr_depth)
    return {nullptr, nullptr, std::string("the codecs of OpenCV cannot be loaded: ") + dlerror()};
  return {reinterpret_cast<Decode>(decode), reinterpret_cast<Decode>(exr_depth), ""};
}

const Codecs& codecs() {
  static const Codecs loaded = load();
  return loaded;
}

}  // namespace

std::string decode_with_opencv(std::string_view bytes, cv::Mat& image) {
  return codecs().decode ? codecs().decode(bytes.data(), bytes.size(), &image) : codecs().problem;
}

std::string decode_exr_depth(std::string_view bytes, cv::Mat& image) {
  return codecs().exr_depth ? codecs().exr_depth(bytes.data(), bytes.size(), &image) : codecs().problem;
}

}  // namespace gestalt
