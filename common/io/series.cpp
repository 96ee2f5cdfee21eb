#include "common/io/series.hpp"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <algorithm>
#include <fstream>

#include "common/error.hpp"
#include "common/io/vtk_errors.hpp"

namespace thalweg {

void write_series(const std::filesystem::path& pvd, const std::vector<SeriesEntry>& entries, const WholeFile& how) {
  vtkNew<vtkXMLDataElement> root;
  root->SetName("VTKFile");
  root->SetAttribute("type", "Collection");
  root->SetAttribute("version", "1.0");
  vtkNew<vtkXMLDataElement> collection;
  collection->SetName("Collection");
  root->AddNestedElement(collection);
  for (const SeriesEntry& entry : entries) {
    vtkNew<vtkXMLDataElement> item;
    item->SetName("DataSet");
    item->SetAttribute("timestep", fmt::format("{}", entry.time).c_str());  // shortest text that reads back equal
    item->SetAttribute("part", "0");
    item->SetAttribute("file", entry.file.generic_string().c_str());
    collection->AddNestedElement(item);
  }
  write_whole_text(
      pvd,
      [&](std::ostream& stream) {
        stream << "<?xml version=\"1.0\"?>\n";
        root->PrintXML(stream, vtkIndent());
      },
      how);
}

std::vector<SeriesEntry> read_series(const std::filesystem::path& pvd) {
  const auto reject = [&](const std::string& what) {
    return InputError(pvd.string() + ": " + what + "; name a .pvd file that a run has written");
  };
  std::ifstream stream(pvd, std::ios::binary);
  if (!stream) throw reject("cannot be opened");
  vtkNew<vtkXMLDataParser> parser;
  vtkNew<VtkErrors> errors;
  parser->AddObserver(vtkCommand::ErrorEvent, errors);
  parser->SetStream(&stream);
  if (parser->Parse() == 0 || errors->any() || parser->GetRootElement() == nullptr) {
    throw reject("is not complete XML (" + errors->first() + ")");
  }
  vtkXMLDataElement* collection = parser->GetRootElement()->FindNestedElementWithName("Collection");
  if (collection == nullptr) throw reject("holds no Collection");

  std::vector<SeriesEntry> entries;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* item = collection->GetNestedElement(i);
    const char* file = item->GetAttribute("file");
    SeriesEntry entry;
    if (file == nullptr || item->GetScalarAttribute("timestep", entry.time) == 0) {
      throw reject("entry " + std::to_string(i + 1) + " lacks `timestep` or `file`");
    }
    entry.file = file;
    entries.push_back(entry);
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const SeriesEntry& a, const SeriesEntry& b) { return a.time < b.time; });
  return entries;
}

}  // namespace thalweg
