#include "case/check_context.hpp"

#include <fmt/format.h>

#include <array>

#include "common/error.hpp"

namespace thalweg {

std::string CaseOrigins::where(std::string name) const {
  for (;;) {
    if (const auto found = given.find(name); found != given.end()) return found->second;
    const auto dot = name.rfind('.');
    if (dot == std::string::npos) return file + ":1";
    name.resize(dot);
  }
}

CheckContext::CheckContext(const CaseOrigins& origins, std::string path, std::vector<std::string> keys, int dimension)
    : origins_(origins), path_(std::move(path)), keys_(std::move(keys)), dimension_(dimension) {}

std::string CheckContext::key(std::string_view name) const { return fmt::format("{}.{}", path_, name); }

void CheckContext::reject(const std::string& blamed, const std::string& what, const std::string& cure) const {
  throw InputError(fmt::format("{}: {}; {}", origins_.where(blamed), what, cure));
}

const char* axis_name(int axis) {
  constexpr std::array names{"x", "y", "z"};
  return names.at(static_cast<std::size_t>(axis));
}

}  // namespace thalweg
