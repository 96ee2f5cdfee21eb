#include "gencase/flow_skin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gencase/booleans.hpp"
#include "gencase/nearest_surface.hpp"
#include "gencase/polyhedron.hpp"

namespace thalweg::gencase {
namespace {

/// The skin of the flow as one closed surface.
class CutSkin : public SkinSearch {
 public:
  CutSkin(Triangles surface, double spacing) : flow_(make_polyhedron(std::move(surface))), spacing_(spacing) {}
  [[nodiscard]] std::optional<SurfacePoint> find(const Vec3& from, double reach) const override {
    std::optional<SurfacePoint> found = flow_->own_search()->find(from, reach);
    // On the skin itself the direction is the surface's normal, which points out of the flow.
    if (found && found->distance <= 1e-9 * spacing_) found->direction = -found->direction;
    return found;
  }

 private:
  RegionPointer flow_;
  double spacing_;
};

/// True if the skin that was cut out of all walls misses a place of it: booleans of surfaces that nearly coincide can
/// lose a whole body.
bool misses_skin(const SkinSearch& skin, const FlowRoom& room, double spacing) {
  const std::vector<Vec3> samples = room.skin_samples(1e-3 * spacing);
  return std::any_of(samples.begin(), samples.end(),
                     [&](const Vec3& place) { return !skin.find(place, 0.1 * spacing).has_value(); });
}

}  // namespace

std::unique_ptr<SkinSearch> make_flow_skin(const FlowRoom& room, const Bounds& around, double spacing, int dimension,
                                           const Notes& notes) {
  if (dimension == 3 && room.has_meshes()) {
    constexpr double deviation = 0.01;  // [spacings] of triangles from curved walls
    try {
      if (auto surface = room.triangles(around, deviation * spacing); surface && !surface->corners.empty()) {
        auto skin = std::make_unique<CutSkin>(std::move(*surface), spacing);
        if (!misses_skin(*skin, room, spacing)) return skin;
      }
    } catch (const NoManifold& error) {
      notes.say(fmt::format("walls touch without overlapping ({}): near the contact the normals are those of one wall",
                            error.what()));
    }
  }
  return std::make_unique<NearestSurface>(room, spacing);
}

}  // namespace thalweg::gencase
