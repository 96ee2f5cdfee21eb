#pragma once

#include <string_view>

/// The gnuplot scripts of figures/scripts, compiled into the program (postproc/CMakeLists.txt): templates for
/// fill_template(). `look` and `picture` frame all pictures; each other one belongs to the figure it is named after.
namespace thalweg::embedded {

extern const std::string_view script_look;
extern const std::string_view script_picture;
extern const std::string_view script_profiles;
extern const std::string_view script_front;
extern const std::string_view script_energies;
extern const std::string_view script_openings;
extern const std::string_view script_curves;
extern const std::string_view script_map;
extern const std::string_view script_section;
extern const std::string_view script_stations;
extern const std::string_view script_space_time;
extern const std::string_view script_particles;
extern const std::string_view script_particle_panel;
extern const std::string_view script_particle_kinds;
extern const std::string_view script_particle_map;
extern const std::string_view script_band;
extern const std::string_view script_cost;
extern const std::string_view script_paper_front;
extern const std::string_view script_paper_sections;
extern const std::string_view script_paper_section;
extern const std::string_view script_paper_scour;

}  // namespace thalweg::embedded
