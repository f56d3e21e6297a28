#include "curve/symmetry_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/angle.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::curve {

namespace {

/// The line through the ends of a curve.
SymmetryLine line_through(const CadFace& face, int c) {
  const Nurbs& nurbs = face.curves[c];
  const Vec2 start = point(nurbs, nurbs.begin()), chord = point(nurbs, nurbs.end()) - start;
  return {start, norm(chord) > 0 ? normalized(chord) : Vec2{1, 0}, {c}};  // a closed curve is not straight
}

/// The point of a curve with the greatest value of `rank`, of its ends and seven points in each knot span.
template <typename Rank>
Vec2 foremost_point(const Nurbs& nurbs, const Rank& rank) {
  constexpr int steps = 8;
  Vec2 best = point(nurbs, nurbs.begin());
  for_each_span(nurbs, [&](double a, double b) {
    for (int i = 1; i <= steps; ++i) {
      const Vec2 x = point(nurbs, i == steps ? b : a + (b - a) * i / steps);
      if (rank(x) > rank(best)) best = x;
    }
  });
  return best;
}

std::string curve_text(const CadFace& face, int c) { return fmt::format("curve {} \"{}\"", c, face.curve_names[c]); }

std::string place_text(const CadFace& face, Vec2 x) { return rounded_position_text(x + face.origin); }

/// Why a curve is not straight; empty if it is.
std::string bend_fault(const CadFace& face, const SymmetryLine& line) {
  const int c = line.curves.front();
  const Vec2 x = foremost_point(face.curves[c], [&](Vec2 p) { return std::abs(line.height(p)); });
  if (std::abs(line.height(x)) <= tolerance::same_point * face.diameter) return {};
  return fmt::format("{} is not straight: at {} it is {:.3g} off the line between its ends", curve_text(face, c),
                     place_text(face, x), std::abs(line.height(x)));
}

/// Why the face is not on one side of a line; empty if it is.
std::string side_fault(const CadFace& face, const SymmetryLine& line) {
  for (const Nurbs& curve : face.curves) {
    const Vec2 x = foremost_point(curve, [&](Vec2 p) { return -line.height(p); });
    if (line.height(x) < -tolerance::same_point * face.diameter)
      return fmt::format("the face lies on both sides of {}: at {} it is {:.3g} beyond its line",
                         curve_text(face, line.curves.front()), place_text(face, x), -line.height(x));
  }
  return {};
}

/// Whether a straight curve is a part of the line.
bool continues(const CadFace& face, const SymmetryLine& line, const SymmetryLine& other) {
  const Nurbs& nurbs = face.curves[other.curves.front()];
  const double tol = tolerance::same_point * face.diameter;
  return std::abs(line.height(point(nurbs, nurbs.begin()))) <= tol &&
         std::abs(line.height(point(nurbs, nurbs.end()))) <= tol;
}

}  // namespace

std::vector<int> curves_that_fit(const CadFace& face, const std::vector<std::string>& patterns) {
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c) {
    const auto fits = [&](const std::string& pattern) { return matches_wildcard(face.curve_names[c], pattern); };
    if (!face.is_interface(c) && std::any_of(patterns.begin(), patterns.end(), fits)) curves.push_back(c);
  }
  return curves;
}

SymmetryLines symmetry_lines(const CadFace& face, const std::vector<int>& curves) {
  std::vector<SymmetryLine> lines;
  for (const int c : curves) {
    const SymmetryLine own = line_through(face, c);
    if (std::string fault = bend_fault(face, own); !fault.empty()) return {{}, std::move(fault)};
    const auto known =
        std::find_if(lines.begin(), lines.end(), [&](const SymmetryLine& line) { return continues(face, line, own); });
    if (known == lines.end())
      lines.push_back(own);
    else
      known->curves.push_back(c);
  }
  for (const SymmetryLine& line : lines)
    if (std::string fault = side_fault(face, line); !fault.empty()) return {{}, std::move(fault)};
  return {std::move(lines), {}};
}

bool is_part_of_whole(const std::vector<SymmetryLine>& lines) {
  return lines.size() == 1 ||
         (lines.size() == 2 && std::abs(dot(lines[0].direction, lines[1].direction)) <= tolerance::same_angle);
}

namespace {

constexpr double smooth_angle = radians(1);  // as --corner-angle of cad2tri by default

/// Successive curves of a loop: all of them, or those between two points of the line.
struct Chain {
  std::vector<int> curves;
  bool is_open = false;
};

double turned_back(double angle) { return wrap_pi(angle + pi); }

class Mirror {
 public:
  Mirror(const CadFace& half, const SymmetryLine& line) : half_(half), line_(line), is_on_line_(half.num_curves()) {
    for (const int c : line.curves) is_on_line_[c] = true;
    result_.copy.assign(half.num_curves(), -1);
    result_.image = result_.copy;
    result_.whole = half;
    CadFace& whole = result_.whole;
    whole.curves.clear(), whole.curve_names.clear(), whole.unnamed_curves.clear(), whole.curve_cad_edges.clear();
    whole.joints.clear(), whole.partners.clear(), whole.periodic_pairs.clear();
    whole.region_loops.clear(), whole.region_names.clear();
    whole.loop_offsets = {0};
  }

  MirroredFace result() {
    CadFace& whole = result_.whole;
    if (half_.num_regions() > 1) whole.region_loops = {0};
    for (int r = 0; r < half_.num_regions(); ++r) add_region(r);
    set_partners();
    whole.diameter = diameter();
    if (half_.chart) {  // in space, images are the curves themselves, reversed: their lengths are the same
      Chart chart = *half_.chart;
      chart.space_curves = std::move(space_curves_);
      whole.chart = std::make_shared<const Chart>(std::move(chart));
    }
    return std::move(result_);
  }

 private:
  /// A region on the line and its image become one, others two.
  void add_region(int r) {
    std::vector<Chain> chains;
    const int first = half_.region_loops.empty() ? 0 : half_.region_loops[r];
    const int last = half_.region_loops.empty() ? half_.num_loops() : half_.region_loops[r + 1];
    for (int l = first; l < last; ++l) add_chains(l, chains);
    // The outline comes first. It goes back along the line, bodies on the line go forward.
    const auto is_outline = [&](const Chain& chain) {
      return chain.is_open ? is_backward(chain) : half_.loop_of(chain.curves.front()) == first;
    };
    std::stable_partition(chains.begin(), chains.end(), is_outline);
    const bool is_joined = std::any_of(chains.begin(), chains.end(), [](const Chain& chain) { return chain.is_open; });
    for (const Chain& chain : chains) {
      add_copies(chain);
      if (is_joined) add_images(chain);
    }
    end_region(r);
    if (is_joined) return;
    for (const Chain& chain : chains) add_images(chain);
    end_region(r);
  }

  void end_region(int r) {
    CadFace& whole = result_.whole;
    if (half_.num_regions() == 1) return;
    whole.region_loops.push_back(whole.num_loops());
    whole.region_names.push_back(half_.region_names[r]);
  }

  void add_chains(int l, std::vector<Chain>& chains) const {
    const int first = half_.loop_offsets[l], last = half_.loop_offsets[l + 1];
    int start = first;  // a curve behind one of the line, if there is one
    while (start < last && !is_on_line_[half_.previous_in_loop(start)]) ++start;
    const bool is_open = start < last;
    bool begins = true;
    for (int i = 0, c = is_open ? start : first; i < last - first; ++i, c = half_.next_in_loop(c)) {
      if (!is_on_line_[c] && begins) chains.push_back({{}, is_open});
      if (!is_on_line_[c]) chains.back().curves.push_back(c);
      begins = is_on_line_[c];
    }
  }

  Vec2 start(int c) const { return half_.joints[c].position; }

  bool is_backward(const Chain& chain) const {
    const Vec2 end = start(half_.next_in_loop(chain.curves.back()));
    return dot(line_.direction, end - start(chain.curves.front())) < 0;
  }

  void add_copies(const Chain& chain) {
    for (const int c : chain.curves) add_copy(c, chain.is_open && c == chain.curves.front());
    if (!chain.is_open) end_loop();  // an open chain and its image make one loop
  }
  void add_images(const Chain& chain) {
    for (auto c = chain.curves.rbegin(); c != chain.curves.rend(); ++c)
      add_image(*c, chain.is_open && c == chain.curves.rbegin());
    end_loop();
  }
  void end_loop() { result_.whole.loop_offsets.push_back(result_.whole.num_curves()); }

  void add_copy(int c, bool begins_on_line) {
    result_.copy[c] = result_.whole.num_curves();
    Joint joint = half_.joints[c];
    if (begins_on_line) {
      joint.tangent_in = turned_back(reflected(joint.tangent_out));
      open_at_line(joint);
    }
    if (half_.chart) space_curves_.push_back(half_.chart->space_curves[c]);
    add(half_.curves[c], c, joint);
  }

  void add_image(int c, bool begins_on_line) {
    result_.image[c] = result_.whole.num_curves();
    Nurbs image = reversed(half_.curves[c]);
    for (Vec2& pole : image.poles) pole = line_(pole);
    Joint joint = half_.joints[half_.next_in_loop(c)];
    const double in = joint.tangent_in, out = joint.tangent_out;
    joint.tangent_out = turned_back(reflected(in));
    if (begins_on_line) {
      open_at_line(joint);
    } else {
      joint.position = line_(joint.position);
      joint.tangent_in = turned_back(reflected(out));
    }
    if (half_.chart) space_curves_.push_back(surface::reversed(half_.chart->space_curves[c]));
    add(image, c, joint);
  }

  void add(const Nurbs& curve, int c, const Joint& joint) {
    CadFace& whole = result_.whole;
    if (!half_.has_given_name(c)) whole.unnamed_curves.push_back(whole.num_curves());
    whole.curves.push_back(curve);
    whole.curve_names.push_back(half_.curve_names[c]);
    whole.curve_cad_edges.push_back(half_.curve_cad_edges[c]);
    whole.joints.push_back(joint);
  }

  /// The angle of the whole where the boundary of the half meets the line.
  static void open_at_line(Joint& joint) {
    joint.is_corner = is_corner_of_whole(joint.interior_angle);
    joint.interior_angle *= 2;
  }

  double reflected(double angle) const { return wrap_pi(2 * angle_of(line_.direction) - angle); }

  void set_partners() {
    if (half_.partners.empty()) return;
    std::vector<int>& partners = result_.whole.partners;
    partners.assign(result_.whole.num_curves(), -1);
    for (int c = 0; c < half_.num_curves(); ++c)
      if (half_.is_interface(c) && !is_on_line_[c]) {
        partners[result_.copy[c]] = result_.copy[half_.partners[c]];
        partners[result_.image[c]] = result_.image[half_.partners[c]];
      }
  }

  /// The largest distance between a point of the boundary and the image of another, sampled.
  double diameter() const {
    constexpr int steps = 32;
    std::vector<Vec2> points;
    for (int c = 0; c < half_.num_curves(); ++c)
      for (int i = 0; i < steps; ++i)
        points.push_back(point(
            half_.curves[c], half_.curves[c].begin() + (half_.curves[c].end() - half_.curves[c].begin()) * i / steps));
    double largest = half_.diameter;
    for (const Vec2 a : points)
      for (const Vec2 b : points) largest = std::max(largest, distance(a, line_(b)));
    return largest;
  }

  const CadFace& half_;
  const SymmetryLine& line_;
  std::vector<bool> is_on_line_;
  std::vector<SpaceCurve> space_curves_;  ///< of the whole, if the face is curved
  MirroredFace result_;
};

}  // namespace

bool is_corner_of_whole(double interior_angle) { return std::abs(2 * interior_angle - pi) > smooth_angle; }

MirroredFace mirrored_face(const CadFace& half, const SymmetryLine& line) { return Mirror(half, line).result(); }

CadFace whole_of(CadFace face, const std::vector<std::string>& symmetry) {
  for (;;) {
    const std::vector<SymmetryLine> lines = symmetry_lines(face, curves_that_fit(face, symmetry)).lines;
    if (!is_part_of_whole(lines)) return face;
    face = mirrored_face(face, lines.front()).whole;
  }
}

}  // namespace quadrille::curve
