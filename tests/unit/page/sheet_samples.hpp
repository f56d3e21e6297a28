#pragma once
// Parts of tabs of pages.

#include <string>

#include "../support/texts.hpp"
#include "page/sheet.hpp"

namespace quadrille::page {

/// Of the unit square.
inline const PageFrame frame = page_frame({{0, 0}, {1, 1}});

/// The JSON of the layer with this key; an empty text if the sheet has no such layer.
inline std::string layer_of(const Sheet& sheet, const std::string& key) {
  for (const JsonObject& layer : sheet.layers)
    if (count(layer.str(), "\"key\":\"" + key + '"') > 0) return layer.str();
  return "";
}

/// The numbers of a layer.
inline std::string member(const std::string& name, const std::vector<std::int32_t>& values) {
  return '"' + name + "\":\"" + packed(values) + '"';
}

}  // namespace quadrille::page
