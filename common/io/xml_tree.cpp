#include "common/io/xml_tree.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <istream>
#include <memory>

#include "common/error.hpp"

namespace thalweg {
namespace {

constexpr std::size_t deepest = 16;       // a file of VTK has 7 levels
constexpr std::size_t longest = 200'000;  // elements; a series has one for each snapshot
constexpr std::size_t most_attributes = 64;

class TreeBuilder {
 public:
  explicit TreeBuilder(std::string_view last) : parser_(XML_ParserCreate(nullptr), XML_ParserFree), last_(last) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(), [](void* self, const char* name, const char** pairs) { of(self).start(name, pairs); },
        [](void* self, const char*) { of(self).open_.pop_back(); });
    XML_SetStartDoctypeDeclHandler(parser_.get(), [](void* self, const char*, const char*, const char*, int) {
      of(self).stop("has a document type, which files of VTK do without");
    });
  }

  /// `next` gives the text part by part, at last an empty one. Returns what is wrong; nothing for a text that is whole.
  std::string read(const std::function<std::string_view()>& next) {
    for (bool ends = false; !ends;) {
      const std::string_view part = next();
      ends = part.empty();
      if (XML_Parse(parser_.get(), part.data(), static_cast<int>(part.size()), ends ? 1 : 0) == XML_STATUS_ERROR) break;
      if (ends) return {};
    }
    if (at_last_) return {};
    return fault_.empty() ? fmt::format("is not complete XML ({})", XML_ErrorString(XML_GetErrorCode(parser_.get())))
                          : fault_;
  }

  [[nodiscard]] std::size_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }
  XmlElement& root() { return root_.children.front(); }

 private:
  static TreeBuilder& of(void* self) { return *static_cast<TreeBuilder*>(self); }

  void stop(const std::string& fault) {
    fault_ = fault;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  void start(const char* name, const char** pairs) {
    if (open_.size() >= deepest) return stop(fmt::format("has elements nested deeper than {} levels", deepest));
    if (++count_ > longest) return stop(fmt::format("has more than {} elements", longest));
    XmlElement& parent = open_.empty() ? root_ : *open_.back();
    XmlElement& element = parent.children.emplace_back();
    open_.push_back(&element);  // its parent gets no further child, and so stays in place, until it is closed
    element.name = name;
    element.line = line();
    element.begin = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())) +
                    static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()));
    for (; *pairs != nullptr; pairs += 2) element.attributes.emplace(pairs[0], pairs[1]);
    if (element.attributes.size() > most_attributes) {
      return stop(fmt::format("has an element of more than {} attributes", most_attributes));
    }
    if (element.name != last_) return;
    at_last_ = true;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::string_view last_;
  XmlElement root_;  // holds the text's root as its only child
  std::vector<XmlElement*> open_;
  std::size_t count_ = 0;
  bool at_last_ = false;
  std::string fault_;
};

}  // namespace

std::string XmlElement::attribute(const std::string& key) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? std::string() : found->second;
}

namespace {

XmlElement parse_parts(const std::function<std::string_view()>& next, const std::filesystem::path& file,
                       std::string_view last) {
  TreeBuilder builder(last);
  if (const std::string fault = builder.read(next); !fault.empty()) {
    throw InputError(
        fmt::format("{}:{}: {}; it may have been cut off: write it again", file.string(), builder.line(), fault));
  }
  return std::move(builder.root());
}

}  // namespace

XmlElement parse_xml(std::string_view text, const std::filesystem::path& file, std::string_view last) {
  const auto next = [&] {
    const std::string_view part = text.substr(0, std::size_t{1} << 24);
    text.remove_prefix(part.size());
    return part;
  };
  return parse_parts(next, file, last);
}

XmlElement parse_xml(std::istream& stream, const std::filesystem::path& file) {
  std::string part(std::size_t{1} << 20, '\0');
  const auto next = [&] {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    return std::string_view(part).substr(0, static_cast<std::size_t>(stream.gcount()));
  };
  return parse_parts(next, file, {});
}

}  // namespace thalweg
