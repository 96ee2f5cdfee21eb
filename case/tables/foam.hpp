#pragma once

#include <array>
#include <string>
#include <vector>

#include "case/models/bed_load.hpp"
#include "case/models/suspended_load.hpp"
#include "case/tables/table.hpp"

namespace thalweg {

/// The names in foam.models and of `thalweg foam --model`; foam_reference/foam_model.hpp describes the models.
inline constexpr std::array<const char*, 3> mesh_model_names{"same-material", "eroding-bed", "stock"};

enum class FoamTurbulence { laminar, smagorinsky, k_omega };

inline constexpr std::array<Choice<FoamTurbulence>, 3> choices(FoamTurbulence) {
  return {{{FoamTurbulence::laminar, "laminar", "none"},
           {FoamTurbulence::smagorinsky, "smagorinsky", "large eddies with Smagorinsky's model, in all phases"},
           {FoamTurbulence::k_omega, "k-omega",
            "Menter's k-omega model with wall functions, of the shapes' roughness: the default where a current lasts "
            "and the particles have a mixing length"}}};
}

/// [foam]: the mesh model of the same scene, in OpenFOAM.
struct Foam {
  static constexpr TableHeading heading{"foam", "The mesh model of the same scene."};

  std::vector<std::string> models;  // empty: all that fit the scene
  double cell = 0;                  // [m]
  int meshes = 2;
  double open_above = 0;  // [m]
  FoamTurbulence turbulence = FoamTurbulence::laminar;
  BedLoad bed_load = BedLoad::meyer_peter_mueller;
  PickUp pick_up = PickUp::mastbergen;

  template <class V>
  void describe(V& v) {
    v.texts(
        "models", models,
        "Mesh models to run: \"same-material\", \"eroding-bed\", \"stock\" (foam_reference/README.md). Default: the "
        "first two where the scene has sediment; of a current over sediment the second alone.");
    v.quantity("cell", cell, "m", 0, 100, "Cell size of the mesh model; 0: twice the particle spacing.");
    v.integer("meshes", meshes, 1, 4,
              "Meshes each model runs on, each twice as coarse as the one before; their difference is shown as the "
              "mesh model's uncertainty.");
    v.quantity("open_above", open_above, "m", 0, 1e6,
               "Height of air above the fluid's highest point in the mesh model; 0: half the fluid's height.");
    v.choice("turbulence", turbulence, "Turbulence of the mesh model.");
    v.choice("bed_load", bed_load, "What carries grains along the bed in \"eroding-bed\".");
    v.choice("pick_up", pick_up, "What brings grains into suspension in \"eroding-bed\".");
  }

  void set_defaults(const GivenWords& given);
  void check(const Case& whole, const CheckContext& at) const;
};

}  // namespace thalweg
