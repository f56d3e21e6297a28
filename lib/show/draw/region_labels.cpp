// The names of regions, where each has most room.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "draw/labels.hpp"

namespace quadrille::draw {

namespace {

/// Pixels.
constexpr double font_size = 13, half_region_height = 9, node_mark_radius = 12;  // of marks round texts

/// The loops of a region as polygons.
std::vector<std::vector<Vec2>> polygons(const CadFace& face, int region) {
  std::vector<std::vector<Vec2>> loops;
  const bool is_one = face.region_loops.empty();
  const int first = is_one ? 0 : face.region_loops[region],
            end = is_one ? face.num_loops() : face.region_loops[region + 1];
  for (int l = first; l < end; ++l) {
    std::vector<Vec2>& loop = loops.emplace_back();
    for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c)
      for (const Vec2 x : dense_points(face.curves[c], 16)) loop.push_back(x);
  }
  return loops;
}

/// Calls visit(a, b) for all sides.
template <typename Visit>
void for_each_side(const std::vector<std::vector<Vec2>>& loops, const Visit& visit) {
  for (const std::vector<Vec2>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
}

/// Positive inside, by the number of sides that a ray crosses; both sides of a slit cancel.
double signed_clearance(const std::vector<std::vector<Vec2>>& loops, Vec2 x) {
  bool is_inside = false;
  double clearance = std::numeric_limits<double>::infinity();
  for_each_side(loops, [&](Vec2 a, Vec2 b) {
    clearance = std::min(clearance, distance_to_segment(x, a, b));
    if ((a.y > x.y) != (b.y > x.y) && x.x < a.x + (x.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_inside = !is_inside;
  });
  return is_inside ? clearance : -clearance;
}

/// Whether a side passes through the box, whose centre is inside the region.
bool meets_side(const Picture& picture, const std::vector<std::vector<Vec2>>& loops, const TextBox& box) {
  bool meets = false;
  for_each_side(loops, [&](Vec2 a, Vec2 b) {
    const Vec2 from = picture.at(a), to = picture.at(b);
    const int num_steps = 1 + static_cast<int>(distance(from, to) / 4);
    for (int i = 0; i <= num_steps && !meets; ++i) meets = box.holds(from + (i / double(num_steps)) * (to - from));
  });
  return meets;
}

/// Those with nearly the greatest clearance come first, from the one nearest to the centre on; then the others by their
/// clearance. What is equal but for rounding keeps its order.
void sort_places(std::vector<RegionPlace>& places, Vec2 centre) {
  double greatest = 0;
  for (const RegionPlace& place : places) greatest = std::max(greatest, place.clearance);
  const auto rounded = [&](double length) { return std::round(1e6 * length / greatest); };
  const auto key = [&](const RegionPlace& place) {
    const bool is_best = place.clearance > 0.9 * greatest;
    return std::pair(is_best ? 0 : 1, rounded(is_best ? distance(place.position, centre) : -place.clearance));
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](const RegionPlace& a, const RegionPlace& b) { return key(a) < key(b); });
}

}  // namespace

std::vector<RegionPlace> region_places(const CadFace& face, int region) {
  constexpr int num_rows = 33;  // odd: with the centre of the region's box
  const std::vector<std::vector<Vec2>> loops = polygons(face, region);
  PictureBox box;
  for_each_side(loops, [&](Vec2 a, Vec2) { box.include(a); });
  std::vector<RegionPlace> places;
  for (int j = 1; j <= num_rows; ++j)
    for (int i = 1; i <= num_rows; ++i) {
      const Vec2 x{std::lerp(box.lower.x, box.upper.x, i / (num_rows + 1.0)),
                   std::lerp(box.lower.y, box.upper.y, j / (num_rows + 1.0))};
      if (const double clearance = signed_clearance(loops, x); clearance > 0) places.push_back({x, clearance});
    }
  sort_places(places, 0.5 * (box.lower + box.upper));
  return places;
}

void label_regions(Picture& picture, const CadFace& face) {
  constexpr std::size_t num_tries = 80;
  if (face.num_regions() == 1) return;
  for (int r = 0; r < face.num_regions(); ++r) {
    const std::string& name = face.region_names[r];
    const std::vector<std::vector<Vec2>> loops = polygons(face, r);
    const std::vector<RegionPlace> places = region_places(face, r);
    for (std::size_t i = 0; i < std::min(num_tries, places.size()); ++i) {
      const TextBox box{picture.at(places[i].position), {0.5 * text_width(name, font_size) + 3, half_region_height}};
      const std::vector<TextBox>& texts = picture.text_boxes();
      const TextBox with_room{box.centre,
                              box.half + Vec2{node_mark_radius, node_mark_radius}};  // texts may be inside of marks
      const bool is_covered =
          std::any_of(texts.begin(), texts.end(), [&](const TextBox& text) { return text.overlaps(with_room); });
      if (is_covered || places[i].clearance * picture.scale() < half_region_height || meets_side(picture, loops, box))
        continue;
      picture.text(box.centre, "region", name);
      break;
    }
  }
}

}  // namespace quadrille::draw
