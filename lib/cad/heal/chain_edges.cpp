#include "heal/chain_edges.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/position_text.hpp"

namespace quadrille::heal {
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

}  // namespace quadrille::heal
