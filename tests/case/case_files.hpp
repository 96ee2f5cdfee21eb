#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "case/reader/case_file.hpp"
#include "common/error.hpp"

// The files that the tests of the case share, and how they read them.
namespace thalweg {

namespace fs = std::filesystem;

inline const fs::path source = THALWEG_SOURCE_DIR;
inline const fs::path good_case = source / "tests/case/good_case.toml";

inline std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A folder for one test.
inline fs::path own_folder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = fmt::format("{}.{}", test->test_suite_name(), test->name());
  std::replace(name.begin(), name.end(), '/', '.');
  const fs::path folder = fs::path(::testing::TempDir()) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// The message with which a case is refused.
inline std::string message_of(const fs::path& file, const std::vector<std::string>& overrides = {}) {
  try {
    read_case(file, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace thalweg
