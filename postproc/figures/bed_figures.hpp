#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postproc/bed_map.hpp"
#include "postproc/figures/figure_writer.hpp"
#include "postproc/report_units.hpp"

namespace thalweg {

/// The table of a map (write_bed_map()), and the folder for the tables of its lines.
struct MapTable {
  const BedMap& map;
  std::filesystem::path file;
};

/// A curve of a picture over time: a column of a table.
struct TimeCurve {
  std::filesystem::path table;
  std::string column;  // "depth [m]"
  std::string title;
  std::string style;  // "lw 2 lc rgb '#0072b2'"
};

/// A level across a picture over time.
struct LevelLine {
  double value = 0;  // [SI]
  std::string title;
  bool outside = false;  // of the range of its formula: drawn dotted
};

/// A picture over time: NAME.svg and NAME.png.
struct TimePicture {
  std::string name;
  std::string abscissa;  // "t  [s]"
  std::string quantity;  // "depth of the scour  [mm]"
  PageUnit time;
  PageUnit unit;
  std::vector<TimeCurve> curves;
  std::vector<LevelLine> levels{};
};
std::filesystem::path time_script(const FigureWriter& writer, const TimePicture& picture);

/// The change of a bed seen from above, with contour lines (PNG only): colours symmetric about zero, of the bed alone.
std::filesystem::path change_map_script(const FigureWriter& writer, const MapTable& table, const PageUnit& height);
/// Shear stress on a bed seen from above [Pa] (PNG only), with a line where it is `critical` [Pa], if that is above 0.
std::filesystem::path shear_map_script(const FigureWriter& writer, const MapTable& table, double grain_weight,
                                       double critical);
/// Shear stress along a bed in the plane [Pa], and `critical` [Pa].
std::filesystem::path shear_profile_script(const FigureWriter& writer, const MapTable& table, double critical);

/// Contour lines between no change and the largest one.
inline constexpr int most_contours = 8;

/// Height over length in the picture of a map [-]: 1 where it has its true shape.
double map_stretch(const BedMap& map);

/// A cut through a bed along x, or along y, at a place: before and after.
std::filesystem::path section_script(const FigureWriter& writer, const MapTable& table, bool along_x,
                                     const std::array<std::size_t, 2>& place, const PageUnit& height);

}  // namespace thalweg
