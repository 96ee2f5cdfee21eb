#include "foam_reference/library/thalweg_sediment.H"

#include <cmath>

#include <Enum.H>
#include <addToRunTimeSelectionTable.H>
#include <fvcGrad.H>

namespace Foam {
namespace viscosityModels {

defineTypeNameAndDebug(thalwegSediment, 0);
addToRunTimeSelectionTable(viscosityModel, thalwegSediment, dictionary);

namespace {

using thalweg::EffectivePressure;
using thalweg::Rheology;
using thalweg::YieldCriterion;
using thalweg::YieldFit;

const Enum<EffectivePressure> closure_names({{EffectivePressure::column, "column"},
                                             {EffectivePressure::laplace, "laplace"},
                                             {EffectivePressure::eos, "eos"}});
const Enum<YieldCriterion> criterion_names({{YieldCriterion::drucker_prager, "druckerPrager"},
                                            {YieldCriterion::mohr_coulomb, "mohrCoulomb"}});
const Enum<Rheology> rheology_names({{Rheology::herschel_bulkley, "herschelBulkley"}, {Rheology::mu_of_i, "muOfI"}});
const Enum<YieldFit> fit_names({{YieldFit::sine, "sin"},
                                {YieldFit::coulomb, "coulomb"},
                                {YieldFit::outer, "outer"},
                                {YieldFit::inner, "inner"},
                                {YieldFit::plane_strain, "planeStrain"},
                                {YieldFit::paper, "paper"}});

}  // namespace

thalwegSediment::Law thalwegSediment::law_of(const dictionary& of) {
  const auto scalar_of = [&](const word& key) { return of.get<scalar>(key); };
  const YieldFit fit = fit_names.get("yieldFit", of);
  const double friction_angle = scalar_of("frictionAngle");
  Law law;
  law.closure = closure_names.get("effectivePressure", of);
  law.criterion = criterion_names.get("yieldCriterion", of);
  law.rheology = rheology_names.get("rheology", of);
  law.yield_coefficient = thalweg::yield_pressure_coefficient(friction_angle, fit);
  law.cohesion_term = thalweg::yield_cohesion_term(scalar_of("cohesion"), friction_angle, fit);
  law.dynamic_coefficient = thalweg::yield_pressure_coefficient(scalar_of("dynamicFrictionAngle"), fit);
  law.consistency = scalar_of("consistency");
  law.flow_index = scalar_of("flowIndex");
  law.regularisation = scalar_of("regularisation");
  law.density = scalar_of("density");
  law.least_viscosity = scalar_of("leastViscosity");
  law.inertia = {scalar_of("inertialNumber"), scalar_of("grainDiameter"), scalar_of("grainDensity")};
  law.pressure.closure = law.closure;
  law.pressure.pore_density = scalar_of("poreDensity");
  law.pressure.bed_density = law.density;
  law.pressure.submerged_weight = (law.density - law.pressure.pore_density) * scalar_of("gravity");
  law.pressure.friction_tangent = std::tan(friction_angle);
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

// What the particle model does in solver/models/bed/sediment_law.hpp, with the same laws.
double thalwegSediment::viscosity(const symmTensor& strain_rate, double effective_pressure) const {
  const double half_square = 0.5 * magSqr(strain_rate);  // D:D/2 [1/s^2]
  const double gdot = 2 * std::sqrt(half_square);        // sqrt(2 D:D) [1/s]
  double lode = 1;
  if (law_.criterion == YieldCriterion::mohr_coulomb) {
    const double sine = thalweg::sine_of_three_lode_angles(double(det(strain_rate)), half_square);
    lode = thalweg::mohr_coulomb_factor(sine, law_.yield_coefficient);
  }
  const double yield_stress = lode * (law_.yield_coefficient * effective_pressure + law_.cohesion_term);
  double eta = 0;
  if (law_.rheology == Rheology::herschel_bulkley) {
    eta =
        thalweg::herschel_bulkley_viscosity(gdot, yield_stress, law_.regularisation, law_.consistency, law_.flow_index);
  } else {
    double growth = law_.dynamic_coefficient - law_.yield_coefficient;
    if (law_.criterion == YieldCriterion::mohr_coulomb) {
      const double sine = thalweg::sine_of_three_lode_angles(double(det(strain_rate)), half_square);
      growth = law_.dynamic_coefficient * thalweg::mohr_coulomb_factor(sine, law_.dynamic_coefficient) -
               law_.yield_coefficient * lode;
    }
    eta = thalweg::mu_of_i_viscosity(gdot, yield_stress, effective_pressure, growth, law_.regularisation,
                                     law_.consistency, law_.inertia);
  }
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
