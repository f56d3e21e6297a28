#pragma once
// The frame of all pictures: title, drawing, legend; one scale, the same line styles.
//
// Everything geometric is in pixels with y up, as `at` returns it, and is written into one group that flips y; texts
// are outside this group.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "draw/draw.hpp"
#include "draw/palette.hpp"
#include "draw/svg.hpp"

namespace quadrille::draw {

/// Empty by default.
struct PictureBox {
  Vec2 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}, upper = -lower;
  void include(Vec2 x);
  bool empty() const { return !(lower.x <= upper.x); }
};

/// A rectangle in the picture, pixels, y up.
struct TextBox {
  Vec2 centre, half;
  bool holds(Vec2 x) const { return std::abs(x.x - centre.x) < half.x && std::abs(x.y - centre.y) < half.y; }
  /// From a segment that does not cross the box.
  double distance(Vec2 a, Vec2 b) const;
  bool overlaps(const TextBox& b) const {
    return std::abs(b.centre.x - centre.x) < half.x + b.half.x && std::abs(b.centre.y - centre.y) < half.y + b.half.y;
  }
};

/// Points of a curve in its direction, `num_pieces` intervals of each knot span, knots between spans twice.
std::vector<Vec2> dense_points(const Nurbs& curve, int num_pieces);
/// The box of the face's boundary curves, by dense sampling.
PictureBox bounding_box(const CadFace& face);

/// The box that the picture shows: the whole or, where the options have one, the window, which is in the coordinates of
/// the file (`origin` included). Throws UsageError if nothing of the whole is in the window.
PictureBox shown_box(const PictureBox& whole, Vec2 origin, const DrawOptions& options);

class Picture {
 public:
  /// A caption that is wider than the picture takes several lines.
  Picture(const PictureBox& box, const DrawOptions& options, const std::string& title, const std::string& caption);

  /// Pixels of a point, y up.
  Vec2 at(Vec2 x) const { return view_.scale * (x - view_.lower); }
  double scale() const { return view_.scale; }  ///< pixels per unit of length
  Vec2 size() const { return view_.size; }      ///< of the drawing, pixels
  bool is_window() const { return view_.is_window; }
  /// Whether a point (pixels, y up) is in the drawing.
  bool holds(Vec2 x) const { return x.x >= 0 && x.y >= 0 && x.x <= view_.size.x && x.y <= view_.size.y; }

  /// Markup inside the flipped group, in the order of the calls. Groups set a common class for many elements.
  void add(const std::string& markup) { drawing_ += markup + '\n'; }
  void open_group(const std::string& css_class);
  /// A group clipped to `outline` (path data, fill rule evenodd).
  void open_clipped_group(const std::string& css_class, const std::string& outline);
  void close_group() { add("</g>"); }

  /// A text centred at x (pixels, y up), drawn above everything; omitted outside a window.
  void text(Vec2 x, const std::string& css_class, const std::string& content);
  /// The places of the texts, with some room around each.
  const std::vector<TextBox>& text_boxes() const { return texts_.boxes; }

  /// Legend entries, drawn from left to right below the picture.
  void legend_bar(const Ramp& ramp, const std::string& label, const std::vector<std::string>& ticks);
  void legend_mark(const std::string& markup, const std::string& label);  ///< markup centred at (0, 0), y up

  /// A scale bar with a round length in `unit`, which may be empty.
  void legend_scale(const std::string& unit);

  /// The whole SVG.
  std::string str() const;

 private:
  struct View {
    double scale = 1;        ///< pixels per unit of length
    Vec2 lower;              ///< the point at the drawing's lower left corner
    Vec2 size;               ///< of the drawing, pixels
    int width = 0;           ///< of the picture, pixels
    double top = 0;          ///< of the drawing, pixels from the top of the picture
    bool is_window = false;  ///< a part of the whole: the drawing is clipped
    bool is_bare = false;    ///< the drawing alone
  };
  struct Legend {
    double x = 0, y = 0;  ///< of the next entry, pixels, y down
    std::string markup;
  };

  struct Texts {
    std::string markup;
    std::vector<TextBox> boxes;
  };

  std::string bare_str() const;
  static View view_of(const PictureBox& box, int width, std::size_t num_caption_lines);
  void reserve_legend(double width);

  std::vector<std::string> caption_lines_;
  View view_;
  Legend legend_;
  Texts texts_;
  std::string title_, file_, drawing_, definitions_;
};

/// The largest of 1, 2 and 5 times a power of ten that is at most `limit` > 0.
double round_length(double limit);
/// Approximate width of a text in pixels; `font_size` in pixels.
double text_width(const std::string& text, double font_size);
/// The text in lines of at most `width` pixels, broken between words; a longer word is a line of its own.
std::vector<std::string> wrapped_text(const std::string& text, double font_size, double width);

}  // namespace quadrille::draw
