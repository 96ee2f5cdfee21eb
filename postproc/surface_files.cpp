#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkSTLWriter.h>

#include <cstdint>

#include "common/error.hpp"
#include "common/io/poly_data_file.hpp"
#include "common/io/vtk_errors.hpp"
#include "common/whole_file.hpp"
#include "postproc/surfaces.hpp"

namespace thalweg {

void write_surface(const std::filesystem::path& file, const Surface& surface, const ParticleFileInfo& info) {
  add_facts(surface.data, info);
  write_poly_data(file, surface.data);
}

void write_stl(const std::filesystem::path& file, const Surface& surface) {
  if (surface.data->GetNumberOfPolys() == 0) return;  // STL has no empty surface
  write_whole_file(file, [&](const std::filesystem::path& temporary) {
    vtkNew<vtkSTLWriter> writer;
    vtkNew<VtkErrors> errors;
    writer->AddObserver(vtkCommand::ErrorEvent, errors);
    writer->SetInputData(surface.data);
    writer->SetFileName(temporary.c_str());
    writer->SetFileTypeToBinary();
    const bool said_whole = writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError && !errors->any();
    // VTK does not look whether the last bytes found room. Binary STL: 84 bytes, and 50 a triangle.
    const auto size = 84 + 50 * static_cast<std::uintmax_t>(surface.data->GetNumberOfPolys());
    if (!said_whole || std::filesystem::file_size(temporary) != size) {
      throw RunError(file.string() + ": cannot be written; check the folder's permissions and free space");
    }
  });
}

}  // namespace thalweg
