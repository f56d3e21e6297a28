#include "draw/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/nurbs.hpp"
#include "draw/palette.hpp"

namespace quadrille::draw {

namespace {

/// Pixels.
constexpr double picture_margin = 36, header_height = 76, legend_row = 34, title_size = 17, caption_size = 13,
                 caption_row = 18;

/// The common line styles: the boundary thick, blocks medium, elements thin.
const char* const line_styles = R"(
svg{font-family:Helvetica,Arial,"Liberation Sans",sans-serif;fill:#26323d}
path,line,circle,polygon{stroke-linejoin:round;stroke-linecap:round;vector-effect:non-scaling-stroke}
.title{font-size:17px;font-weight:bold}
.caption{font-size:13px;fill:#66727d}
.legend{font-size:12px}
.tick{font-size:11px;fill:#66727d}
.file{font-size:13px;fill:#66727d;text-anchor:end}
.frame{fill:none;stroke:#66727d;stroke-width:1}
.scale{fill:none;stroke:#26323d;stroke-width:1.4}
.face{fill:#f6f5f1;stroke:none;fill-rule:evenodd}
.boundary{fill:none;stroke:#1d2731;stroke-width:2.6}
.line{fill:none;stroke-width:1.8}
.elems path,.elems polygon{stroke:#5b6f82;stroke-width:.6}
.cells path{stroke-width:.8}
.cross{fill:none;stroke:#3b4a57;stroke-width:1}
.prescribed{fill:none;stroke:#b3261e;stroke-width:2}
.quiet{opacity:.4}
.jump{fill:none;stroke:#b03a2e;stroke-width:1.6;stroke-dasharray:6 4}
.edge{fill:none;stroke:#44535f;stroke-width:1.5}
.ring{fill:none;stroke:#1d2731;stroke-width:1.6}
.worst{fill:none;stroke:#b3261e;stroke-width:3.2}
.corner{fill:#1d2731;stroke:#fff;stroke-width:1}
.dot{fill:#fff;stroke:#44535f;stroke-width:1.2}
.cell-zero{fill:none;stroke:#7d8b98;stroke-width:.8}
.cell-open{fill:#f0b64e;fill-opacity:.35;stroke:#c27a12;stroke-width:.8}
.disc{fill:none;stroke:#7d8b98;stroke-width:1;stroke-dasharray:1.5 3}
.cluster{fill:none;stroke:#7b4ea3;stroke-width:1.5;stroke-dasharray:5 3.5}
.member{fill:#7b4ea3;stroke:none}
.change{fill:none;stroke:#0b7d68;stroke-width:1.3}
.head{fill:#0b7d68;stroke:none}
.ghost{fill:#fff;fill-opacity:.75;stroke:#0b7d68;stroke-width:1.2}
.taker{fill:none;stroke:#0b7d68;stroke-width:2}
.error{fill:#1d2731;fill-opacity:.06;stroke:#1d2731;stroke-width:1}
.inner{font-size:10px;font-weight:bold;text-anchor:middle;fill:#fff}
.label{font-size:13px;text-anchor:middle;stroke:#fff;stroke-width:3px;stroke-opacity:.8;paint-order:stroke}
.name{font-size:13px;font-style:italic;text-anchor:middle;stroke:#fff;stroke-width:3px;stroke-opacity:.8;paint-order:stroke}
.region{font-size:13px;font-weight:bold;text-anchor:middle;stroke:#fff;stroke-width:3px;stroke-opacity:.8;paint-order:stroke}
.small{font-size:10px;text-anchor:middle}
path:hover,polygon:hover,circle:hover{filter:brightness(.9)}
)";

/// The line styles with the colours of nodes and contours.
std::string style_sheet() {
  const Palette& colours = palette(Paper::light);
  std::string text = line_styles;
  for (const auto& [name, colour] : {std::pair{"v3", colours.few}, {"v5", colours.many}, {"vx", colours.other}})
    text += fmt::format(".{}{{fill:{};stroke:#fff;stroke-width:1.2}}\n", name, colour);
  for (const auto& [name, colour] : {std::pair{"zero-u", colours.u_contour}, {"zero-v", colours.v_contour}})
    text += fmt::format(".{}{{fill:none;stroke:{};stroke-width:1.6}}\n", name, colour);
  text += fmt::format(".interface,.slit{{fill:none;stroke:{};stroke-width:2.4}}\n", colours.interface);
  text += ".slit{stroke-dasharray:9 4}\n";
  return text;
}

std::string text_element(const std::string& css_class, double x, double y, const std::string& content) {
  return svg_element("text", {{"class", css_class}, {"x", svg_number(x)}, {"y", svg_number(y)}}, {},
                     xml_escaped(content));
}

/// The markup clipped to the rectangle from (0, 0) to `size`, with a thin frame.
std::string in_frame(const std::string& markup, Vec2 size) {
  const Attributes corners{{"width", svg_number(size.x)}, {"height", svg_number(size.y)}};
  Attributes frame = corners;
  frame.insert(frame.begin(), {"class", "frame"});
  return svg_element("clipPath", {{"id", "window"}}, {}, svg_element("rect", corners)) +
         "\n<g clip-path=\"url(#window)\">\n" + markup + "</g>\n" + svg_element("rect", frame) + '\n';
}

}  // namespace

void PictureBox::include(Vec2 x) {
  lower = {std::min(lower.x, x.x), std::min(lower.y, x.y)};
  upper = {std::max(upper.x, x.x), std::max(upper.y, x.y)};
}

std::vector<Vec2> dense_points(const Nurbs& curve, int num_pieces) {
  std::vector<Vec2> points;
  for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k)
    for (int i = 0; i <= num_pieces && curve.knots[k] < curve.knots[k + 1]; ++i)
      points.push_back(
          curve::point(curve, std::lerp(curve.knots[k], curve.knots[k + 1], i / static_cast<double>(num_pieces))));
  return points;
}

double TextBox::distance(Vec2 a, Vec2 b) const {
  const auto to_box = [&](Vec2 x) {
    const Vec2 beyond{std::abs(x.x - centre.x) - half.x, std::abs(x.y - centre.y) - half.y};
    return norm(Vec2{std::max(0.0, beyond.x), std::max(0.0, beyond.y)});
  };
  double least = std::min(to_box(a), to_box(b));
  for (const Vec2 corner : {half, -half, Vec2{half.x, -half.y}, Vec2{-half.x, half.y}})
    least = std::min(least, distance_to_segment(centre + corner, a, b));
  return least;
}

PictureBox bounding_box(const CadFace& face) {
  PictureBox box;
  for (const Nurbs& curve : face.curves)
    for (const Vec2 x : dense_points(curve, 32)) box.include(x);
  return box;
}

PictureBox shown_box(const PictureBox& whole, Vec2 origin, const DrawOptions& options) {
  if (!options.window) return whole;
  const PictureBox shown{options.window->lower - origin, options.window->upper - origin};
  const bool meets = whole.lower.x <= shown.upper.x && whole.upper.x >= shown.lower.x &&
                     whole.lower.y <= shown.upper.y && whole.upper.y >= shown.lower.y;
  if (!meets && !whole.empty())
    throw UsageError(fmt::format("--window: nothing is there; the picture extends from {} to {}",
                                 position_text(whole.lower + origin), position_text(whole.upper + origin)));
  return shown;
}

double text_width(const std::string& text, double font_size) {
  const auto is_first_byte = [](unsigned char c) { return (c & 0xc0) != 0x80; };
  return 0.56 * font_size * static_cast<double>(std::count_if(text.begin(), text.end(), is_first_byte));
}

std::vector<std::string> wrapped_text(const std::string& text, double font_size, double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (!lines.empty() && text_width(lines.back() + ' ' + word, font_size) <= width)
      lines.back() += ' ' + word;
    else
      lines.push_back(word);
  return lines;
}

double round_length(double limit) {
  const double power = std::pow(10, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= limit * (1 + 1e-12)) return factor * power;
  return power;
}

Picture::Picture(const PictureBox& box, const DrawOptions& options, const std::string& title,
                 const std::string& caption)
    : caption_lines_(wrapped_text(caption, caption_size, options.width - 2 * picture_margin)),
      title_(options.title_prefix + title) {
  const double text = text_width(title_, title_size) + text_width(options.file, caption_size);
  (text + 2 * picture_margin + 20 < options.width || options.file.empty() ? file_ : caption_lines_.emplace_back()) =
      options.file;
  view_ = view_of(box, options.width, caption_lines_.size());
  view_.is_window = options.window.has_value();
  view_.is_bare = options.is_bare;
  legend_ = {picture_margin, view_.top + view_.size.y + 2 * picture_margin + 2, {}};
}

Picture::View Picture::view_of(const PictureBox& box, int width, std::size_t num_caption_lines) {
  const Vec2 extent = box.empty() ? Vec2{1, 1} : box.upper - box.lower;
  const double free_width = std::max(1.0, width - 2 * picture_margin);
  const double tallest = 1.1 * free_width;
  const double scale = std::min(free_width / std::max(extent.x, 1e-300), tallest / std::max(extent.y, 1e-300));
  const double top =
      header_height + caption_row * (static_cast<double>(std::max<std::size_t>(1, num_caption_lines)) - 1);
  return {scale, box.empty() ? Vec2{} : box.lower, scale * extent, width, top};
}

void Picture::open_group(const std::string& css_class) { add("<g class=\"" + xml_escaped(css_class) + "\">"); }

void Picture::open_clipped_group(const std::string& css_class, const std::string& outline) {
  const std::string id = fmt::format("clip{}", definitions_.size());
  definitions_ +=
      svg_element("clipPath", {{"id", id}}, {}, svg_element("path", {{"clip-rule", "evenodd"}, {"d", outline}})) + '\n';
  add(fmt::format("<g class=\"{}\" clip-path=\"url(#{})\">", xml_escaped(css_class), id));
}

void Picture::text(Vec2 x, const std::string& css_class, const std::string& content) {
  if (is_window() && !holds(x)) return;
  texts_.boxes.push_back({x, {0.5 * text_width(content, caption_size) + 2, 8}});
  texts_.markup += text_element(css_class, x.x, view_.size.y - x.y + 4, content) + '\n';
}

void Picture::reserve_legend(double width) {
  if (legend_.x > picture_margin && legend_.x + width > view_.width - picture_margin) {
    legend_.x = picture_margin;
    legend_.y += legend_row;
  }
}

void Picture::legend_bar(const Ramp& ramp, const std::string& label, const std::vector<std::string>& ticks) {
  const double bar = 220, height = 9, text = text_width(label, 12) + 10;
  reserve_legend(text + bar + 30);
  const std::string id = fmt::format("ramp{}", definitions_.size());
  std::string stops;
  for (const ColourStop& stop : ramp)
    stops += svg_element("stop", {{"offset", svg_number(stop.position, 4)}, {"stop-color", stop.colour}});
  definitions_ += svg_element("linearGradient", {{"id", id}}, {}, stops) + '\n';
  legend_.markup += text_element("legend", legend_.x, legend_.y + 4, label);
  const double left = legend_.x + text;
  legend_.markup += svg_element("rect", {{"x", svg_number(left)},
                                         {"y", svg_number(legend_.y - height / 2)},
                                         {"width", svg_number(bar)},
                                         {"height", svg_number(height)},
                                         {"rx", "2"},
                                         {"fill", "url(#" + id + ")"}});
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double x = left + bar * static_cast<double>(i) / std::max<double>(1, static_cast<double>(ticks.size()) - 1);
    legend_.markup += svg_element(
        "text", {{"class", "tick"}, {"text-anchor", "middle"}, {"x", svg_number(x)}, {"y", svg_number(legend_.y + 18)}},
        {}, xml_escaped(ticks[i]));
  }
  legend_.markup += '\n';
  legend_.x = left + bar + 34;
}

void Picture::legend_mark(const std::string& markup, const std::string& label) {
  const double mark = 22, width = mark + text_width(label, 12);
  reserve_legend(width);
  const std::string transform =
      fmt::format("translate({} {}) scale(1 -1)", svg_number(legend_.x + mark / 2 - 4), svg_number(legend_.y));
  legend_.markup += svg_element("g", {{"transform", transform}}, {}, markup);
  legend_.markup += text_element("legend", legend_.x + mark, legend_.y + 4, label) + '\n';
  legend_.x += width + 24;
}

void Picture::legend_scale(const std::string& unit) {
  const double longest = 130, tick = 4, gap = 8;
  const double length = round_length(longest / view_.scale), bar = length * view_.scale;
  const std::string label = fmt::format("{:g}{}{}", length, unit.empty() ? "" : " ", unit);
  const double width = bar + gap + text_width(label, 12);
  reserve_legend(width);
  legend_.markup += svg_element("path", {{"class", "scale"},
                                         {"d", fmt::format("M{0} {1}v{2}m0 -{3}h{4}m0 -{3}v{2}", svg_number(legend_.x),
                                                           svg_number(legend_.y - tick), svg_number(2 * tick),
                                                           svg_number(tick), svg_number(bar))}});
  legend_.markup += text_element("legend", legend_.x + bar + gap, legend_.y + 4, label) + '\n';
  legend_.x += width + 24;
}

std::string Picture::bare_str() const {
  constexpr double margin = 6;  // pixels, for the widths of lines
  const double width = view_.size.x + 2 * margin, height = view_.size.y + 2 * margin;
  return fmt::format(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
             svg_number(width), svg_number(height)) +
         fmt::format("<title>{}</title>\n<style>{}</style>\n<defs>\n{}</defs>\n", xml_escaped(title_), style_sheet(),
                     definitions_) +
         fmt::format("<g id=\"drawing\" transform=\"translate({} {}) scale(1 -1)\">\n", margin, height - margin) +
         (is_window() ? in_frame(drawing_, view_.size) : drawing_) + "</g>\n</svg>\n";
}

std::string Picture::str() const {
  if (view_.is_bare) return bare_str();
  const double left = picture_margin + 0.5 * std::max(0.0, view_.width - 2 * picture_margin - view_.size.x);
  const int height = static_cast<int>(std::ceil(legend_.y + (legend_.markup.empty() ? -14 : 32)));
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
      view_.width, height);
  out += fmt::format("<title>{}</title>\n<style>{}</style>\n", xml_escaped(title_), style_sheet());
  if (!definitions_.empty()) out += "<defs>\n" + definitions_ + "</defs>\n";
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  out += text_element("title", picture_margin, 32, title_);
  if (!file_.empty()) out += text_element("file", view_.width - picture_margin, 32, file_);
  for (std::size_t i = 0; i < caption_lines_.size(); ++i)
    out += text_element("caption", picture_margin, 52 + caption_row * static_cast<double>(i), caption_lines_[i]);
  out += fmt::format("\n<g id=\"drawing\" transform=\"translate({} {}) scale(1 -1)\">\n", svg_number(left),
                     svg_number(view_.top + view_.size.y));
  out += is_window() ? in_frame(drawing_, view_.size) : drawing_;
  out += "</g>\n";
  out += fmt::format("<g id=\"texts\" transform=\"translate({} {})\">\n{}</g>\n", svg_number(left),
                     svg_number(view_.top), texts_.markup);
  if (!legend_.markup.empty()) out += "<g id=\"legend\">\n" + legend_.markup + "</g>\n";
  return out + "</svg>\n";
}

}  // namespace quadrille::draw
