#include "draw/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "draw/marks.hpp"

namespace quadrille::draw {

namespace {

/// Pixels.
struct LabelSizes {
  double font = 13, box_height = 16, padding = 6, ink_step = 3, tied = 1e-3;
  double shortest_leader = 16;                              ///< labels nearer than this to their curve need no line
  double side_room = 33, room_above = 16, room_below = 46;  ///< beside the drawing that labels may use
};
constexpr LabelSizes label_sizes{};

/// Points of a curve in the picture, at most ink_step apart, and the distance to each along the curve.
struct Trace {
  std::vector<Vec2> points;
  std::vector<double> lengths;

  Trace(const Picture& picture, const Nurbs& curve) {
    for (const Vec2 x : dense_points(curve, 64)) add(picture.at(x));
    if (points.empty()) add(picture.at(curve.poles.front()));  // a curve without length
    if (picture.is_window()) keep_inside(picture);
  }

  double length() const { return lengths.back(); }

  /// Removes the points outside the picture, unless all are.
  void keep_inside(const Picture& picture) {
    const std::vector<Vec2> all = std::move(points);
    points.clear(), lengths.clear();
    for (const Vec2 x : all)
      if (picture.holds(x))
        points.push_back(x), lengths.push_back(static_cast<double>(points.size()) * label_sizes.ink_step);
    if (points.empty()) points = {all.front()}, lengths = {0};
  }

  void add(Vec2 x) {
    const double step = points.empty() ? 0 : distance(points.back(), x);
    const int num_steps = std::max(1, static_cast<int>(std::ceil(step / label_sizes.ink_step)));
    const Vec2 from = points.empty() ? x : points.back();
    const double before = lengths.empty() ? 0 : lengths.back();
    for (int i = 1; i <= num_steps; ++i) {
      const double part = i / static_cast<double>(num_steps);
      points.push_back(from + part * (x - from));
      lengths.push_back(before + part * step);
    }
  }

  std::size_t at(double fraction) const {
    const auto found = std::lower_bound(lengths.begin(), lengths.end(), fraction * length());
    return std::min(static_cast<std::size_t>(found - lengths.begin()), points.size() - 1);
  }

  Vec2 tangent(std::size_t i) const {
    std::size_t from = i > 0 ? i - 1 : 0, to = std::min(i + 1, points.size() - 1);
    while (to + 1 < points.size() && !(distance(points[from], points[to]) > 0)) ++to;
    while (from > 0 && !(distance(points[from], points[to]) > 0)) --from;
    return distance(points[from], points[to]) > 0 ? normalized(points[to] - points[from]) : Vec2{1, 0};
  }
};

/// Not what lies outside a window.
bool is_piece_of_trace(Vec2 a, Vec2 b) { return distance(a, b) < 2 * label_sizes.ink_step; }

/// Whether the segments have a point in common, which may be an end.
bool segments_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return cross(b - a, c - a) * cross(b - a, d - a) <= 0 && cross(d - c, a - c) * cross(d - c, b - c) <= 0;
}

struct Place {
  Vec2 foot;  ///< on the curve
  TextBox box;
  bool has_leader = false;

  /// The point of the box that is nearest to the foot.
  Vec2 leader_end() const {
    const Vec2 low = box.centre - box.half, high = box.centre + box.half;
    return {std::clamp(foot.x, low.x, high.x), std::clamp(foot.y, low.y, high.y)};
  }
};

class Labels {
 public:
  /// `owners`: by curve, the first one that the same label may name.
  Labels(Picture& picture, const CadFace& face, std::vector<int> owners)
      : picture_(picture), owners_(std::move(owners)), boxes_(picture.text_boxes()) {
    for (const Nurbs& curve : face.curves) traces_.emplace_back(picture, curve);
    for (const Trace& trace : traces_) ink_.insert(ink_.end(), trace.points.begin(), trace.points.end());
  }

  double length(int curve) const { return traces_[curve].length(); }
  /// Whether something of the curve is in the picture.
  bool is_seen(int curve) const { return !picture_.is_window() || picture_.holds(traces_[curve].points.front()); }

  /// Writes the text at the first free place beside the curve. Returns false if no place is free.
  bool write(int curve, const std::string& css_class, const std::string& text) {
    const std::optional<Place> place = free_place(curve, text);
    if (!place) return false;
    if (place->has_leader) draw_leader(*place);
    boxes_.push_back(place->box);
    picture_.text(place->box.centre, css_class, text);
    return true;
  }

 private:
  std::optional<Place> free_place(int curve, const std::string& text) const {
    const Trace& trace = traces_[curve];
    const Vec2 half{0.5 * (text_width(text, label_sizes.font) + label_sizes.padding), 0.5 * label_sizes.box_height};
    for (const double gap : {7.0, 12.0, 24.0, 40.0, 60.0, 85.0, 115.0, 150.0})
      for (const double fraction : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9})
        for (const double side : {-1.0, 1.0})  // the face is on the left
          for (const double turn : {0.0, 0.6, -0.6}) {
            const std::size_t i = trace.at(fraction);
            const Vec2 normal = side * left_of(trace.tangent(i));
            const Vec2 away = std::cos(turn) * normal + std::sin(turn) * left_of(normal);
            const double reach = half.x * std::abs(away.x) + half.y * std::abs(away.y);
            const Place place{
                trace.points[i], {trace.points[i] + (gap + reach) * away, half}, gap > label_sizes.shortest_leader};
            if (is_free(place, curve)) return place;
          }
    return std::nullopt;
  }

  bool is_free(const Place& place, int curve) const {
    const TextBox& box = place.box;
    if (picture_.is_window() && !picture_.holds(place.foot)) return false;
    const Vec2 size = picture_.size();
    const double room = picture_.is_window() ? 0 : 1;  // the labels of a window are inside
    if (box.centre.x - box.half.x < -room * label_sizes.side_room ||
        box.centre.x + box.half.x > size.x + room * label_sizes.side_room ||
        box.centre.y - box.half.y < -room * label_sizes.room_below ||
        box.centre.y + box.half.y > size.y + room * label_sizes.room_above)
      return false;
    if (std::any_of(boxes_.begin(), boxes_.end(), [&](const TextBox& b) { return b.overlaps(box); })) return false;
    if (std::any_of(ink_.begin(), ink_.end(), [&](Vec2 x) { return box.holds(x); })) return false;
    if (!place.has_leader) return is_nearest(box, curve);
    if (is_crossed(place)) return false;
    const std::vector<Vec2> leader = leader_points(place);
    return std::none_of(boxes_.begin(), boxes_.end(), [&](const TextBox& b) {
      return std::any_of(leader.begin(), leader.end(), [&](Vec2 x) { return b.holds(x); });
    });
  }

  /// Whether no curve of another label is nearer to this one, which would seem to be its. Curves that meet are equal.
  bool is_nearest(const TextBox& box, int curve) const {
    double own = HUGE_VAL, other = HUGE_VAL;
    for (std::size_t c = 0; c < traces_.size(); ++c) {
      const std::vector<Vec2>& points = traces_[c].points;
      double& least = owners_[c] == owners_[curve] ? own : other;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_piece = i > 0 && is_piece_of_trace(points[i - 1], points[i]);
        least = std::min(least, box.distance(points[is_piece ? i - 1 : i], points[i]));
      }
    }
    return own <= other + label_sizes.tied;
  }

  /// Whether the boundary passes between the label and its curve.
  bool is_crossed(const Place& place) const {
    const Vec2 start = place.foot + 0.5 * normalized(place.box.centre - place.foot);
    return std::any_of(traces_.begin(), traces_.end(), [&](const Trace& trace) {
      for (std::size_t i = 1; i < trace.points.size(); ++i) {
        const Vec2 a = trace.points[i - 1], b = trace.points[i];
        if (is_piece_of_trace(a, b) && segments_meet(start, place.box.centre, a, b)) return true;
      }
      return false;
    });
  }

  static std::vector<Vec2> leader_points(const Place& place) {
    const Vec2 end = place.leader_end();
    const int count = 1 + static_cast<int>(distance(place.foot, end) / label_sizes.ink_step);
    std::vector<Vec2> points;
    for (int i = 0; i <= count; ++i)
      points.push_back(place.foot + (i / static_cast<double>(count)) * (end - place.foot));
    return points;
  }

  void draw_leader(const Place& place) {
    const std::vector<Vec2> points = leader_points(place);
    PathData path;
    path.move_to(points.front());
    path.line_to(points.back());
    picture_.add(path_element("edge", path.str()));
    ink_.insert(ink_.end(), points.begin(), points.end() - 1);
  }

  Picture& picture_;
  std::vector<int> owners_;
  std::vector<Trace> traces_;
  std::vector<Vec2> ink_;       ///< points of the boundary and of the lines that labels must not cover
  std::vector<TextBox> boxes_;  ///< of texts
};

void draw_joints(Picture& picture, const CadFace& face) {
  for (const Joint& joint : face.joints)
    if (!joint.is_corner) picture.add(circle_mark("dot", picture.at(joint.position), 3, "end of a boundary curve"));
}

bool is_named(const CadFace& face, int curve) { return face.has_given_name(curve) && !face.curve_names[curve].empty(); }

/// An interface is labelled once, as the first of its two curves.
bool is_second_side(const CadFace& face, int curve) { return face.is_interface(curve) && face.partners[curve] < curve; }

/// By curve, the first one whose label is the same: that of its name, or of its number.
std::vector<int> label_owners(const CadFace& face, bool all) {
  std::vector<int> owners(face.curves.size());
  for (int c = 0; c < face.num_curves(); ++c) {
    const auto first = std::ranges::find(face.curve_names, face.curve_names[c]);
    const int by_number = is_second_side(face, c) ? face.partners[c] : c;
    owners[c] = all ? by_number : static_cast<int>(first - face.curve_names.begin());
  }
  return owners;
}

/// Curves from the shortest to the longest, which has the most places.
void sort_by_length(std::vector<int>& curves, const Labels& labels) {
  std::stable_sort(curves.begin(), curves.end(), [&](int a, int b) { return labels.length(a) < labels.length(b); });
}

/// Of each run of curves with one given name in a loop, the longest.
std::vector<int> longest_of_names(const CadFace& face, const Labels& labels) {
  std::vector<int> longest(face.curves.size(), -1);  // by the first curve of the run
  const std::vector<int> runs = name_runs(face);
  for (int c = 0; c < face.num_curves(); ++c) {
    if (runs[c] < 0) continue;
    int& known = longest[runs[c]];
    if (known < 0 || labels.length(c) > labels.length(known)) known = c;
  }
  std::erase(longest, -1);
  return longest;
}

int label_names(Labels& labels, const CadFace& face) {
  std::vector<int> curves = longest_of_names(face, labels);
  sort_by_length(curves, labels);
  const auto is_omitted = [&](int c) { return labels.is_seen(c) && !labels.write(c, "name", face.curve_names[c]); };
  return static_cast<int>(std::count_if(curves.begin(), curves.end(), is_omitted));
}

int label_all(Labels& labels, const CadFace& face) {
  std::vector<int> curves(face.curves.size());
  std::iota(curves.begin(), curves.end(), 0);
  sort_by_length(curves, labels);
  int num_omitted = 0;
  for (const int c : curves) {
    if (!labels.is_seen(c) || is_second_side(face, c)) continue;
    const std::string number = face.is_interface(c) ? fmt::format("{}/{}", c, face.partners[c]) : fmt::format("{}", c);
    const bool is_written = is_named(face, c) && labels.write(c, "label", number + ' ' + face.curve_names[c]);
    if (!is_written && !labels.write(c, "label", number)) ++num_omitted;
  }
  return num_omitted;
}

}  // namespace

std::vector<int> name_runs(const CadFace& face) {
  std::vector<int> runs(face.curves.size(), -1);
  for (int c = 0; c < face.num_curves(); ++c) {
    if (!is_named(face, c) || is_second_side(face, c)) continue;
    const auto continues = [&](int curve) {
      const int before = face.previous_in_loop(curve);
      return is_named(face, before) && face.curve_names[before] == face.curve_names[c];
    };
    int first = c;
    while (continues(first) && face.previous_in_loop(first) != c) first = face.previous_in_loop(first);
    runs[c] = continues(first) ? face.loop_offsets[face.loop_of(c)] : first;  // the whole loop has one name
  }
  return runs;
}

void label_curves(Picture& picture, const CadFace& face, CurveLabels which) {
  if (which == CurveLabels::none) return;
  const bool all = which == CurveLabels::all;
  label_regions(picture, face);
  if (all) draw_joints(picture, face);
  Labels labels(picture, face, label_owners(face, all));
  const int num_omitted = all ? label_all(labels, face) : label_names(labels, face);
  const std::string omitted =
      num_omitted > 0 ? fmt::format("without room for {}: raise --width", counted(num_omitted, "label")) : "";
  if (all)
    picture.legend_mark(circle_mark("dot", {0, 0}, 3),
                        "end of a curve; curves by number and name" + (omitted.empty() ? "" : ", " + omitted));
  else if (!omitted.empty())
    picture.legend_mark("", omitted);
}

}  // namespace quadrille::draw
