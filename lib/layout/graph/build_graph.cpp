#include "graph/build_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "surface/positions.hpp"

namespace quadrille::graph {
namespace {

struct OnLine {
  double t = 0;
  int node = 0;
};

// A graph under construction, and its nodes on each line.
struct Building {
  const CadFace& face;
  std::vector<FinishedLine>& lines;
  double snap;
  std::size_t num_fixed = 0;
  std::vector<int> fixed_on_boundary = {};        // nodes
  std::vector<std::array<int, 2>> ends = {};      // nodes of each line, -1: determined by a crossing
  std::vector<std::vector<OnLine>> on_line = {};  // the nodes of each line
  SeparatrixGraph graph = {};
};

int add_node(Building& build, const GraphNode& node) {
  build.graph.nodes.push_back(node);
  return static_cast<int>(build.graph.nodes.size()) - 1;
}

void snap_to_fixed(const Building& build, LineEnd& end) {
  const Vec2 x = curve::point(build.face.curves[end.curve], end.t);
  for (const int n : build.fixed_on_boundary)
    if (distance(x, build.graph.nodes[n].position) <= build.snap) end.node = n;
}

void snap_to_joint(const Building& build, LineEnd& end) {
  const Vec2 x = curve::point(build.face.curves[end.curve], end.t);
  const int next = build.face.next_in_loop(end.curve);
  for (const int joint : {end.curve, next}) {
    if (distance(x, build.face.joints[joint].position) > build.snap) continue;
    // A closed curve has the same joint at both ends; either way it is the start of `joint`.
    end.curve = joint;
    end.t = build.face.curves[joint].begin();
    return;
  }
}

int boundary_node(Building& build, const LineEnd& end, bool is_cut) {
  const Vec2 x = curve::point(build.face.curves[end.curve], end.t);
  if (build.graph.nodes.size() > build.num_fixed) {
    const GraphNode& last = build.graph.nodes.back();
    if (last.curve == end.curve && distance(last.position, x) <= build.snap)
      return static_cast<int>(build.graph.nodes.size()) - 1;
  }
  return add_node(build, {x, is_cut ? NodeKind::cut : NodeKind::boundary, 2, end.curve, end.t});
}

int node_at_start_of(Building& build, int loop) {
  const int joint = build.face.loop_offsets[loop];
  return add_node(build,
                  {build.face.joints[joint].position, NodeKind::boundary, 2, joint, build.face.curves[joint].begin()});
}

void put_end(Building& build, int line, int which, int node) {
  Nurbs& spline = build.lines[line].spline;
  build.ends[line][which] = node;
  (which == 0 ? spline.poles.front() : spline.poles.back()) = build.graph.nodes[node].position;
  build.on_line[line].push_back({which == 0 ? spline.begin() : spline.end(), node});
}

// The end (0 or 1) of a line that is to be determined by a crossing at parameter t, or -1.
int open_end(const Building& build, int line, double t) {
  const Nurbs& spline = build.lines[line].spline;
  if (build.ends[line][0] < 0 && t <= spline.begin()) return 0;
  if (build.ends[line][1] < 0 && t >= spline.end()) return 1;
  return -1;
}

int end_near(const Building& build, int line, Vec2 x) {
  for (const int which : {0, 1})
    if (build.ends[line][which] >= 0 &&
        distance(build.graph.nodes[build.ends[line][which]].position, x) <= 2 * build.snap)
      return build.ends[line][which];
  return -1;
}

int crossing_near(const Building& build, int line, Vec2 x) {
  for (const OnLine& on : build.on_line[line])
    if (distance(build.graph.nodes[on.node].position, x) <= build.snap) return on.node;
  return -1;
}

// A line that crosses itself passes the node twice; any other passes a node once.
void put_on_line(Building& build, int line, double t, int node, bool crosses_itself) {
  if (!crosses_itself)
    for (const OnLine& on : build.on_line[line])
      if (on.node == node) return;
  build.on_line[line].push_back({t, node});
}

void add_fixed(Building& build, const std::vector<GraphNode>& fixed) {
  for (const GraphNode& n : fixed)
    if (const int node = add_node(build, n); n.curve >= 0) build.fixed_on_boundary.push_back(node);
  build.num_fixed = build.graph.nodes.size();
}

void add_line_ends(Building& build) {
  struct End {
    LineEnd at;
    int line, which;
  };
  std::vector<End> on_boundary;
  for (int i = 0; i < static_cast<int>(build.lines.size()); ++i)
    for (const int which : {0, 1}) {
      LineEnd end = which == 0 ? build.lines[i].start : build.lines[i].end;
      build.ends[i][which] = -1;
      if (end.is_on_line()) continue;
      if (end.node < 0) snap_to_fixed(build, end);
      if (end.node < 0) snap_to_joint(build, end);
      if (end.node >= 0)
        build.ends[i][which] = end.node;
      else
        on_boundary.push_back({end, i, which});
    }
  std::stable_sort(on_boundary.begin(), on_boundary.end(), [](const End& a, const End& b) {
    return a.at.curve != b.at.curve ? a.at.curve < b.at.curve : a.at.t < b.at.t;
  });
  for (const End& end : on_boundary)
    build.ends[end.line][end.which] = boundary_node(build, end.at, build.lines[end.line].kind == LineKind::cut);
  for (int i = 0; i < static_cast<int>(build.lines.size()); ++i)
    for (const int which : {0, 1})
      if (build.ends[i][which] >= 0) put_end(build, i, which, build.ends[i][which]);
}

void add_crossing(Building& build, const Crossing& c) {
  const int end_a = end_near(build, c.a, c.position), end_b = end_near(build, c.b, c.position);
  if (end_a >= 0 && end_a == end_b) return;
  if (end_a >= 0 || end_b >= 0) {
    throw ComputeError(fmt::format("a separatrix passes through the end of another at {}",
                                   surface::position_text(build.face, c.position)));
  }
  int node = crossing_near(build, c.a, c.position);
  if (node < 0) node = crossing_near(build, c.b, c.position);
  if (node < 0) node = add_node(build, {c.position, NodeKind::crossing, 4, -1, 0});
  for (const auto& [line, t] : {std::pair{c.a, c.s}, std::pair{c.b, c.t}}) {
    const int which = open_end(build, line, t);
    which >= 0 ? put_end(build, line, which, node) : put_on_line(build, line, t, node, c.a == c.b);
  }
}

// Where one line ends on the side of another.
void add_t_junctions(Building& build) {
  std::vector<int> degree(build.graph.nodes.size(), 0);
  for (const GraphArc& arc : build.graph.arcs) ++degree[arc.from], ++degree[arc.to];
  for (int n = 0; n < static_cast<int>(build.graph.nodes.size()); ++n)
    if (build.graph.nodes[n].kind == NodeKind::crossing && degree[n] == 3) build.graph.t_junctions.push_back(n);
}

void add_line_arcs(Building& build) {
  for (size_t i = 0; i < build.lines.size(); ++i) {
    const int curve = build.face.num_curves() + static_cast<int>(i);
    std::vector<OnLine>& on = build.on_line[i];
    std::stable_sort(on.begin(), on.end(), [](const OnLine& a, const OnLine& b) { return a.t < b.t; });
    SeparatrixLine line{build.ends[i][0], build.ends[i][1], build.lines[i].kind, {}};
    for (size_t k = 0; k + 1 < on.size(); ++k) {
      line.arcs.push_back(static_cast<int>(build.graph.arcs.size()));
      build.graph.arcs.push_back({on[k].node, on[k + 1].node, false, 0, {{curve, on[k].t, on[k + 1].t}}});
    }
    build.graph.lines.push_back(std::move(line));
    build.graph.splines.push_back(std::move(build.lines[i].spline));
  }
}

void add_boundary_arcs(Building& build) {
  std::vector<std::vector<int>> nodes_of_loop(build.face.num_loops());
  for (int n = 0; n < static_cast<int>(build.graph.nodes.size()); ++n)
    if (build.graph.nodes[n].curve >= 0) nodes_of_loop[build.face.loop_of(build.graph.nodes[n].curve)].push_back(n);
  for (int loop = 0; loop < build.face.num_loops(); ++loop) {
    std::vector<int>& nodes = nodes_of_loop[loop];
    if (nodes.empty()) nodes.push_back(node_at_start_of(build, loop));
    std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) {
      const GraphNode &p = build.graph.nodes[a], &q = build.graph.nodes[b];
      return p.curve != q.curve ? p.curve < q.curve : p.t < q.t;
    });
    for (size_t k = 0; k < nodes.size(); ++k) {
      const int from = nodes[k], to = nodes[(k + 1) % nodes.size()];
      build.graph.arcs.push_back(
          {from, to, true, 0, boundary_path(build.face, build.graph.nodes[from], build.graph.nodes[to])});
    }
  }
}

}  // namespace

SeparatrixGraph build_graph(const CadFace& face, const std::vector<GraphNode>& fixed, std::vector<FinishedLine> lines,
                            const std::vector<Crossing>& crossings, double snap) {
  Building build{face, lines, snap};
  build.ends.resize(lines.size());
  build.on_line.resize(lines.size());
  build.graph.face = face;
  add_fixed(build, fixed);
  add_line_ends(build);
  for (const Crossing& c : crossings) add_crossing(build, c);
  add_boundary_arcs(build);
  add_line_arcs(build);
  add_t_junctions(build);
  return std::move(build.graph);
}

}  // namespace quadrille::graph
