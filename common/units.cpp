#include "common/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "common/error.hpp"

namespace thalweg {
namespace {

struct Release {
  void operator()(ut_unit* unit) const { ut_free(unit); }
  void operator()(cv_converter* converter) const { cv_free(converter); }
  void operator()(ut_system* system) const { ut_free_system(system); }
};
using Unit = std::unique_ptr<ut_unit, Release>;
using Converter = std::unique_ptr<cv_converter, Release>;

// UDUNITS keeps its status and its system in global variables, so that every use needs this lock.
std::mutex& lock() {
  static std::mutex mutex;
  return mutex;
}

/// The units database that lies beside the programs of a bundle (tools/bundle).
std::string bundled_database() {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return program.parent_path().parent_path() / "share" / "udunits" / "udunits2.xml";
}

const ut_system* unit_system() {
  static const std::unique_ptr<ut_system, Release> system = [] {
    ut_set_error_message_handler(ut_ignore);  // our exceptions carry the message
    std::unique_ptr<ut_system, Release> read(ut_read_xml(nullptr));
    if (!read) read.reset(ut_read_xml(bundled_database().c_str()));
    if (!read) {
      throw RunError(
          "the units database of UDUNITS cannot be read; install libudunits2-data or let UDUNITS2_XML_PATH name "
          "udunits2.xml");
    }
    const Unit degree(ut_parse(read.get(), "arc_degree", UT_ASCII));
    ut_map_name_to_unit("deg", UT_ASCII, degree.get());  // UDUNITS itself knows only "degree" and "arcdeg"
    const Unit byte(ut_parse(read.get(), "byte", UT_ASCII));
    ut_map_symbol_to_unit("B", UT_ASCII, byte.get());  // a symbol takes prefixes: GB
    return read;
  }();
  return system.get();
}

Unit parse_unit(std::string_view name) { return Unit(ut_parse(unit_system(), std::string(name).c_str(), UT_UTF8)); }

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

// True for a unit with a number in it, such as "mm 3" or "3 mm": UDUNITS would read the number as a factor.
bool holds_loose_number(std::string_view unit) {
  bool at_start = true;
  for (const char c : unit) {
    const bool numeric = std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '+' || c == '-';
    if (at_start && numeric) return true;
    at_start = std::isspace(static_cast<unsigned char>(c)) != 0;
  }
  return false;
}

double convert(double value, const Unit& from, const Unit& to) {
  const Converter converter(ut_get_converter(from.get(), to.get()));
  return cv_convert_double(converter.get(), value);
}

[[noreturn]] void reject(const std::string& message) { throw std::invalid_argument(message); }

}  // namespace

double parse_quantity(std::string_view text, std::string_view unit_in_si) {
  const std::string_view content = trimmed(text);
  const std::string_view digits = content.starts_with('+') ? content.substr(1) : content;
  double number = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status == std::errc::result_out_of_range)
    reject(fmt::format("\"{}\" is too large or too small a number; check it", text));
  if (status != std::errc{}) {
    reject(fmt::format("\"{}\" does not begin with a number; write a number and a unit, such as \"1 {}\"", text,
                       unit_in_si));
  }
  if (!std::isfinite(number)) reject(fmt::format("\"{}\" is not finite; write a finite number", text));

  const std::string_view unit_name = trimmed(digits.substr(static_cast<std::size_t>(end - digits.data())));
  if (unit_name.empty()) reject(fmt::format("\"{0}\" has no unit; add one, such as \"{0} {1}\"", content, unit_in_si));
  const std::string cure = fmt::format("give it in {} or a unit that converts to it", unit_in_si);
  const std::scoped_lock guard(lock());
  const Unit unit = holds_loose_number(unit_name) ? nullptr : parse_unit(unit_name);
  if (!unit) reject(fmt::format("\"{}\" is not a unit; {}", unit_name, cure));
  const Unit si = parse_unit(unit_in_si);
  if (ut_are_convertible(unit.get(), si.get()) == 0)
    reject(fmt::format("\"{}\" does not measure {}; {}", unit_name, unit_in_si, cure));
  const double value = convert(number, unit, si);
  if (!std::isfinite(value)) reject(fmt::format("\"{}\" is not finite in {}; check it", text, unit_in_si));
  return value;
}

std::string format_quantity(double value_in_si, std::string_view unit_in_si) {
  struct Ladder {
    std::string_view unit_in_si;
    std::string_view zero;                  // the unit for a value of 0
    std::array<std::string_view, 4> units;  // from large to small; the first in which the value is at least 1 is taken
  };
  static constexpr std::array ladders{
      Ladder{"m", "m", {"m", "cm", "mm", "um"}},
      Ladder{"s", "s", {"s", "ms", "us"}},
      Ladder{"Pa", "Pa", {"MPa", "kPa", "Pa"}},
      Ladder{"rad", "deg", {"deg"}},
  };
  for (const Ladder& ladder : ladders) {
    if (ladder.unit_in_si != unit_in_si || !std::isfinite(value_in_si)) continue;
    if (value_in_si == 0) return fmt::format("0 {}", ladder.zero);
    const std::scoped_lock guard(lock());
    const Unit si = parse_unit(unit_in_si);
    std::string_view unit;
    double value = 0;
    for (const std::string_view candidate : ladder.units) {
      if (candidate.empty()) break;
      unit = candidate;
      value = convert(value_in_si, si, parse_unit(candidate));
      if (std::abs(value) >= 1 - 1e-9) break;
    }
    return fmt::format("{:.4g} {}", value, unit);
  }
  return fmt::format("{:.4g} {}", value_in_si, unit_in_si);
}

}  // namespace thalweg
