#include "foam_reference/library/thalweg_sediment.H"

#include <cmath>

#include <addToRunTimeSelectionTable.H>
#include <fvcGrad.H>
#include "foam_reference/library/dictionary_choices.H"

namespace Foam {
namespace viscosityModels {

defineTypeNameAndDebug(thalwegSediment, 0);
addToRunTimeSelectionTable(viscosityModel, thalwegSediment, dictionary);

namespace {

using thalweg::EffectivePressure;
using thalweg::Rheology;
using thalweg::YieldCriterion;
using thalweg::YieldFit;
using thalweg::foam::dictionary_choices;

const auto closures = dictionary_choices(EffectivePressure::column, EffectivePressure::laplace, EffectivePressure::eos,
                                         EffectivePressure::total);
const auto criteria = dictionary_choices(YieldCriterion::drucker_prager, YieldCriterion::mohr_coulomb);
const auto rheologies = dictionary_choices(Rheology::herschel_bulkley, Rheology::mu_of_i);
const auto fits = dictionary_choices(YieldFit::sine, YieldFit::coulomb, YieldFit::outer, YieldFit::inner,
                                     YieldFit::plane_strain, YieldFit::paper, YieldFit::printed);

thalweg::SedimentParameters parameters_of(const dictionary& of) {
  const auto scalar_of = [&](const word& key) { return of.get<scalar>(key); };
  thalweg::SedimentParameters s;
  s.grain_density = scalar_of("grainDensity");
  s.porosity = scalar_of("porosity");
  s.grain_diameter = scalar_of("grainDiameter");
  s.friction_angle = scalar_of("frictionAngle");
  s.cohesion = scalar_of("cohesion");
  s.pore_density = scalar_of("poreDensity");
  s.consistency = scalar_of("consistency");
  s.flow_index = scalar_of("flowIndex");
  s.regularisation = scalar_of("regularisation");
  s.dynamic_friction_angle = scalar_of("dynamicFrictionAngle");
  s.inertial_number = scalar_of("inertialNumber");
  return s;
}

}  // namespace

thalwegSediment::Law thalwegSediment::law_of(const dictionary& of) {
  const thalweg::SedimentParameters parameters = parameters_of(of);
  Law law;
  law.material =
      thalweg::make_material<double>(parameters, {criteria.get("yieldCriterion", of), fits.get("yieldFit", of),
                                                  rheologies.get("rheology", of), of.get<bool>("asPrinted")});
  law.density = of.get<scalar>("density");
  law.least_viscosity = of.get<scalar>("leastViscosity");
  law.pressure.closure = closures.get("effectivePressure", of);
  law.pressure.pore_density = parameters.pore_density;
  law.pressure.bed_density = law.density;
  law.pressure.submerged_weight =
      thalweg::submerged_weight(law.density, parameters.pore_density, double(of.get<scalar>("gravity")));
  law.pressure.friction_tangent = law.material.friction_tangent;
  return law;
}

thalwegSediment::thalwegSediment(const word& name, const dictionary& properties, const volVectorField& U,
                                 const surfaceScalarField& phi)
    : viscosityModel(name, properties, U, phi),
      law_(law_of(properties.optionalSubDict(typeName + "Coeffs"))),
      columns_(U.mesh(), properties.optionalSubDict(typeName + "Coeffs").subDict("columns")),
      nu_(IOobject(name, U.time().timeName(), U.db(), IOobject::NO_READ, IOobject::AUTO_WRITE), U.mesh(),
          dimensionedScalar(dimViscosity, Zero)) {
  correct();
}

double thalwegSediment::viscosity(const symmTensor& strain_rate, double effective_pressure) const {
  const double half_square = 0.5 * magSqr(strain_rate);  // D:D/2 [1/s^2]
  const double shear_rate = 2 * std::sqrt(half_square);  // sqrt(2 D:D) [1/s]
  const double lode_sine = thalweg::sine_of_three_lode_angles(double(det(strain_rate)), half_square);
  const double yield_stress = thalweg::yield_stress_of(law_.material, effective_pressure, lode_sine);
  const double eta =
      thalweg::apparent_viscosity_of(law_.material, shear_rate, yield_stress, effective_pressure, lode_sine);
  return (eta > law_.least_viscosity ? eta : law_.least_viscosity) / law_.density;
}

void thalwegSediment::correct() {
  // A phase's viscosity is called nu.PHASE, its share alpha.PHASE.
  const auto& sediment = U_.mesh().lookupObject<volScalarField>(IOobject::groupName("alpha", nu_.group()));
  const scalarField pressure(thalweg::foam::effective_pressure(law_.pressure, columns_, sediment));
  const tmp<volTensorField> gradient(fvc::grad(U_));
  const tensorField& of = gradient().primitiveField();
  scalarField& nu = nu_.primitiveFieldRef();
  forAll(nu, cell) { nu[cell] = viscosity(dev(symm(of[cell])), pressure[cell]); }
  // Walls and open faces: the viscosity of the cell beside them.
  forAll(nu_.boundaryField(), patch) {
    fvPatchScalarField& at_patch = nu_.boundaryFieldRef()[patch];
    if (!at_patch.coupled()) at_patch == at_patch.patchInternalField();
  }
  nu_.boundaryFieldRef().evaluate();
}

bool thalwegSediment::read(const dictionary& properties) {
  viscosityModel::read(properties);
  law_ = law_of(properties.optionalSubDict(typeName + "Coeffs"));
  return true;
}

}  // namespace viscosityModels
}  // namespace Foam
