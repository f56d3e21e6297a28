// The colours of lib/show/draw/palette.hpp for the page's script.
#include "page/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>

#include "base/base64.hpp"
#include "base/message_text.hpp"
#include "curve/nurbs.hpp"
#include "draw/palette.hpp"

namespace quadrille::page {

namespace {

template <typename T>
std::string packed_bytes(const std::vector<T>& values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(T));
  for (const T value : values) {
    const auto bits = static_cast<std::uint32_t>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(bits >> (8 * i) & 255);
  }
  return base64(bytes);
}

/// Replaces the three characters that end or open markup by what `escape` gives.
template <typename Escape>
std::string without_markup(const std::string& text, const Escape& escape) {
  std::string out;
  for (const char c : text)
    if (c == '<' || c == '>' || c == '&')
      out += escape(c);
    else
      out += c;
  return out;
}

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

using Complex = std::complex<double>;
using draw::CurvePoint;

struct BendTolerances {
  double side = 3e-4;      ///< of elements, in chords
  double straight = 5e-5;  ///< what counts as a straight side, in chords
  double chain = 1e-6;     ///< of chains, in the frame's extent
  int greatest_depth = 8;  ///< of the halving of a curve between two knots
};
constexpr BendTolerances bend_tolerances{};

Complex number(Vec2 x) { return {x.x, x.y}; }

/// The cubic piece between two points whose parameters differ by h, at its fraction s.
Vec2 hermite(const CurvePoint& a, const CurvePoint& b, double h, double s) {
  const double r = 1 - s;
  const Vec2 first = a.position + h / 3 * a.derivative, second = b.position - h / 3 * b.derivative;
  return r * r * r * a.position + 3 * r * r * s * first + 3 * r * s * s * second + s * s * s * b.position;
}

bool is_straight(const SideSamples& side) {
  const Vec2 a = side.front().position, chord = side.back().position - a;
  return std::all_of(side.begin(), side.end(), [&](const CurvePoint& p) {
    return std::abs(cross(chord, p.position - a)) <= bend_tolerances.straight * norm2(chord);
  });
}

bool is_exact(const SideSamples& side, int pieces) {
  const int width = 8 / pieces;
  const double tolerance = bend_tolerances.side * distance(side.front().position, side.back().position);
  for (int i = 0; i < 8; ++i) {
    const int start = i / width * width;
    const double s = static_cast<double>(i - start) / width;
    if (distance(hermite(side[start], side[start + width], 1.0 / pieces, s), side[i].position) > tolerance)
      return false;
  }
  return true;
}

void append_cubic(Chains& chains, const PageFrame& frame, const Nurbs& curve, double t0, double t1, int depth) {
  const double last = std::max(t0, t1);
  const auto at = [&](double t) -> CurvePoint {
    const auto d = curve::derivatives(curve, t, t == last);
    return {d[0], d[1]};
  };
  const CurvePoint a = at(t0), b = at(t1);
  const double h = t1 - t0;
  double error = 0;
  for (const double s : {0.25, 0.5, 0.75})
    error = std::max(error, distance(hermite(a, b, h, s), curve::point(curve, std::lerp(t0, t1, s))));
  if (error > bend_tolerances.chain * frame.extent && depth < bend_tolerances.greatest_depth) {
    const double half = 0.5 * (t0 + t1);
    append_cubic(chains, frame, curve, t0, half, depth + 1);
    append_cubic(chains, frame, curve, half, t1, depth + 1);
    return;
  }
  frame.append(chains.points, a.position + h / 3 * a.derivative);
  frame.append(chains.points, b.position - h / 3 * b.derivative);
  frame.append(chains.points, b.position);
}

}  // namespace

std::string packed(const std::vector<std::int32_t>& values) { return packed_bytes(values); }
std::string packed(const std::vector<std::int16_t>& values) { return packed_bytes(values); }
std::string packed(const std::vector<std::uint8_t>& values) { return packed_bytes(values); }

std::string packed_floats(const std::vector<double>& values) {
  std::vector<std::int32_t> bits;
  bits.reserve(values.size());
  for (const double value : values) bits.push_back(std::bit_cast<std::int32_t>(static_cast<float>(value)));
  return packed_bytes(bits);
}

std::string script_json(const std::string& json) {
  return without_markup(json, [](char c) { return fmt::format("\\u{:04x}", static_cast<int>(c)); });
}

std::string script_string(const std::string& text) { return script_json(json_string(text)); }

std::string html_text(const std::string& text) {
  std::string out;
  for (const char c : without_markup(text, [](char c) { return c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&amp;"; }))
    if (c == '"')
      out += "&quot;";
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return out;
}

std::string json_list(const std::vector<std::string>& values) { return fmt::format("[{}]", fmt::join(values, ",")); }

std::string json_texts(const std::vector<std::string>& texts) {
  std::vector<std::string> values;
  values.reserve(texts.size());
  for (const std::string& text : texts) values.push_back(script_string(text));
  return json_list(values);
}

JsonObject& JsonObject::json(const std::string& key, const std::string& value) {
  members_ += fmt::format("{}\"{}\":{}", members_.empty() ? "" : ",", key, value);
  return *this;
}

JsonObject& JsonObject::number(const std::string& key, double value) {
  return json(key, std::isfinite(value) ? fmt::format("{:.17g}", value) : "null");
}

std::string palettes_json() {
  JsonObject object;
  object.json("light", palette_json(draw::Paper::light));
  return object.json("dark", palette_json(draw::Paper::dark)).str();
}

std::int32_t PageFrame::quantised(double distance) const {
  const double limit = std::numeric_limits<std::int32_t>::max();
  const double steps = std::round(distance / step);
  return std::isnan(steps) ? 0 : static_cast<std::int32_t>(std::clamp(steps, -limit, limit));
}

void PageFrame::append(std::vector<std::int32_t>& to, Vec2 x) const {
  to.push_back(quantised(x.x - centre.x));
  to.push_back(quantised(x.y - centre.y));
}

double PageFrame::pixel(Vec2 x) const {
  constexpr double window = 800;  // pixels of a large window that the greater side fills
  if (body.empty()) return extent / window;
  const Vec2 size = body.upper - body.lower, p = x - centre - 0.5 * (body.lower + body.upper);
  const double greater = std::max(size.x, size.y);
  return std::max(std::abs(p.x), std::abs(p.y)) < greater ? greater / window : extent / window;
}

PageFrame page_frame(const draw::PictureBox& box) {
  if (box.empty()) return page_frame({{0, 0}, {1, 1}});
  const double extent = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
  PageFrame frame;
  frame.centre = 0.5 * (box.lower + box.upper);
  frame.extent = extent > 0 ? extent : 1;
  frame.step = std::ldexp(frame.extent, -30);
  return frame;
}

void Bends::append(const SideSamples& side) {
  const Complex a = number(side.front().position), chord = number(side.back().position) - a;
  int count = 0;
  if (chord != Complex(0) && !is_straight(side)) count = is_exact(side, 1) ? 1 : is_exact(side, 2) ? 2 : 4;
  pieces.push_back(static_cast<std::uint8_t>(count));
  const auto add = [&](Vec2 p) {
    const Complex z = 8192.0 * (number(p) - a) / chord;
    for (const double part : {z.real(), z.imag()})
      points.push_back(
          static_cast<std::int16_t>(std::isnan(part) ? 0 : std::clamp(std::round(part), -32767.0, 32767.0)));
  };
  for (int i = 0; i < count; ++i) {
    const CurvePoint &from = side[i * 8 / count], &to = side[(i + 1) * 8 / count];
    const double third = 1.0 / (3.0 * count);
    add(from.position + third * from.derivative);
    add(to.position - third * to.derivative);
    if (i + 1 < count) add(to.position);
  }
}

void Chains::append_piece(const PageFrame& frame, const Nurbs& curve, double t0, double t1) {
  if (points.size() / 2 == static_cast<std::size_t>(offsets.back())) frame.append(points, curve::point(curve, t0));
  std::vector<double> cuts{std::min(t0, t1)};
  for (const double knot : curve.knots)
    if (knot > cuts.back() && knot < std::max(t0, t1)) cuts.push_back(knot);
  cuts.push_back(std::max(t0, t1));
  if (t0 > t1) std::reverse(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) append_cubic(*this, frame, curve, cuts[i - 1], cuts[i], 0);
}

}  // namespace quadrille::page
