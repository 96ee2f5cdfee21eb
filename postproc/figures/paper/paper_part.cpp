#include "postproc/figures/paper/paper_part.hpp"

#include <algorithm>

#include "postproc/html.hpp"

namespace thalweg::paper {

Context::Context(const ReportInput& of)
    : input(of), folder(of.run.report() / "paper"), writer(folder), spacing(of.extraction.info.spacing) {}

const TimedProfile* Context::initial() const { return input.extraction.initial ? &*input.extraction.initial : nullptr; }

bool Context::has_measurement() const {
  return std::any_of(input.sets.begin(), input.sets.end(),
                     [](const ProfileSet& set) { return set.kind == SourceKind::measured; });
}

std::string Context::measured_slot() const {
  if (has_measurement()) return "";
  const std::vector<std::string>& references = input.resolved.compare.references;
  return empty_slot("measured profiles, t0.250.csv … in " + (references.empty() ? "reference" : references.front()) +
                    "/ of the case, would be drawn here as markers");
}

std::string empty_slot(const std::string& what) {
  return "<div class=\"missing\">empty slot: " + html::escape(what) + "</div>\n";
}

double value_at(const std::vector<double>& x, const std::vector<double>& z, double at) {
  const auto right = std::lower_bound(x.begin(), x.end(), at);
  if (right == x.end() || z.empty()) return Profile::missing;
  const auto i = static_cast<std::size_t>(right - x.begin());
  if (*right == at) return z[i];
  if (i == 0) return Profile::missing;
  return z[i - 1] + (z[i] - z[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

DeepestScour deepest_scour(const Profile& initial, const Profile& now) {
  DeepestScour deepest;
  for (std::size_t i = 0; i < now.bed.size(); ++i) {
    const double depth = value_at(initial.x, initial.bed, now.x[i]) - now.bed[i];
    if (depth > deepest.depth) deepest = {depth, now.x[i]};
  }
  return deepest;
}

}  // namespace thalweg::paper
