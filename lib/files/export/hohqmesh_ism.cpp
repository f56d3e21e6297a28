#include "export/hohqmesh_ism.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "export/hohqmesh_model.hpp"

namespace quadrille::exports {
namespace {

class Writer {
 public:
  Writer(const QuadMesh& mesh, const HohqmeshModel& model) : mesh_(mesh), model_(model) {}

  std::string text() {
    print("{}\n{} {} {} {}\n", has_materials() ? "ISM-MM" : "ISM-V2", model_.corners.size(), model_.edges.size(),
          mesh_.num_elems(), mesh_.order);
    for (const int node : model_.corners) write_point(node);
    if (!has_materials())
      for (const HohqmeshEdge& edge : model_.edges) write_edge(edge);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) write_element(elem);
    return fmt::to_string(out_);
  }

 private:
  bool has_materials() const { return !model_.materials.empty(); }

  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  void write_point(int node) {
    const std::array<double, 3>& x = model_.points[node];
    print("{} {} {}\n", x[0], x[1], x[2]);
  }

  /// Start, end, element on the left, element on the right, their sides; the last one negative where both sides run the
  /// same way round their elements, so that their points are in opposite order.
  void write_edge(const HohqmeshEdge& e) {
    const std::array<int, 4>& corners = model_.elem_corners[e.elem];
    print("{} {} {} ", corners[e.side], corners[(e.side + 1) % 4], e.elem + 1);
    if (e.other_elem < 0) {
      print("0 {} 0\n", e.side + 1);
      return;
    }
    const bool is_opposite = (e.side < 2) == (e.other_side < 2);
    print("{} {} {}\n", e.other_elem + 1, e.side + 1, (is_opposite ? -1 : 1) * (e.other_side + 1));
  }

  void write_element(int elem) {
    const std::array<int, 4>& c = model_.elem_corners[elem];
    const std::array<bool, 4>& curved = model_.is_curved[elem];
    print("{} {} {} {}", c[0], c[1], c[2], c[3]);
    if (has_materials()) print(" {}", model_.materials[elem]);
    print("\n{:d} {:d} {:d} {:d}\n", curved[0], curved[1], curved[2], curved[3]);
    for (int side = 0; side < 4; ++side)
      if (curved[side])
        for (const int node : hohqmesh_side(mesh_, elem, side)) write_point(node);
    print("{} {} {} {}\n", model_.name(elem, 0), model_.name(elem, 1), model_.name(elem, 2), model_.name(elem, 3));
  }

  const QuadMesh& mesh_;
  const HohqmeshModel& model_;
  fmt::memory_buffer out_;
};

}  // namespace

namespace {

Exported exported(const QuadMesh& mesh, HohqmeshModel model) {
  std::string text = Writer(mesh, model).text();
  return {std::move(text), false, std::move(model.side_files), std::move(model.losses)};
}

}  // namespace

Exported hohqmesh_ism(const QuadMesh& mesh, const Frame& frame) {
  HohqmeshModel model = hohqmesh_model(mesh, frame);
  join_periodic_edges(mesh, model);
  if (const std::string loss = rotation_loss(mesh.face); !loss.empty()) model.losses.push_back(loss);
  return exported(mesh, std::move(model));
}

Exported hohqmesh_ism_mm(const QuadMesh& mesh, const Frame& frame) {
  return exported(mesh, hohqmesh_model_with_materials(mesh, frame));
}

}  // namespace quadrille::exports
