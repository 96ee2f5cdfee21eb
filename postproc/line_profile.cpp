#include "postproc/line_profile.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "common/error.hpp"
#include "common/extraction/subset.hpp"
#include "common/units.hpp"

namespace thalweg {

Profile extract_along(const ParticleSet& particles, const ExtractionSettings& settings, const ProfileLine& line) {
  const Vec3 start(line.from.at(0), line.from.at(1), 0);
  const Vec3 end(line.to.at(0), line.to.at(1), 0);
  const double length = (end - start).norm();
  const Vec3 along = (end - start) / length;
  const Vec3 across(-along.y(), along.x(), 0);
  const double reach = 2 * particles.info.smoothing_length + particles.info.spacing;
  ParticleSet near = subset(particles, [&](const Vec3& at) {
    const double s = along.dot(at - start);
    return std::abs(across.dot(at - start)) < reach && s > -reach && s < length + reach;
  });
  for (Vec3& at : near.position) at = Vec3(along.dot(at - start), across.dot(at - start), at.z());

  ExtractionSettings turned = settings;
  turned.narrow_to_walls = false;
  turned.plane_y = 0;
  turned.x_from = 0;
  turned.x_to = length;
  return extract_profile(near, turned).profile;
}

std::string description_of(const ProfileLine& line) {
  return fmt::format(
      "along the line {} from x = {:g} m, y = {:g} m to x = {:g} m, y = {:g} m; x is the distance from its start",
      line.name, line.from.at(0), line.from.at(1), line.to.at(0), line.to.at(1));
}

ProfileLine parse_line(const std::string& text) {
  const auto reject = [&](const std::string& what) -> InputError {
    return InputError(fmt::format(
        "--line {}: {}; write --line \"NAME=0 m,0.1 m,1 m,0.1 m\": x and y of its start, then of its end", text, what));
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw reject("has no name");
  ProfileLine line{text.substr(0, equals), {}, {}};
  if (line.name == "all" || line.name.find_first_of("/\\ ") != std::string::npos || line.name.front() == '.') {
    throw reject("the name cannot name its folder");
  }
  std::istringstream places(text.substr(equals + 1));
  std::vector<double> numbers;
  for (std::string place; std::getline(places, place, ',');) {
    try {
      numbers.push_back(parse_quantity(place, "m"));
    } catch (const std::invalid_argument& error) {
      throw reject(error.what());
    }
  }
  if (numbers.size() != 4) throw reject(fmt::format("has {} numbers", numbers.size()));
  line.from = {numbers[0], numbers[1]};
  line.to = {numbers[2], numbers[3]};
  if (line.from == line.to) throw reject("has no length");
  return line;
}

}  // namespace thalweg
