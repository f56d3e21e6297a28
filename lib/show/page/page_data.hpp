#pragma once
// The data of a page as JSON: objects with sorted-by-call keys, arrays of numbers as base64 of little-endian bytes.
//
// Geometry is in integers. Positions have 32 bits, whose step is the extent of everything drawn by 2^30.
// Curves are cubic Bezier pieces: sides of elements relative to their chords, in 16 bits; chains of curves in the
// frame.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "draw/picture.hpp"
#include "draw/svg.hpp"
#include "model/arc_graph.hpp"

namespace quadrille::page {

/// The bytes of the numbers, little-endian, as base64.
std::string packed(const std::vector<std::int32_t>& values);
std::string packed(const std::vector<std::int16_t>& values);
std::string packed(const std::vector<std::uint8_t>& values);
/// As IEEE numbers of 32 bits.
std::string packed_floats(const std::vector<double>& values);

/// `text` as a JSON string that may stand inside a <script> element: no "<", ">" or "&".
std::string script_string(const std::string& text);
/// JSON as it may stand inside a <script> element: such characters are in strings only, and are escaped there.
std::string script_json(const std::string& json);
/// `text` as the content of an HTML element or attribute.
std::string html_text(const std::string& text);

/// A JSON array of values that are JSON already.
std::string json_list(const std::vector<std::string>& values);
/// A JSON array of strings.
std::string json_texts(const std::vector<std::string>& texts);

/// The colours of drawings, light and dark.
std::string palettes_json();

// The parts of a page that do not depend on its data, compiled in from view/ (CMakeLists.txt).
std::string page_style();        ///< view/view.css
std::string workbench_style();   ///< view/bench.css, behind it
std::string page_body();         ///< view/body.html
std::string page_script();       ///< view/*.js in one function, without those of the workbench
std::string workbench_script();  ///< the same with view/bench_*.js

/// A JSON object, key by key.
class JsonObject {
 public:
  JsonObject& json(const std::string& key, const std::string& value);
  JsonObject& text(const std::string& key, const std::string& value) { return json(key, script_string(value)); }
  /// Finite numbers with 17 digits; others become null.
  JsonObject& number(const std::string& key, double value);
  JsonObject& flag(const std::string& key, bool value) { return json(key, value ? "true" : "false"); }
  /// Base64, which needs no escapes.
  JsonObject& data(const std::string& key, const std::string& base64) { return json(key, '"' + base64 + '"'); }
  std::string str() const { return '{' + members_ + '}'; }

 private:
  std::string members_;
};

struct PageFrame {
  Vec2 centre;
  double step = 1;    ///< a length: one unit of the integers
  double extent = 1;  ///< greater side of the box, a length
  /// Of the first view, relative to the centre: the bodies in a far field; empty: everything is shown.
  draw::PictureBox body;

  /// About the length of a pixel of the first view at x; of everything where the first view does not show x.
  double pixel(Vec2 x) const;
  /// The nearest integer of the range; 0 for what is no number.
  std::int32_t quantised(double distance) const;
  void append(std::vector<std::int32_t>& to, Vec2 x) const;
};

/// The frame of a box; an empty one counts as the unit square, a point as a square of side 1 around it.
PageFrame page_frame(const draw::PictureBox& box);

/// Positions and derivatives of a side at s = k / 8, s in [0, 1].
using SideSamples = std::array<draw::CurvePoint, 9>;

/// Sides of elements as cubic pieces. A side from a to b has 0 (straight), 1, 2 or 4 pieces of equal parameter length;
/// a point p of it is stored as the complex number (p - a) / (b - a) in units of 1 / 8192: both inner control points
/// of each piece, and the end of each piece but the last.
struct Bends {
  std::vector<std::uint8_t> pieces;  ///< one per side
  std::vector<std::int16_t> points;  ///< two per control point

  /// Appends a side. The pieces are exact to 3e-4 of the side's chord, or are four.
  void append(const SideSamples& side);
};

/// Chains of cubic pieces: chain k has the points [offsets[k], offsets[k+1]), three for each piece after the first.
struct Chains {
  std::vector<std::int32_t> offsets{0};
  std::vector<std::int32_t> points;  ///< two per point, in the frame's units

  /// Appends a chain of pieces of curves, exact to 1e-6 of the frame's extent. `curve_of` returns the curve of a piece.
  template <typename CurveOf>
  void append(const PageFrame& frame, const std::vector<ArcPiece>& pieces, const CurveOf& curve_of) {
    for (const ArcPiece& piece : pieces) append_piece(frame, curve_of(piece.curve), piece.t0, piece.t1);
    close_chain();
  }
  void append_piece(const PageFrame& frame, const Nurbs& curve, double t0, double t1);
  void close_chain() { offsets.push_back(static_cast<std::int32_t>(points.size() / 2)); }
};

}  // namespace quadrille::page
