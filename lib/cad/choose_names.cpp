#include "cad/choose_names.hpp"

#include <algorithm>

namespace quadrille::cad {
namespace {

std::vector<heal::RawEdge*> edges_of(heal::RawFace& raw) {
  std::vector<heal::RawEdge*> edges;
  for (auto& wire : raw.wires)
    for (heal::RawEdge& edge : wire) edges.push_back(&edge);
  return edges;
}

bool have_one_colour(const std::vector<heal::RawEdge*>& edges) {
  const auto alike = [&](const heal::RawEdge* e) { return e->colour == edges.front()->colour; };
  return edges.size() > 1 && std::all_of(edges.begin(), edges.end(), alike);
}

}  // namespace

void choose_names(heal::RawFace& raw) {
  const std::vector<heal::RawEdge*> edges = edges_of(raw);
  const auto is_on_face_layer = [&](const heal::RawEdge* e) { return e->layer == raw.layer; };
  const bool is_part_layer = std::any_of(edges.begin(), edges.end(), is_on_face_layer);
  const bool colours_tell = !have_one_colour(edges);
  for (heal::RawEdge* edge : edges) {
    if (edge->name.empty() && !is_on_face_layer(edge)) edge->name = edge->layer;
    if (edge->name.empty() && colours_tell && !edge->colour.empty()) edge->name = "colour_" + edge->colour;
  }
  if (raw.name.empty() && !is_part_layer) raw.name = raw.layer;
}

}  // namespace quadrille::cad
