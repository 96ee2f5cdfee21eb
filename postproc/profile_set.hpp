#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/profile.hpp"

namespace thalweg {

/// The origin of profiles. It decides how a source is drawn, and which of two sources is the reference of a comparison:
/// the later one in this list.
enum class SourceKind { run, other, mesh, measured };

/// Two profiles belong to one time when they are closer than this: half of what a profile's file name resolves.
inline constexpr double same_time = 0.5e-3;  // [s]

struct TimedProfile {
  double time = 0;  // [s]
  std::filesystem::path file;
  Profile profile;
};

/// All profiles of one source, in order of time.
struct ProfileSet {
  std::string label;
  SourceKind kind = SourceKind::other;
  std::filesystem::path origin;
  std::vector<TimedProfile> profiles;
  std::optional<TimedProfile> initial{};  // before anything moved, where the source has it
  std::string line{};                     // empty: the profile along x

  /// The profile at a time, or nothing.
  [[nodiscard]] const TimedProfile* at(double time) const;
};

/// One curve of a Profile by the name its column has.
struct Curve {
  const char* name;   // "free_surface"
  const char* title;  // "free surface"
  std::vector<double> Profile::*values;
};
inline constexpr Curve curves[] = {{"free_surface", "free surface", &Profile::free_surface},
                                   {"bed", "bed", &Profile::bed},
                                   {"moving_bed", "moving bed", &Profile::moving_bed}};

/// True if a folder holds a file named like a profile (t0.250.csv).
bool holds_profiles(const std::filesystem::path& folder);

/// Reads a folder of profiles, a run's folder (its profiles/), or one file whose name says its time.
/// Throws InputError when there is no profile, or one cannot be read.
ProfileSet read_profile_set(const std::filesystem::path& folder_or_file, const std::string& label, SourceKind kind);

/// The profiles of the same source along a line: those in the folder NAME beside its others; nothing without them.
/// Throws InputError.
std::optional<ProfileSet> read_line_set(const ProfileSet& source, const std::string& line);

/// Reads the arguments of --compare, "PATH" or "LABEL=PATH"; files with one label become one set. Throws InputError.
std::vector<ProfileSet> read_named_sets(const std::vector<std::string>& arguments);

}  // namespace thalweg
