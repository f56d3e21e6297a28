#include "page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/length_scale.hpp"
#include "model/name_rules.hpp"
#include "page/sheet.hpp"

namespace quadrille::page {

namespace {

/// nullptr: it has none, as hexahedra and some critical points.
const CadFace* face_of(const StageModel& stage) {
  return std::visit(
      [](const auto& model) -> const CadFace* {
        if constexpr (requires { model.mesh.face; })
          return &model.mesh.face;
        else if constexpr (requires { model.face; })
          return model.face.curves.empty() ? nullptr : &model.face;
        else
          return nullptr;
      },
      stage);
}

/// The first face of the stages; nullptr if none has one.
const CadFace* first_face(const std::vector<StageModel>& stages) {
  for (const StageModel& stage : stages)
    if (const CadFace* face = face_of(stage)) return face;
  return nullptr;
}

draw::PictureBox box_of(const CriticalPoints& points) {
  draw::PictureBox box;
  for (const CriticalPoint& p : points.critical_points) box.include(p.position);
  for (const Corner& c : points.corners) box.include(c.position);
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) box.include(b.position);
  return box;
}

/// Where the positions of a stage count from.
Vec2 origin_of(const StageModel& stage) {
  if (const CadFace* face = face_of(stage)) return face->origin;
  const auto* points = std::get_if<CriticalPoints>(&stage);
  return points ? points->origin : Vec2{};
}

/// Of the face, or of the points without one; hexahedra have nothing in the plane.
draw::PictureBox own_box(const StageModel& stage) {
  if (const CadFace* face = face_of(stage)) return draw::bounding_box(*face);
  const auto* points = std::get_if<CriticalPoints>(&stage);
  return points ? box_of(*points) : draw::PictureBox{};
}

/// The symbol of the unit of length, "" if none is known.
std::string unit_of(const std::vector<StageModel>& stages) {
  CadFace own;
  if (const CadFace* face = first_face(stages))
    own.length_unit = face->length_unit;
  else if (const auto* hexes = std::get_if<HexMesh>(&stages.front()))
    own.length_unit = hexes->length_unit;
  return own.length_unit.empty() ? "" : unit_symbol(own);
}

/// In the coordinates of the CAD file, origins included.
draw::PictureBox box_of(const std::vector<StageModel>& stages) {
  draw::PictureBox box;
  for (const StageModel& stage : stages) {
    const draw::PictureBox own = own_box(stage);
    if (own.empty()) continue;
    box.include(own.lower + origin_of(stage));
    box.include(own.upper + origin_of(stage));
  }
  return box;
}

/// What lies in a far field, in the coordinates of the CAD file: curves of the boundary that neither have its name nor
/// reach it as lines of symmetry do. Empty without a far field, and where the whole is not much larger.
draw::PictureBox body_box(const StageModel& stage) {
  constexpr double smallest_whole = 4;  // in extents of the body
  const CadFace* face = face_of(stage);
  if (!face || !has_far_field(*face)) return {};
  draw::PictureBox body;
  for (int c = 0; c < face->num_curves(); ++c)
    if (!is_far_field(*face, c) && !face->is_interface(c) && !face->curve_names[c].starts_with("symmetry"))
      for (const Vec2 x : draw::dense_points(face->curves[c], 32)) body.include(x + face->origin);
  const auto extent = [](const draw::PictureBox& box) {
    return std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
  };
  return body.empty() || smallest_whole * extent(body) > extent(own_box(stage)) ? draw::PictureBox{} : body;
}

/// The frame of all stages, and the first view that the first one with bodies in a far field has.
PageFrame frame_of(const std::vector<StageModel>& stages, const draw::PictureBox& box) {
  PageFrame frame = page_frame(box);
  for (const StageModel& stage : stages)
    if (const draw::PictureBox body = body_box(stage); !body.empty() && frame.body.empty())
      frame.body = {body.lower - frame.centre, body.upper - frame.centre};
  return frame;
}

std::string facts_json(const std::vector<draw::Figure>& facts) {
  std::vector<std::string> rows;
  for (const draw::Figure& fact : facts) rows.push_back(json_texts({fact.label, fact.value}));
  return json_list(rows);
}

/// The steps that made the stage: [tool, version, options].
std::string steps_json(const Provenance& provenance) {
  std::vector<std::string> steps;
  for (const ProvenanceStep& step : provenance) steps.push_back(json_texts({step.tool, step.version, step.options}));
  return json_list(steps);
}

/// `name`: of the file, in a comparison.
std::string sheet_json(const StageModel& stage, const std::string& name, const PageFrame& frame) {
  const Sheet sheet = std::visit([&](const auto& model) { return stage_sheet(model, frame); }, stage);
  std::vector<std::string> layers;
  for (const JsonObject& layer : sheet.layers) layers.push_back(layer.str());
  JsonObject object;
  object.text("title", sheet.title)
      .text("name", name)
      .text("caption", sheet.caption)
      .json("facts", facts_json(sheet.facts));
  object.json("steps", steps_json(provenance_of(stage)));
  if (!sheet.space.empty()) object.json("space", sheet.space);
  if (sheet.is_only_in_space) object.flag("only_in_space", true);
  if (const CadFace* face = face_of(stage)) object.json("boundary", boundary_layer(*face, frame).str());
  return object.json("layers", json_list(layers)).str();
}

/// What the page shows: stages of a chain, or two that are compared.
struct Content {
  const std::vector<StageModel>& stages;
  std::vector<std::string> names;  ///< of A and B; else empty
  RunRecord run;

  bool is_comparison() const { return !names.empty(); }
};

std::string title_of(const Content& content) {
  if (content.is_comparison() && !content.names[0].empty())
    return fmt::format("{} and {}", content.names[0], content.names[1]);
  if (!content.run.shape.empty()) return content.run.shape;
  const CadFace* face = first_face(content.stages);
  return face && !face->name.empty() ? face->name : "Quadrille";
}

std::string data_json(const Content& content) {
  const auto& [stages, names, run] = content;
  const draw::PictureBox box = box_of(stages);
  const PageFrame frame = frame_of(stages, box);
  const Vec2 size = box.empty() ? Vec2{1, 1} : box.upper - box.lower;
  std::vector<std::string> sheets;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    PageFrame own = frame;
    own.centre -= origin_of(stages[i]);
    sheets.push_back(sheet_json(stages[i], content.is_comparison() ? names[i] : "", own));
  }
  JsonObject object;
  object.text("title", title_of(content)).text("unit", unit_of(stages));
  object.json("palettes", palettes_json());
  object.number("step", frame.step).number("x", frame.centre.x).number("y", frame.centre.y);
  object.number("width", size.x).number("height", size.y);
  if (const auto& [lower, upper] = frame.body; !frame.body.empty())
    object.json("body", fmt::format("[{:.9g},{:.9g},{:.9g},{:.9g}]", lower.x, lower.y, upper.x, upper.y));
  if (!run.report.empty()) object.json("report", script_json(run.report)).json("commands", json_texts(run.commands));
  if (!run.workbench.empty()) object.json("workbench", script_json(run.workbench));
  return object.flag("comparison", content.is_comparison()).json("sheets", json_list(sheets)).str();
}

/// What a page may load and where it may send requests: nothing and nowhere, but for a workbench's own server.
std::string content_policy(bool is_workbench) {
  const std::string policy = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";
  return is_workbench ? policy + "; connect-src 'self'" : policy;
}

std::string page_of(const Content& content) {
  const bool is_workbench = !content.run.workbench.empty();
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n{}"
      "<script type=\"application/json\" id=\"data\">{}</script>\n<script>\n{}</script>\n</body>\n</html>\n",
      content_policy(is_workbench), html_text(title_of(content)),
      is_workbench ? page_style() + workbench_style() : page_style(), page_body(), data_json(content),
      is_workbench ? workbench_script() : page_script());
}

}  // namespace

std::string html_page(const std::vector<StageModel>& stages, const RunRecord& run) {
  return page_of({stages, {}, run});
}

std::string page_data(const std::vector<StageModel>& stages, const RunRecord& run) {
  return data_json({stages, {}, run});
}

std::string comparison_page(const StageModel& a, const StageModel& b, const std::array<std::string, 2>& names) {
  const std::vector<StageModel> stages{a, b};
  return page_of({stages, {names[0], names[1]}, {}});
}

}  // namespace quadrille::page
