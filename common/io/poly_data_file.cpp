#include "common/io/poly_data_file.hpp"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>

#include "common/error.hpp"
#include "common/io/file_seal.hpp"
#include "common/io/particle_names.hpp"
#include "common/io/poly_data_check.hpp"
#include "common/io/vtk_errors.hpp"

namespace thalweg {
namespace {

template <class T>
void add_number(vtkPolyData* data, const char* name, T value) {
  vtkNew<vtkAOSDataArrayTemplate<T>> one;
  one->SetName(name);
  one->InsertNextValue(value);
  data->GetFieldData()->AddArray(one);
}
void add_text(vtkPolyData* data, const char* name, const std::string& value) {
  vtkNew<vtkStringArray> one;
  one->SetName(name);
  one->InsertNextValue(value);
  data->GetFieldData()->AddArray(one);
}

}  // namespace

void add_fact(vtkPolyData* data, const char* name, float value) { add_number(data, name, value); }

void add_fact(vtkPolyData* data, const char* name, std::int64_t value) { add_number<vtkTypeInt64>(data, name, value); }

void add_fact(vtkPolyData* data, const char* name, const Vec3& value) {
  vtkNew<vtkAOSDataArrayTemplate<double>> one;
  one->SetName(name);
  one->SetNumberOfComponents(3);
  one->InsertNextTuple(value.data());
  data->GetFieldData()->AddArray(one);
}

void add_facts(vtkPolyData* data, const ParticleFileInfo& info) {
  add_number(data, particle_names::time, info.time);
  add_number<vtkTypeInt64>(data, particle_names::step, info.step);
  add_number<int>(data, particle_names::dimension, info.dimension);
  add_number(data, particle_names::spacing, info.spacing);
  add_number(data, particle_names::smoothing, info.smoothing_length);
  add_text(data, particle_names::case_name, info.case_name);
  add_text(data, particle_names::version, info.code_version);
  add_text(data, particle_names::hash, info.case_hash);
}

void add_fact(vtkPolyData* data, const char* name, const std::string& value) { add_text(data, name, value); }

vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file) {
  check_poly_data(file);
  vtkNew<vtkXMLPolyDataReader> reader;
  vtkNew<VtkErrors> errors;
  reader->AddObserver(vtkCommand::ErrorEvent, errors);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || errors->any()) {
    throw InputError(file.string() + ": is no complete file of VTK (" + errors->first() + "); write it again");
  }
  return reader->GetOutput();
}

std::string poly_data_text(const std::filesystem::path& file, vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  vtkNew<VtkErrors> errors;
  writer->AddObserver(vtkCommand::ErrorEvent, errors);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  writer->SetInputData(data);
  // To memory: on a full disk VTK 9.1 crashes while it cleans up.
  writer->WriteToOutputStringOn();
  // Appended raw data would be a quarter smaller, but since the expat of Debian 12.12 ParaView 5.11 cannot open them.
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);  // higher levels cost several times the time for a few per cent of size
  writer->SetHeaderTypeToUInt64();
  if (writer->Write() == 0 || errors->any()) {
    throw RunError(file.string() + ": cannot be made: " + errors->first() + "; is there enough memory?");
  }
  return writer->GetOutputString();
}

void write_poly_data(const std::filesystem::path& file, vtkPolyData* data, const WholeFile& how) {
  std::string contents = poly_data_text(file, data);
  contents += seal_of(contents);
  write_whole_bytes(file, contents, how);
}

}  // namespace thalweg
