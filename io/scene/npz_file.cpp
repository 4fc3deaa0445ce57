// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "npz_file.h"

#include <zip.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <string_view>

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
    throw InputError(file.string() + ": is not a .npz file (" + reason + "); write it with numpy.savez_compressed");
  }
  zip_error_fini(&error);
  return Archive(archive);
}

/// The dictionary of an .npy file's header, one line of Python that numpy wrote: {'descr': '<f4', 'fortran_order':
/// False, 'shape': (480, 640), }. place is for messages.
class NpyHeader {
 public:
  NpyHeader(std::string place, std::string_view text) : place_(std::move(place)), text_(text) {}

  /// Sets kind and size; gives whether the bytes of an element are to be turned round.
  bool read_type(NpyArray& array) const {
    const std::string_view value = value_of("descr");
    if (value.starts_with('['))
      fail("is a structured array (fields of several types); write each field as an array of its own");
    const std::string_view type = value.substr(1, value.substr(1).find_first_of("'\""));
    if (type.ends_with('O'))
      fail("is a pickled object of Python, which cannot be read safely; write arrays: " + unpickled());
    const bool known = type.size() == 3 && std::string_view("<>|=").find(type[0]) != type.npos &&
                       std::string_view("uifb").find(type[1]) != type.npos &&
                       std::string_view("1248").find(type[2]) != type.npos;
    if (!known || (type[1] == 'f' && type[2] == '1'))
      fail("has the type '" + std::string(type.substr(0, 20)) + "'; write it as integers or floats of up to 8 bytes");
    array.kind = type[1];
    array.size = type[2] - '0';
    return type[0] == '>' && array.size > 1;
  }

  bool is_fortran() const {
    const std::string_view value = value_of("fortran_order");
    if (!value.starts_with("True") && !value.starts_with("False")) reject("fortran_order");
    return value.starts_with("True");
  }

  /// Extents whose product is at most most_bytes.
  std::vector<std::size_t> shape() const {
    std::string_view value = value_of("shape");
    const std::size_t end = value.find(')');
    if (!value.starts_with('(') || end == value.npos) reject("shape");
    value = value.substr(1, end - 1);
    std::vector<std::size_t> shape;
    std::size_t count = 1;
    while (!value.empty()) {
      if (value[0] == ' ' || value[0] == ',' || value[0] == 'L') {  // L: a long integer of Python 2
        value.remove_prefix(1);
        continue;
      }
      std::size_t extent = 0;
      const auto [last, error] = std::from_chars(value.data(), value.data() + value.size(), extent);
      if (error == std::errc::invalid_argument) reject("shape");
      if (error != std::errc{} || (extent && count > most_bytes / extent)) fail("its header claims too large a shape");
      shape.push_back(extent);
      if (shape.size() > most_dimensions) reject("shape");
      count *= extent;
      value.remove_prefix(std::size_t(last - value.data()));
    }
    return shape;
  }

 private:
  static constexpr std::size_t most_dimensions = 32;  // numpy's own limit

  [[noreturn]] void fail(const std::string& what) const { throw InputError(place_ + ": " + what); }
  [[noreturn]] void reject(std::string_view key) const {
    fail("its header has no valid '" + std::string(key) + "'; write it with numpy.savez, as numbers");
  }

  static std::string unpickled() {
    return "numpy.savez_compressed('scene.npz', **numpy.load(FILE, allow_pickle=True).item()) where FILE is a "
           "dictionary "
           "of them";
  }

  /// What follows "'key':".
  std::string_view value_of(std::string_view key) const {
    for (const char quote : {'\'', '"'}) {
      std::string quoted(1, quote);
      quoted.append(key).push_back(quote);
      const std::size_t at = text_.find(quoted);
      if (at == text_.npos) continue;
      std::string_view value = text_.substr(at + quoted.size());
      const auto skip_spaces = [&] { value.remove_prefix(std::min(value.find_first_not_of(" \t"), value.size())); };
      skip_spaces();
      if (!value.starts_with(':')) continue;
      value.remove_prefix(1);
      skip_spaces();
      if (!value.empty()) return value;
    }
    reject(key);
  }

  std::string place_;
  std::string_view text_;
};

/// The elements of an array that lies column by column, row by row.
std::string in_c_order(const NpyArray& array, const std::string& columns) {
  const std::size_t dimensions = array.shape.size(), size = std::size_t(array.size), count = array.count();
  std::vector<std::size_t> index(dimensions), stride(dimensions);  // elements
  for (std::size_t i = 0, step = 1; i < dimensions; step *= array.shape[i++]) stride[i] = step;
  std::string rows(columns.size(), '\0');
  std::size_t from = 0;
  for (std::size_t to = 0; to < count; ++to) {
    std::memcpy(rows.data() + to * size, columns.data() + from * size, size);
    for (std::size_t i = dimensions; i-- > 0;) {  // the next index, the last one first
      from += stride[i];
      if (++index[i] < array.shape[i]) break;
      from -= stride[i] * array.shape[i];
      index[i] = 0;
    }
  }
  return rows;
}

/// An array by the bytes of an .npy file; place is for messages.
NpyArray parse(const std::string& place, std::string bytes) {
  const auto fail = [&](const std::string& what) { throw InputError(place + ": " + what); };
  const auto byte = [&](std::size_t i) { return std::size_t(std::uint8_t(bytes[i])); };
  if (bytes.size() < 10 || bytes.compare(0, 6, magic) != 0) fail("is not a numpy array; write it with numpy.savez");
  const std::size_t wide = byte(6) >= 2 ? 4 : 2, begin = 8 + wide;
  if (bytes.size() < begin) fail("ends within its header; write it again");
  std::size_t length = 0;
  for (std::size_t i = 0; i < wide; ++i) length |= byte(8 + i) << (8 * i);
  if (length > most_header || begin + length > bytes.size()) fail("ends within its header; write it again");
  NpyArray array;
  const NpyHeader header(place, std::string_view(bytes).substr(begin, length));
  const bool reversed = header.read_type(array), columns = header.is_fortran();
  array.shape = header.shape();
  bytes.erase(0, begin + length);
  const std::size_t size = std::size_t(array.size), needed = array.count() * size;
  if (bytes.size() != needed)
    fail("has " + std::to_string(bytes.size()) + " bytes of data, its shape needs " + std::to_string(needed) +
         "; write it again");
  if (reversed)
    for (std::size_t at = 0; at < needed; at += size) std::reverse(bytes.data() + at, bytes.data() + at + size);
  array.bytes = columns && array.shape.size() > 1 ? in_c_order(array, bytes) : std::move(bytes);
  return array;
}

/// Of half precision (IEEE 754 binary16).
double from_half(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  const double sign = bits >> 15 ? -1 : 1;
  if (exponent == 31) return fraction ? std::nan("") : sign * HUGE_VAL;
  return sign * (exponent ? std::ldexp(1024 + fraction, exponent - 25) : std::ldexp(fraction, -24));
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
    throw InputError(place + ": is compressed in a way that numpy does not use; write it with numpy.savez_compressed");
  if (stat.size > left)
    throw InputError(place + ": claims, with the arrays before it, more than 2^30 bytes; split the file");
  if (stat.size / most_inflated > std::min<std::uint64_t>(stat.comp_size, file_size))
    throw InputError(place + ": claims more bytes than its compressed data can hold; write the file again");
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
      if (size == 2) {
        std::uint16_t bits = 0;
        std::memcpy(&bits, element, sizeof bits);
        return from_half(bits);
      }
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
    arrays.emplace(name, read_array(place, archive.get(), index, size));
  }
  return arrays;
}

NpyArray read_npy(const fs::path& file) { return parse(file.string(), read_bytes(file, most_bytes + most_header)); }

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
