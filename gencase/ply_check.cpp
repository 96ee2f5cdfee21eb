#include "gencase/ply_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "common/error.hpp"
#include "gencase/words.hpp"

namespace thalweg::gencase {
namespace {

/// A type of numbers: its size [bytes] and, for integers, its range.
struct Type {
  std::size_t size = 0;
  bool integral = true;
  std::int64_t least = 0;
  std::int64_t greatest = 0;
};

template <class Number>
constexpr Type integer() {
  return {sizeof(Number), true, std::numeric_limits<Number>::min(), std::numeric_limits<Number>::max()};
}

const Type* type_of(const std::string& name) {
  static const std::map<std::string, Type> types{{"char", integer<std::int8_t>()},
                                                 {"int8", integer<std::int8_t>()},
                                                 {"uchar", integer<std::uint8_t>()},
                                                 {"uint8", integer<std::uint8_t>()},
                                                 {"short", integer<std::int16_t>()},
                                                 {"int16", integer<std::int16_t>()},
                                                 {"ushort", integer<std::uint16_t>()},
                                                 {"uint16", integer<std::uint16_t>()},
                                                 {"int", integer<std::int32_t>()},
                                                 {"int32", integer<std::int32_t>()},
                                                 {"uint", integer<std::uint32_t>()},
                                                 {"uint32", integer<std::uint32_t>()},
                                                 {"float", {4, false}},
                                                 {"float32", {4, false}},
                                                 {"double", {8, false}},
                                                 {"float64", {8, false}}};
  const auto found = types.find(name);
  return found == types.end() ? nullptr : &found->second;
}

struct Property {
  Type type;
  const Type* count = nullptr;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t number = 0;
  std::vector<Property> properties;
};

enum class Format { none, text, little_endian, big_endian };

struct Header {
  Format format = Format::none;
  std::vector<Element> elements;
  std::size_t end = 0;  // first byte of the data
};

[[noreturn]] void damaged(const std::string& line) {
  throw InputError(fmt::format("has a damaged header (\"{}\"); export it again", line));
}

Format format_of(const std::string& name, const std::string& line) {
  if (name == "ascii") return Format::text;
  if (name == "binary_little_endian") return Format::little_endian;
  if (name == "binary_big_endian") return Format::big_endian;
  damaged(line);
}

Element element_of(const std::vector<std::string>& words, const std::string& line) {
  if (!is_count(words[2])) damaged(line);
  return {words[1], std::stoull(words[2]), {}};
}

/// The property that a line of the header announces. Adds to `has` the parts of a surface that it gives.
Property property_of(const std::vector<std::string>& words, const std::string& line, const std::string& element,
                     std::set<std::string>& has) {
  if (words.size() == 3) {
    const Type* type = type_of(words[1]);
    if (!type) damaged(line);
    const bool place = element == "vertex" && (words[2] == "x" || words[2] == "y" || words[2] == "z");
    if (place && type->integral)
      throw InputError(fmt::format("gives {} as {}; export its coordinates as float or double", words[2], words[1]));
    has.insert(element + " " + words[2]);
    return {*type};
  }
  if (words.size() != 5 || words[1] != "list") damaged(line);
  const Type* count = type_of(words[2]);
  const Type* type = type_of(words[3]);
  if (!count || !count->integral || !type) damaged(line);
  has.insert(element);
  return {*type, count};
}

Header read_header(const std::string& bytes) {
  const std::size_t end = bytes.find("\nend_header");
  if (bytes.compare(0, 3, "ply") != 0 || end == std::string::npos ||
      bytes.find_first_not_of('\r', end + 11) != bytes.find('\n', end + 1))
    throw InputError("is no PLY file: its header is missing; export it again");
  Header header;
  header.end = std::min(bytes.size(), bytes.find('\n', end + 1) + 1);
  std::istringstream lines(bytes.substr(0, end));
  std::set<std::string> has;  // "vertex x", "face" with a list
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && line.back() == '\r') line.pop_back();
    const std::vector<std::string> words = words_of(line);
    // CGAL takes the format from the second line, whatever stands there.
    ++number;
    if (number == 1 && words == std::vector<std::string>{"ply"}) continue;
    if (number == 2 && words.size() == 3 && words[0] == "format") {
      header.format = format_of(words[1], line);
      continue;
    }
    if (number == 2) throw InputError("has a header without format in its second line; export it again");
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "element" && words.size() == 3)
      header.elements.push_back(element_of(words, line));
    else if (words[0] == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(property_of(words, line, header.elements.back().name, has));
    else
      damaged(line);
  }
  if (header.format == Format::none)
    throw InputError("has a header without format in its second line; export it again");
  if (!has.contains("vertex x") || !has.contains("vertex y") || !has.contains("vertex z"))
    throw InputError("has points without x, y or z; export it again");
  if (!has.contains("face")) throw InputError("holds points and no faces; export the surface, not a cloud of points");
  return header;
}

/// A place in the data, for messages; it becomes text only if something is wrong.
struct Place {
  const std::string& element;
  std::uint64_t number;
  std::uint64_t of;
};

std::string text_of(const Place& place) { return fmt::format("{} {} of {}", place.element, place.number, place.of); }

/// Reads the numbers of the data, one after the other.
class Data {
 public:
  Data(const std::string& bytes, const Header& header)
      : rest_(std::string_view(bytes).substr(header.end)), format_(header.format) {}

  /// The smallest number of bytes that `numbers` of a type take.
  [[nodiscard]] std::size_t least_size(const Type& type, std::int64_t numbers) const {
    return static_cast<std::size_t>(numbers) * (format_ == Format::text ? 1 : type.size);  // a digit; 2^35 at most
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

  std::int64_t integer(const Type& type, const Place& where) {
    if (format_ == Format::text) return integer_of(word(where), type, where);
    const std::string_view raw = take(type.size, where);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < type.size; ++i) {
      const std::size_t from_the_top = format_ == Format::big_endian ? i : type.size - 1 - i;
      value = value << 8U | static_cast<unsigned char>(raw[from_the_top]);
    }
    const std::uint64_t sign = 1ULL << (8 * type.size - 1);
    if (type.least < 0 && (value & sign) != 0)
      return static_cast<std::int64_t>(value) - 2 * static_cast<std::int64_t>(sign);
    return static_cast<std::int64_t>(value);
  }

  void skip(const Type& type, std::int64_t numbers, const Place& where) {
    if (format_ != Format::text) {
      take(type.size * static_cast<std::size_t>(numbers), where);
      return;
    }
    for (std::int64_t i = 0; i < numbers; ++i) {
      const std::string_view text = word(where);
      if (type.integral)
        integer_of(text, type, where);
      else
        check_real(text, where);
    }
  }

 private:
  [[noreturn]] static void refuse(std::string_view text, const Place& where) {
    constexpr std::size_t enough = 20;  // characters to quote of a word that may be of any length
    throw InputError(
        fmt::format("has \"{}\" where a number of {} is due; export it again", text.substr(0, enough), text_of(where)));
  }

  static std::int64_t integer_of(std::string_view text, const Type& type, const Place& where) {
    const std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value < type.least || value > type.greatest)
      refuse(text, where);
    return value;
  }

  static void check_real(std::string_view text, const Place& where) {
    const std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) refuse(text, where);
  }

  std::string_view word(const Place& where) {
    constexpr std::string_view blanks = " \t\r\n\v\f";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    return take(std::max<std::size_t>(std::min(rest_.find_first_of(blanks), rest_.size()), 1), where);
  }

  std::string_view take(std::size_t size, const Place& where) {
    if (size > rest_.size())
      throw InputError(fmt::format("ends within {}: it is cut off; export it again", text_of(where)));
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
  Format format_;
};

void check_element(const Element& element, Data& data) {
  for (std::uint64_t i = 0; i < element.number; ++i) {
    const Place where{element.name, i + 1, element.number};
    for (const Property& property : element.properties) {
      const std::int64_t numbers = property.count ? data.integer(*property.count, where) : 1;
      if (numbers < 0 || (property.count && data.least_size(property.type, numbers) > data.left()))
        throw InputError(
            fmt::format("announces {} numbers in {} and has only {} bytes left: it is cut off or damaged; "
                        "export it again",
                        numbers, text_of(where), data.left()));
      data.skip(property.type, numbers, where);
    }
  }
}

}  // namespace

void check_ply(const std::string& bytes) {
  const Header header = read_header(bytes);
  Data data(bytes, header);
  for (const Element& element : header.elements) {
    if (element.number > bytes.size())
      throw InputError(
          fmt::format("announces {} of the element \"{}\" and has only {} bytes: it is cut off or damaged; "
                      "export it again",
                      element.number, element.name, bytes.size()));
    check_element(element, data);
  }
}

}  // namespace thalweg::gencase
