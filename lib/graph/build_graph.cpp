#include "graph/build_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::graph {
namespace {

struct OnLine {
  double t = 0;
  int node = 0;
};

class Builder {
 public:
  Builder(const CadFace& face, std::vector<FinishedLine>& lines, double snap)
      : face_(face), lines_(lines), snap_(snap), ends_(lines.size()), on_line_(lines.size()) {
    graph.face = face;
  }

  void add_fixed(const std::vector<FixedNode>& fixed) {
    for (const FixedNode& n : fixed) {
      const int curve = n.joint >= 0 ? n.joint : n.curve;
      const double t = n.joint >= 0 ? face_.curves[n.joint].begin() : n.t;
      graph.nodes.push_back({n.position, n.kind, n.valence, curve, t});
    }
    num_fixed_ = graph.nodes.size();
  }

  void add_line_ends() {
    struct End {
      LineEnd at;
      int line, which;
    };
    std::vector<End> on_boundary;
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i)
      for (const int which : {0, 1}) {
        LineEnd end = which == 0 ? lines_[i].start : lines_[i].end;
        ends_[i][which] = -1;
        if (end.is_on_line()) continue;
        if (end.node < 0) snap_to_fixed(end);
        if (end.node < 0) snap_to_joint(end);
        if (end.node >= 0)
          ends_[i][which] = end.node;
        else
          on_boundary.push_back({end, i, which});
      }
    std::stable_sort(on_boundary.begin(), on_boundary.end(), [](const End& a, const End& b) {
      return a.at.curve != b.at.curve ? a.at.curve < b.at.curve : a.at.t < b.at.t;
    });
    for (const End& end : on_boundary)
      ends_[end.line][end.which] = boundary_node(end.at, lines_[end.line].kind == "cut");
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i)
      for (const int which : {0, 1})
        if (ends_[i][which] >= 0) put_end(i, which, ends_[i][which]);
  }

  void add_crossing(const Crossing& c) {
    const int end_a = end_near(c.a, c.position), end_b = end_near(c.b, c.position);
    if (end_a >= 0 && end_a == end_b) return;
    if (end_a >= 0 || end_b >= 0) {
      const Vec2 place = c.position + face_.origin;
      throw ComputeError(
          fmt::format("a separatrix passes through the end of another at ({:.6g}, {:.6g})", place.x, place.y));
    }
    int node = crossing_near(c.a, c.position);
    if (node < 0) node = crossing_near(c.b, c.position);
    if (node < 0) {
      node = static_cast<int>(graph.nodes.size());
      graph.nodes.push_back({c.position, NodeKind::crossing, 4, -1, 0});
    }
    for (const auto& [line, t] : {std::pair{c.a, c.s}, std::pair{c.b, c.t}}) {
      const int which = open_end(line, t);
      which >= 0 ? put_end(line, which, node) : put_on_line(line, t, node, c.a == c.b);
    }
  }

  // Where one line ends on the side of another.
  void add_t_junctions() {
    std::vector<int> degree(graph.nodes.size(), 0);
    for (const GraphArc& arc : graph.arcs) ++degree[arc.from], ++degree[arc.to];
    for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n)
      if (graph.nodes[n].kind == NodeKind::crossing && degree[n] == 3) graph.t_junctions.push_back(n);
  }

  void add_line_arcs() {
    for (size_t i = 0; i < lines_.size(); ++i) {
      const int curve = face_.num_curves() + static_cast<int>(i);
      std::vector<OnLine>& on = on_line_[i];
      std::stable_sort(on.begin(), on.end(), [](const OnLine& a, const OnLine& b) { return a.t < b.t; });
      SeparatrixLine line{ends_[i][0], ends_[i][1], lines_[i].kind, {}};
      for (size_t k = 0; k + 1 < on.size(); ++k) {
        line.arcs.push_back(static_cast<int>(graph.arcs.size()));
        graph.arcs.push_back({on[k].node, on[k + 1].node, false, 0, {{curve, on[k].t, on[k + 1].t}}});
      }
      graph.lines.push_back(std::move(line));
      graph.splines.push_back(std::move(lines_[i].spline));
    }
  }

  void add_boundary_arcs() {
    for (int loop = 0; loop < face_.num_loops(); ++loop) {
      std::vector<int> nodes;
      for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n)
        if (graph.nodes[n].curve >= 0 && face_.loop_of(graph.nodes[n].curve) == loop) nodes.push_back(n);
      if (nodes.empty()) nodes.push_back(node_at_start_of(loop));
      std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) {
        const GraphNode &p = graph.nodes[a], &q = graph.nodes[b];
        return p.curve != q.curve ? p.curve < q.curve : p.t < q.t;
      });
      for (size_t k = 0; k < nodes.size(); ++k) add_boundary_arc(nodes[k], nodes[(k + 1) % nodes.size()]);
    }
  }

  SeparatrixGraph graph;

 private:
  void snap_to_fixed(LineEnd& end) const {
    const Vec2 x = curve::point(face_.curves[end.curve], end.t);
    for (size_t n = 0; n < num_fixed_; ++n)
      if (graph.nodes[n].curve >= 0 && distance(x, graph.nodes[n].position) <= snap_) end.node = static_cast<int>(n);
  }

  void snap_to_joint(LineEnd& end) const {
    const Vec2 x = curve::point(face_.curves[end.curve], end.t);
    const int next = face_.next_in_loop(end.curve);
    for (const int joint : {end.curve, next}) {
      if (distance(x, face_.joints[joint].position) > snap_) continue;
      // A closed curve has the same joint at both ends; either way it is the start of `joint`.
      end.curve = joint;
      end.t = face_.curves[joint].begin();
      return;
    }
  }

  int boundary_node(const LineEnd& end, bool is_cut) {
    const Vec2 x = curve::point(face_.curves[end.curve], end.t);
    if (graph.nodes.size() > num_fixed_) {
      const GraphNode& last = graph.nodes.back();
      if (last.curve == end.curve && distance(last.position, x) <= snap_)
        return static_cast<int>(graph.nodes.size()) - 1;
    }
    graph.nodes.push_back({x, is_cut ? NodeKind::cut : NodeKind::boundary, 2, end.curve, end.t});
    return static_cast<int>(graph.nodes.size()) - 1;
  }

  int node_at_start_of(int loop) {
    const int joint = face_.loop_offsets[loop];
    graph.nodes.push_back({face_.joints[joint].position, NodeKind::boundary, 2, joint, face_.curves[joint].begin()});
    return static_cast<int>(graph.nodes.size()) - 1;
  }

  void put_end(int line, int which, int node) {
    Nurbs& spline = lines_[line].spline;
    ends_[line][which] = node;
    (which == 0 ? spline.poles.front() : spline.poles.back()) = graph.nodes[node].position;
    on_line_[line].push_back({which == 0 ? spline.begin() : spline.end(), node});
  }

  // The end of a line that waits for a crossing at parameter t, or -1.
  int open_end(int line, double t) const {
    const Nurbs& spline = lines_[line].spline;
    if (ends_[line][0] < 0 && t <= spline.begin()) return 0;
    if (ends_[line][1] < 0 && t >= spline.end()) return 1;
    return -1;
  }

  int end_near(int line, Vec2 x) const {
    for (const int which : {0, 1})
      if (ends_[line][which] >= 0 && distance(graph.nodes[ends_[line][which]].position, x) <= 2 * snap_)
        return ends_[line][which];
    return -1;
  }

  int crossing_near(int line, Vec2 x) const {
    for (const OnLine& on : on_line_[line])
      if (distance(graph.nodes[on.node].position, x) <= snap_) return on.node;
    return -1;
  }

  // A line that crosses itself passes the node twice; any other passes a node once.
  void put_on_line(int line, double t, int node, bool crosses_itself) {
    if (!crosses_itself)
      for (const OnLine& on : on_line_[line])
        if (on.node == node) return;
    on_line_[line].push_back({t, node});
  }

  void add_boundary_arc(int from, int to) {
    const GraphNode &a = graph.nodes[from], &b = graph.nodes[to];
    GraphArc arc{from, to, true, 0, {}};
    int curve = a.curve;
    double t = a.t;
    while (!(curve == b.curve && (t < b.t || !arc.pieces.empty()))) {
      arc.pieces.push_back({curve, t, face_.curves[curve].end()});
      curve = face_.next_in_loop(curve);
      t = face_.curves[curve].begin();
    }
    if (t < b.t) arc.pieces.push_back({curve, t, b.t});
    graph.arcs.push_back(std::move(arc));
  }

  const CadFace& face_;
  std::vector<FinishedLine>& lines_;
  double snap_;
  size_t num_fixed_ = 0;
  std::vector<std::array<int, 2>> ends_;
  std::vector<std::vector<OnLine>> on_line_;
};

}  // namespace

SeparatrixGraph build_graph(const CadFace& face, const std::vector<FixedNode>& fixed, std::vector<FinishedLine> lines,
                            const std::vector<Crossing>& crossings, double snap) {
  Builder builder(face, lines, snap);
  builder.add_fixed(fixed);
  builder.add_line_ends();
  for (const Crossing& c : crossings) builder.add_crossing(c);
  builder.add_boundary_arcs();
  builder.add_line_arcs();
  builder.add_t_junctions();
  return std::move(builder.graph);
}

}  // namespace quadrille::graph
