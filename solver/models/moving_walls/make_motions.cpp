#include "solver/models/moving_walls/make_motions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thalweg {
namespace {

void copy(const Vec3& from, double* to) {
  for (int c = 0; c < 3; ++c) to[c] = from[c];
}

/// Linear between the rows, at rest outside of them.
std::vector<MotionSegment> linear(const std::vector<double>& times, const std::vector<double>& places) {
  std::vector<MotionSegment> segments;
  for (std::size_t i = 0; i < times.size(); ++i) {
    MotionSegment& s = segments.emplace_back();
    s.begin = times[i];
    s.place = places[i];
    if (i + 1 < times.size()) s.rate = (places[i + 1] - places[i]) / (times[i + 1] - times[i]);
  }
  return segments;
}

std::vector<MotionSegment> gate_lift(const Motion& m) {
  std::vector<MotionSegment> segments;
  const bool accelerates = m.acceleration > 0;
  MotionSegment& first = segments.emplace_back();
  first.begin = m.start;
  first.change = m.acceleration;
  first.rate = accelerates ? 0 : m.speed;
  double stop = accelerates ? std::sqrt(2 * m.distance / m.acceleration) : m.distance / m.speed;
  if (const double run_up = m.speed / m.acceleration; accelerates && m.speed > 0) {
    const double way = 0.5 * m.speed * run_up;
    if (m.distance == 0 || m.distance > way) segments.push_back({m.start + run_up, way, m.speed});
    if (m.distance > way) stop = run_up + (m.distance - way) / m.speed;
  }
  if (m.distance > 0) segments.push_back({m.start + stop, m.distance});
  return segments;
}

std::vector<MotionSegment> segments_of(const Motion& m) {
  switch (m.kind) {
    case MotionKind::piecewise_linear:
      return linear(m.times, m.displacements);
    case MotionKind::rotation:
      if (m.angular_speed == 0) return linear(m.times, m.angles);
      return {{m.start, 0, m.angular_speed}};
    case MotionKind::gate_lift:
    case MotionKind::sliding_surface:
      return gate_lift(m);
    case MotionKind::oscillation:
      return {{m.start, 0, 0, 0, m.amplitude, 2 * std::numbers::pi / m.period}};
  }
  return {};
}

}  // namespace

std::vector<WallMotion> make_motions(const Case& from) {
  std::vector<WallMotion> motions;
  for (const Motion& m : from.motions) {
    WallMotion& motion = motions.emplace_back();
    motion.axis.turns = m.kind == MotionKind::rotation;
    motion.stays = m.kind == MotionKind::sliding_surface;
    // In the plane x-z counter-clockwise is about -y.
    const Vec3 about = from.info.dimension == 2 ? Vec3(0, -1, 0) : m.axis;
    copy(motion.axis.turns ? about.normalized() : m.direction.normalized(), motion.axis.direction);
    copy(m.center, motion.axis.center);
    motion.segments = segments_of(m);
    const double at_start = motion.at(0).place;
    for (MotionSegment& segment : motion.segments) segment.place -= at_start;
  }
  return motions;
}

double largest_wall_speed(const std::vector<WallMotion>& motions, const ParticleSet& particles, double end) {
  std::vector<double> reach(motions.size(), 0.0);  // speed for a rate of 1
  const auto numbers = particles.scalars.find(motion_array);
  for (std::size_t i = 0; numbers != particles.scalars.end() && i < particles.size(); ++i) {
    const auto number = static_cast<std::size_t>(numbers->second[i]);
    if (number == 0 || number > motions.size()) continue;
    Vec3 u;
    rigid_velocity(motions[number - 1].axis, 1, particles.position[i].data(), u.data());
    reach[number - 1] = std::max(reach[number - 1], u.norm());
  }
  double largest = 0;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const auto& segments = motions[m].segments;
    for (std::size_t s = 0; s < segments.size() && segments[s].begin < end; ++s) {
      const double until = s + 1 < segments.size() ? std::min(end, segments[s + 1].begin) : end;
      const double last = segments[s].rate + segments[s].change * (until - segments[s].begin);
      const double peak = std::max(std::abs(segments[s].rate), std::abs(last));
      largest = std::max(largest, reach[m] * (peak + segments[s].amplitude * segments[s].frequency));
    }
  }
  return largest;
}

}  // namespace thalweg
