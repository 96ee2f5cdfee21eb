#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postproc/figures.hpp"
#include "postproc/report.hpp"

namespace thalweg::report_sections {

/// Writes the gnuplot scripts of methods() and their data: bands between fine and coarse meshes, speed against error.
std::vector<std::filesystem::path> method_scripts(const std::vector<Method>& methods, const ProfileSet& particles,
                                                  const PictureFrame& frame, const RunFolder& run);

// The parts of the report's page, each a piece of HTML.

std::string heading(const ReportInput& input);
std::string at_a_glance(const ReportInput& input);
std::string profiles(const ReportInput& input, const std::filesystem::path& pictures);
std::string errors(const ReportInput& input);
std::string front_and_energies(const ReportInput& input, const std::filesystem::path& pictures);
std::string particles(const ReportInput& input, const std::filesystem::path& pictures);
std::string methods(const ReportInput& input, const std::filesystem::path& pictures);
std::string run_numbers(const ReportInput& input);
std::string model(const ReportInput& input);
std::string remarks(const ReportInput& input);
std::string provenance(const ReportInput& input);

}  // namespace thalweg::report_sections
