#include "foam_reference/library/suspended_grains.H"

#include <surfaceInterpolate.H>
#include <upwind.H>

namespace thalweg::foam {

namespace {

using Foam::label;
using Foam::surfaceScalarField;
using Foam::volScalarField;

Foam::tmp<surfaceScalarField> upwind_of(const volScalarField& values, const surfaceScalarField& flux) {
  return Foam::upwind<Foam::scalar>(values.mesh(), flux).interpolate(values);
}

// Volume [m^3] that leaves each cell in a step of dt [s].
Foam::scalarField leaving(const surfaceScalarField& flux, double dt) {
  const Foam::fvMesh& mesh = flux.mesh();
  Foam::scalarField out(mesh.nCells(), 0);
  forAll(flux, face) {
    const label from = flux[face] > 0 ? mesh.owner()[face] : mesh.neighbour()[face];
    out[from] += dt * Foam::mag(flux[face]);
  }
  forAll(mesh.boundary(), patch) {
    const Foam::labelUList& cells = mesh.boundary()[patch].faceCells();
    const Foam::scalarField& through = flux.boundaryField()[patch];
    forAll(through, face) { out[cells[face]] += dt * Foam::max(through[face], Foam::scalar(0)); }
  }
  return out;
}

}  // namespace

double carry_grains(volScalarField& grains, const volScalarField& alpha_water, const volScalarField& free,
                    const surfaceScalarField& water, const Grains& of) {
  const Foam::fvMesh& mesh = grains.mesh();
  const double dt = mesh.time().deltaTValue();
  // Grains per volume of water; below a hundredth of water in a cell they stay behind.
  const volScalarField in_water("grainsInWater", grains / Foam::max(alpha_water, Foam::scalar(0.01)));
  // 1 where both cells of a face are free.
  const surfaceScalarField open("open", Foam::pos(Foam::fvc::interpolate(free) - Foam::scalar(1 - 1e-6)));

  volScalarField sinking("sinking", grains * Foam::dimensionedScalar(Foam::dimVelocity, Foam::Zero));
  forAll(sinking, cell) { sinking[cell] = grains[cell] * of.settling(grains[cell]); }
  sinking.correctBoundaryConditions();
  const Foam::dimensionedVector down("down", Foam::dimless, Foam::vector(0, 0, -1));
  const surfaceScalarField downwards("downwards", mesh.Sf() & down);
  surfaceScalarField flux("grainFlux",
                          open * (water * upwind_of(in_water, water) + downwards * upwind_of(sinking, downwards)));
  // At the ends of the mesh grains leave with the water; none sink through, and none come in.
  forAll(mesh.boundary(), patch) {
    if (mesh.boundary()[patch].coupled()) continue;
    flux.boundaryFieldRef()[patch] = Foam::max(water.boundaryField()[patch], Foam::scalar(0)) *
                                     in_water.boundaryField()[patch] * free.boundaryField()[patch];
  }

  volScalarField share("share", free);
  const Foam::scalarField out(leaving(flux, dt));
  forAll(share, cell) {
    const double held = Foam::max(grains[cell] * mesh.V()[cell], Foam::scalar(0));
    // No branch around the division: the compiler divides before it decides, and OpenFOAM traps 0/0.
    share[cell] = held / Foam::max(Foam::max(out[cell], held), Foam::VSMALL);
  }
  share.correctBoundaryConditions();
  flux *= upwind_of(share, flux);

  Foam::scalarField& values = grains.primitiveFieldRef();
  forAll(flux, face) {
    const label owner = mesh.owner()[face];
    const label neighbour = mesh.neighbour()[face];
    values[owner] -= dt * flux[face] / mesh.V()[owner];
    values[neighbour] += dt * flux[face] / mesh.V()[neighbour];
  }
  double gone = 0;
  forAll(mesh.boundary(), patch) {
    const Foam::labelUList& cells = mesh.boundary()[patch].faceCells();
    const Foam::scalarField& through = flux.boundaryField()[patch];
    forAll(through, face) { values[cells[face]] -= dt * through[face] / mesh.V()[cells[face]]; }
    if (!mesh.boundary()[patch].coupled()) gone += dt * Foam::sum(through);
  }
  grains.correctBoundaryConditions();
  return gone;
}

}  // namespace thalweg::foam
