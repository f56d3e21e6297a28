#include "refine/even_vertices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "curve/named_places.hpp"

namespace quadrille::refine {
namespace {

constexpr double same_length = 1e-6;  ///< of elements, over their mean

/// The vertices of a loop as they slide to equal lengths.
class EvenLoop {
 public:
  EvenLoop(const RelaxProblem& problem, const VertexMoves& moves, int loop)
      : problem_(problem), total_(problem.boundary.loop_length(loop)) {
    const std::vector<SlidingVertex>& all = problem.boundary.vertices();
    for (int b = 0; b < std::ssize(all); ++b)
      if (all[b].loop == loop) vertices_.push_back({all[b].length + problem.follow.slide(b, moves), b});
    for (OnLoop& v : vertices_) v.length -= total_ * std::floor(v.length / total_);
    std::ranges::stable_sort(vertices_, {}, &OnLoop::length);
    const CadFace& face = problem.start.face;
    for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
      first_.push_back(nearest(problem.boundary.curve_start(c)));
  }

  /// Adds the vertices of curve number `curve` of the loop, which starts and ends at these lengths, that are not done.
  /// Returns whether that is possible.
  bool add(int curve, double start, double length, std::vector<bool>& is_done, std::vector<HeldVertex>& found) const;

 private:
  struct OnLoop {
    double length = 0;  ///< along the loop, at least 0 and less than the whole
    int vertex = 0;     ///< of the boundary
  };
  int nearest(double length) const;
  double slide(const OnLoop& v, double length) const { return std::remainder(length - v.length, total_); }

  const RelaxProblem& problem_;
  double total_;
  std::vector<OnLoop> vertices_;
  std::vector<int> first_;  ///< of each curve
};

int EvenLoop::nearest(double length) const {
  int best = 0;
  for (int v = 1; v < std::ssize(vertices_); ++v)
    if (std::abs(slide(vertices_[v], length)) < std::abs(slide(vertices_[best], length))) best = v;
  return best;
}

bool EvenLoop::add(int curve, double start, double length, std::vector<bool>& is_done,
                   std::vector<HeldVertex>& found) const {
  const int count = static_cast<int>(vertices_.size()), num_curves = static_cast<int>(first_.size());
  const int first = first_[curve], past = (first_[(curve + 1) % num_curves] - first + count) % count;
  const int num_edges = num_curves == 1 ? count : past;
  if (num_edges == 0) return false;
  const auto vertex = [&](int k) { return problem_.follow.vertex_of(vertices_[(first + k) % count].vertex); };
  const auto is_settled = [&](int k) { return is_done[vertex(k)]; };
  bool is_copy = num_edges > 1;  // the other side of an interface
  for (int k = 1; k < num_edges; ++k) is_copy &= is_settled(k);
  for (int k = 0; k <= num_edges && !is_copy; ++k) {
    const OnLoop& v = vertices_[(first + k) % count];
    const double slide = this->slide(v, start + length * k / num_edges);
    if (is_settled(k)) continue;
    if (problem_.is_fixed[vertex(k)] && std::abs(slide) > tolerance::round_off * problem_.start.face.diameter)
      return false;
    is_done[vertex(k)] = true;
    if (!problem_.is_fixed[vertex(k)]) found.push_back({vertex(k), problem_.follow.direction(v.vertex) * slide});
  }
  return true;
}

}  // namespace

std::optional<std::vector<HeldVertex>> even_vertices(const RelaxProblem& problem, const VertexMoves& moves,
                                                     const std::vector<bool>& is_even) {
  std::vector<HeldVertex> found;
  if (is_even.empty()) return found;
  const CadFace& face = problem.start.face;
  std::vector<bool> is_done(problem.num_vertices(), false);
  for (int l = 0; l < face.num_loops(); ++l) {
    const auto begin = is_even.begin() + face.loop_offsets[l], end = is_even.begin() + face.loop_offsets[l + 1];
    if (std::none_of(begin, end, [](bool is) { return is; })) continue;
    const EvenLoop loop(problem, moves, l);
    for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c)
      if (is_even[c] && !loop.add(c - face.loop_offsets[l], problem.boundary.curve_start(c),
                                  problem.boundary.curve_length(c), is_done, found))
        return std::nullopt;
  }
  for (std::size_t i = 0, count = found.size(); i < count; ++i)  // those that slide together with one of them
    if (const int twin = problem.twin(found[i].vertex); twin >= 0 && !is_done[twin])
      found.push_back({twin, -found[i].slide});
  return found;
}

std::vector<int> vertices_on(const RelaxProblem& problem, const std::vector<bool>& is_even) {
  std::vector<int> found;
  for (int e = 0; !is_even.empty() && e < std::ssize(problem.boundary.edges()); ++e) {
    if (!is_even[problem.boundary.edge_middle(e, 0, 0).curve]) continue;
    const SlidingEdge& edge = problem.boundary.edges()[e];
    for (const int end : {edge.from, edge.to}) found.push_back(problem.follow.vertex_of(end));
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

namespace {

/// The greatest difference of the lengths of edges along one of the curves, over their mean.
double unevenness(const BoundarySlide& slide, const std::vector<bool>& is_even) {
  std::vector<std::vector<double>> lengths(is_even.size());
  for (int e = 0; e < std::ssize(slide.edges()); ++e) {
    const SlidingVertex &from = slide.vertices()[slide.edges()[e].from], &to = slide.vertices()[slide.edges()[e].to];
    const double length = to.length - from.length, total = slide.loop_length(from.loop);
    lengths[slide.edge_middle(e, 0, 0).curve].push_back(length > 0 ? length : length + total);
  }
  double greatest = 0;
  for (std::size_t c = 0; c < is_even.size(); ++c) {
    if (!is_even[c] || lengths[c].empty()) continue;
    const auto [least, most] = std::ranges::minmax(lengths[c]);
    const double mean = slide.curve_length(static_cast<int>(c)) / static_cast<double>(lengths[c].size());
    greatest = std::max(greatest, (most - least) / mean);
  }
  return greatest;
}

}  // namespace

void report_even_counts(const QuadMesh& mesh, const std::vector<prescribe::BoundaryCount>& boundaries, Report& report) {
  if (std::ranges::none_of(boundaries, &prescribe::BoundaryCount::is_even)) return;
  const BoundarySlide slide(mesh);
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    if (!boundaries[i].is_even) continue;
    const double uneven = unevenness(slide, prescribe::even_curves(mesh.face, {boundaries[i]}));
    report.set(fmt::format("counts.{}.unevenness", i), uneven);
    if (uneven <= same_length) continue;
    report.warn(warning::uneven_count,
                fmt::format("--count {0}={1},even: elements along one curve of '{0}' differ by {2:.3g} % of their mean "
                            "length: its vertices could not slide there, because of layers that end on it, of bends "
                            "inside elements or of elements that would not be valid: use another number, a greater "
                            "--geometry-tol, or no layers there",
                            boundaries[i].boundary, boundaries[i].count, 100 * uneven));
  }
}

void require_even_alone(const CadFace& face, const RefineOptions& options, const std::vector<sizing::NearSize>& near) {
  const std::vector<bool> is_even = prescribe::even_curves(face, options.boundary_counts);
  if (is_even.empty()) return;
  if (face.chart)
    throw UsageError("--count NAME=N,even: the face is curved, and equal lengths in space are not made: write NAME=N");
  const auto require_free = [&](const std::string& option, const std::string& name) {
    for (const int c : curve::named_curves(face, name, option))
      if (is_even[c])
        throw UsageError(
            fmt::format("{} {}: --count prescribes elements of equal length (even) along this boundary: "
                        "leave out one of the two",
                        option, name));
  };
  for (const sizing::NearSize& size : near) require_free("--size-near", size.boundary);
  for (const prescribe::EndGrading& grading : options.end_gradings) require_free("--grading", grading.boundary);
  for (const layers::WallSpec& wall : options.walls)
    for (const std::string& name : wall.names) require_free("--wall", name);
}

}  // namespace quadrille::refine
