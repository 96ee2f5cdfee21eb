#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <vector>

// The elements of an XML text, read by expat within limits that hold for any text: no document types (whose entities
// can grow without bound), no endless nesting, no endless list.
namespace thalweg {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<XmlElement> children;
  std::size_t begin = 0;  // of its contents in the text, right behind its start tag [bytes]
  std::size_t line = 0;

  /// The attribute's text; empty where there is none.
  [[nodiscard]] std::string attribute(const std::string& key) const;
};

/// The root of an XML text that `file` holds. Reading ends with the start tag of an element named `last`, behind which
/// bytes may follow that are no XML. Throws InputError "file:line: what is wrong; what to do".
XmlElement parse_xml(std::string_view text, const std::filesystem::path& file, std::string_view last = {});
/// The same of a text that is not in memory: what `stream`, which is that file, has left.
XmlElement parse_xml(std::istream& stream, const std::filesystem::path& file);

}  // namespace thalweg
