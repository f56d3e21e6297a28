#pragma once
// What a page shows of one stage: a tab with layers. Private to page; one .cpp for each kind of stage.

#include <string>
#include <vector>

#include "draw/figures.hpp"
#include "model/stage_formats.hpp"
#include "page/page_data.hpp"

namespace quadrille::page {

struct Sheet {
  std::string title, caption;
  std::vector<draw::Figure> facts;
  std::vector<JsonObject> layers;  ///< drawn in this order
  std::string space;               ///< of a mesh in space: JSON of page/space_data; else empty
  bool is_only_in_space = false;   ///< without a drawing in the plane beside it
};

/// The tab of a struct of StageModel.
Sheet stage_sheet(const ChartedFace& charted, const PageFrame& frame);
Sheet stage_sheet(const TriMesh& mesh, const PageFrame& frame);
Sheet stage_sheet(const Field& field, const PageFrame& frame);
Sheet stage_sheet(const CriticalPoints& points, const PageFrame& frame);
Sheet stage_sheet(const SeparatrixGraph& graph, const PageFrame& frame);
Sheet stage_sheet(const BlockLayout& layout, const PageFrame& frame);
Sheet stage_sheet(const QuadMesh& mesh, const PageFrame& frame);
Sheet stage_sheet(const HexMesh& mesh, const PageFrame& frame);

/// The boundary of the face with the names of its curves, in every tab.
JsonObject boundary_layer(const CadFace& face, const PageFrame& frame);

/// A figure of each item of a layer. `worst` is "low", "high" or empty. The ramp runs from `low` to `high`, from bad to
/// good; if they are equal, nothing is known to be bad, and it runs over the values, from less to more.
struct Quantity {
  std::string title, worst;
  double low = 0, high = 0;
  std::vector<double> values;
  bool is_logarithmic = false;
};
/// Of lower bounds of det J, which are lengths squared: only those that prove nothing are bad.
Quantity bounds_of_jacobian(const std::vector<double>& bounds);
std::string quantities_json(const std::vector<Quantity>& quantities);

/// Marks at nodes: shape and colour by valence, `kind` "node", "corner", "boundary", "dot" or "hollow".
struct Marks {
  std::vector<std::int32_t> positions;
  std::vector<std::int32_t> valences;
  std::vector<std::string> kinds, texts;
  void add(const PageFrame& frame, Vec2 x, int valence, const std::string& kind, const std::string& text);
  JsonObject layer(const std::string& key, const std::string& title, bool is_shown = true) const;
};
/// The nodes of a graph: irregular ones and corners; with `crossings` also where lines cross and end.
Marks marks_of(const ArcGraph& graph, const PageFrame& frame, bool with_crossings);

/// The triangles as cells. `is_shown`: at first.
JsonObject triangle_layer(const TriMesh& mesh, const std::vector<Quantity>& quantities, bool is_shown,
                          const PageFrame& frame);

}  // namespace quadrille::page
