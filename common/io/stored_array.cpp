#include "common/io/stored_array.hpp"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <charconv>
#include <cstring>

#include "common/error.hpp"
#include "common/io/vtk_errors.hpp"
#include "common/shown.hpp"

namespace thalweg {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// True for a word that is a number of the type. At any other VTK stops, and for cell data it then reads beyond the numbers
/// that it has.
template <class Number>
bool fits(std::string_view word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

/// False for the words that stand for an infinite number or for none, which have a letter n; no finite number has one.
bool names_finite(std::string_view word) { return word.find_first_of("nN") == std::string_view::npos; }

struct NumberType {
  const char* name;
  std::size_t width;  // [bytes]
  bool (*is_in)(std::string_view word);
};

template <class Number>
constexpr NumberType number_type(const char* name) {
  return {name, sizeof(Number), fits<Number>};
}
constexpr NumberType number_types[] = {number_type<std::int8_t>("Int8"),   number_type<std::uint8_t>("UInt8"),
                                       number_type<std::int16_t>("Int16"), number_type<std::uint16_t>("UInt16"),
                                       number_type<std::int32_t>("Int32"), number_type<std::uint32_t>("UInt32"),
                                       number_type<std::int64_t>("Int64"), number_type<std::uint64_t>("UInt64"),
                                       number_type<float>("Float32"),      number_type<double>("Float64")};
// Characters of a text: bytes, which VTK writes as numbers with or without a sign.
constexpr NumberType character_type{"String", 1, fits<std::int16_t>};

vtkSmartPointer<vtkDataCompressor> compressor_of(const std::string& name) {
  if (name == "vtkLZ4DataCompressor") return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (name == "vtkLZMADataCompressor") return vtkSmartPointer<vtkLZMADataCompressor>::New();
  return vtkSmartPointer<vtkZLibDataCompressor>::New();
}

template <class Number>
std::vector<std::int64_t> numbers_in(const std::string& bytes) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(bytes.size() / sizeof(Number));
  for (std::size_t at = 0; at + sizeof(Number) <= bytes.size(); at += sizeof(Number)) {
    Number number{};
    std::memcpy(&number, bytes.data() + at, sizeof(Number));
    numbers.push_back(static_cast<std::int64_t>(number));
  }
  return numbers;
}

void reverse_each(std::string& bytes, std::size_t width) {
  for (auto at = bytes.begin(); bytes.end() - at >= static_cast<std::ptrdiff_t>(width);
       at += static_cast<std::ptrdiff_t>(width))
    std::reverse(at, at + static_cast<std::ptrdiff_t>(width));
}

std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace

void VtkFile::refuse(const XmlElement& at, const std::string& what, const std::string& cure) const {
  throw InputError(fmt::format("{}:{}: {}; {}", path.string(), at.line, what, cure));
}

StoredArray::StoredArray(const VtkFile& file, const XmlElement& element)
    : file_(file), element_(element), name_(element.attribute("Name")), type_(element.attribute("type")) {
  is_text_array_ = type_ == character_type.name;
  const NumberType* type = &character_type;
  if (!is_text_array_) {
    type = std::find_if(std::begin(number_types), std::end(number_types),
                        [&](const NumberType& known) { return type_ == known.name; });
    if (type == std::end(number_types)) refuse(fmt::format("is of the unknown type \"{}\"", shown(type_)));
  }
  width_ = type->width;
  find_data();
  if (is_text_) {
    std::uint64_t words = 0;
    std::string_view text = data_;
    for (std::string_view word = next_word(text); !word.empty(); word = next_word(text), ++words) {
      if (!type->is_in(word))
        refuse(fmt::format("holds \"{}\", which is no number of the type {}", shown(word), type_));
      is_finite_ = is_finite_ && names_finite(word);
    }
    size_ = words * width_;
  } else if (!data_.empty()) {
    read_header();
  }
}

void StoredArray::refuse(const std::string& what) const {
  file_.refuse(element_, fmt::format("the array \"{}\" {}", shown(name_), what));
}

void StoredArray::find_data() {
  const std::string format = element_.attribute("format");
  if (format == "appended") {
    if (!file_.appended) refuse("is appended, and nothing is");
    const std::string offset = element_.attribute("offset");
    std::uint64_t at = 0;
    const auto [end, error] = std::from_chars(offset.data(), offset.data() + offset.size(), at);
    if (error != std::errc{} || end != offset.data() + offset.size() || at > file_.bytes.size() - *file_.appended) {
      refuse(fmt::format("lies at the offset \"{}\", outside of the file", shown(offset)));
    }
    data_ = file_.bytes.substr(*file_.appended + at);
    is_base64_ = file_.appended_is_base64;
    return;
  }
  is_text_ = format == "ascii";
  if (!is_text_ && format != "binary") refuse(fmt::format("is stored in the unknown format \"{}\"", shown(format)));
  data_ = file_.bytes.substr(element_.begin);
  data_ = data_.substr(0, data_.find('<'));
  data_.remove_prefix(std::min(data_.find_first_not_of(blanks), data_.size()));
  data_ = data_.substr(0, data_.find_last_not_of(blanks) + 1);
}

/// Bytes or characters that so many bytes take in the file.
std::uint64_t StoredArray::stored(std::uint64_t size) const {
  if (size > file_.bytes.size()) refuse("announces more bytes than the file has");
  return is_base64_ ? (size + 2) / 3 * 4 : size;
}

/// So many bytes, decoded, that begin at `at` of what is stored.
std::string StoredArray::take(std::size_t at, std::uint64_t size) const {
  const std::uint64_t taken = stored(size);
  if (at > data_.size() || taken > data_.size() - at) refuse("announces more bytes than the file has");
  if (!is_base64_) return std::string(data_.substr(at, taken));
  std::string bytes(taken / 4 * 3, '\0');
  const std::size_t read =
      vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char*>(data_.data() + at), taken,
                                       reinterpret_cast<unsigned char*>(bytes.data()), bytes.size());
  if (read < size) refuse("is no base64 text");
  bytes.resize(size);
  return bytes;
}

std::uint64_t StoredArray::word(std::string_view bytes, std::size_t index) const {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < file_.word; ++i) {
    const std::size_t significance = file_.big_endian ? file_.word - 1 - i : i;
    value |= std::uint64_t{static_cast<unsigned char>(bytes[index * file_.word + i])} << (8 * significance);
  }
  return value;
}

void StoredArray::read_header() {
  if (!file_.compressor.empty()) return read_compressed_header();
  size_ = word(take(0, file_.word), 0);
  if (size_ > file_.bytes.size()) refuse("announces more bytes than the file has");
  (void)take(0, file_.word + size_);
}

// Number of blocks, bytes of a block, bytes of the last if it is shorter, then the compressed bytes of each.
void StoredArray::read_compressed_header() {
  const std::string begin = take(0, 3 * file_.word);
  const std::uint64_t count = word(begin, 0);
  const std::uint64_t whole = word(begin, 1);
  const std::uint64_t last = word(begin, 2);
  constexpr std::uint64_t largest = std::uint64_t{1} << 30;  // VTK's own blocks have 32 KiB
  if (count > file_.bytes.size() / file_.word) refuse("announces more blocks than the file has bytes for");
  if (whole > largest || last > whole) refuse("announces blocks of impossible sizes");
  if (count == 0) return;
  const std::uint64_t header = (3 + count) * file_.word;
  const std::string sizes = take(0, header);
  std::uint64_t packed = 0;  // base64 runs through all blocks, whose borders need not be those of its groups
  for (std::size_t i = 0; i < count; ++i) {
    const Block block{packed, word(sizes, 3 + i), i + 1 == count && last > 0 ? last : whole};
    if (block.packed > file_.bytes.size()) refuse("announces more bytes than the file has");
    packed += block.packed;
    size_ += block.unpacked;
    blocks_.push_back(block);
  }
  if (stored(packed) > data_.size() - stored(header)) refuse("announces more bytes than the file has");
}

std::string StoredArray::decoded() const {
  if (data_.empty()) return {};
  if (file_.compressor.empty()) return take(0, file_.word + size_).substr(file_.word);
  if (blocks_.empty()) return {};
  const std::uint64_t packed = blocks_.back().at + blocks_.back().packed;
  const std::string all = take(stored((3 + blocks_.size()) * file_.word), packed);
  const auto compressor = compressor_of(file_.compressor);
  vtkNew<VtkErrors> errors;
  compressor->AddObserver(vtkCommand::ErrorEvent, errors);
  std::string bytes(size_, '\0');
  std::size_t to = 0;
  for (const Block& block : blocks_) {
    const std::size_t read =
        compressor->Uncompress(reinterpret_cast<const unsigned char*>(all.data() + block.at), block.packed,
                               reinterpret_cast<unsigned char*>(bytes.data() + to), block.unpacked);
    if (read != block.unpacked) refuse("cannot be decompressed");
    to += block.unpacked;
  }
  return bytes;
}

std::vector<std::int64_t> StoredArray::integers_in_text() const {
  std::vector<std::int64_t> numbers;
  std::string_view text = data_;
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size()) {
      refuse(fmt::format("holds \"{}\", no whole number", shown(word)));
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<std::int64_t> StoredArray::integers() const {
  if (type_.starts_with("Float")) refuse("needs whole numbers");
  if (is_text_) return integers_in_text();
  std::string bytes = decoded();
  constexpr bool host_is_big_endian = false;  // the processors that Thalweg is built for
  if (file_.big_endian != host_is_big_endian) reverse_each(bytes, width_);
  if (is_text_array_ || type_ == "UInt8") return numbers_in<std::uint8_t>(bytes);
  if (type_ == "Int8") return numbers_in<std::int8_t>(bytes);
  if (type_ == "Int16") return numbers_in<std::int16_t>(bytes);
  if (type_ == "UInt16") return numbers_in<std::uint16_t>(bytes);
  if (type_ == "Int32") return numbers_in<std::int32_t>(bytes);
  if (type_ == "UInt32") return numbers_in<std::uint32_t>(bytes);
  return numbers_in<std::int64_t>(bytes);  // an unsigned number beyond becomes negative, and is refused as that
}

}  // namespace thalweg
