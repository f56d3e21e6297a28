// The colours of lib/show/draw/palette.hpp for the page's script.

#include <fmt/format.h>

#include "draw/palette.hpp"
#include "page/page_data.hpp"

namespace quadrille::page {

namespace {

/// [[position, colour], ...].
std::string ramp_json(const draw::Ramp& ramp) {
  std::vector<std::string> stops;
  for (const draw::ColourStop& stop : ramp)
    stops.push_back(json_list({fmt::format("{:.4g}", stop.position), script_string(stop.colour)}));
  return json_list(stops);
}

std::string palette_json(draw::Paper paper) {
  const draw::Palette& colours = draw::palette(paper);
  JsonObject object;
  object.json("quality", ramp_json(colours.quality)).json("amount", ramp_json(colours.amount));
  object.json("angle", ramp_json(draw::cross_angle_ramp(paper)));
  object.text("calm", draw::cross_angle_colour(paper, 0, 0));
  object.json("blocks", json_texts(colours.blocks)).json("lines", json_texts(colours.lines));
  object.json("contours", json_texts({colours.u_contour, colours.v_contour}));
  object.text("interface", colours.interface);
  return object.text("few", colours.few).text("many", colours.many).text("other", colours.other).str();
}

}  // namespace

std::string palettes_json() {
  JsonObject object;
  object.json("light", palette_json(draw::Paper::light));
  return object.json("dark", palette_json(draw::Paper::dark)).str();
}

}  // namespace quadrille::page
