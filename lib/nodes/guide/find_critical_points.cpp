#include "guide/find_critical_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "curve/face_boundary.hpp"
#include "field/error_estimate.hpp"
#include "guide/clusters.hpp"
#include "guide/complete_nodes.hpp"
#include "placement/node_ledger.hpp"
#include "surface/positions.hpp"
#include "zeros/undecided_zeros.hpp"

namespace quadrille::guide {
namespace {

/// The point xi clamped to the closed reference triangle: a zero on an edge may lie beyond it by round-off or its jump.
Vec2 clamped(Vec2 xi) {
  xi = {std::max(xi.x, -1.0), std::max(xi.y, -1.0)};
  const double excess = xi.x + xi.y;
  return excess > 0 ? Vec2{xi.x - excess / 2, xi.y - excess / 2} : xi;
}

CriticalPoint critical_point(const field::FieldEvaluator& evaluator, const zeros::FoundZero& zero) {
  const field::FieldSample s = evaluator.sample(zero.elem, zero.xi);
  const Mat2& j = s.dv_dx;
  const std::vector<double>& errors = evaluator.field().elem_error;
  const double diameter = evaluator.field().mesh.face.diameter;
  const double error = errors.empty() ? 0 : std::min(field::position_error(j, errors[zero.elem]), diameter);
  return {s.x, zero.index, 4 - zero.index, zero.elem, clamped(zero.xi), {j.xx, j.xy, j.yx, j.yy}, error};
}

std::vector<CriticalPoint> sorted_points(const field::FieldEvaluator& evaluator,
                                         const std::vector<zeros::FoundZero>& zeros) {
  std::vector<CriticalPoint> points;
  for (const zeros::FoundZero& zero : zeros) points.push_back(critical_point(evaluator, zero));
  sort_by_position(points, tolerance::same_point * evaluator.field().mesh.face.diameter,
                   [](const CriticalPoint& p) { return p.position; });
  return points;
}

template <typename Condition>
std::vector<zeros::FoundZero> filtered(const std::vector<zeros::FoundZero>& zeros, const Condition& holds) {
  std::vector<zeros::FoundZero> result;
  for (std::size_t i = 0; i < zeros.size(); ++i)
    if (holds(i)) result.push_back(zeros[i]);
  return result;
}

CertificateCell certificate_cell(int elem, const std::array<Vec2, 3>& p, CellVerdict verdict) {
  return {elem, {p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y}, verdict};
}

Certificate certificate_of(const zeros::SearchResult& search, const std::vector<zeros::FoundZero>& zeros,
                           const std::vector<zeros::Disc>& discs, int num_elems) {
  const zeros::SearchCounts& counts = search.counts;
  Certificate c;
  c.elements = num_elems;
  c.cells_examined = static_cast<double>(counts.examined);
  c.cells_excluded = static_cast<double>(counts.excluded);
  c.cells_isolated = static_cast<double>(counts.isolated);
  c.cells_left_to_corners = static_cast<double>(counts.ignored);
  c.greatest_depth = counts.greatest_depth;
  for (const zeros::FoundZero& zero : zeros)
    c.cells.push_back(certificate_cell(zero.elem, zero.cell, CellVerdict::zero));
  for (const zeros::OpenCell& cell : search.open_cells)
    c.cells.push_back(certificate_cell(cell.elem, cell.cell, CellVerdict::open));
  for (const zeros::Disc& disc : discs) {
    c.disc_centres.push_back(disc.centre);
    c.disc_radii.push_back(disc.radius);
  }
  return c;
}

void report_proof(const zeros::SearchResult& search, const CriticalPoints& points, Report& report) {
  const zeros::SearchCounts& counts = search.counts;
  report.set("critical_points", points.critical_points.size());
  report.set("corners", points.corners.size());
  report.set("clusters", points.clusters.size());
  report.set("index_sum.value", points.index_sum);
  report.set("index_sum.expected", points.index_sum_expected);
  report.set("proof.elements", points.certificate.elements);
  report.set("proof.cells_examined", counts.examined);
  report.set("proof.cells_excluded", counts.excluded);
  report.set("proof.cells_isolated", counts.isolated);
  report.set("proof.cells_left_to_corners", counts.ignored);
  report.set("proof.cells_open", search.open_cells.size());
  report.set("proof.greatest_depth", counts.greatest_depth);
}

/// Throws ComputeError if the search cannot decide.
zeros::SearchResult search_all(const field::FieldEvaluator& evaluator, const std::vector<zeros::Disc>& discs,
                               double noise, Progress* progress) {
  const TriMesh& mesh = evaluator.field().mesh;
  zeros::ZeroSearch search(evaluator, discs, noise);
  const Progress::Part elements(progress, "elements", mesh.num_elems());
  for (int e = 0; e < mesh.num_elems() && !search.is_budget_exhausted(); ++e, elements.advance()) search.search(e);
  zeros::require_decided(search, mesh.face);
  return search.take();
}

/// Warns of zeros that the field's error alone makes a cluster.
void warn_of_undecided(const Field& field, const std::vector<Cluster>& clusters, Report& report) {
  for (const Cluster& cluster : clusters) {
    if (!cluster.is_undecided) continue;
    std::string places;
    for (const Vec2 x : cluster.members)
      places += (places.empty() ? "" : ", ") + surface::position_text(field.mesh.face, x);
    report.warn(
        warning::zeros_not_decided,
        fmt::format(
            "the zeros at {} lie in one region in which the field is below its error, {:.2g}, so that it does not "
            "decide whether they exist: {}; look at the layout with stageview",
            places, zeros::undecided_below(field),
            cluster.index == 0 ? std::string("they cancel, and no node is put there")
                               : fmt::format("nodes of total index {} replace them", cluster.index)));
  }
}

void require_in(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw UsageError(fmt::format("{} is {}, it must be between {} and {}", name, value, low, high));
}

using zeros::FoundZero;

struct Near {
  int zero;
  double distance;
};

/// The corner nearest to x within reach; std::nullopt if no corner is within reach or two are equally near.
std::optional<std::size_t> nearest_corner(const std::vector<Corner>& corners, Vec2 x, double reach, double tol) {
  std::optional<std::size_t> nearest;
  double least = reach + tol;
  bool is_tie = false;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const double d = distance(corners[c].position, x);
    if (d > reach + tol) continue;
    is_tie = nearest && std::abs(d - least) <= tol;
    if (!nearest || d < least) nearest = c, least = d;
  }
  return is_tie ? std::nullopt : nearest;
}

/// The zeros that one corner may absorb.
using Candidates = std::vector<Near>;

/// Candidates of each corner, nearest first.
std::vector<Candidates> candidates_of(const CadFace& face, const std::vector<FoundZero>& zeros, double length,
                                      double tol, const std::vector<Corner>& corners) {
  const curve::FaceBoundary boundary(face);
  std::vector<Candidates> by_corner(corners.size());
  for (int i = 0; i < static_cast<int>(zeros.size()); ++i) {
    const auto c = nearest_corner(corners, zeros[i].x, length, tol);
    if (!c) continue;
    const Vec2 corner = corners[*c].position;
    if (boundary.is_visible(corner + 0.1 * (zeros[i].x - corner), zeros[i].x))  // off the corner's own sides
      by_corner[*c].push_back({i, distance(corner, zeros[i].x)});
  }
  for (Candidates& list : by_corner)
    std::stable_sort(list.begin(), list.end(), [](const Near& a, const Near& b) { return a.distance < b.distance; });
  return by_corner;
}

placement::NodeEdit edit_of(const std::vector<FoundZero>& zeros, Candidates::const_iterator first,
                            Candidates::const_iterator last, const Corner& corner, double length) {
  placement::NodeEdit edit;
  edit.kind = ChangeKind::absorb;
  edit.reason = fmt::format(
      "a node of valence {} is {:.3g} from the corner of {:.6g} degrees, less than the absorption distance {:.3g}",
      4 - zeros[first->zero].index, first->distance, corner.angle_degrees, length);
  edit.corners = {{corner.joint, corner.valence}};
  for (; first != last; ++first) {
    const FoundZero& zero = zeros[first->zero];
    edit.zeros.push_back({zero.x, 4 - zero.index, NodeLocation::inside});
    edit.corners[0].valence -= zero.index;
  }
  return edit;
}

/// Decides classes of equally near candidates of one corner, each class as a whole.
void absorb_into(std::size_t c, const std::vector<FoundZero>& zeros, const Candidates& candidates, double length,
                 double tol, std::vector<bool>& is_absorbed, CriticalPoints& points) {
  for (auto first = candidates.begin(); first != candidates.end();) {
    const auto last =
        end_of_ties(first, candidates.end(), tol, [](const Near& candidate) { return candidate.distance; });
    const placement::NodeEdit edit = edit_of(zeros, first, last, points.corners[c], length);
    if (is_admissible_after_absorption(points.corners[c].angle_degrees, edit.corners[0].valence)) {
      placement::apply({edit}, points);
      for (auto it = first; it != last; ++it) is_absorbed[it->zero] = true;
    }
    first = last;
  }
}

}  // namespace

void SearchOptions::validate() const {
  require_in("the cluster distance", cluster_distance, 0, 0.1);
  require_in("the length of corner absorption", corner_absorb, 0, 0.1);
  require_in("the noise", noise, 1e-14, 1e-2);
}

CriticalPoints find_critical_points(const field::FieldEvaluator& evaluator, const SearchOptions& options,
                                    CornerValences valences, const zeros::SearchResult& search, Report& report) {
  const TriMesh& mesh = evaluator.field().mesh;
  const CadFace& face = mesh.face;
  const std::vector<zeros::FoundZero> found = zeros::distinct_zeros(evaluator, search.zeros);
  const std::vector<zeros::FoundZero> zeros = filtered(found, [&](std::size_t i) {
    return std::none_of(valences.discs.begin(), valences.discs.end(),
                        [&](const zeros::Disc& disc) { return distance(disc.centre, found[i].x) <= disc.radius; });
  });

  CriticalPoints points;
  points.origin = face.origin;
  points.corners = std::move(valences.corners);
  const std::vector<bool> is_absorbed = absorb_into_corners(face, zeros, options.corner_absorb * face.diameter, points);
  const std::vector<zeros::FoundZero> free = filtered(zeros, [&](std::size_t i) { return !is_absorbed[i]; });
  Clustering clustering = find_clusters(evaluator, free, zeros::cells_without_zero(search.open_cells, zeros),
                                        {options.cluster_distance * face.diameter, options.noise});
  points.clusters = std::move(clustering.clusters);
  sort_by_position(points.clusters, tolerance::same_point * face.diameter, [](const Cluster& c) { return c.centre; });
  warn_of_undecided(evaluator.field(), points.clusters, report);
  points.critical_points = sorted_points(evaluator, clustering.simple);
  if (clustering.simple.size() != zeros.size()) points.zeros = sorted_points(evaluator, zeros);
  points.certificate = certificate_of(search, zeros, valences.discs, mesh.num_elems());
  points.index_sum = index_sum_with_clusters(points);
  points.index_sum_expected = 4 * face.euler_characteristic();
  report_proof(search, points, report);
  return points;
}

CriticalPoints find_critical_points(const field::FieldEvaluator& evaluator, const SearchOptions& options,
                                    CornerValences valences, Report& report) {
  const zeros::SearchResult search = search_all(evaluator, valences.discs, options.noise, report.progress());
  return find_critical_points(evaluator, options, std::move(valences), search, report);
}

CriticalPoints find_critical_points(const field::FieldEvaluator& evaluator, const SearchOptions& options,
                                    Report& report) {
  options.validate();
  return find_critical_points(evaluator, options, corner_valences(evaluator, options.noise), report);
}

std::vector<bool> absorb_into_corners(const CadFace& face, const std::vector<zeros::FoundZero>& zeros, double length,
                                      CriticalPoints& points) {
  std::vector<bool> is_absorbed(zeros.size(), false);
  if (length == 0) return is_absorbed;
  const double tol = tolerance::tied * length;
  const std::vector<Candidates> candidates = candidates_of(face, zeros, length, tol, points.corners);
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (points.corners[c].source != NodeSource::line)
      absorb_into(c, zeros, candidates[c], length, tol, is_absorbed, points);
  return is_absorbed;
}

}  // namespace quadrille::guide
