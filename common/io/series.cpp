#include "common/io/series.hpp"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkXMLDataElement.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "common/error.hpp"
#include "common/io/xml_tree.hpp"
#include "common/shown.hpp"

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
  std::error_code ignored;  // what cannot be looked at cannot be opened either
  std::ifstream stream(pvd, std::ios::binary);
  if (!stream || !std::filesystem::is_regular_file(pvd, ignored)) {
    throw InputError(pvd.string() + ": cannot be opened; name a .pvd file that a run has written");
  }
  std::ostringstream text;
  text << stream.rdbuf();
  const XmlElement root = parse_xml(text.view(), pvd);
  const auto refuse = [&](const XmlElement& at, const std::string& what) {
    throw InputError(fmt::format("{}:{}: {}; name a .pvd file that a run has written", pvd.string(), at.line, what));
  };
  const auto is_collection = [](const XmlElement& element) { return element.name == "Collection"; };
  const auto collection = std::find_if(root.children.begin(), root.children.end(), is_collection);
  if (collection == root.children.end()) refuse(root, "holds no Collection");

  std::vector<SeriesEntry> entries;
  for (const XmlElement& item : collection->children) {
    const std::string time = item.attribute("timestep");
    SeriesEntry& entry = entries.emplace_back();
    entry.file = item.attribute("file");
    const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), entry.time);
    const bool is_time = error == std::errc{} && end == time.data() + time.size() && std::isfinite(entry.time);
    if (!is_time) refuse(item, fmt::format("the time \"{}\" is no number of seconds", shown(time)));
    if (entry.file.empty()) refuse(item, "the entry names no file");
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const SeriesEntry& a, const SeriesEntry& b) { return a.time < b.time; });
  return entries;
}

}  // namespace thalweg
