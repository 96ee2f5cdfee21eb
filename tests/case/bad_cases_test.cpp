#include <gtest/gtest.h>

#include <algorithm>

#include "tests/case/case_files.hpp"

namespace thalweg {
namespace {

// Every file of bad_cases is a case with one mistake; its first line is the message it must cause, without the folder.
class BadCase : public ::testing::TestWithParam<fs::path> {};

TEST_P(BadCase, CausesItsMessage) {
  std::string expected;
  std::ifstream file(GetParam());
  std::getline(file, expected);
  const std::string folder = (source / "tests/case/bad_cases/").string();
  std::string message = message_of(GetParam());
  if (message.starts_with(folder)) message.erase(0, folder.size());
  EXPECT_EQ("# " + message, expected);
}

std::vector<fs::path> bad_cases() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(source / "tests/case/bad_cases")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadCase, ::testing::ValuesIn(bad_cases()),
                         [](const auto& parameter) { return parameter.param.stem().string(); });

TEST(BadCases, AreMany) { EXPECT_GE(bad_cases().size(), 70U); }

}  // namespace
}  // namespace thalweg
