#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "common/input_errors.hpp"
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

/// The files with more than one mistake, and how many: a point for each corner, both openings of one name, a motion that
/// no shape has because the shape's is wrong, and a flood with a zone outside.
std::size_t mistakes_in(const std::string& name) {
  static const std::map<std::string, std::size_t> several{
      {"domain_missing", 2},       {"motion_missing", 2},           {"motion_unknown", 2},
      {"openings_of_one_name", 2}, {"point_too_short_in_space", 8}, {"surface_bed_under_a_flood", 2}};
  const auto found = several.find(name);
  return found == several.end() ? 1 : found->second;
}

// A message that merely follows from a mistake is no mistake of the user's.
TEST_P(BadCase, CausesAsManyMessagesAsItHasMistakes) {
  std::vector<std::string> messages;
  try {
    read_case(GetParam());
  } catch (const InputErrors& errors) {
    messages = errors.messages();
  } catch (const InputError& error) {
    messages = {error.what()};
  }
  EXPECT_EQ(messages.size(), mistakes_in(GetParam().stem().string())) << fmt::format("{}", fmt::join(messages, "\n"));
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
