#include "outline/extent.hpp"

#include <algorithm>
#include <cmath>

#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::outline {
namespace {

struct Sample {
  int curve;
  double t, low, high;  ///< parameters of the sample and of its neighbours
  Vec2 x;
};

std::vector<Sample> sampled(const std::vector<Nurbs>& loop) {
  std::vector<Sample> samples;
  for (int c = 0; c < static_cast<int>(loop.size()); ++c) {
    const Nurbs& curve = loop[c];
    std::vector<double> t{curve.begin()};
    const int spans = static_cast<int>(curve.poles.size()) - curve.degree;
    const int per_span = curve.degree == 1 ? 1 : std::max(4, 64 / spans);
    for (size_t k = 1; k < curve.knots.size(); ++k)
      for (int j = 1; j <= per_span && curve.knots[k - 1] < curve.knots[k]; ++j)
        t.push_back(curve.knots[k - 1] + (curve.knots[k] - curve.knots[k - 1]) * j / per_span);
    for (size_t i = 0; i < t.size(); ++i)
      samples.push_back({c, t[i], t[i == 0 ? 0 : i - 1], t[std::min(i + 1, t.size() - 1)], curve::point(curve, t[i])});
  }
  return samples;
}

// Convex hull (monotone chain), counter-clockwise: it contains the farthest pair.
std::vector<Sample> hull(std::vector<Sample> points) {
  std::stable_sort(points.begin(), points.end(),
                   [](const Sample& a, const Sample& b) { return a.x.x < b.x.x || (a.x.x == b.x.x && a.x.y < b.x.y); });
  std::vector<Sample> result;
  for (int pass = 0; pass < 2; ++pass) {
    const size_t base = result.size();
    for (const Sample& p : points) {
      while (result.size() >= base + 2 &&
             cross(result.back().x - result[result.size() - 2].x, p.x - result.back().x) <= 0)
        result.pop_back();
      result.push_back(p);
    }
    result.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return result;
}

// Moves the sample to the point of its curve, between its neighbours, that is farthest from x.
void go_farthest(const Nurbs& curve, Sample& s, Vec2 x) {
  double low = s.low, high = s.high, t = s.t;
  for (int i = 0; i < 60 && low < high; ++i) {
    const auto d = curve::derivatives(curve, t);
    const Vec2 r = d[0] - x;
    const double f = dot(r, d[1]), slope = norm2(d[1]) + dot(r, d[2]);
    if (f == 0) break;
    (f > 0 ? low : high) = t;
    const double next = slope < 0 && i % 8 != 7 ? std::clamp(t - f / slope, low, high) : (low + high) / 2;
    if (std::abs(next - t) <= 1e-15 * (curve.end() - curve.begin())) break;
    t = next;
  }
  s.t = t;
  s.x = curve::point(curve, t);
}

double refined(const std::vector<Nurbs>& loop, Sample a, Sample b) {
  double best = distance(a.x, b.x);
  for (int i = 0; i < 100; ++i) {
    go_farthest(loop[a.curve], a, b.x);
    go_farthest(loop[b.curve], b, a.x);
    const double now = distance(a.x, b.x);
    if (now <= best * (1 + 1e-16)) break;
    best = now;
  }
  return best;
}

}  // namespace

double signed_area(const std::vector<Nurbs>& loop) {
  // Coordinates relative to a point of the loop: far from the origin the products would cancel.
  const Vec2 centre = loop.front().poles.front();
  double area = 0;
  for (const Nurbs& curve : loop)
    for (size_t k = 1; k < curve.knots.size(); ++k)
      if (curve.knots[k - 1] < curve.knots[k])
        area += curve::gauss_integral(
            [&](double t) {
              const auto d = curve::derivatives(curve, t);
              return cross(d[0] - centre, d[1]) / 2;
            },
            curve.knots[k - 1], curve.knots[k]);
  return area;
}

double area(const CadFace& face) {
  double area = 0;
  for (int l = 0; l < face.num_loops(); ++l)
    area += signed_area({face.curves.begin() + face.loop_offsets[l], face.curves.begin() + face.loop_offsets[l + 1]});
  return area;
}

double diameter(const std::vector<Nurbs>& loop) {
  const std::vector<Sample> points = hull(sampled(loop));
  const int n = static_cast<int>(points.size());
  const auto d2 = [&](int i, int j) { return norm2(points[(i + n) % n].x - points[(j + n) % n].x); };
  struct Pair {
    int i, j;
    double d2;
  };
  // Local maxima of the distance among sampled pairs: the farthest sampled pair need not be next to the global maximum.
  std::vector<Pair> pairs;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      const double d = d2(i, j);
      if (d >= d2(i - 1, j) && d >= d2(i + 1, j) && d >= d2(i, j - 1) && d >= d2(i, j + 1)) pairs.push_back({i, j, d});
    }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.d2 > b.d2; });
  if (pairs.size() > 24) pairs.resize(24);
  double best = 0;
  for (const Pair& p : pairs) best = std::max(best, refined(loop, points[p.i], points[p.j]));
  return best;
}

}  // namespace quadrille::outline
