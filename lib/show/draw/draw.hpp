#pragma once
// One SVG picture per stage file, all with the same line styles (one .cpp per stage over svg.hpp).

#include <optional>
#include <string>

#include "base/vec2.hpp"
#include "base/vec3.hpp"
#include "model/stage_formats.hpp"

namespace quadrille::draw {

/// Boundary curves with a label: those with a given name, all of them (with their numbers), or none.
enum class CurveLabels { given, all, none };

/// The part of the plane that a picture shows, in the coordinates of the file; lower < upper.
struct Window {
  Vec2 lower, upper;
};

/// Towards the viewer; none: isometric, on the side of the face's normal.
using ViewDirection = std::optional<Vec3>;

struct DrawOptions {
  int width = 1000;                               ///< pixels
  CurveLabels curve_labels = CurveLabels::given;  ///< where the face is known
  std::string show = "psi";                       ///< of a field: "u", "v", "psi" or "order"
  std::optional<Window> window;                   ///< none: everything
  /// Of a mesh of a curved face: seen in space from there; without it, seen isometrically, beside the chart. Of
  /// hexahedra: where their outer faces are seen from.
  std::optional<ViewDirection> view;
  std::string file;          ///< name of the file without folders, written beside the title; empty: none
  std::string title_prefix;  ///< "A: " in a comparison
  bool is_bare = false;      ///< the drawing alone, without title, texts and legend
  /// Drawn under critical points. Without it, the outline of the face, if the points have it, is all that is drawn of
  /// the rest.
  const Field* field = nullptr;
};

/// The picture of a struct of StageModel.
std::string draw_stage(const ChartedFace& charted, const DrawOptions& options);
std::string draw_stage(const TriMesh& mesh, const DrawOptions& options);
std::string draw_stage(const Field& field, const DrawOptions& options);
std::string draw_stage(const CriticalPoints& points, const DrawOptions& options);
std::string draw_stage(const SeparatrixGraph& graph, const DrawOptions& options);
std::string draw_stage(const BlockLayout& layout, const DrawOptions& options);
std::string draw_stage(const QuadMesh& mesh, const DrawOptions& options);
std::string draw_stage(const HexMesh& mesh, const DrawOptions& options);

}  // namespace quadrille::draw
