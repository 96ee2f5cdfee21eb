#include "foam_reference/foam_model.hpp"

#include <gmock/gmock.h>

#include "common/error.hpp"
#include "foam_reference/all_models.hpp"
#include "foam_reference/case_files.hpp"
#include "tests/foam_reference/expect_error.hpp"
#include "tests/foam_reference/small_scene.hpp"

namespace thalweg::foam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(FoamModel, IsNamedAsInTheCaseFile) {
  for (const FoamModel model : {FoamModel::same_material, FoamModel::eroding_bed, FoamModel::stock}) {
    EXPECT_EQ(model_of(name_of(model)), model);
  }
  EXPECT_EQ(name_of(FoamModel::eroding_bed), "eroding-bed");
  EXPECT_EQ(folder_of(FoamModel::same_material, 2), "same-material-2x");
  EXPECT_THAT(message_of<InputError>([] { model_of("flow-3d"); }),
              HasSubstr("the models are same-material, eroding-bed, stock"));
}

TEST(FoamModel, DefaultsToBothOfOurOwnWhereThereIsSediment) {
  Case scene = still_tank();
  EXPECT_THAT(models_of(scene), ElementsAre(FoamModel::same_material, FoamModel::eroding_bed));
  scene.foam.models = {"stock"};
  EXPECT_THAT(models_of(scene), ElementsAre(FoamModel::stock));
  EXPECT_THAT(models_of(water_tank()), ElementsAre(FoamModel::stock));
  EXPECT_FALSE(needs_library(water_tank(), FoamModel::same_material));
}

TEST(SameMaterial, HasTheCasesOwnLaws) {
  Case scene = still_tank();
  scene.model.effective_pressure = EffectivePressure::laplace;
  scene.model.yield_fit = YieldFit::plane_strain;
  const CaseFiles files = case_files(make_foam_case(scene, 1, FoamModel::same_material, "/somewhere"));
  const std::string& text = files.at("constant/transportProperties");
  EXPECT_THAT(text, HasSubstr("transportModel  thalwegSediment;"));
  EXPECT_THAT(text, HasSubstr("effectivePressure   laplace;"));
  EXPECT_THAT(text, HasSubstr("yieldFit            planeStrain;"));
  EXPECT_THAT(text, HasSubstr("frictionAngle       0.523598775598;"));  // 30 degrees
  EXPECT_THAT(text, HasSubstr("count       (40 1);"));
  EXPECT_THAT(files.at("system/controlDict"), HasSubstr("libs            (\"libthalwegFoam.so\");"));
  EXPECT_THAT(files.at("Allrun"), HasSubstr("/somewhere"));
  EXPECT_FALSE(files.contains("constant/fvOptions"));
}

TEST(ErodingBed, LiesUnderWaterAndAir) {
  const CaseFiles files = case_files(make_foam_case(still_tank(), 2, FoamModel::eroding_bed, "/somewhere"));
  EXPECT_THAT(files.at("system/controlDict"), HasSubstr("application     interFoam;"));
  EXPECT_THAT(files.at("system/controlDict"), HasSubstr("type            erodingBed;"));
  EXPECT_THAT(files.at("constant/fvOptions"), HasSubstr("type            immersedBed;"));
  EXPECT_THAT(files.at("constant/transportProperties"), Not(HasSubstr("sediment\n")));
  // The bed's pores are full of water.
  EXPECT_THAT(files.at("system/setFieldsDict"),
              HasSubstr("volScalarFieldValue alpha.water 1 volScalarFieldValue bed 1"));
  EXPECT_THAT(files.at("Allrun"), HasSubstr("interFoam -parallel"));
  EXPECT_FALSE(files.contains("0.orig/alpha.sediment"));
  EXPECT_TRUE(files.contains("0.orig/grains"));
}

TEST(LargeEddies, HaveTheirDictionaryAndField) {
  Case scene = still_tank();
  scene.foam.turbulence = FoamTurbulence::smagorinsky;
  const CaseFiles files = case_files(make_foam_case(scene, 1));
  EXPECT_THAT(files.at("constant/turbulenceProperties"), HasSubstr("LESModel        Smagorinsky;"));
  EXPECT_TRUE(files.contains("0.orig/nut"));
}

}  // namespace
}  // namespace thalweg::foam
