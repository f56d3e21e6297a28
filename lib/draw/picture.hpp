#pragma once
// The frame of all pictures: title, drawing, legend; one scale, the same line styles.
//
// Everything geometric is in pixels with y up, as `at` returns it, and is written into one group that flips y; texts
// are outside this group.

#include <string>
#include <vector>

#include "draw/colour.hpp"
#include "draw/draw.hpp"
#include "draw/pixel_curve.hpp"
#include "draw/svg.hpp"

namespace quadrille::draw {

struct PictureBox {
  Vec2 lower, upper;
  void include(Vec2 x);
  bool empty() const { return !(lower.x <= upper.x); }
};

/// The empty box.
PictureBox empty_box();
/// The box of the face's boundary curves, by dense sampling.
PictureBox bounding_box(const CadFace& face);

class Picture {
 public:
  Picture(const PictureBox& box, const DrawOptions& options, const std::string& title, const std::string& caption);

  /// Pixels of a point, y up.
  Vec2 at(Vec2 x) const { return scale_ * (x - lower_); }
  double scale() const { return scale_; }  ///< pixels per unit of length
  Vec2 size() const { return size_; }      ///< of the drawing, pixels

  /// Markup inside the flipped group, in the order of the calls. Groups set a common class for many elements.
  void add(const std::string& markup) { drawing_ += markup + '\n'; }
  void open_group(const std::string& css_class);
  /// A group clipped to `outline` (path data, fill rule evenodd).
  void open_clipped_group(const std::string& css_class, const std::string& outline);
  void close_group() { add("</g>"); }

  /// A text centred at x (pixels, y up), moved by `offset`; drawn above everything.
  void text(Vec2 x, const std::string& css_class, const std::string& content);

  /// Legend entries, drawn from left to right below the picture.
  void legend_bar(const Ramp& ramp, const std::string& label, const std::vector<std::string>& ticks);
  void legend_mark(const std::string& markup, const std::string& label);  ///< markup centred at (0, 0), y up

  /// The whole SVG.
  std::string str() const;

 private:
  double scale_ = 1;
  Vec2 lower_, size_;
  int width_ = 0;
  double legend_x_ = 0, legend_y_ = 0;
  std::string title_, caption_, drawing_, texts_, legend_, definitions_;
  void reserve_legend(double width);
};

/// Approximate width of a text in pixels.
double text_width(const std::string& text, double font_size);

}  // namespace quadrille::draw
