// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "npz_file.h"

#include <zip.h>

#include <charconv>
#include <cstring>
#include <memory>
#include <numeric>
#include <regex>

#include "deflate.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30;  // of a file's arrays together
constexpr std::size_t most_header = 1 << 16;
constexpr std::uintmax_t largest_npz = std::uintmax_t{1} << 32;  // bytes; other arrays may be in it
constexpr const char* magic = "\x93NUMPY";

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Archive = std::unique_ptr<zip_t, CloseArchive>;

Archive open(const fs::path& file, const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr;
  if (!archive) {
    const std::string reason = zip_error_strerror(&error);
    if (source) zip_source_free(source);
    zip_error_fini(&error);
    throw InputError(file.string() + ": is no .npz file (" + reason + "); write it with numpy.savez_compressed");
  }
  zip_error_fini(&error);
  return Archive(archive);
}

/// What the header of an .npy file says; place is for messages.
NpyArray parse(const std::string& place, std::string bytes) {
  const auto fail = [&](const std::string& what) -> std::string { throw InputError(place + ": " + what); };
  const auto byte = [&](std::size_t i) { return std::size_t(std::uint8_t(bytes[i])); };
  if (bytes.size() < 10 || bytes.compare(0, 6, magic) != 0) fail("is no array of numpy; write it with numpy.savez");
  const std::size_t wide = byte(6) >= 2 ? 4 : 2, begin = 8 + wide;
  if (bytes.size() < begin) fail("breaks off in its header; write it again");
  std::size_t length = 0;
  for (std::size_t i = 0; i < wide; ++i) length |= byte(8 + i) << (8 * i);
  if (length > most_header || begin + length > bytes.size()) fail("breaks off in its header; write it again");
  const std::string header = bytes.substr(begin, length);
  const auto value_of = [&](const std::string& key, const std::string& pattern) {
    std::smatch match;
    return std::regex_search(header, match, std::regex("'" + key + "'\\s*:\\s*" + pattern))
               ? match[1].str()
               : fail("its header has no valid '" + key + "'; write it with numpy.savez, as numbers");
  };
  NpyArray array;
  const std::string type = value_of("descr", "'([^']*)'");
  static const std::regex numeric("[<|]([uifb])([1248])");
  std::smatch match;
  if (!std::regex_match(type, match, numeric))
    fail("has the type '" + type.substr(0, 20) + "'; write it little-endian, as integers or floats of up to 8 bytes");
  array.kind = match[1].str()[0];
  array.size = match[2].str()[0] - '0';
  if (value_of("fortran_order", "(True|False)") == "True")
    fail("is in Fortran order; write numpy.ascontiguousarray of it");
  const std::string shape = value_of("shape", "\\(([0-9, L]*)\\)");
  static const std::regex number("[0-9]+");
  std::size_t count = 1;
  for (std::sregex_iterator one(shape.begin(), shape.end(), number), end; one != end; ++one) {
    const std::string digits = one->str();
    std::size_t extent = 0;
    const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), extent);
    if (error != std::errc{} || last != digits.data() + digits.size() || (extent && count > most_bytes / extent))
      fail("its header claims too large a shape");
    array.shape.push_back(extent);
    count *= extent;
  }
  bytes.erase(0, begin + length);
  if (bytes.size() != count * std::size_t(array.size))
    fail("has " + std::to_string(bytes.size()) + " bytes of data, its shape needs " +
         std::to_string(count * std::size_t(array.size)) + "; write it again");
  array.bytes = std::move(bytes);
  return array;
}

/// Bytes of an array that its file's directory claims, when that may be: of a file of so many bytes, of whose arrays so
/// many may still be read.
std::size_t claimed_size(const std::string& place, zip_t* archive, zip_uint64_t index, std::size_t file_size,
                         std::size_t left) {
  zip_stat_t stat;
  constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD;
  if (zip_stat_index(archive, index, 0, &stat) != 0 || (stat.valid & needed) != needed)
    throw InputError(place + ": has no size in the file's directory; write the file again");
  if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
    throw InputError(place + ": is packed as numpy does not; write it with numpy.savez_compressed");
  if (stat.size > left)
    throw InputError(place + ": claims, with the arrays before it, more than 2^30 bytes; divide the file");
  if (stat.size / most_inflated > std::min<std::uint64_t>(stat.comp_size, file_size))
    throw InputError(place + ": claims more bytes than its packed ones can be; write the file again");
  return stat.size;
}

NpyArray read_array(const std::string& place, zip_t* archive, zip_uint64_t index, std::size_t size) {
  const std::unique_ptr<zip_file_t, CloseEntry> entry(zip_fopen_index(archive, index, 0));
  const auto damaged = [&](const char* reason) { return InputError(place + ": cannot be read (" + reason + ")"); };
  if (!entry) throw damaged(zip_strerror(archive));
  std::string bytes(size, '\0');
  if (zip_fread(entry.get(), bytes.data(), bytes.size()) != zip_int64_t(bytes.size()))
    throw damaged(zip_file_strerror(entry.get()));
  char more = 0;  // at its end the checksum is compared
  if (zip_fread(entry.get(), &more, 1) != 0) throw damaged(zip_file_strerror(entry.get()));
  return parse(place, std::move(bytes));
}

std::string encode(const NpyArray& array) {
  std::string shape;
  for (const std::size_t extent : array.shape) shape += std::to_string(extent) + ", ";
  std::string header = "{'descr': '" + std::string(array.size == 1 ? "|" : "<") + array.kind +
                       std::to_string(array.size) + "', 'fortran_order': False, 'shape': (" + shape + "), }";
  header.append(63 - (header.size() + 10) % 64, ' ');
  header += '\n';
  std::string bytes = std::string(magic) + '\x01' + '\0';
  bytes += char(header.size() & 255);
  bytes += char(header.size() >> 8);
  return bytes + header + array.bytes;
}

}  // namespace

std::size_t NpyArray::count() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

double NpyArray::at(std::size_t index) const {
  const char* const element = bytes.data() + index * std::size_t(size);
  const auto as = [&](auto value) {
    std::memcpy(&value, element, sizeof value);
    return double(value);
  };
  switch (kind) {
    case 'f':
      return size == 4 ? as(float{}) : as(double{});
    case 'i':
      return size == 1   ? as(std::int8_t{})
             : size == 2 ? as(std::int16_t{})
             : size == 4 ? as(std::int32_t{})
                         : as(std::int64_t{});
    default:
      return size == 1   ? as(std::uint8_t{})
             : size == 2 ? as(std::uint16_t{})
             : size == 4 ? as(std::uint32_t{})
                         : as(std::uint64_t{});
  }
}

std::map<std::string, NpyArray> read_npz(const fs::path& file, std::span<const std::string> names) {
  const std::string bytes = read_bytes(file, largest_npz);
  const Archive archive = open(file, bytes);
  std::map<std::string, NpyArray> arrays;
  std::size_t left = most_bytes;
  for (const std::string& name : names) {
    const zip_int64_t found = zip_name_locate(archive.get(), (name + ".npy").c_str(), 0);
    if (found < 0) continue;
    const std::string place = file.string() + ": array '" + name + "'";
    const auto index = zip_uint64_t(found);
    const std::size_t size = claimed_size(place, archive.get(), index, bytes.size(), left);
    left -= size;
    NpyArray array = read_array(place, archive.get(), index, size);
    if (array.kind == 'f' && array.size < 4) throw InputError(place + " is of half precision; write it as float32");
    arrays.emplace(name, std::move(array));
  }
  return arrays;
}

std::string encode_npz(const std::map<std::string, NpyArray>& arrays) {
  std::map<std::string, std::string> files;  // live until the archive is closed
  for (const auto& [name, array] : arrays) files[name + ".npy"] = encode(array);
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_t* archive = target ? zip_open_from_source(target, ZIP_TRUNCATE, &error) : nullptr;
  if (!archive) throw OutputError(std::string("cannot make a .npz file: ") + zip_error_strerror(&error));
  zip_source_keep(target);
  for (const auto& [name, bytes] : files) {
    zip_source_t* const source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
    const zip_int64_t index = source ? zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    // Without a time of its own, so that the same scene gives the same file.
    if (index < 0 || zip_file_set_dostime(archive, zip_uint64_t(index), 0, (1 << 5) | 1, 0) != 0)
      throw OutputError(std::string("cannot make a .npz file: ") + zip_strerror(archive));
  }
  if (zip_close(archive) != 0) throw OutputError(std::string("cannot make a .npz file: ") + zip_strerror(archive));
  zip_source_open(target);
  zip_source_seek(target, 0, SEEK_END);
  std::string bytes(std::size_t(zip_source_tell(target)), '\0');
  zip_source_seek(target, 0, SEEK_SET);
  const bool whole = zip_source_read(target, bytes.data(), bytes.size()) == zip_int64_t(bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  if (!whole) throw OutputError("cannot make a .npz file: it cannot be read again");
  return bytes;
}

}  // namespace gestalt
