#include "export/vertex_stars.hpp"

#include <algorithm>

namespace quadrille::exports {

VertexStars::VertexStars(const QuadMesh& mesh)
    : numbering_(number_parts(mesh)), ends_(numbering_.edges.size(), {-1, -1}) {
  find_neighbours();
  std::vector<bool> is_done(across_.size(), false);  // by corner, 4 elem + corner
  for (int corner = 0; corner < static_cast<int>(across_.size()); ++corner)
    if (!is_done[corner]) add_star(corner, is_done);
}

void VertexStars::find_neighbours() {
  across_.assign(numbering_.elem2edges.size(), -1);
  for (int k = 0; k < static_cast<int>(across_.size()); ++k) {
    const NumberedEdge& edge = numbering_.edges[numbering_.elem2edges[k]];
    const int first = 4 * edge.elem + edge.edge;
    if (first != k) across_[k] = first, across_[first] = k;
  }
}

/// Corner c of an element lies between its sides c - 1 and c; the next one counter-clockwise is across side c - 1.
void VertexStars::add_star(int corner, std::vector<bool>& is_done) {
  const auto before = [](int k) { return k / 4 * 4 + (k + 3) % 4; };
  int first = corner;
  while (across_[first] >= 0) {  // clockwise, to the boundary or once round
    const int beyond = across_[first];
    first = beyond / 4 * 4 + (beyond + 1) % 4;
    if (first == corner) break;
  }
  VertexStar star;
  star.is_closed = across_[first] >= 0;
  int at = first;
  do {
    is_done[at] = true;
    star.edges.push_back(numbering_.elem2edges[at]);
    const int last = before(at);
    at = across_[last];
    if (at < 0) star.edges.push_back(numbering_.elem2edges[last]);
  } while (at >= 0 && at != first);
  for (const int edge : star.edges) ends_[edge][ends_[edge][0] < 0 ? 0 : 1] = static_cast<int>(stars_.size());
  stars_.push_back(std::move(star));
}

std::vector<int> VertexStars::missing_lines(int star, const std::vector<bool>& is_line) const {
  const std::vector<int>& edges = stars_[star].edges;
  const auto count = static_cast<int>(edges.size());
  const auto first = std::find_if(edges.begin(), edges.end(), [&](int edge) { return is_line[edge]; });
  std::vector<int> missing;
  if (first == edges.end()) {
    for (int k = 0; k < count && count != 4; k += 2) missing.push_back(edges[k]);
    return missing;
  }
  const auto start = static_cast<int>(first - edges.begin());
  int run = 0;  // edges since the last line
  for (int k = 1; k < count; ++k) {
    const int edge = edges[(start + k) % count];
    run = is_line[edge] ? 0 : run + 1;
    if (run == 2) missing.push_back(edge), run = 0;
  }
  return missing;
}

int VertexStars::deficit(int star, const std::vector<bool>& is_line) const {
  return static_cast<int>(missing_lines(star, is_line).size());
}

int VertexStars::straight_on(int star, int edge, const std::vector<bool>& is_line) const {
  const VertexStar& at = stars_[star];
  if (!at.is_closed || at.edges.size() != 4) return -1;
  if (std::any_of(at.edges.begin(), at.edges.end(), [&](int other) { return is_line[other]; })) return -1;
  const auto here = std::find(at.edges.begin(), at.edges.end(), edge);
  return at.edges[(here - at.edges.begin() + 2) % 4];
}

}  // namespace quadrille::exports
