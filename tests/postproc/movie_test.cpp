#include "postproc/movie.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "case/reader/case_file.hpp"
#include "tests/postproc/synthetic_run.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
using manufactured::SyntheticRun;
using manufactured::TemporaryFolder;
using testing::HasSubstr;

TEST(Movie, HasAFrameOfEverySnapshotThatShowsWaterAndSediment) {
  const TemporaryFolder folder("movie");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  fs::resize_file(synthetic.folder().snapshots() / "s00003.vtp", 5000);
  const Movie movie = make_movie(synthetic.folder(), read_case(synthetic.folder().resolved_case()));
  if (movie.frames == 0) GTEST_SKIP() << movie.warnings.front();  // neither a display nor Xvfb
  EXPECT_EQ(movie.frames, 10U);                                   // of eleven, one of which is damaged
  EXPECT_THAT(movie.warnings, testing::Contains(HasSubstr("skipped: ")));
  for (std::size_t n = 0; n < movie.frames; ++n) {
    EXPECT_GT(fs::file_size(synthetic.folder().root / "movie" / fmt::format("f{:05}.png", n)), 10'000U) << n;
  }
  if (movie.film.empty()) {
    EXPECT_THAT(movie.warnings, testing::Contains(HasSubstr("apt-get install ffmpeg")));
  } else {
    EXPECT_GT(fs::file_size(movie.film), 10'000U);
  }
}

TEST(Movie, WithoutAnyDisplaySaysWhatToInstall) {
  const TemporaryFolder folder("no_display");
  const SyntheticRun synthetic(folder.path());
  synthetic.write();
  const char* path = std::getenv("PATH");
  const std::string programs = path != nullptr ? path : "";
  const char* display = std::getenv("DISPLAY");
  const std::string screen = display != nullptr ? display : "";
  ASSERT_EQ(unsetenv("DISPLAY"), 0);
  ASSERT_EQ(setenv("PATH", "/nonexistent", 1), 0);
  const Movie movie = make_movie(synthetic.folder(), read_case(synthetic.folder().resolved_case()));
  ASSERT_EQ(setenv("PATH", programs.c_str(), 1), 0);
  if (display != nullptr) {
    ASSERT_EQ(setenv("DISPLAY", screen.c_str(), 1), 0);
  }
  EXPECT_EQ(movie.frames, 0U);
  ASSERT_EQ(movie.warnings.size(), 1U);
  EXPECT_THAT(movie.warnings.front(), HasSubstr("apt-get install xvfb"));
}

}  // namespace
}  // namespace thalweg
