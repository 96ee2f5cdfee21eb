#include "case/tables/common_checks.hpp"

#include <cctype>

namespace thalweg {

void check_file_name(const CheckContext& at, const std::string& name) {
  const bool usable = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
  });
  if (usable && name.front() != '.') return;
  at.reject(at.key("name"), fmt::format("{} = \"{}\" cannot name files", at.key("name"), name),
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
              "give times within the run or extend it");
  }
}

}  // namespace thalweg
