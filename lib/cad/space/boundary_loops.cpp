#include "space/boundary_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/vec3.hpp"
#include "space/space_curve.hpp"

namespace quadrille::space {

namespace {

using Side = std::pair<int, int>;  // of a triangle: its vertices, with the triangle on the left

constexpr const char* remedy = "repair the face in the CAD program, or cut it there";

[[noreturn]] void refuse(const RawSpaceFace& raw, const std::string& fault, int vertex) {
  throw FormatError(
      fmt::format("{}: {} at {}: {}", raw.labels.file, fault, position_text(raw.vertices[vertex]), remedy));
}

std::set<Side> sides_of(const RawSpaceFace& raw) {
  std::set<Side> sides;
  for (const auto& t : raw.triangles)
    for (int k = 0; k < 3; ++k)
      if (!sides.insert({t[k], t[(k + 1) % 3]}).second)
        refuse(raw, "the CAD kernel's triangles of the face overlap", t[k]);
  return sides;
}

/// The vertex that follows each vertex of the boundary.
std::map<int, int> boundary_of(const RawSpaceFace& raw, const std::set<Side>& sides) {
  std::map<int, int> next;
  for (const auto& [a, b] : sides)
    if (!sides.contains({b, a}) && !next.emplace(a, b).second)
      refuse(raw, "the boundary of the face touches itself", a);
  if (next.empty())
    throw FormatError(raw.labels.file +
                      ": the face is closed, without a boundary, like a whole sphere or torus: cut it into faces with "
                      "a boundary in the CAD program, such as halves");
  return next;
}

/// The segment of a polygon with these ends, and its direction.
struct Segment {
  int polygon = 0, index = 0;
  bool is_reversed = false;
};

std::map<Side, Segment> segments_of(const RawSpaceFace& raw) {
  std::map<Side, Segment> segments;
  for (int p = 0; p < static_cast<int>(raw.polygons.size()); ++p) {
    const std::vector<int>& v = raw.polygons[p].vertices;
    for (int i = 0; i + 1 < static_cast<int>(v.size()); ++i) {
      segments.emplace(Side{v[i], v[i + 1]}, Segment{p, i, false});
      segments.emplace(Side{v[i + 1], v[i]}, Segment{p, i, true});
    }
  }
  return segments;
}

/// Follows the boundary, loop after loop.
class LoopTracer {
 public:
  explicit LoopTracer(const RawSpaceFace& raw) : raw_(raw), next_(boundary_of(raw, sides_of(raw))) {}

  std::vector<std::vector<LoopEdge>> loops() {
    segments_ = segments_of(raw_);
    std::vector<std::vector<LoopEdge>> found;
    while (!next_.empty()) found.push_back(edges_of(traced_from(next_.begin()->first)));
    return found;
  }

 private:
  std::vector<Segment> traced_from(int first) {
    std::vector<Segment> loop;
    for (int a = first; next_.contains(a);) {
      const int b = next_.at(a);
      const auto found = segments_.find({a, b});
      if (found == segments_.end()) refuse(raw_, "the CAD kernel's triangles of the face end beside its edges", a);
      loop.push_back(found->second);
      next_.erase(a);
      a = b;
    }
    return loop;
  }

  int num_segments(int polygon) const { return static_cast<int>(raw_.polygons[polygon].vertices.size()) - 1; }
  int cad_edge(const LoopEdge& e) const { return raw_.cad_edge(raw_.polygons[e.polygon].edge); }

  /// Each edge appears once, with all of its segments, from that at its start on.
  std::vector<LoopEdge> edges_of(const std::vector<Segment>& loop) const {
    const std::size_t n = loop.size();
    std::vector<LoopEdge> edges;
    std::size_t num_seen = 0;
    for (const Segment& s : loop) {
      if (s.index != (s.is_reversed ? num_segments(s.polygon) - 1 : 0)) continue;
      edges.push_back({s.polygon, s.is_reversed});
      num_seen += num_segments(s.polygon);
    }
    if (num_seen != n) {
      const Segment& s = loop.front();
      const EdgePolygon& polygon = raw_.polygons[s.polygon];
      refuse(raw_, fmt::format("edge {} lies only partly on the boundary of the face", raw_.cad_edge(polygon.edge)),
             polygon.vertices[s.index]);
    }
    const auto first = std::min_element(
        edges.begin(), edges.end(), [&](const LoopEdge& a, const LoopEdge& b) { return cad_edge(a) < cad_edge(b); });
    std::rotate(edges.begin(), first, edges.end());
    return edges;
  }

  const RawSpaceFace& raw_;
  std::map<int, int> next_;
  std::map<Side, Segment> segments_;
};

double length_of(const RawSpaceFace& raw, const std::vector<LoopEdge>& loop) {
  double length = 0;
  for (const LoopEdge& e : loop) {
    const std::vector<int>& v = raw.polygons[e.polygon].vertices;
    for (std::size_t i = 1; i < v.size(); ++i) length += distance(raw.vertices[v[i - 1]], raw.vertices[v[i]]);
  }
  return length;
}

/// V - E + F of a connected surface in the plane is 2 less the number of its loops.
void require_planar_topology(const RawSpaceFace& raw, std::size_t num_loops) {
  DisjointSets parts(raw.vertices.size());
  std::set<int> used;
  for (const auto& t : raw.triangles) {
    parts.unite(t[0], t[1]), parts.unite(t[0], t[2]);
    used.insert(t.begin(), t.end());
  }
  for (const int v : used)
    if (parts.find(v) != parts.find(*used.begin())) refuse(raw, "the face has separate parts, one", v);
  std::set<Side> edges;
  for (const auto& t : raw.triangles)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  const auto characteristic = static_cast<long>(used.size() + raw.triangles.size()) - static_cast<long>(edges.size());
  if (characteristic != 2 - static_cast<long>(num_loops))
    throw FormatError(raw.labels.file +
                      ": the face goes round a handle, like a torus with a hole, and has no image in the plane: cut "
                      "it into faces without handles in the CAD program");
}

}  // namespace

std::vector<std::vector<LoopEdge>> boundary_loops(const RawSpaceFace& raw) {
  if (raw.triangles.empty())
    throw FormatError(fmt::format("{}: the CAD kernel finds no triangles of the face: {}", raw.labels.file,
                                  "repair it in the CAD program, or cut it into simpler faces"));
  std::vector<std::vector<LoopEdge>> loops = LoopTracer(raw).loops();
  require_planar_topology(raw, loops.size());
  const auto edge_of = [&](const std::vector<LoopEdge>& loop) {
    return raw.cad_edge(raw.polygons[loop.front().polygon].edge);
  };
  std::sort(loops.begin(), loops.end(), [&](const auto& a, const auto& b) { return edge_of(a) < edge_of(b); });
  std::size_t longest = 0;
  for (std::size_t l = 1; l < loops.size(); ++l)
    if (length_of(raw, loops[l]) > (1 + 1e-6) * length_of(raw, loops[longest])) longest = l;
  const auto at = loops.begin() + static_cast<long>(longest);
  std::rotate(loops.begin(), at, at + 1);
  return loops;
}

}  // namespace quadrille::space
