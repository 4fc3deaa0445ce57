// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>

#include <cstring>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>

namespace {

/// A file in memory.
class Bytes : public Imf::IStream {
 public:
  Bytes(const char* bytes, std::size_t size) : IStream("image"), bytes_(bytes), size_(size) {}

  bool read(char* target, int count) override {
    if (count < 0 || std::uint64_t(count) > size_ - at_) throw std::runtime_error("it ends too early");
    std::memcpy(target, bytes_ + at_, std::size_t(count));
    at_ += std::uint64_t(count);
    return at_ < size_;
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t to) override {
    if (to > size_) throw std::runtime_error("it points beyond its end");
    at_ = to;
  }

 private:
  const char* bytes_;
  std::uint64_t size_, at_ = 0;
};

/// Of all EXR files: memory is taken for whole tiles, of which a few bytes may claim any size.
void limit_tiles() {
  constexpr int largest = 1024;
  Imf::Header::setMaxTileSize(largest, largest);
}

/// The channel of depth: Z, also of a layer; else the only one. "" where there is none.
std::string depth_channel(const Imf::ChannelList& channels) {
  std::string only;
  int count = 0;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel, ++count) {
    const std::string name = channel.name();
    if (name == "Z" || name.ends_with(".Z")) return name;
    only = name;
  }
  return count == 1 ? only : "";
}

}  // namespace

/// Decodes the channel of depth of an EXR file to CV_32FC1. Gives "", or what is wrong; no image where no channel is
/// known to be depth.
extern "C" __attribute__((visibility("default"))) const char* gestalt_decode_exr_depth(const char* bytes,
                                                                                       std::size_t size,
                                                                                       cv::Mat* image) {
  try {
    limit_tiles();
    Bytes stream(bytes, size);
    Imf::InputFile file(stream, 1);
    const std::string name = depth_channel(file.header().channels());
    if (name.empty()) return "";
    const Imf::Channel& channel = file.header().channels()[name];
    if (channel.xSampling != 1 || channel.ySampling != 1) return "its depth has fewer pixels than the image";
    const auto window = file.header().dataWindow();
    image->create(window.max.y - window.min.y + 1, window.max.x - window.min.x + 1, CV_32FC1);
    *image = 0;
    Imf::FrameBuffer target;
    const auto row = std::ptrdiff_t(image->step[0]), column = std::ptrdiff_t(sizeof(float));
    char* const origin = reinterpret_cast<char*>(image->data) - window.min.y * row - window.min.x * column;
    target.insert(name, Imf::Slice(Imf::FLOAT, origin, std::size_t(column), std::size_t(row)));
    file.setFrameBuffer(target);
    file.readPixels(window.min.y, window.max.y);
    return "";
  } catch (const std::exception&) {
    return "its data are damaged";
  }
}

/// Decodes a whole image file, its pixels as they are stored. Gives "", or what is wrong.
extern "C" __attribute__((visibility("default"))) const char* gestalt_decode_image(const char* bytes, std::size_t size,
                                                                                   cv::Mat* image) {
  // The caller reports errors, with the file's name.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    limit_tiles();
    const cv::Mat buffer(1, int(size), CV_8UC1, const_cast<char*>(bytes));
    *image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
    return image->empty() ? "its data are damaged, or of a kind that OpenCV does not read" : "";
  } catch (const std::exception&) {
    return "its data are damaged";
  }
}
