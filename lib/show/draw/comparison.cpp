#include "draw/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "draw/figures.hpp"
#include "draw/picture.hpp"

namespace quadrille::draw {

namespace {

constexpr double margin = 36, row = 20;  // pixels

/// In the coordinates of the file.
void include_face(PictureBox& box, const CadFace& face) {
  const PictureBox own = bounding_box(face);
  if (own.empty()) return;
  box.include(own.lower + face.origin);
  box.include(own.upper + face.origin);
}

/// By a fiftieth on each side, so that the frame does not touch what it shows.
PictureBox widened(const PictureBox& box) {
  const Vec2 size = box.upper - box.lower;
  const double slack = 0.02 * std::max(size.x, size.y);
  return {box.lower - Vec2{slack, slack}, box.upper + Vec2{slack, slack}};
}

/// A picture as a part of another: placed, and with identifiers of its own. Texts contain no quotation mark (svg.hpp).
std::string embedded(const std::string& svg, const std::string& prefix, double x) {
  std::string part = svg.substr(svg.find("<svg "));
  part.insert(5, fmt::format("x=\"{}\" ", svg_number(x)));
  for (const std::string& mark : {std::string(" id=\""), std::string("\"url(#")})
    for (std::size_t at = part.find(mark); at != std::string::npos; at = part.find(mark, at + 1))
      part.insert(at + mark.size(), prefix);
  return part;
}

/// The height that Picture::str wrote into the root element.
double height_of(const std::string& svg) { return std::stod(svg.substr(svg.find("height=\"") + 8)); }

/// Rows of label, A, B: the labels of both in their order, "–" where one has no such figure.
std::vector<std::array<std::string, 3>> table_rows(const std::vector<Figure>& a, const std::vector<Figure>& b) {
  std::vector<std::array<std::string, 3>> rows{{"", "A", "B"}};
  const auto row_of = [&](const std::string& label) {
    return std::find_if(rows.begin(), rows.end(), [&](const auto& known) { return known[0] == label; });
  };
  for (const Figure& figure : a) rows.push_back({figure.label, figure.value, "–"});
  for (const Figure& figure : b) {
    const auto known = row_of(figure.label);
    if (known != rows.end())
      (*known)[2] = figure.value;
    else
      rows.push_back({figure.label, "–", figure.value});
  }
  return rows;
}

template <typename Stage>
std::vector<Figure> all_figures(const Stage& stage) {
  std::vector<Figure> figures = figures_of(stage);
  for (const Figure& figure : quality_figures_of(stage)) figures.push_back(figure);
  return figures;
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& weight, const std::string& text) {
  return svg_element("text",
                     {{"x", svg_number(x)}, {"y", svg_number(y)}, {"text-anchor", anchor}, {"font-weight", weight}}, {},
                     xml_escaped(text)) +
         '\n';
}

std::string table(const std::vector<std::array<std::string, 3>>& rows, double top) {
  constexpr double a = 270, b = 380;
  std::string out =
      "<g id=\"table\" font-family=\"Helvetica,Arial,'Liberation Sans',sans-serif\" font-size=\"13\" "
      "fill=\"#26323d\">\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double y = top + row * static_cast<double>(i);
    const bool is_head = i == 0, differs = rows[i][1] != rows[i][2];
    out += text_at(margin, y, "start", "normal", rows[i][0]);
    for (int k = 1; k <= 2; ++k)
      out += text_at(k == 1 ? a : b, y, "end", is_head || differs ? "bold" : "normal", rows[i][k]);
    out += svg_element("line", {{"x1", svg_number(margin)},
                                {"x2", svg_number(b)},
                                {"y1", svg_number(y + 6)},
                                {"y2", svg_number(y + 6)},
                                {"stroke", is_head ? "#26323d" : "#dde3ea"}}) +
           '\n';
  }
  return out + "</g>\n";
}

}  // namespace

template <Comparable Stage>
std::string draw_comparison(const std::array<const Stage*, 2>& pair, const std::array<std::string, 2>& files,
                            const DrawOptions& options) {
  PictureBox box = empty_box();
  for (const Stage* stage : pair) include_face(box, stage->face);
  if (!box.empty() && !options.window) box = widened(box);
  std::array<std::string, 2> parts;
  double height = 0;
  for (int k = 0; k < 2; ++k) {
    DrawOptions own = options;
    own.width = options.width / 2;
    own.file = files[k];
    own.title_prefix = k == 0 ? "A: " : "B: ";
    if (!box.empty() && !own.window) own.window = Window{box.lower, box.upper};
    const std::string svg = draw_stage(*pair[k], own);
    height = std::max(height, height_of(svg));
    parts[k] = embedded(svg, k == 0 ? "a-" : "b-", k * own.width);
  }
  const auto rows = table_rows(all_figures(*pair[0]), all_figures(*pair[1]));
  const double top = height + row;
  const double whole = top + row * static_cast<double>(rows.size()) + 10;
  return fmt::format(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" viewBox=\"0 0 {0} {1:.0f}\">\n"
             "<title>Comparison</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
             options.width, whole) +
         parts[0] + parts[1] + table(rows, top) + "</svg>\n";
}

template std::string draw_comparison(const std::array<const SeparatrixGraph*, 2>&, const std::array<std::string, 2>&,
                                     const DrawOptions&);
template std::string draw_comparison(const std::array<const BlockLayout*, 2>&, const std::array<std::string, 2>&,
                                     const DrawOptions&);
template std::string draw_comparison(const std::array<const QuadMesh*, 2>&, const std::array<std::string, 2>&,
                                     const DrawOptions&);

}  // namespace quadrille::draw
