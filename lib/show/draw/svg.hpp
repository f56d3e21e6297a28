#pragma once
// A small SVG writer: escaping, numbers, elements with a hover title, paths. Smooth curves become cubic Bezier
// segments: Hermite interpolation, halved until it is exact to a fraction of a pixel.

#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::draw {

/// `text` with the five special characters of XML escaped; control characters become blanks.
std::string xml_escaped(const std::string& text);

/// Decimal with at most `digits` digits behind the point, no trailing zeros, never "-0".
std::string svg_number(double value, int digits = 2);

/// The data of a <path>, in pixels.
class PathData {
 public:
  explicit PathData(int digits = 2) : digits_(digits) {}
  void move_to(Vec2 p);
  void line_to(Vec2 p);
  void cubic_to(Vec2 c1, Vec2 c2, Vec2 p);
  /// Lines given by their steps: the shortest text for small figures.
  void relative_lines(std::initializer_list<Vec2> steps) { add('l', steps); }
  void close() { d_ += 'z'; }
  bool empty() const { return d_.empty(); }
  const std::string& str() const { return d_; }

 private:
  void add(char command, std::initializer_list<Vec2> points);
  int digits_;
  std::string d_;
};

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// <name a="...">...</name>; `inner` is markup, a non-empty `title` becomes the hover text, escaped like attributes.
std::string svg_element(const std::string& name, const Attributes& attributes, const std::string& title = {},
                        const std::string& inner = {});

struct CurvePoint {
  Vec2 position;    ///< pixels
  Vec2 derivative;  ///< with respect to the parameter
};
using PixelCurve = std::function<CurvePoint(double)>;

/// Appends the curve from t0 to t1 (t0 > t1: backwards) to `path`, whose last point is its start. Straight parts become
/// lines. The distance to the curve is below 0.05 pixels at the sampled points.
void append_curve(PathData& path, const PixelCurve& curve, double t0, double t1);

/// A <path> of a class.
std::string path_element(const std::string& css_class, const std::string& d, const std::string& title = {});

}  // namespace quadrille::draw
