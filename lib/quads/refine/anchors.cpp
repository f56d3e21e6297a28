#include "refine/anchors.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace quadrille::refine {
namespace {

bool has_two_of_one_arc(const std::vector<Break>& breaks) {
  std::set<int> arcs;
  return std::any_of(breaks.begin(), breaks.end(), [&](const Break& b) { return !arcs.insert(b.arc).second; });
}

Anchor anchor_of(std::vector<Break> breaks) {
  double sum = 0;
  for (const Break& b : breaks) sum += b.u;
  return {sum / static_cast<double>(breaks.size()), std::move(breaks)};
}

}  // namespace

std::vector<Anchor> find_anchors(std::vector<Break> breaks, double reach) {
  std::sort(breaks.begin(), breaks.end(),
            [](const Break& a, const Break& b) { return std::tie(a.u, a.arc) < std::tie(b.u, b.arc); });
  std::vector<Anchor> anchors;
  for (std::size_t first = 0, last = 0; first < breaks.size(); first = last) {
    for (last = first + 1; last < breaks.size() && breaks[last].u - breaks[last - 1].u < reach;) ++last;
    std::vector<Break> group(breaks.begin() + first, breaks.begin() + last);
    if (!has_two_of_one_arc(group)) {
      anchors.push_back(anchor_of(std::move(group)));
    } else {
      const std::vector<Anchor> parts = find_anchors(std::move(group), reach / 2);
      anchors.insert(anchors.end(), parts.begin(), parts.end());
    }
  }
  return anchors;
}

}  // namespace quadrille::refine
