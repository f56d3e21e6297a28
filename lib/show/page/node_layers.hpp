#pragma once
// How the irregular nodes came about (formats/critical-points.md), as layers of the page: the counterpart of
// draw/node_history.hpp. Private to page.

#include <vector>

#include "model/critical_points.hpp"
#include "page/page_data.hpp"
#include "page/page_frame.hpp"

namespace quadrille::page {

/// Layers to draw below the nodes, those that are not empty: cells and discs of the search for zeros, clusters with
/// their members, error bars, arrows of changes, the directions in which separatrices start at zeros.
std::vector<JsonObject> node_layers(const CriticalPoints& points, const PageFrame& frame);

}  // namespace quadrille::page
