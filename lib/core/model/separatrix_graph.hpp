#pragma once
// The planar graph of separatrices and boundary (formats/separatrix-graph.md, x.sep.json).

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "model/arc_graph.hpp"
#include "model/provenance.hpp"

namespace quadrille {

enum class LineKind {
  traced,   ///< integrated through the field
  merged,   ///< two separatrices merged into one, or a blend of two
  cut,      ///< an auxiliary line from the boundary
  extended  ///< continued along integer iso-lines of a T-mesh
};

constexpr auto enum_names(LineKind) { return std::to_array({"traced", "merged", "cut", "extended"}); }

/// The history of a separatrix, for people and pictures: origin and end node, and its arcs from one to the other.
struct SeparatrixLine {
  int origin = -1;
  int end = -1;
  LineKind kind = LineKind::traced;
  std::vector<int> arcs;
};

/// The number of faces of the graph with so many corners: quarter turns of the cross, not degrees in space. A
/// degenerate corner counts twice.
struct FaceCount {
  int corners = 4;
  int faces = 0;
};

enum class LayoutMethod {
  traced,     ///< separatrices are traced to their ends
  quantized,  ///< they stop at each other and are continued by an integer program
  t_mesh,     ///< they stop at each other, with T-junctions
  midpoint    ///< without separatrices: triangles, each divided into three blocks
};

constexpr auto enum_names(LayoutMethod) { return std::to_array({"traced", "quantized", "t-mesh", "midpoint"}); }

/// Counts of a graph and the method that made it.
struct LayoutCertificate {
  std::optional<LayoutMethod> method;             ///< std::nullopt: the graph has no certificate
  std::string reason;                             ///< for people: why "traced" failed at first; else empty
  int index_sum = 0;                              ///< sum (4 - V) over inner and sum (2 - V) over boundary nodes: 4 chi
  std::vector<FaceCount> face_valence_histogram;  ///< by ascending number of corners
  int t_junctions = 0;                            ///< 0: conforming
  int merged_lines = 0;                           ///< pairs of separatrices merged into one
  int collapsed_chords = 0;                       ///< thin chords of blocks that were collapsed
  int shortened_spirals = 0;             ///< lines that end at a node which they pass, instead of one turn later
  double largest_deviation_degrees = 0;  ///< largest angle between a line and the field
};

struct SeparatrixGraph : ArcGraph {
  Provenance provenance;
  std::vector<SeparatrixLine> lines;
  std::vector<int> t_junctions;  ///< nodes where an arc ends on the side of a block; empty for a conforming layout
  LayoutCertificate certificate;
};

}  // namespace quadrille
