#include "refine/anchored_segments.hpp"

#include <algorithm>

namespace quadrille::refine {

void require_anchor(AnchoredSegments& anchored, int anchor) {
  std::vector<int>& required = anchored.required;
  const auto at = std::lower_bound(required.begin(), required.end(), anchor) - required.begin();
  if (at < std::ssize(required) && required[at] == anchor) return;
  required.insert(required.begin() + at, anchor);
  sizing::Segments& segments = anchored.segments;
  segments.ends.insert(segments.ends.begin() + at + 1, anchored.anchors[anchor].u);
  segments.least_counts[at] = 1;
  segments.least_counts.insert(segments.least_counts.begin() + at + 1, 1);
}

void move_breaks(AnchoredSegments& anchored, const std::function<double(const Break&)>& position) {
  for (Anchor& anchor : anchored.anchors) {
    anchor.u = 0;
    for (Break& b : anchor.breaks) {
      b.u = position(b);
      anchor.u += b.u / static_cast<double>(anchor.breaks.size());
    }
  }
  for (std::size_t s = 0; s < anchored.required.size(); ++s)
    anchored.segments.ends[s + 1] = anchored.anchors[anchored.required[s]].u;
}

}  // namespace quadrille::refine
