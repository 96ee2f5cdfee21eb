#include "common/version.hpp"

namespace thalweg {

// Programs bring their own (cmake/build_version.cmake), which replace these.
[[gnu::weak]] const char* build_version() { return THALWEG_RELEASE; }
[[gnu::weak]] const char* build_commit() { return "unknown"; }

std::string version() { return build_version(); }

std::string release_of(std::string_view version) { return std::string(version.substr(0, version.find('+'))); }

}  // namespace thalweg
