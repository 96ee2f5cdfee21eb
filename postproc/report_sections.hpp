#pragma once

#include <filesystem>
#include <string>

#include "postproc/report.hpp"

/// The parts of the report's page, each a piece of HTML.
namespace thalweg::report_sections {

std::string heading(const ReportInput& input);
std::string at_a_glance(const ReportInput& input);
std::string profiles(const ReportInput& input, const std::filesystem::path& pictures);
std::string errors(const ReportInput& input);
std::string front_and_energies(const ReportInput& input, const std::filesystem::path& pictures);
std::string particles(const ReportInput& input, const std::filesystem::path& pictures);
std::string run_numbers(const ReportInput& input);
std::string model(const ReportInput& input);
std::string remarks(const ReportInput& input);
std::string provenance(const ReportInput& input);

}  // namespace thalweg::report_sections
