#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "case/reader/case_file.hpp"
#include "common/error.hpp"
#include "gencase/generate.hpp"

namespace thalweg::gencase::test {
namespace {

namespace fs = std::filesystem;

const fs::path folder = BAD_GEOMETRY;

std::string without_folder(std::string text) {
  const std::string prefix = folder.string() + "/";
  for (auto found = text.find(prefix); found != std::string::npos; found = text.find(prefix))
    text.erase(found, prefix.size());
  return text;
}

/// An input of the corpus: its first line is the message it must cause, every further one an override of scene.toml.
class BadGeometry : public testing::TestWithParam<fs::path> {};

TEST_P(BadGeometry, SaysWhatIsWrongAndWhatToDo) {
  std::ifstream input(GetParam());
  std::string expected;
  std::getline(input, expected);
  std::vector<std::string> overrides;
  for (std::string line; std::getline(input, line);) overrides.push_back(line);
  try {
    generate(read_case(folder / "scene.toml", overrides));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ("# " + without_folder(error.what()), expected);
  }
}

std::vector<fs::path> inputs() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".set") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadGeometry, testing::ValuesIn(inputs()),
                         [](const auto& input) { return input.param.stem().string(); });

TEST(BadGeometryCorpus, IsLargeAndItsSceneIsGood) {
  EXPECT_GE(inputs().size(), 40U);
  EXPECT_NO_THROW(generate(read_case(folder / "scene.toml")));
}

}  // namespace
}  // namespace thalweg::gencase::test
