#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postproc/report.hpp"
#include "postproc/scene3d.hpp"

namespace thalweg::report_sections {

// The parts of the report's page, each a piece of HTML.

std::string heading(const ReportInput& input);
std::string question(const ReportInput& input);
std::string answer(const ReportInput& input);
std::string cost(const ReportInput& input);
std::string what_is_seen(const ReportInput& input);
std::string conclusions(const ReportInput& input);
std::string bed_map(const ReportInput& input, const std::filesystem::path& pictures);
std::string sections(const ReportInput& input, const std::filesystem::path& pictures);
std::string bed_shear(const ReportInput& input, const std::filesystem::path& pictures);
std::string scene(const ReportInput& input, const std::filesystem::path& pictures);
std::string earlier_scenes(const ReportInput& input);
std::string which_is_which(const ReportInput& input);
std::string profiles(const ReportInput& input, const std::filesystem::path& pictures);
std::string errors(const ReportInput& input);
std::string front_and_energies(const ReportInput& input, const std::filesystem::path& pictures);
std::string openings(const ReportInput& input, const std::filesystem::path& pictures);
std::string scour(const ReportInput& input, const std::filesystem::path& pictures);
std::string formulas(const ReportInput& input);
std::string stations(const ReportInput& input, const std::filesystem::path& pictures);
std::string particles(const ReportInput& input, const std::filesystem::path& pictures);
std::string space_time(const ReportInput& input, const std::filesystem::path& pictures);
std::string methods(const ReportInput& input, const std::filesystem::path& pictures);
std::string run_numbers(const ReportInput& input);
std::string model(const ReportInput& input);
std::string remarks(const ReportInput& input);
std::string provenance(const ReportInput& input);

/// Pictures from ParaView that are older than the run: of an earlier one in the same folder. They are left out.
std::size_t old_paraview_pictures(const ReportInput& input);

/// "x = 0.1850 m, y = 0.1350 m"; in 2-D x alone.
std::string place_in_words(const ReportInput& input, double x, double y);

/// "± 4.6 mm", of the run's band, which is known.
std::string band_in_words(const ReportInput& input);

/// True if the scene has water, or water comes in.
bool has_water(const Case& of);

/// True if some opening has a level to show.
bool has_levels(const OpeningRecords& records);

/// The 3-D view with its slider, or nothing.
std::string space_view(const ReportInput& input, const SpaceScene& scene);

/// The curves of the profile pictures as data, and the script that shows them under the pointer.
std::string hover(const ReportInput& input);

/// A picture with its caption, or the reason why there is none.
std::string figure(const std::string& picture, const std::string& caption, const std::string& id = "");

/// The id of the picture with the profiles of a time: "t0_250".
std::string id_of_profile(double time);

}  // namespace thalweg::report_sections
