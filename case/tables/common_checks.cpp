#include "case/tables/common_checks.hpp"

#include <cctype>

namespace thalweg {
namespace {

constexpr std::size_t longest_name = 64;  // [bytes] leaves room for folders and endings in 255

/// A name as one line of a message.
std::string shown(const std::string& name) {
  std::string text;
  for (const char c : name.substr(0, longest_name / 2)) text += std::iscntrl(static_cast<unsigned char>(c)) ? '?' : c;
  return name.size() > longest_name / 2 ? text + "..." : text;
}

}  // namespace

void check_word(const CheckContext& at, const std::string& kind, const std::string& name) {
  // Letters beyond ASCII come as bytes from 0x80 on.
  const bool usable = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return c >= 0x80 || std::isalnum(c) != 0 ||
           std::string_view(" -_.,+()").find(static_cast<char>(c)) != std::string_view::npos;
  });
  const bool begins_well = !name.empty() && name.front() != '.' && name.front() != ' ' && name.back() != ' ';
  if (usable && begins_well && name.size() <= longest_name) return;
  at.reject(at.path(), fmt::format("\"{}\" cannot name a {}", shown(name), kind),
            fmt::format("use letters, digits, blanks and - _ . , + ( ), at most {} of them", longest_name));
}

void check_line_of_text(const CheckContext& at, std::string_view key, const std::string& text) {
  if (std::none_of(text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; })) return;
  at.reject(at.key(key), at.key(key) + " holds a line end or another control character", "write it in one line");
}

void check_file_name(const CheckContext& at, const std::string& name) {
  const bool usable =
      !name.empty() && name.size() <= longest_name && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
      });
  if (usable && name.front() != '.') return;
  at.reject(at.key("name"), fmt::format("{} = \"{}\" cannot name files", at.key("name"), shown(name)),
            "use letters, digits, \"-\" and \"_\"");
}

void check_corners(const CheckContext& at, const Vec3& from, const Vec3& to) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!at.uses(axis) || from[axis] < to[axis]) continue;
    at.reject(at.key("to"), fmt::format("{} is not beyond {} in {}", at.key("to"), at.key("from"), axis_name(axis)),
              "give the lower corner first and some extent in every direction");
  }
}

void check_within_run(const CheckContext& at, std::string_view key, const std::vector<double>& times, double end) {
  for (const double time : times) {
    if (time <= end) continue;
    at.reject(at.key(key), fmt::format("{} has {} s, after output.end = {} s", at.key(key), time, end),
              fmt::format("give times within the run, extend it, or leave them out with --set {}=[]", at.key(key)));
  }
}

void check_table_over_time(const CheckContext& at, const std::string& column, const std::vector<double>& times,
                           const std::vector<double>& values) {
  if (times.size() != values.size() || values.size() < 2) {
    at.reject(at.key(column), fmt::format("{} has {} times and {} {}", at.path(), times.size(), values.size(), column),
              "give as many of both, two at least");
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) continue;
    at.reject(at.key("times"), fmt::format("{} has {} s after {} s", at.key("times"), times[i], times[i - 1]),
              "let them increase");
  }
}

}  // namespace thalweg
