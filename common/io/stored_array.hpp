#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/xml_tree.hpp"

// An array as a VTK XML file stores it: text, or bytes in base64 or raw, in the element or appended, compressed or not.
// Its size is known from a few words before its data, which are held against the bytes that are there.
namespace thalweg {

/// A file of VTK in memory, and how its arrays are stored.
struct VtkFile {
  const std::filesystem::path& path;
  std::string_view bytes;
  bool big_endian = false;
  std::size_t word = 4;                   // bytes of a number in a header
  std::string compressor{};               // VTK's class; empty: not compressed
  std::optional<std::size_t> appended{};  // where the appended data begin
  bool appended_is_base64 = false;

  [[noreturn]] void refuse(const XmlElement& at, const std::string& what,
                           const std::string& cure = "write the file again") const;
};

class StoredArray {
 public:
  /// Reads the array's header. Throws InputError if the array is of an unknown type or kind of storage, if its header
  /// announces more than the file holds, or if it holds a text that is no number of its type.
  StoredArray(const VtkFile& file, const XmlElement& element);

  /// Numbers that are stored; of a text array its characters.
  [[nodiscard]] std::uint64_t count() const { return size_ / width_; }
  /// Bytes of all numbers.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] bool is_text_array() const { return is_text_array_; }
  /// False if a number that stands in text is infinite or none.
  [[nodiscard]] bool is_finite() const { return is_finite_; }
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Throws InputError if the array's bytes cannot be decompressed.
  void check_contents() const {
    if (!blocks_.empty()) (void)decoded();
  }

  /// The array's numbers, which have to be whole. Throws InputError for an array of fractions, or for bytes that cannot be
  /// decompressed.
  [[nodiscard]] std::vector<std::int64_t> integers() const;

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  void find_data();
  void read_header();
  void read_compressed_header();
  [[nodiscard]] std::string take(std::size_t at, std::uint64_t size) const;
  [[nodiscard]] std::uint64_t stored(std::uint64_t size) const;
  [[nodiscard]] std::uint64_t word(std::string_view bytes, std::size_t index) const;
  [[nodiscard]] std::string decoded() const;
  [[nodiscard]] std::vector<std::int64_t> integers_in_text() const;

  const VtkFile& file_;
  const XmlElement& element_;
  std::string name_;
  std::string type_;
  std::size_t width_ = 1;  // bytes of a number
  bool is_text_array_ = false;
  bool is_finite_ = true;
  bool is_text_ = false;  // format="ascii"
  bool is_base64_ = true;
  std::string_view data_;   // what is stored, from its header on
  std::uint64_t size_ = 0;  // bytes of all numbers

  struct Block {
    std::uint64_t at;        // byte among those of all blocks
    std::uint64_t packed;    // bytes in the file
    std::uint64_t unpacked;  // bytes that they become
  };
  std::vector<Block> blocks_;
};

}  // namespace thalweg
