#include "postproc/profile_set.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/run_folder.hpp"
#include "common/shown.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

TimedProfile read_timed(const fs::path& file) {
  const std::optional<double> time = time_of_profile(file);
  if (!time) {
    throw InputError(file.string() + ": the name does not say the time of the profile; rename it like " +
                     profile_file_name(0.25) + " for 0.25 s");
  }
  return {*time, file, read_profile(file)};
}

void sort_by_time(ProfileSet& set) {
  std::sort(set.profiles.begin(), set.profiles.end(),
            [](const TimedProfile& a, const TimedProfile& b) { return a.time < b.time; });
}

// A run keeps them in profiles/.
fs::path folder_of_profiles(const fs::path& folder) {
  const bool is_run = !holds_profiles(folder) && fs::is_directory(folder / "profiles");
  return is_run ? folder / "profiles" : folder;
}

// The profile at t = 0, among the others or, for a run, among those of all its snapshots.
void take_initial(ProfileSet& set) {
  if (const TimedProfile* first = set.at(0)) {
    set.initial = *first;
    return;
  }
  const fs::path first = folder_of_profiles(set.origin) / "all" / profile_file_name(0);
  if (fs::exists(first)) set.initial = read_timed(first);
}

// A label people recognise: the folder's name, or its parent's where the folder is just called "profiles".
std::string label_of(const fs::path& path) {
  std::error_code too_long;
  fs::path folder = fs::is_directory(path, too_long) ? path.lexically_normal() : path.lexically_normal().parent_path();
  if (folder.filename().empty()) folder = folder.parent_path();
  if (folder.filename() == "profiles") folder = folder.parent_path();
  const std::string name = folder.filename().string();
  return name.empty() || name == "." || name == ".." ? path.stem().string() : name;
}

}  // namespace

const TimedProfile* ProfileSet::at(double time) const {
  for (const TimedProfile& candidate : profiles) {
    if (std::abs(candidate.time - time) <= same_time) return &candidate;
  }
  return nullptr;
}

bool holds_profiles(const fs::path& folder) {
  if (!fs::is_directory(folder)) return false;
  return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [](const fs::directory_entry& entry) { return time_of_profile(entry.path()).has_value(); });
}

ProfileSet read_profile_set(const fs::path& folder_or_file, const std::string& label, SourceKind kind) {
  ProfileSet set{label, kind, folder_or_file, {}};
  std::error_code too_long;
  if (!fs::exists(folder_or_file, too_long)) {
    throw InputError((too_long ? shown(folder_or_file.string()) : folder_or_file.string()) +
                     ": there is no such file or folder; name a profile (t0.250.csv), a folder of them or a run");
  }
  if (fs::is_regular_file(folder_or_file)) {
    set.profiles.push_back(read_timed(folder_or_file));
    return set;
  }
  if (!fs::is_directory(folder_or_file)) {
    throw InputError(folder_or_file.string() + ": is neither a plain file nor a folder; name a profile or a run");
  }
  for (const auto& entry : fs::directory_iterator(folder_of_profiles(folder_or_file))) {
    if (time_of_profile(entry.path())) set.profiles.push_back(read_timed(entry.path()));
  }
  if (set.profiles.empty()) {
    if (fs::exists(RunFolder{folder_or_file}.resolved_case())) {
      throw InputError(folder_or_file.string() + ": is a run without profiles; take them with thalweg-postproc " +
                       folder_or_file.string());
    }
    throw InputError(folder_or_file.string() + ": holds no profile; they are named like " + profile_file_name(0.25));
  }
  sort_by_time(set);
  take_initial(set);
  return set;
}

std::optional<ProfileSet> read_line_set(const ProfileSet& source, const std::string& line) {
  if (!fs::is_directory(source.origin)) return std::nullopt;
  const fs::path folder = folder_of_profiles(source.origin) / line;
  if (!holds_profiles(folder)) return std::nullopt;
  ProfileSet set = read_profile_set(folder, source.label, source.kind);
  set.line = line;
  return set;
}

std::vector<ProfileSet> read_named_sets(const std::vector<std::string>& arguments) {
  std::vector<ProfileSet> sets;
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    std::error_code too_long;  // a path can be no file because of its length
    const bool named = equals != std::string::npos && !fs::exists(argument, too_long);
    const fs::path path = named ? argument.substr(equals + 1) : argument;
    const std::string label = named ? argument.substr(0, equals) : label_of(path);
    constexpr std::size_t longest = 60;  // it stands in tables, legends and names of files
    if (named && (label.empty() || label.size() > longest)) {
      throw InputError("--compare " + shown(argument) + ": the label has " + std::to_string(label.size()) +
                       " characters; give 1 to " + std::to_string(longest) + " before the =");
    }
    ProfileSet set = read_profile_set(path, label, SourceKind::other);
    const auto known =
        std::find_if(sets.begin(), sets.end(), [&](const ProfileSet& other) { return other.label == label; });
    if (known == sets.end()) {
      sets.push_back(std::move(set));
      continue;
    }
    for (TimedProfile& profile : set.profiles) {
      if (known->at(profile.time) != nullptr) {
        throw InputError(profile.file.string() + ": \"" + label + "\" already has a profile at this time (" +
                         known->at(profile.time)->file.string() +
                         "); give them different labels: --compare LABEL=PATH");
      }
      known->profiles.push_back(std::move(profile));
    }
    sort_by_time(*known);
    take_initial(*known);
  }
  return sets;
}

}  // namespace thalweg
