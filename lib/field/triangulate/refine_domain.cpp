#include "triangulate/refine_domain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "surface/positions.hpp"

namespace quadrille::triangulate {
namespace {

struct RefinementLimits {
  /// A point encroaches on a segment if it sees the segment at an angle above 107 degrees: cos = -0.3.
  double encroached_cosine = -0.3;
  /// Greatest ratio of circumradius to shortest edge: 1.4 means a least angle of 21 degrees.
  double thin_ratio = 1.4;
  /// Greatest ratio of circumradius to size; an equilateral triangle whose edges have the prescribed size has 0.577.
  double large_ratio = 0.75;
  /// Thin triangles and encroached segments below this fraction of the size are not refined, so that refinement
  /// terminates.
  double least_size = 0.2;
  int max_rounds = 200;
};
constexpr RefinementLimits refinement;

bool encroaches(Vec2 x, Vec2 a, Vec2 b) {
  const Vec2 to_a = a - x, to_b = b - x;
  return dot(to_a, to_b) <= refinement.encroached_cosine * norm(to_a) * norm(to_b);
}

struct Circle {
  Vec2 centre;
  double radius = 0;
};

Circle circumcircle(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 p = b - a, q = c - a;
  const double twice_area = 2 * cross(p, q);
  const Vec2 offset{(q.y * norm2(p) - p.y * norm2(q)) / twice_area, (p.x * norm2(q) - q.x * norm2(p)) / twice_area};
  return {a + offset, norm(offset)};
}

}  // namespace

DomainRefiner::DomainRefiner(BoundaryMesh& boundary, Draft& draft, double size, double growth,
                             const std::vector<SizePoint>& size_points)
    : boundary_(&boundary), draft_(&draft), sizes_(boundary.segments(), size, growth, size_points) {
  for (const Segment& segment : boundary.segments()) {
    add_point(segment.from);
    add_point(segment.to);
  }
  int i = 0;
  for (const Segment& segment : boundary.segments()) {
    constrain(segment);
    vertices2segment_[{segment.from, segment.to}] = i++;
  }
}

int DomainRefiner::add_point(int draft_vertex) {
  vertex2point_.resize(std::max<std::size_t>(vertex2point_.size(), draft_vertex + 1), -1);
  if (vertex2point_[draft_vertex] >= 0) return vertex2point_[draft_vertex];
  const int point = delaunay_.insert(draft_->vertices[draft_vertex]);
  if (point < static_cast<int>(point2vertex_.size())) {
    throw ComputeError("two points of the boundary coincide at " +
                       surface::position_text(boundary_->face(), draft_->vertices[draft_vertex]) +
                       ": draw its parts further apart there");
  }
  point2vertex_.push_back(draft_vertex);
  vertex2point_[draft_vertex] = point;
  return point;
}

void DomainRefiner::constrain(const Segment& segment) {
  if (delaunay_.constrain(vertex2point_[segment.from], vertex2point_[segment.to], boundary_->is_inner(segment))) return;
  throw ComputeError(
      fmt::format("the chords of two parts of the boundary cross near {}, one of them {:.2g} long: draw these "
                  "parts further apart, or give a smaller --size",
                  surface::position_text(boundary_->face(), segment.centre), segment.length()));
}

void DomainRefiner::split(int segment) {
  const Segment whole = boundary_->segments()[segment];
  delaunay_.release(vertex2point_[whole.from], vertex2point_[whole.to]);
  vertices2segment_.erase({whole.from, whole.to});
  add_point(boundary_->split(segment));
  const int second = static_cast<int>(boundary_->segments().size()) - 1;
  for (const int half : {segment, second}) {
    const Segment& part = boundary_->segments()[half];
    vertices2segment_[{part.from, part.to}] = half;
    constrain(part);
  }
}

bool DomainRefiner::split_between(int from, int to) {
  const int segment = segment_between(from, to);
  if (segment < 0 || boundary_->segments()[segment].is_rim()) return false;
  split(segment);
  return true;
}

int DomainRefiner::segment_between(int from, int to) const {
  for (const auto& ends : {std::pair(from, to), std::pair(to, from)})
    if (const auto found = vertices2segment_.find(ends); found != vertices2segment_.end()) return found->second;
  return -1;
}

bool DomainRefiner::may_split(int segment) const {
  const Segment& s = boundary_->segments()[segment];
  return !s.is_rim() && s.length() > refinement.least_size * sizes_.at(s.samples[2]);
}

bool DomainRefiner::split_encroached(const Triangles& triangles) {
  std::vector<int> marked;
  std::set<int> seen;  // a slit has triangles on both sides
  for (const DelaunayTriangle& triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      if (triangle.neighbors[k] >= 0) continue;
      const int a = triangle.vertices[k], b = triangle.vertices[(k + 1) % 3], c = triangle.vertices[(k + 2) % 3];
      if (!encroaches(position(c), position(a), position(b))) continue;
      const int segment = segment_between(point2vertex_[a], point2vertex_[b]);
      if (may_split(segment) && seen.insert(segment).second) marked.push_back(segment);
    }
  }
  for (const int segment : marked) split(segment);
  return !marked.empty();
}

DomainRefiner::Candidates DomainRefiner::candidates(const Triangles& triangles) {
  Candidates result;
  std::vector<Candidate>& found = result.all;
  std::vector<std::array<int, 3>> good;
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
    const auto& [p, q, r] = triangles[i].vertices;
    if (std::binary_search(good_.begin(), good_.end(), triangles[i].vertices)) {
      good.push_back(triangles[i].vertices);
      continue;
    }
    const Vec2 a = position(p), b = position(q), c = position(r);
    const Circle circle = circumcircle(a, b, c);
    const double size = sizes_.at((a + b + c) / 3);
    const double shortest = std::min({distance(a, b), distance(b, c), distance(c, a)});
    const bool is_large = circle.radius > refinement.large_ratio * size;
    const bool is_thin = circle.radius > refinement.thin_ratio * shortest && shortest > refinement.least_size * size;
    if (is_large || is_thin) {
      found.push_back({circle.centre, circle.radius, i, is_thin});
      const double excess = circle.radius / (refinement.large_ratio * size);
      result.num_triangles += std::max(1.0, excess * excess);
    } else {
      good.push_back(triangles[i].vertices);
    }
  }
  result.num_triangles += static_cast<double>(good.size());
  good_ = std::move(good);
  // Largest first; candidates that are equal up to rounding keep the order of the triangles.
  const auto rank = [](const Candidate& c) { return std::llround(std::log(c.circumradius) * 1e6); };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Candidate& a, const Candidate& b) { return rank(a) > rank(b); });
  return result;
}

void DomainRefiner::find_blockers(const Triangles& triangles, const Candidate& candidate,
                                  std::vector<int>& blockers) const {
  blockers.clear();
  int here = candidate.triangle;
  for (std::size_t step = 0; step < triangles.size(); ++step) {
    const DelaunayTriangle& triangle = triangles[here];
    int exit = -1;
    double farthest = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = position(triangle.vertices[k]), b = position(triangle.vertices[(k + 1) % 3]);
      const double outside = cross(candidate.centre - a, b - a) / norm(b - a);
      if (outside > farthest) exit = k, farthest = outside;
    }
    if (exit < 0) break;
    if (triangle.neighbors[exit] < 0) {
      const int a = triangle.vertices[exit], b = triangle.vertices[(exit + 1) % 3];
      blockers.push_back(segment_between(point2vertex_[a], point2vertex_[b]));
      return;
    }
    here = triangle.neighbors[exit];
  }
  const auto& segments = boundary_->segments();
  for (int i = 0; i < static_cast<int>(segments.size()); ++i) {
    const Segment& s = segments[i];
    if (norm2(candidate.centre - s.centre) > s.radius * s.radius) continue;
    if (encroaches(candidate.centre, s.samples.front(), s.samples.back())) blockers.push_back(i);
  }
}

bool DomainRefiner::insert_centres(const Triangles& triangles, Progress* progress) {
  std::vector<Vec2> accepted;
  std::vector<int> blockers, marked;
  const Candidates found = candidates(triangles);
  const Progress::Part part(progress, "triangles", std::llround(found.num_triangles));
  part.advance(std::ssize(triangles));
  for (const Candidate& candidate : found.all) {
    // An accepted centre inside the circumcircle of this triangle changes the triangle: it is re-examined in the next
    // round.
    const bool is_disturbed = std::any_of(accepted.begin(), accepted.end(), [&](Vec2 x) {
      return distance(x, candidate.centre) < candidate.circumradius * (1 - 1e-6);
    });
    if (is_disturbed) continue;
    find_blockers(triangles, candidate, blockers);
    if (blockers.empty()) {
      accepted.push_back(candidate.centre);
    } else if (candidate.is_thin) {
      for (const int segment : blockers)
        if (may_split(segment)) marked.push_back(segment);
    }
  }
  for (const Vec2 x : accepted) add_point(draft_->add_vertex(x));
  std::sort(marked.begin(), marked.end());
  marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
  for (const int segment : marked) split(segment);
  return !accepted.empty() || !marked.empty();
}

void DomainRefiner::refine(Progress* progress) {
  const Progress::Part part(progress, "refinements", refinement.max_rounds, Progress::Total::bound);
  for (int round = 0; round < refinement.max_rounds; ++round, part.advance()) {
    const Triangles triangles = delaunay_.triangles();
    if (!split_encroached(triangles) && !insert_centres(triangles, progress)) return;
  }
}

std::vector<std::array<int, 3>> DomainRefiner::triangles() const {
  std::vector<std::array<int, 3>> result;
  for (const DelaunayTriangle& triangle : delaunay_.triangles()) {
    const auto& [a, b, c] = triangle.vertices;
    result.push_back({point2vertex_[a], point2vertex_[b], point2vertex_[c]});
  }
  return result;
}

}  // namespace quadrille::triangulate
