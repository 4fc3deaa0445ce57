// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "decompression.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <memory>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

/// No compression makes more of a byte; a header that claims more lies, and no memory is taken for it.
constexpr std::uint64_t largest_ratio = 40000;

[[noreturn]] void fail_damaged(std::string_view compression) {
  throw InputError("a chunk's " + std::string(compression) +
                   " data are damaged or of another size than its header says; the recording may be incomplete");
}

bool from_bz2(std::string_view bytes, std::string& out) {
  auto size = static_cast<unsigned>(out.size());
  std::string copy(bytes);  // its interface has no const
  return BZ2_bzBuffToBuffDecompress(out.data(), &size, copy.data(), static_cast<unsigned>(copy.size()), 0, 0) ==
             BZ_OK &&
         size == out.size();
}

bool from_lz4(std::string_view bytes, std::string& out) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION))) return false;
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> owned(context, LZ4F_freeDecompressionContext);
  std::size_t read = 0, written = 0;
  for (std::size_t more = 1; more != 0;) {
    std::size_t in = bytes.size() - read, done = out.size() - written;
    more = LZ4F_decompress(context, out.data() + written, &done, bytes.data() + read, &in, nullptr);
    if (LZ4F_isError(more) || (in == 0 && done == 0 && more != 0)) return false;
    read += in, written += done;
  }
  return written == out.size();
}

bool from_zstd(std::string_view bytes, std::string& out) {
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  return !ZSTD_isError(size) && size == out.size();
}

}  // namespace

std::string decompressed(std::string_view bytes, std::string_view compression, std::uint64_t size) {
  if (compression.empty() || compression == "none") {
    if (size != bytes.size()) fail_damaged("uncompressed");
    return std::string(bytes);
  }
  if (size > largest_chunk)
    throw InputError("a chunk of " + std::to_string(size) + " bytes is larger than 256 MiB; record in smaller chunks");
  if (size > largest_ratio * (bytes.size() + 1)) fail_damaged(compression);
  std::string out(std::size_t(size), '\0');
  const bool good = compression == "bz2"   ? from_bz2(bytes, out)
                    : compression == "lz4" ? from_lz4(bytes, out)
                    : compression == "zstd"
                        ? from_zstd(bytes, out)
                        : throw InputError("a chunk has the compression '" + std::string(compression) +
                                           "'; only none, bz2, lz4 and zstd can be read");
  if (!good) fail_damaged(compression);
  return out;
}

}  // namespace gestalt
