#include "cad/curve_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/number_list.hpp"
#include "base/warning_codes.hpp"
#include "curve/named_places.hpp"
#include "curve/select_curves.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::cad {

namespace {

std::vector<heal::RawEdge*> edges_of(heal::RawFace& raw) {
  std::vector<heal::RawEdge*> edges;
  for (auto& wire : raw.wires)
    for (heal::RawEdge& edge : wire) edges.push_back(&edge);
  for (heal::RawEdge& edge : raw.inner_edges) edges.push_back(&edge);
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

/// The names, after the one that `text` may stand for.
std::string known_curves(const CadFace& face, const std::string& text = {}) {
  std::vector<std::string> known;
  for (int c = 0; c < std::min(face.num_curves(), 20); ++c)
    known.push_back(fmt::format("{} \"{}\"", c, face.curve_names[c]));
  return fmt::format("{}; the curves are {}{}", text.empty() ? "" : did_you_mean(text, face.curve_names),
                     fmt::join(known, ", "), face.num_curves() > 20 ? ", ..." : "");
}

std::vector<int> nearest_curve(const CadFace& face, const NameRule& rule) {
  const std::vector<double> distances = curve::curve_distances(face, rule.position, rule.where);
  const std::string text = fmt::format("({:.6g})", fmt::join(rule.position, ", "));
  const double diameter = face.chart ? surface::diameter(*face.chart) : face.diameter;
  const double least = *std::min_element(distances.begin(), distances.end());
  if (!(least <= rule.max_distance * diameter))
    throw FormatError(fmt::format("{}: {} lies {:.3g} away from the boundary, whose diameter is {:.3g}{}", rule.where,
                                  text, least, diameter,
                                  rule.max_distance < 1 ? fmt::format(" (at most {} of it)", rule.max_distance) : ""));
  std::vector<std::string> equals;
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c)
    if (distances[c] <= least + 1e-6 * diameter && !(face.is_interface(c) && face.partners[c] < c)) {
      curves.push_back(c);
      equals.push_back(fmt::format("{} \"{}\"", c, face.curve_names[c]));
    }
  if (curves.size() > 1)
    throw FormatError(
        fmt::format("{}: {} is equally near to the curves {}", rule.where, text, fmt::join(equals, " and ")));
  return curves;
}

bool is_in_part(const CadFace& face, int curve, NameRule::Part part) {
  return part == NameRule::Part::any || face.is_interface(curve) == (part == NameRule::Part::interface);
}

std::vector<int> curves_of_pattern(const CadFace& face, const NameRule& rule) {
  std::vector<int> curves = curve::selected_curves(face, rule.text, rule.where);
  std::erase_if(curves, [&](int c) { return !is_in_part(face, c, rule.part); });
  if (curves.empty())
    throw FormatError(fmt::format("{}: no {} {} {}{}", rule.where,
                                  rule.part == NameRule::Part::interface ? "interface" : "boundary curve",
                                  rule.text.ends_with(')') ? "fits" : "has the name", rule.text,
                                  known_curves(face, rule.part == NameRule::Part::any ? rule.text : "")));
  return curves;
}

/// All that a rule for the rest may name.
std::vector<int> curves_of_rest(const CadFace& face, const NameRule& rule) {
  std::vector<int> curves;
  const NameRule::Part part = rule.part == NameRule::Part::any ? NameRule::Part::boundary : rule.part;
  for (int c = 0; c < face.num_curves(); ++c)
    if (is_in_part(face, c, part)) curves.push_back(c);
  if (curves.empty()) throw FormatError(rule.where + ": the face has no interface, nor a curve inside it");
  return curves;
}

std::vector<int> curves_of_range(const CadFace& face, const NameRule& rule) {
  if (rule.last_number >= face.num_curves())
    throw FormatError(fmt::format("{}: no boundary curve has the number {}{}", rule.where,
                                  std::max(rule.number, face.num_curves()), known_curves(face)));
  std::vector<int> curves;
  for (int c = rule.number; c <= rule.last_number; ++c) curves.push_back(c);
  return curves;
}

std::vector<int> curves_of(const CadFace& face, const NameRule& rule) {
  if (rule.kind == NameRule::Kind::position) return nearest_curve(face, rule);
  if (rule.kind == NameRule::Kind::pattern) return curves_of_pattern(face, rule);
  if (rule.kind == NameRule::Kind::range) return curves_of_range(face, rule);
  if (rule.kind == NameRule::Kind::rest) return curves_of_rest(face, rule);
  std::vector<int> curves;
  if (rule.kind == NameRule::Kind::key) curves = curve::selected_curves(face, rule.text, rule.where);
  if (rule.kind == NameRule::Kind::old_name) curves = curves_of_name(face, rule.text);
  if (curves.empty() && rule.kind != NameRule::Kind::old_name) curves = curve_of_number(face, rule.number);
  if (curves.empty())
    throw FormatError(
        fmt::format("{}: no boundary curve has this name or number{}", rule.where, known_curves(face, rule.text)));
  return curves;
}

/// With the other sides of common curves.
std::vector<int> with_partners(const CadFace& face, std::vector<int> curves) {
  for (size_t i = 0, count = curves.size(); i < count; ++i)
    if (face.is_interface(curves[i])) curves.push_back(face.partners[curves[i]]);
  std::sort(curves.begin(), curves.end());
  curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
  return curves;
}

/// A boundary condition does not apply to an interface: one name for both is probably a mistake.
void warn_of_both_kinds(const CadFace& face, const NameRule& rule, const std::vector<int>& curves, Report& report) {
  const auto num_sides = std::count_if(curves.begin(), curves.end(), [&](int c) { return face.is_interface(c); });
  const auto num_outer = static_cast<std::ptrdiff_t>(curves.size()) - num_sides;
  if (num_sides == 0 || num_outer == 0) return;
  report.warn(warning::name_of_both_kinds,
              fmt::format("{} names {} of the boundary and {} inside the face, between regions or in one: write "
                          "boundary:PATTERN or interface:PATTERN in --name for one of these kinds",
                          rule.where, counted(num_outer, "curve"), counted(num_sides / 2, "curve")));
}

std::vector<GivenName> given_names(const CadFace& face, const std::vector<NameRule>& rules, Report& report) {
  std::vector<GivenName> given;
  for (const NameRule& rule : rules) {
    const std::vector<int> curves = with_partners(face, curves_of(face, rule));
    warn_of_both_kinds(face, rule, curves, report);
    given.push_back({rule.name, curves, rule.kind == NameRule::Kind::rest, rule.where});
  }
  return given;
}

/// One entry for each name, with each of its curves once.
std::vector<GivenName> merged_by_name(const std::vector<GivenName>& given) {
  std::vector<GivenName> merged;
  for (const GivenName& g : given) {
    const auto is_same = [&](const GivenName& m) { return m.name == g.name && m.is_for_rest == g.is_for_rest; };
    const auto found = std::find_if(merged.begin(), merged.end(), is_same);
    if (found == merged.end()) {
      merged.push_back(g);
      continue;
    }
    std::vector<int>& targets = found->targets;
    targets.insert(targets.end(), g.targets.begin(), g.targets.end());
    std::sort(targets.begin(), targets.end());
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  }
  return merged;
}

/// Removes from `given` what `overriding` names.
void yield(std::vector<GivenName>& given, const std::vector<GivenName>& overriding) {
  for (const GivenName& winner : overriding) {
    const auto is_taken = [&](int target) {
      return std::find(winner.targets.begin(), winner.targets.end(), target) != winner.targets.end();
    };
    for (GivenName& g : given)
      if (g.is_for_rest || !winner.is_for_rest) std::erase_if(g.targets, is_taken);
  }
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

void rename_curves(CadFace& face, const std::vector<NameRule>& rules, const std::vector<NameRule>& overriding,
                   Report& report) {
  std::vector<GivenName> given = given_names(face, rules, report);
  std::vector<std::string> names = face.curve_names;
  assign_names(names, given, "curve");  // refuses contradictions of the first set, also where the second one decides
  const std::vector<GivenName> winners = merged_by_name(given_names(face, overriding, report));
  yield(given, winners);
  given.insert(given.end(), winners.begin(), winners.end());
  const std::vector<int> named = assign_names(face.curve_names, given, "curve");
  std::erase_if(face.unnamed_curves, [&](int c) { return std::binary_search(named.begin(), named.end(), c); });
}

namespace {

/// "4" or "3-6": the first number and the last; nothing for other texts.
std::optional<std::pair<int, int>> range_of(const std::string& item) {
  if (item.empty() || item.find_first_not_of("0123456789-") != std::string::npos) return std::nullopt;
  const std::size_t dash = item.find('-');
  const auto first = number_of<int>(item.substr(0, dash));
  const auto last = dash == std::string::npos ? first : number_of<int>(item.substr(dash + 1));
  if (!first || !last || *first < 0 || *last < *first) return std::nullopt;
  return std::pair{*first, *last};
}

NameRule rule_of_item(const std::string& item, const std::string& where) {
  NameRule rule;
  if (item.empty()) throw UsageError(where + ": an item of the list is empty");
  std::string_view pattern = item;
  for (const auto& [prefix, part] : {std::pair{std::string_view("boundary:"), NameRule::Part::boundary},
                                     std::pair{std::string_view("interface:"), NameRule::Part::interface}})
    if (pattern.starts_with(prefix)) rule.part = part, pattern.remove_prefix(prefix.size());
  if (pattern == "*") return rule;
  if (const auto range = range_of(item)) {
    rule.kind = NameRule::Kind::range;
    rule.number = range->first, rule.last_number = range->second;
  } else {
    rule.kind = NameRule::Kind::pattern;
    rule.text = pattern;
  }
  return rule;
}

NameRule rule_of_point(const std::string& point, const std::string& where) {
  NameRule rule;
  rule.kind = NameRule::Kind::position;
  rule.max_distance = max_option_distance;
  rule.position = numbers_of(point);
  if (rule.position.size() < 2 || rule.position.size() > 3)
    throw UsageError(where + ": a point is X,Y or X,Y,Z, in file units");
  return rule;
}

}  // namespace

std::vector<NameRule> name_option_rules(const std::vector<std::string>& options, const std::string& option_name) {
  std::vector<NameRule> rules;
  for (const std::string& option : options) {
    const std::string where = fmt::format("{} {}", option_name, option);
    const std::size_t end = option.find_first_of("=@");
    const std::string name = end == std::string::npos ? "" : clean_name(option.substr(0, end));
    if (name.empty())
      throw UsageError(where + ": expected NAME=LIST, such as hole=4 or wall=1,3-6 or wall=edge_*, or NAME@X,Y");
    const std::string target = option.substr(end + 1);
    const auto add = [&](NameRule rule) {
      rule.name = name, rule.where = where;
      rules.push_back(std::move(rule));
    };
    if (option[end] == '@')
      add(rule_of_point(target, where));
    else
      for (const std::string& item : split_at_commas(target)) add(rule_of_item(item, where));
  }
  return rules;
}

}  // namespace quadrille::cad
