#include "draw/node_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/marks.hpp"

namespace quadrille::draw {

namespace {

// Pixels.
constexpr double node_radius = 10, ghost_radius = 7, corner_radius = 8, cluster_radius = 17, ring_radius = 14;

std::string cell_path(const std::string& css_class, const std::string& d, const std::string& title = {}) {
  return svg_element("path", {{"class", css_class}, {"d", d}}, title);
}

std::string outline(const Picture& picture, const CertificateCell& cell) {
  const auto& v = cell.vertices;
  PathData path;
  path.move_to(picture.at({v[0], v[1]}));
  path.line_to(picture.at({v[2], v[3]}));
  path.line_to(picture.at({v[4], v[5]}));
  path.close();
  return path.str();
}

/// Position and size of `mark` in the picture.
struct Spot {
  Vec2 at;
  double radius = 0;
};

Spot spot(const Picture& picture, const NodeMark& mark, double inside_radius) {
  return {picture.at(mark.position), mark.location == NodeLocation::inside     ? inside_radius
                                     : mark.location == NodeLocation::boundary ? node_radius
                                                                               : corner_radius};
}

const Spot& nearest(const std::vector<Spot>& spots, Vec2 x) {
  return *std::min_element(spots.begin(), spots.end(),
                           [&](const Spot& a, const Spot& b) { return distance(a.at, x) < distance(b.at, x); });
}

bool is_at_one_of(const std::vector<Spot>& spots, Vec2 x) {
  return std::any_of(spots.begin(), spots.end(), [&](const Spot& s) { return distance(s.at, x) < 0.5; });
}

/// An arrow between two marks, or a ring about the second if they are too close for one.
std::string arrow_between(const Spot& from, const Spot& to) {
  constexpr double gap = 2, shortest = 9;
  const double length = distance(from.at, to.at) - from.radius - to.radius - 2 * gap;
  if (!(length >= shortest)) return circle_mark("change", to.at, std::max(ring_radius, to.radius + 4));
  const Vec2 along = normalized(to.at - from.at);
  return arrow_mark(from.at + (from.radius + gap) * along, to.at - (to.radius + gap) * along);
}

std::vector<Spot> spots(const Picture& picture, const std::vector<NodeMark>& marks, double inside_radius) {
  std::vector<Spot> all;
  for (const NodeMark& mark : marks) all.push_back(spot(picture, mark, inside_radius));
  return all;
}

/// Draws an arrow from every mark before to the nearest one after, and to every remaining mark after. A mark that does
/// not move (a corner that absorbs a node) has no arrow.
std::string arrows(const std::vector<Spot>& before, const std::vector<Spot>& after) {
  std::string all;
  std::vector<Spot> reached;
  for (const Spot& from : before) {
    if (after.empty() || is_at_one_of(after, from.at)) continue;
    reached.push_back(nearest(after, from.at));
    all += arrow_between(from, reached.back());
  }
  for (const Spot& to : after) {
    if (is_at_one_of(reached, to.at) || is_at_one_of(before, to.at)) continue;
    all += before.empty() ? circle_mark("change", to.at, ring_radius) : arrow_between(nearest(before, to.at), to);
  }
  return all;
}

std::string cross_mark(Vec2 at) {
  constexpr double arm = 5;
  PathData path;
  path.move_to(at + Vec2{-arm, -arm});
  path.line_to(at + Vec2{arm, arm});
  path.move_to(at + Vec2{-arm, arm});
  path.line_to(at + Vec2{arm, -arm});
  return cell_path("change", path.str());
}

std::string change_marks(const Picture& picture, const NodeChange& change) {
  const std::vector<Spot> before = spots(picture, change.before, ghost_radius);
  const std::vector<Spot> after = spots(picture, change.after, node_radius);
  std::string all;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool was_node = change.before[i].location == NodeLocation::inside && !is_at_one_of(after, before[i].at);
    if (was_node) all += valence_outline(before[i].at, change.before[i].valence, ghost_radius);
    if (after.empty()) all += cross_mark(before[i].at);
  }
  return all + arrows(before, after);
}

}  // namespace

void draw_certificate(Picture& picture, const Certificate& certificate, const CadFace* face) {
  bool has_open = false, has_zero = false;
  const std::size_t num_discs = std::min(certificate.disc_centres.size(), certificate.disc_radii.size());
  if (certificate.cells.empty() && num_discs == 0) return;
  if (face)
    picture.open_clipped_group("certificate", face_outline(picture, *face));
  else
    picture.open_group("certificate");
  for (const CertificateCell& cell : certificate.cells) {
    const bool is_open = cell.verdict == CellVerdict::open;
    (is_open ? has_open : has_zero) = true;
    picture.add(cell_path(
        is_open ? "cell-open" : "cell-zero", outline(picture, cell),
        fmt::format("cell in element {}: {}", cell.elem, is_open ? "could not be decided" : "holds exactly one zero")));
  }
  for (std::size_t i = 0; i < num_discs; ++i)
    picture.add(circle_mark("disc", picture.at(certificate.disc_centres[i]),
                            picture.scale() * certificate.disc_radii[i],
                            fmt::format("left to the corner: radius {:.3g}", certificate.disc_radii[i])));
  picture.close_group();
  if (has_zero) picture.legend_mark(cell_path("cell-zero", "M-7 -5L7 -5L0 7z"), "cell with one zero");
  if (has_open) picture.legend_mark(cell_path("cell-open", "M-7 -5L7 -5L0 7z"), "undecided cell");
  if (num_discs > 0) picture.legend_mark(circle_mark("disc", {0, 0}, 7), "left to the corner");
}

void draw_clusters(Picture& picture, const std::vector<Cluster>& clusters, Vec2 origin) {
  for (const Cluster& cluster : clusters) {
    const Vec2 at = picture.at(cluster.centre);
    const double radius = std::max(cluster_radius, picture.scale() * cluster.radius);
    picture.add(circle_mark("cluster", at, radius,
                            fmt::format("cluster of index {} at {}, radius {:.3g}, {}", cluster.index,
                                        position_text(cluster.centre, origin), cluster.radius,
                                        counted(static_cast<int>(cluster.members.size()), "member"))));
    for (const Vec2 member : cluster.members) picture.add(circle_mark("member", picture.at(member), 2));
    picture.text(at + (radius + 12) * normalized({1, 1}), "label", fmt::format("{:+}", cluster.index));
  }
  if (!clusters.empty()) picture.legend_mark(circle_mark("cluster", {0, 0}, 7), "cluster and its index");
}

void draw_changes(Picture& picture, const std::vector<NodeChange>& changes) {
  bool has_ghost = false, has_cross = false;
  for (const NodeChange& change : changes) {
    picture.add(svg_element("g", {}, enum_name(change.kind) + ": " + change.reason, change_marks(picture, change)));
    for (const NodeMark& mark : change.before) has_ghost = has_ghost || mark.location == NodeLocation::inside;
    has_cross = has_cross || (change.after.empty() && !change.before.empty());
  }
  if (has_ghost) picture.legend_mark(valence_outline({0, 0}, 5, ghost_radius), "node before a change");
  if (has_cross) picture.legend_mark(cross_mark({0, 0}), "cancelled");
  if (!changes.empty()) picture.legend_mark(arrow_mark({-8, 0}, {8, 0}), "change");
}

}  // namespace quadrille::draw
