#include "gencase/spans.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg::gencase {

Spans unite(const Spans& a, const Spans& b) {
  Spans all;
  all.reserve(a.size() + b.size());
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all),
             [](const Span& s, const Span& t) { return s.low < t.low; });
  Spans result;
  for (const Span& span : all) {
    if (!result.empty() && span.low <= result.back().high)
      result.back().high = std::max(result.back().high, span.high);
    else
      result.push_back(span);
  }
  return result;
}

Spans intersect(const Spans& a, const Spans& b) {
  Spans result;
  for (auto s = a.begin(), t = b.begin(); s != a.end() && t != b.end(); s->high < t->high ? ++s : ++t) {
    const Span common{std::max(s->low, t->low), std::min(s->high, t->high)};
    if (common.low <= common.high) result.push_back(common);
  }
  return result;
}

Spans subtract(const Spans& a, const Spans& b) {
  Spans result;
  for (const Span& span : a) {
    double low = span.low;
    bool rest = true;
    for (const Span& hole : b) {
      if (hole.high < low) continue;
      if (hole.low > span.high) break;
      // The ends of a hole belong to the hole, so the rest ends just before it.
      if (hole.low > low) result.push_back({low, std::nextafter(hole.low, -HUGE_VAL)});
      low = std::nextafter(hole.high, HUGE_VAL);
      rest = low <= span.high;
      if (!rest) break;
    }
    if (rest) result.push_back({low, span.high});
  }
  return result;
}

std::int64_t first_node_from(const Line& line, double at) {
  const double guess = std::ceil((at - line.first) / line.step);
  auto node = static_cast<std::int64_t>(std::clamp(guess, 0.0, static_cast<double>(line.count)));
  while (node > 0 && line.along(node - 1) >= at) --node;
  while (node < line.count && line.along(node) < at) ++node;
  return node;
}

bool covers(const Spans& spans, double at) {
  return std::any_of(spans.begin(), spans.end(), [at](const Span& span) { return at >= span.low && at <= span.high; });
}

}  // namespace thalweg::gencase
