#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "export/gmsh_model.hpp"
#include "export/patches.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

/// The group of all elements, and the beginning of the names of periodic sides; PyFR reads names in lower case.
constexpr const char* all_elements = "fluid";
constexpr std::string_view periodic_word = "periodic";

bool begins_as_periodic(const std::string& name) {
  return name.size() >= periodic_word.size() && std::equal(periodic_word.begin(), periodic_word.end(), name.begin(),
                                                           [](char a, char b) { return a == (b | 0x20); });
}

/// The patches that PyFR couples: the motion must be a translation.
std::vector<CyclicPatch> translated_patches(const QuadMesh& mesh, const Groups& groups) {
  std::vector<CyclicPatch> patches = cyclic_patches(mesh, groups, {});
  for (CyclicPatch& patch : patches)
    if (patch.pair >= 0 && mesh.face.periodic_pairs[patch.pair].angle != 0) patch.neighbour = -1;
  return patches;
}

/// The words for the boundaries, and a sentence about those of periodic sides.
struct PyfrNames {
  NameList words;
  std::string periodic_names;
};

PyfrNames pyfr_names(const Groups& groups, const std::vector<CyclicPatch>& patches, Exported& exported) {
  NameList names = groups.boundary_names, taken{all_elements};
  for (std::string& name : names)
    if (begins_as_periodic(name)) name.insert(0, 1, '_');
  PyfrNames result{plain_names(names, {taken, 0, true}), {}};
  NameList of_others = result.words;
  int count = 0;
  for (std::size_t b = 0; b < patches.size(); ++b) {
    if (patches[b].neighbour < 0 || !patches[b].is_first) continue;
    const auto other = static_cast<std::size_t>(patches[b].neighbour);
    for (const auto& [boundary, side] : {std::pair{b, 'l'}, {other, 'r'}}) {
      result.words[boundary] = fmt::format("{}_{}_{}", periodic_word, count, side);
      of_others[boundary] = groups.boundary_names[boundary];
      result.periodic_names += fmt::format("{}\"{}\" as {}", result.periodic_names.empty() ? "" : ", ",
                                           groups.boundary_names[boundary], result.words[boundary]);
    }
    ++count;
  }
  exported.add_loss(renamed_loss(groups.boundary_names, of_others));
  return result;
}

/// The model with PyFR's groups alone: lines inside the mesh have none.
void set_pyfr_groups(const NameList& words, GmshModel& model) {
  model.groups.boundary_names = words;
  model.groups.interface_names.clear();
  model.groups.region_names = {all_elements};
  for (GmshEntity& curve : model.entities[1])
    if (curve.is_inside) curve.group = 0;
  for (GmshEntity& surface : model.entities[2]) surface.group = 1 + static_cast<int>(words.size());
}

}  // namespace

Exported gmsh_pyfr(const QuadMesh& mesh, const Frame& frame) {
  GmshModel model = gmsh_model(mesh, frame);
  const Groups groups = model.groups;
  const std::vector<CyclicPatch> patches = translated_patches(mesh, groups);
  Exported exported;
  exported.add_loss(interface_loss(groups));
  exported.add_loss(region_loss(groups));
  const auto [words, periodic_names] = pyfr_names(groups, patches, exported);
  if (!periodic_names.empty()) exported.add_loss("periodic sides have the names that PyFR requires: " + periodic_names);
  exported.add_loss(
      cyclic_loss(mesh.face, groups, patches, "PyFR couples two sides of one name each that are moved, not turned"));
  if (words != groups.boundary_names) exported.side_files.push_back(names_table(groups, words, {}));
  set_pyfr_groups(words, model);
  exported.bytes = gmsh41_text(model);
  return exported;
}

}  // namespace quadrille::exports
