#include "heal/wire_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::heal {

namespace {

using Wire = std::vector<MeasuredEdge>;

// Whether edge `in` can be joined with edge `out` when the `count` edges between them are removed.
bool can_be_joined(const Wire& wire, size_t in, size_t count, const JointLimit& limit) {
  const size_t n = wire.size();
  std::vector<const RawEdge*> near;
  for (size_t k = 0; k < count + 4; ++k) near.push_back(wire[(in + n - 1 + k) % n].raw);
  const LimitedJoint joint = limit.joint(wire[in], wire[(in + count + 1) % n], near);
  return joint_target(joint.in, joint.out).has_value();
}

}  // namespace

std::vector<bool> short_edges(const Wire& wire, double length, const JointLimit& limit) {
  const size_t n = wire.size();
  std::vector<bool> removed(n, false);
  const auto is_short = [&](size_t i) { return wire[i % n].length <= length * (1 + 1e-6); };
  for (size_t in = 0; in < n; ++in) {
    if (is_short(in)) continue;
    size_t count = 0;
    double sum = 0;
    while (is_short(in + 1 + count)) sum += wire[(in + 1 + count++) % n].length;
    if (count == 0 || sum > length * (1 + 1e-6) || !can_be_joined(wire, in, count, limit)) continue;
    for (size_t k = 1; k <= count; ++k) removed[(in + k) % n] = true;
  }
  return removed;
}

namespace {

double gap(const RawEdge& in, const RawEdge& out) { return distance(in.curve.poles.back(), out.curve.poles.front()); }

// Vertices that lie off their curves still say which edges belong together.
double vertex_gap(const RawEdge& in, const RawEdge& out) { return std::min(gap(in, out), distance(in.end, out.start)); }

using Edges = std::vector<const RawEdge*>;

Edges::const_iterator successor(const RawEdge& edge, const Edges& rest, double near, double tol) {
  const auto first = std::find_if(rest.begin(), rest.end(), [&](const RawEdge* e) { return gap(edge, *e) <= near; });
  if (first != rest.end()) return first;
  const auto nearest = std::min_element(rest.begin(), rest.end(), [&](const RawEdge* a, const RawEdge* b) {
    return vertex_gap(edge, *a) < vertex_gap(edge, *b);
  });
  return vertex_gap(edge, **nearest) <= tol ? nearest : rest.end();
}

}  // namespace

Edges chain_edges(const Edges& edges, double near, double tol, const std::string& file) {
  Edges rest(edges.begin() + 1, edges.end()), chain{edges.front()};
  while (!rest.empty()) {
    const auto next = successor(*chain.back(), rest, near, tol);
    if (next == rest.end())
      throw FormatError(fmt::format("{}: the wire is open: no edge continues edge {} at {}", file,
                                    chain.back()->cad_edge, rounded_position_text(chain.back()->curve.poles.back())));
    chain.push_back(*next);
    rest.erase(next);
  }
  const RawEdge &first = *chain.front(), &last = *chain.back();
  if (!(gap(last, first) <= near) && !(vertex_gap(last, first) <= tol))
    throw FormatError(fmt::format("{}: the wire is open: it begins at {} and ends at {}", file,
                                  rounded_position_text(first.curve.poles.front()),
                                  rounded_position_text(last.curve.poles.back())));
  return chain;
}

namespace {

/// Edge e starts at the end 2 e and ends at 2 e + 1.
class LooseEnds {
 public:
  LooseEnds(std::vector<RawEdge> edges, const HealScale& scale) : edges_(std::move(edges)), scale_(scale) {
    for (const RawEdge& edge : edges_) ends_.push_back(edge.start), ends_.push_back(edge.end);
  }

  std::vector<std::vector<RawEdge>> closed() {
    match_ends();
    std::vector<std::vector<RawEdge>> wires;
    std::vector<bool> is_used(edges_.size(), false);
    for (int first = 0; first < num_ends(); first += 2) {
      if (is_used[first / 2]) continue;
      wires.emplace_back();
      for (int start = first; !is_used[start / 2]; start = other_[start ^ 1]) {
        is_used[start / 2] = true;
        wires.back().push_back(start % 2 == 0 ? edges_[start / 2] : turned_round(edges_[start / 2]));
      }
    }
    return wires;
  }

 private:
  int num_ends() const { return static_cast<int>(ends_.size()); }

  static RawEdge turned_round(RawEdge edge) {
    edge.curve = curve::reversed(edge.curve);
    std::swap(edge.start, edge.end);
    return edge;
  }

  /// The other ends within the tolerance of each end: one of each, or the curves are refused.
  void match_ends() {
    const double tol = std::max(2 * scale_.tolerance, scale_.rounding);
    std::vector<int> by_x(ends_.size());
    for (int i = 0; i < num_ends(); ++i) by_x[i] = i;
    std::stable_sort(by_x.begin(), by_x.end(), [&](int a, int b) { return ends_[a].x < ends_[b].x; });
    std::vector<std::vector<int>> near(ends_.size());
    for (size_t m = 0; m < by_x.size(); ++m)
      for (size_t n = m + 1; n < by_x.size() && ends_[by_x[n]].x <= ends_[by_x[m]].x + tol; ++n)
        if (distance(ends_[by_x[m]], ends_[by_x[n]]) <= tol)
          near[by_x[m]].push_back(by_x[n]), near[by_x[n]].push_back(by_x[m]);
    refuse_branches(near);
    refuse_gaps(near);
    for (const std::vector<int>& others : near) other_.push_back(others.front());
  }

  void refuse_branches(const std::vector<std::vector<int>>& near) const {
    for (int i = 0; i < num_ends(); ++i)
      if (near[i].size() > 1)
        throw FormatError(
            fmt::format("{}: the file holds no face, and its curves bound none: {} end at {}, such as edges {} and {}: "
                        "remove those "
                        "that are no boundary, or draw a face",
                        scale_.file, counted(near[i].size() + 1, "curve"), rounded_position_text(ends_[i]),
                        edges_[i / 2].cad_edge, edges_[near[i].front() / 2].cad_edge));
  }

  /// Names the narrowest gap: it is the one that is likely to be meant to be closed.
  void refuse_gaps(const std::vector<std::vector<int>>& near) const {
    std::vector<int> loose;
    for (int i = 0; i < num_ends(); ++i)
      if (near[i].empty()) loose.push_back(i);
    double least = std::numeric_limits<double>::infinity();
    int at = -1, other = -1;
    for (size_t m = 0; m < loose.size(); ++m)
      for (size_t n = m + 1; n < loose.size(); ++n)
        if (const double gap = distance(ends_[loose[m]], ends_[loose[n]]); gap < least)
          least = gap, at = loose[m], other = loose[n];
    if (at >= 0)
      throw FormatError(fmt::format(
          "{}: the file holds no face, and its curves leave {}: edge {} ends at {}, {:.3g} from edge {} at {}{}",
          scale_.file, counted((loose.size() + 1) / 2, "gap"), edges_[at / 2].cad_edge,
          rounded_position_text(ends_[at]), least, edges_[other / 2].cad_edge, rounded_position_text(ends_[other]),
          remedy(scale_, least)));
  }

  std::vector<RawEdge> edges_;
  const HealScale& scale_;
  std::vector<Vec2> ends_;
  std::vector<int> other_;  ///< the end that each end meets
};

}  // namespace

void close_wires(RawFace& raw, const HealScale& scale) {
  std::vector<RawEdge> edges;
  for (auto& wire : raw.wires) std::move(wire.begin(), wire.end(), std::back_inserter(edges));
  raw.wires = LooseEnds(std::move(edges), scale).closed();
}

}  // namespace quadrille::heal
