// Any bytes are a table, a profile or a survey, or are refused with InputError; a table keeps its cells when it is
// written and read again.
#include <algorithm>
#include <cstdlib>

#include "common/csv.hpp"
#include "common/error.hpp"
#include "common/profile.hpp"
#include "gencase/survey_reader.hpp"
#include "input_file.hpp"

namespace {

namespace fs = std::filesystem;
constexpr std::size_t longest_message = 300 + 64;  // the file's name lies deeper for a user than here

template <class Read>
void refuse_or(const Read& read) {
  try {
    read();
  } catch (const thalweg::InputError& error) {
    const std::string_view message = error.what();
    if (message.size() > longest_message || message.find('\n') != std::string_view::npos) std::abort();
  }
}

void read_all_columns(const fs::path& file, thalweg::LastLine last) {
  refuse_or([&] {
    const auto table = thalweg::CsvTable::read(file, last);
    for (const auto& column : table.columns()) {
      (void)table.texts(column.name);
      refuse_or([&] { (void)table.numbers(column.name, column.unit); });
    }
  });
}

void read_survey(const fs::path& file) {
  refuse_or([&] {
    auto points = thalweg::gencase::read_survey(file).points;
    if (!std::all_of(points.begin(), points.end(), [](const auto& p) { return p.allFinite(); })) std::abort();
    constexpr std::size_t few = 1000;
    if (points.empty() || points.size() > few) return;
    (void)thalweg::gencase::merge_repeated(points);
    (void)thalweg::gencase::averaged(points, 1.0);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fs::path table = thalweg::fuzz::input_file(data, size, ".csv");
  read_all_columns(table, thalweg::LastLine::whole);
  read_all_columns(table, thalweg::LastLine::may_be_cut);
  refuse_or([&] { (void)thalweg::read_profile(table); });
  read_survey(table);
  for (const char* extension : {".xyz", ".asc"}) {
    const fs::path survey = fs::path(table).replace_extension(extension);
    fs::rename(survey.extension() == ".xyz" ? table : fs::path(table).replace_extension(".xyz"), survey);
    read_survey(survey);
  }
  return 0;
}
