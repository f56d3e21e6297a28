#include "galerkin/linear_solver.hpp"

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "galerkin/partial_cholesky.hpp"

namespace quadrille {

namespace {

/// A part of the mesh: the dofs that are eliminated with it, then those that it shares with the outside, both ascending.
struct Part {
  std::vector<int> dofs;
  int num_eliminated = 0;
  Front front;              ///< the panel stays, the rest goes to the parent
  Eigen::MatrixX2d values;  ///< right-hand side over dofs; in the end the solution

  int num_shared() const { return static_cast<int>(dofs.size()) - num_eliminated; }
};

class Multifrontal {
 public:
  Multifrontal(const EliminationTree& tree, const DofMap& map, const std::vector<CondensedElement>& elements,
               const Eigen::MatrixX2d& rhs, int num_threads);
  Eigen::MatrixX2d solve();

 private:
  void find_dofs();
  void divide_work();
  void factor(int node, int num_threads);
  void add_elements(int node);
  void add_part(const Part& child, Part& part);
  void substitute_back(int node);

  const EliminationTree* tree_;
  const DofMap* map_;
  const std::vector<CondensedElement>* elements_;
  const Eigen::MatrixX2d* rhs_;
  int num_threads_;
  std::vector<Part> parts_;  ///< by node of the tree
  Eigen::MatrixX2d solution_;
  struct Range {
    int begin, end;
  };
  std::vector<Range> subtrees_;  ///< nodes [begin, end): independent of each other
  std::vector<int> top_;         ///< the nodes above them, children first
};

Multifrontal::Multifrontal(const EliminationTree& tree, const DofMap& map,
                           const std::vector<CondensedElement>& elements, const Eigen::MatrixX2d& rhs, int num_threads)
    : tree_(&tree),
      map_(&map),
      elements_(&elements),
      rhs_(&rhs),
      num_threads_(num_threads),
      parts_(tree.nodes.size()),
      solution_(map.num_unknowns, 2) {
  find_dofs();
  divide_work();
}

// A dof is eliminated with the smallest part that holds all its elements.
void Multifrontal::find_dofs() {
  std::vector<int> dof2last(map_->num_unknowns, -1), dof2first(map_->num_unknowns, -1);  // places in tree.elements
  const auto free_dofs = [&](int place, auto&& use) {
    const int elem = tree_->elements[place];
    for (int i = map_->elem2offset[elem]; i < map_->elem2offset[elem + 1]; ++i) {
      const int dof = map_->elem2dofs[i];
      if (dof >= 0 && dof < map_->num_unknowns) use(dof);
    }
  };
  for (int place = 0; place < static_cast<int>(tree_->elements.size()); ++place) {
    free_dofs(place, [&](int dof) {
      if (dof2first[dof] < 0) dof2first[dof] = place;
      dof2last[dof] = place;
    });
  }
  for (std::size_t n = 0; n < parts_.size(); ++n) {
    const EliminationTree::Node& node = tree_->nodes[n];
    std::vector<int>& dofs = parts_[n].dofs;
    if (node.first < 0) {
      for (int place = node.begin; place < node.end; ++place) free_dofs(place, [&](int dof) { dofs.push_back(dof); });
      std::sort(dofs.begin(), dofs.end());
      dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
    } else {
      const Part &a = parts_[node.first], &b = parts_[node.second];
      std::set_union(a.dofs.begin() + a.num_eliminated, a.dofs.end(), b.dofs.begin() + b.num_eliminated, b.dofs.end(),
                     std::back_inserter(dofs));
    }
    const auto is_inside = [&](int dof) { return dof2first[dof] >= node.begin && dof2last[dof] < node.end; };
    if (!std::is_partitioned(dofs.begin(), dofs.end(), is_inside)) throw Defect("dofs do not follow the elimination tree");
    parts_[n].num_eliminated =
        static_cast<int>(std::partition_point(dofs.begin(), dofs.end(), is_inside) - dofs.begin());
  }
}

// Subtrees of about a 32nd of the elements.
void Multifrontal::divide_work() {
  const int num_nodes = static_cast<int>(parts_.size()), share = static_cast<int>(elements_->size()) / 32;
  const auto size = [&](int node) { return tree_->nodes[node].end - tree_->nodes[node].begin; };
  int begin = 0;
  for (int node = 0; node < num_nodes; ++node) {
    const int parent = tree_->nodes[node].parent;
    const bool is_small = size(node) <= share || tree_->nodes[node].first < 0;
    if (!is_small) {
      top_.push_back(node);
      begin = node + 1;
    } else if (parent < 0 || size(parent) > share) {
      subtrees_.push_back({begin, node + 1});
      begin = node + 1;
    }
  }
}

void Multifrontal::add_elements(int node) {
  Part& part = parts_[node];
  const int k = part.num_eliminated;
  std::vector<int> places;
  for (int place = tree_->nodes[node].begin; place < tree_->nodes[node].end; ++place) {
    const int elem = tree_->elements[place], offset = map_->elem2offset[elem];
    const int n = map_->elem2offset[elem + 1] - offset;
    const Eigen::MatrixXd& schur = (*elements_)[elem].schur;
    const double* signs = &map_->elem2signs[offset];
    places.assign(n, -1);
    for (int i = 0; i < n; ++i) {
      const int dof = map_->elem2dofs[offset + i];
      if (dof >= 0 && dof < map_->num_unknowns)
        places[i] = static_cast<int>(std::lower_bound(part.dofs.begin(), part.dofs.end(), dof) - part.dofs.begin());
    }
    for (int j = 0; j < n; ++j) {
      const int column = places[j];
      if (column < 0) continue;
      double* const target = column < k ? &part.front.panel(0, column) : &part.front.rest(0, column - k) - k;
      for (int i = 0; i < n; ++i) {
        if (places[i] >= column) target[places[i]] += signs[i] * signs[j] * schur(i, j);
      }
    }
  }
}

void Multifrontal::add_part(const Part& child, Part& part) {
  const int n = child.num_shared(), k = part.num_eliminated;
  std::vector<int> places(n);
  for (int i = 0, place = 0; i < n; ++i, ++place) {
    while (part.dofs[place] != child.dofs[child.num_eliminated + i]) ++place;
    places[i] = place;
  }
  for (int j = 0; j < n; ++j) {
    const int column = places[j];
    const double* const source = &child.front.rest(0, j);
    double* const target = column < k ? &part.front.panel(0, column) : &part.front.rest(0, column - k) - k;
    for (int i = j; i < n; ++i) target[places[i]] += source[i];
    part.values.row(column) += child.values.row(child.num_eliminated + j);
  }
}

void Multifrontal::factor(int n, int num_threads) {
  const EliminationTree::Node& node = tree_->nodes[n];
  Part& part = parts_[n];
  const int size = static_cast<int>(part.dofs.size()), k = part.num_eliminated, shared = part.num_shared();
  part.front.panel.setZero(size, k);
  part.front.rest.setZero(shared, shared);
  part.values.setZero(size, 2);
  for (int i = 0; i < k; ++i) part.values.row(i) = rhs_->row(part.dofs[i]);
  if (node.first < 0) add_elements(n);
  for (const int half : {node.first, node.second}) {
    if (half < 0) continue;
    add_part(parts_[half], part);
    parts_[half].front.rest.resize(0, 0);
  }
  if (k == 0) return;
  if (!eliminate(part.front, num_threads)) throw ComputeError("the Laplace problem's matrix is not positive definite");
  part.front.panel.topRows(k).triangularView<Eigen::Lower>().solveInPlace(part.values.topRows(k));
  part.values.bottomRows(shared).noalias() -= part.front.panel.bottomRows(shared) * part.values.topRows(k);
}

void Multifrontal::substitute_back(int node) {
  Part& part = parts_[node];
  const int k = part.num_eliminated, shared = part.num_shared();
  if (k == 0) return;
  for (int i = 0; i < shared; ++i) part.values.row(k + i) = solution_.row(part.dofs[k + i]);
  part.values.topRows(k).noalias() -= part.front.panel.bottomRows(shared).transpose() * part.values.bottomRows(shared);
  part.front.panel.topRows(k).triangularView<Eigen::Lower>().transpose().solveInPlace(part.values.topRows(k));
  for (int i = 0; i < k; ++i) solution_.row(part.dofs[i]) = part.values.row(i);
}

Eigen::MatrixX2d Multifrontal::solve() {
  const int num_subtrees = static_cast<int>(subtrees_.size());
  parallel_for(num_subtrees, num_threads_, [&](int i) {
    for (int node = subtrees_[i].begin; node < subtrees_[i].end; ++node) factor(node, 1);
  });
  for (const int node : top_) factor(node, num_threads_);
  for (auto node = top_.rbegin(); node != top_.rend(); ++node) substitute_back(*node);
  parallel_for(num_subtrees, num_threads_, [&](int i) {
    for (int node = subtrees_[i].end - 1; node >= subtrees_[i].begin; --node) substitute_back(node);
  });
  return std::move(solution_);
}

}  // namespace

Eigen::MatrixX2d solve_condensed(const EliminationTree& tree, const DofMap& map,
                                 const std::vector<CondensedElement>& elements, const Eigen::MatrixX2d& rhs,
                                 int num_threads) {
  if (map.num_unknowns == 0) return rhs;
  return Multifrontal(tree, map, elements, rhs, num_threads).solve();
}

}  // namespace quadrille
