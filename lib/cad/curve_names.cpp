#include "cad/curve_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/assign_names.hpp"
#include "base/error.hpp"
#include "curve/face_position.hpp"
#include "curve/project.hpp"

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

std::vector<int> curves_of_name(const CadFace& face, const std::string& name) {
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.curve_names[c] == name) curves.push_back(c);
  return curves;
}

std::vector<int> curve_of_number(const CadFace& face, int number) {
  return 0 <= number && number < face.num_curves() ? std::vector<int>{number} : std::vector<int>();
}

std::string known_curves(const CadFace& face) {
  std::vector<std::string> known;
  for (int c = 0; c < std::min(face.num_curves(), 20); ++c)
    known.push_back(fmt::format("{} \"{}\"", c, face.curve_names[c]));
  return fmt::format("the curves are {}{}", fmt::join(known, ", "), face.num_curves() > 20 ? ", ..." : "");
}

std::vector<int> nearest_curve(const CadFace& face, const NameRule& rule) {
  const Vec2 x = curve::face_position(face, rule.position, rule.where);
  const std::string text = fmt::format("({:.6g})", fmt::join(rule.position, ", "));
  std::vector<double> distances;
  for (const Nurbs& curve : face.curves) distances.push_back(curve::project(curve, x).distance);
  const double least = *std::min_element(distances.begin(), distances.end());
  if (!(least <= face.diameter))
    throw FormatError(fmt::format("{}: {} lies {:.3g} away from the boundary, whose diameter is {:.3g}", rule.where,
                                  text, least, face.diameter));
  std::vector<std::string> equals;
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c)
    if (distances[c] <= least + 1e-6 * face.diameter) {
      curves.push_back(c);
      equals.push_back(fmt::format("{} \"{}\"", c, face.curve_names[c]));
    }
  if (curves.size() > 1)
    throw FormatError(
        fmt::format("{}: {} is equally near to the curves {}", rule.where, text, fmt::join(equals, " and ")));
  return curves;
}

std::vector<int> curves_of(const CadFace& face, const NameRule& rule) {
  if (rule.kind == NameRule::Kind::position) return nearest_curve(face, rule);
  std::vector<int> curves;
  if (rule.kind == NameRule::Kind::key || rule.kind == NameRule::Kind::old_name)
    curves = curves_of_name(face, rule.text);
  if (curves.empty() && rule.kind != NameRule::Kind::old_name) curves = curve_of_number(face, rule.number);
  if (curves.empty())
    throw FormatError(fmt::format("{}: no boundary curve has this name or number; {}", rule.where, known_curves(face)));
  return curves;
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

void rename_curves(CadFace& face, const std::vector<NameRule>& rules) {
  std::vector<GivenName> given;
  for (const NameRule& rule : rules) {
    const bool is_for_rest = rule.kind == NameRule::Kind::rest;
    given.push_back({rule.name, is_for_rest ? std::vector<int>() : curves_of(face, rule), is_for_rest, rule.where});
  }
  const std::vector<int> named = assign_names(face.curve_names, given, "curve");
  std::erase_if(face.unnamed_curves, [&](int c) { return std::binary_search(named.begin(), named.end(), c); });
}

}  // namespace quadrille::cad
