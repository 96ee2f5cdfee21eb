#include "foam_reference/field_file.hpp"

#include <gmock/gmock.h>

#include "common/error.hpp"
#include "tests/foam_reference/expect_error.hpp"
#include "tests/foam_reference/temporary_folder.hpp"

namespace thalweg::foam {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

std::string head(const std::string& format) {
  return "FoamFile\n{\n    version     2.0;\n    format      " + format +
         ";\n    arch        \"LSB;label=32;scalar=64\";\n    class       volScalarField;\n}\n\ndimensions [0 0 0 0 0 "
         "0 "
         "0];\n\n";
}

TEST(FieldFile, ReadsAsciiLists) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("alpha", head("ascii") + "internalField   nonuniform List<scalar> \n3\n(\n0.5\n1e-3\n1\n)\n;\n");
  EXPECT_THAT(read_scalar_field(file), ElementsAre(0.5, 1e-3, 1));
}

TEST(FieldFile, ReadsBinaryLists) {
  const TemporaryFolder folder;
  const double values[] = {0.25, -1e-30, 1};
  const std::string bytes(reinterpret_cast<const char*>(values), sizeof values);
  const auto file =
      folder.write("alpha", head("binary") + "internalField   nonuniform List<scalar> \n3\n(" + bytes + ")\n;\n");
  EXPECT_THAT(read_scalar_field(file), ElementsAre(0.25, -1e-30, 1));
}

TEST(FieldFile, ReadsVectors) {
  const TemporaryFolder folder;
  const auto ascii = folder.write(
      "U", head("ascii") + "internalField   nonuniform List<vector> \n2\n(\n(0.5 0 1e-3)\n(1 2 3)\n)\n;\n");
  EXPECT_THAT(read_vector_field(ascii), ElementsAre(Vec3(0.5, 0, 1e-3), Vec3(1, 2, 3)));
  const double values[] = {0.25, 0, -1};
  const std::string bytes(reinterpret_cast<const char*>(values), sizeof values);
  const auto binary =
      folder.write("V", head("binary") + "internalField   nonuniform List<vector> \n1\n(" + bytes + ")\n;\n");
  EXPECT_THAT(read_vector_field(binary), ElementsAre(Vec3(0.25, 0, -1)));
  EXPECT_THAT(read_vector_field(folder.write("W", head("binary") + "internalField   uniform (1 0 -2);\n")),
              ElementsAre(Vec3(1, 0, -2)));
}

TEST(FieldFile, ReadsUniformFields) {
  const TemporaryFolder folder;
  EXPECT_THAT(read_scalar_field(folder.write("alpha", head("binary") + "internalField   uniform 0.75;\n")),
              ElementsAre(0.75));
}

TEST(FieldFile, NamesAFileThatEndsEarly) {
  const TemporaryFolder folder;
  const auto file = folder.write("alpha", head("ascii") + "internalField   nonuniform List<scalar> \n3\n(\n0.5\n");
  EXPECT_EQ(message_of<RunError>([&] { read_scalar_field(file); }),
            file.string() + ": internalField ends early; run ./Allclean && ./Allrun in the case's folder again");
}

TEST(FieldFile, NamesAFileThatIsMissing) {
  EXPECT_THAT(message_of<RunError>([] { read_scalar_field("nowhere/alpha"); }),
              StartsWith("nowhere/alpha: this field has not been written"));
}

}  // namespace
}  // namespace thalweg::foam
