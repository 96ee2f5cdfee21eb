#include "case/reader/case_file.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "case/reader/mistakes.hpp"
#include "case/reader/read_tables.hpp"
#include "case/reader/toml.hpp"
#include "common/error.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

fs::path find_case_file(const fs::path& given) {
  if (fs::is_regular_file(given)) return given;
  const fs::path inside = given / "case.toml";
  if (fs::is_regular_file(inside)) return inside;
  reject_case(given.string(),
              fs::is_directory(given) ? "the folder holds no case.toml" : "there is no such file or folder",
              "name a folder with case.toml, or the file");
}

// The content of files that the case names. A run's folder may be looked at where they are not: it carries their hashes
// along.
void hash_files(const toml::table& root, Case& of) {
  if (const toml::table* known = root[resolved_table]["files"].as_table()) {
    for (const auto& [name, hash] : *known) of.file_hashes[std::string(name.str())] = hash.value_or("");
    return;
  }
  for_each_entry(of, [&]<class T>(const EntryPlace&, T& table) {
    if constexpr (requires { &T::hashed_files; }) {
      for (const std::string& name : table.hashed_files()) {
        std::error_code unreadable;
        if (!fs::is_regular_file(of.folder / name, unreadable)) continue;  // gencase says so when it needs it
        const std::ifstream file(of.folder / name, std::ios::binary);
        if (!file) continue;
        std::ostringstream content;
        content << file.rdbuf();
        of.file_hashes[name] = hash_of_text(content.str());
      }
    }
  });
}

}  // namespace

Case read_case(const fs::path& case_path, const std::vector<std::string>& overrides) {
  const Declarations& tables = case_declarations();
  const fs::path file = find_case_file(case_path);
  // The path goes into scripts and messages of one line.
  const std::string path = fs::absolute(file).string();
  if (std::any_of(path.begin(), path.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }))
    throw InputError("the path of the case holds a line end or another control character; rename the file or folder");
  toml::table root = parse_case_toml(file);
  Mistakes mistakes;
  for (const std::string& text : overrides) mistakes.attempt([&] { apply_override(root, text, tables); });
  mistakes.throw_any();

  Case result;
  result.file = file;
  result.folder = fs::absolute(file).lexically_normal().parent_path();
  CaseOrigins origins;
  origins.file = file.string();
  if (const auto original = root[resolved_table]["folder"].value<std::string>()) {
    result.folder = *original;
    origins.resolved = true;
  }
  read_tables(root, tables, result.folder, origins, result);
  hash_files(root, result);
  return result;
}

}  // namespace thalweg
