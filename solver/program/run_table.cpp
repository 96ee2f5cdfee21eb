#include "solver/program/run_table.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "common/whole_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, int cause) {
  throw RunError(
      fmt::format("{}: cannot be written any more: {}; check the free space, then continue with --restart "
                  "latest",
                  file.string(), std::strerror(cause)));
}

/// Separators of a row; those in quotes count as text.
std::ptrdiff_t separators(const std::string& row) {
  bool quoted = false;
  return std::count_if(row.begin(), row.end(), [&](char c) {
    if (c == '"') quoted = !quoted;
    return c == ',' && !quoted;
  });
}

/// The time of a row [s]; nothing if the row is no whole one.
std::optional<double> time_of(const std::string& row, std::ptrdiff_t cells) {
  double time = 0;
  const auto parsed = std::from_chars(row.data(), row.data() + row.size(), time);
  const bool whole = parsed.ec == std::errc{} && parsed.ptr != row.data() + row.size() && *parsed.ptr == ',' &&
                     separators(row) == cells && row.find('\0') == std::string::npos;
  return whole ? std::make_optional(time) : std::nullopt;
}

/// The whole rows up to a time of what stands in a file under the heading. A last line without its end was cut off.
std::vector<std::string> rows_until(const fs::path& file, const std::string& heading, double until) {
  std::ifstream old(file, std::ios::binary);
  std::vector<std::string> kept;
  std::string line;
  if (!std::getline(old, line)) return kept;
  if (line != heading) {
    if (old.peek() == std::ifstream::traits_type::eof()) return kept;
    const fs::path aside =
        file.parent_path() / fmt::format("{}.until-{:g}s{}", file.stem().string(), until, file.extension().string());
    fs::rename(file, aside);
    spdlog::warn("{} has other columns now; the rows so far are in {}", file.string(), aside.string());
    return kept;
  }
  const std::ptrdiff_t cells = separators(heading);
  const double last = std::max(until, std::stod(fmt::format("{:.9g}", until)));  // as the rows of that time say it
  while (std::getline(old, line) && !old.eof()) {
    const auto time = time_of(line, cells);
    if (time && *time <= last) kept.push_back(line);
  }
  return kept;
}

}  // namespace

RunTable::RunTable(fs::path file, const std::string& heading, std::optional<double> keep_until)
    : file_(std::move(file)) {
  std::vector<std::string> rows;
  if (keep_until) rows = rows_until(file_, heading, *keep_until);
  kept_ = static_cast<std::int64_t>(rows.size());
  std::string text = heading + '\n';
  for (const std::string& row : rows) text += row + '\n';
  write_whole_bytes(file_, text, {.make_folders = false});
  descriptor_ = open(file_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0) fail(file_, errno);
}

RunTable::~RunTable() {
  if (descriptor_ >= 0) close(descriptor_);
}

RunTable::RunTable(RunTable&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)), kept_(other.kept_) {}

RunTable& RunTable::operator=(RunTable&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(kept_, other.kept_);
  return *this;
}

void RunTable::add(const std::string& row) {
  const std::string line = row + '\n';
  const off_t before = lseek(descriptor_, 0, SEEK_END);
  const ssize_t written = write(descriptor_, line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return;
  const int cause = written < 0 ? errno : ENOSPC;
  if (before >= 0) static_cast<void>(ftruncate(descriptor_, before) != 0);  // takes back the part that was written
  fail(file_, cause);
}

void RunTable::sync() const {
  if (fsync(descriptor_) != 0) fail(file_, errno);
}

}  // namespace thalweg
