#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quadrille::draw {

namespace {

constexpr double curve_tolerance = 0.05;  // pixels
constexpr int max_halvings = 12;

struct Cubic {
  Vec2 a, b, c, d;
  Vec2 at(double s) const {
    const double r = 1 - s;
    return r * r * r * a + 3 * r * r * s * b + 3 * r * s * s * c + s * s * s * d;
  }
};

bool is_on_chord(const Cubic& cubic, const Vec2 samples[3]) {
  const Vec2 chord = cubic.d - cubic.a;
  const double length = norm(chord);
  const auto is_near = [&](Vec2 p) {
    return length > 0 ? std::abs(cross(chord, p - cubic.a)) <= 0.5 * curve_tolerance * length : p == cubic.a;
  };
  return std::all_of(samples, samples + 3, is_near);
}

void append_cubics(PathData& path, const PixelCurve& curve, double t0, CurvePoint p0, double t1, CurvePoint p1,
                   int depth) {
  const double third = (t1 - t0) / 3;
  const Cubic cubic{p0.position, p0.position + third * p0.derivative, p1.position - third * p1.derivative, p1.position};
  Vec2 samples[3];
  double error = 0;
  CurvePoint middle;
  for (int i = 0; i < 3; ++i) {
    const double s = 0.25 * (i + 1);
    const CurvePoint p = curve(t0 + s * (t1 - t0));
    if (i == 1) middle = p;
    samples[i] = p.position;
    error = std::max(error, distance(p.position, cubic.at(s)));
  }
  if (is_on_chord(cubic, samples)) return path.line_to(p1.position);
  if (error < curve_tolerance || depth == max_halvings) return path.cubic_to(cubic.b, cubic.c, cubic.d);
  const double half = 0.5 * (t0 + t1);
  append_cubics(path, curve, t0, p0, half, middle, depth + 1);
  append_cubics(path, curve, half, middle, t1, p1, depth + 1);
}

}  // namespace

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  return out;
}

std::string svg_number(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

void PathData::add(char command, std::initializer_list<Vec2> points) {
  d_ += command;
  bool first = true;
  for (const Vec2 p : points)
    for (const double value : {p.x, p.y}) {
      const std::string number = svg_number(value, digits_);
      if (!first && number[0] != '-') d_ += ' ';
      d_ += number;
      first = false;
    }
}

void PathData::move_to(Vec2 p) { add('M', {p}); }
void PathData::line_to(Vec2 p) { add('L', {p}); }
void PathData::cubic_to(Vec2 c1, Vec2 c2, Vec2 p) { add('C', {c1, c2, p}); }

std::string svg_element(const std::string& name, const Attributes& attributes, const std::string& title,
                        const std::string& inner) {
  std::string out = '<' + name;
  for (const auto& [key, value] : attributes) out += ' ' + key + "=\"" + xml_escaped(value) + '"';
  if (title.empty() && inner.empty()) return out + "/>";
  out += '>';
  if (!title.empty()) out += "<title>" + xml_escaped(title) + "</title>";
  return out + inner + "</" + name + '>';
}

void append_curve(PathData& path, const PixelCurve& curve, double t0, double t1) {
  append_cubics(path, curve, t0, curve(t0), t1, curve(t1), 0);
}

std::string path_element(const std::string& css_class, const std::string& d, const std::string& title) {
  return svg_element("path", {{"class", css_class}, {"d", d}}, title);
}

}  // namespace quadrille::draw
