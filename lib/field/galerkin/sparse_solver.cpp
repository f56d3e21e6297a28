#include "galerkin/sparse_solver.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "galerkin/partial_cholesky.hpp"

namespace quadrille::galerkin {
namespace {

/// The sparse symmetric positive definite system of the condensed elements, by the multifrontal method (Duff and Reid
/// 1983; Liu 1992): along an elimination tree, each part of the mesh has a dense matrix; the unknowns inside the part
/// are eliminated, and the Schur complement is passed to the parent. The sparse matrix is never assembled.
///
/// Cholesky factorisation of the sum of the elements' Schur complements over the free dofs. The result does not depend
/// on the number of threads. For n elements: time n^1.5, memory n log n.
class CondensedCholesky : public SparseSolver {
 public:
  /// Symbolic factorisation. `map` numbers its dofs in the order of tree.elimination_order; both must outlive this.
  CondensedCholesky(const mesh::EliminationTree& tree, const DofMap& map, int num_threads = 1);
  void factor(const CondensedElements& elements, Progress* progress = nullptr) override;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs, double negligible) override;
  /// Each column is carried only through the parts of the mesh between its entries and the whole.
  Eigen::MatrixXd inverse_products(const SparseColumns& b) const override;

 private:
  /// A part of the mesh: the dofs eliminated with it, then the dofs shared with the rest of the mesh, both ascending.
  struct Part {
    std::vector<int> dofs;
    int num_eliminated = 0;
    std::vector<int> positions_in_parent;  ///< of the shared dofs in the parent's dofs
    Front front;                           ///< the panel is kept, the rest is added to the parent
    Eigen::MatrixXd values;  ///< over dofs: right-hand side, then solution; empty if there is no right-hand side
    int num_shared() const { return static_cast<int>(dofs.size()) - num_eliminated; }
    /// Proportional to the operations of its elimination.
    long long work() const { return static_cast<long long>(num_eliminated) * dofs.size() * dofs.size(); }
  };
  void find_dofs();
  void find_positions_in_parent();
  void divide_work();
  void add_elements(const CondensedElements& elements, int node);
  void add_half(Part& half, Part& part);
  void factor_part(const CondensedElements& elements, int node, int num_threads);
  void substitute_forward(const Eigen::MatrixXd& rhs, int node);
  void substitute_back(Eigen::MatrixXd& solution, double negligible, int node);
  /// Columns that have values in a part of the mesh, ascending, and their values over the part's dofs.
  struct Carried {
    std::vector<int> columns;
    Eigen::MatrixXd values;
  };
  std::vector<int> columns_in_part(const SparseColumns& b, const std::vector<Carried>& carried, int node) const;
  Carried carry(const SparseColumns& b, std::vector<Carried>& carried, int node) const;
  /// Call f(node, threads) for children before parents, and f(node) for parents before children.
  void upwards(const std::function<void(int, int)>& f) const;
  void downwards(const std::function<void(int)>& f) const;

  const mesh::EliminationTree* tree_;
  const DofMap* map_;
  int num_threads_;
  std::vector<Part> parts_;  ///< by node of the tree
  struct Range {
    int begin, end;
  };
  std::vector<Range> subtrees_;           ///< nodes [begin, end): independent of each other
  std::vector<std::vector<int>> levels_;  ///< the nodes above the subtrees, lowest level first
};

CondensedCholesky::CondensedCholesky(const mesh::EliminationTree& tree, const DofMap& map, int num_threads)
    : tree_(&tree), map_(&map), num_threads_(num_threads), parts_(tree.nodes.size()) {
  find_dofs();
  find_positions_in_parent();
  divide_work();
}

// A dof is eliminated with the smallest part that contains all its elements.
void CondensedCholesky::find_dofs() {
  std::vector<int> dof2last(map_->num_unknowns, -1), dof2first(map_->num_unknowns, -1);  // positions in tree.elements
  const auto free_dofs = [&](int position, auto&& use) {
    const int elem = tree_->elements[position];
    for (int i = map_->elem2offset[elem]; i < map_->elem2offset[elem + 1]; ++i) {
      const int dof = map_->elem2dofs[i];
      if (dof >= 0 && dof < map_->num_unknowns) use(dof);
    }
  };
  for (int position = 0; position < static_cast<int>(tree_->elements.size()); ++position) {
    free_dofs(position, [&](int dof) {
      if (dof2first[dof] < 0) dof2first[dof] = position;
      dof2last[dof] = position;
    });
  }
  for (std::size_t n = 0; n < parts_.size(); ++n) {
    const mesh::EliminationTree::Node& node = tree_->nodes[n];
    std::vector<int>& dofs = parts_[n].dofs;
    if (node.first < 0) {
      for (int position = node.begin; position < node.end; ++position)
        free_dofs(position, [&](int dof) { dofs.push_back(dof); });
      std::sort(dofs.begin(), dofs.end());
      dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
    } else {
      const Part &a = parts_[node.first], &b = parts_[node.second];
      std::set_union(a.dofs.begin() + a.num_eliminated, a.dofs.end(), b.dofs.begin() + b.num_eliminated, b.dofs.end(),
                     std::back_inserter(dofs));
    }
    const auto is_inside = [&](int dof) { return dof2first[dof] >= node.begin && dof2last[dof] < node.end; };
    if (!std::is_partitioned(dofs.begin(), dofs.end(), is_inside))
      throw Defect("dofs do not follow the elimination tree");
    parts_[n].num_eliminated =
        static_cast<int>(std::partition_point(dofs.begin(), dofs.end(), is_inside) - dofs.begin());
  }
}

void CondensedCholesky::find_positions_in_parent() {
  for (std::size_t n = 0; n < parts_.size(); ++n) {
    const int parent = tree_->nodes[n].parent;
    if (parent < 0) continue;
    Part& part = parts_[n];
    const std::vector<int>& there = parts_[parent].dofs;
    part.positions_in_parent.resize(part.num_shared());
    for (int i = 0, position = 0; i < part.num_shared(); ++i, ++position) {
      while (there[position] != part.dofs[part.num_eliminated + i]) ++position;
      part.positions_in_parent[i] = position;
    }
  }
}

// Divides the tree into subtrees of about 1/32 of the elements each.
void CondensedCholesky::divide_work() {
  const int num_nodes = static_cast<int>(parts_.size()), subtree_size = static_cast<int>(tree_->elements.size()) / 32;
  const auto size = [&](int node) { return tree_->nodes[node].end - tree_->nodes[node].begin; };
  std::vector<std::size_t> height(num_nodes, 0);  // of the nodes above the subtrees
  int begin = 0;
  for (int n = 0; n < num_nodes; ++n) {
    const mesh::EliminationTree::Node& node = tree_->nodes[n];
    if (size(n) > subtree_size && node.first >= 0) {
      height[n] = 1 + std::max(height[node.first], height[node.second]);
      if (levels_.size() < height[n]) levels_.emplace_back();
      levels_[height[n] - 1].push_back(n);
    } else if (node.parent < 0 || size(node.parent) > subtree_size) {
      subtrees_.push_back({begin, n + 1});
    } else {
      continue;
    }
    begin = n + 1;
  }
}

void CondensedCholesky::upwards(const std::function<void(int, int)>& f) const {
  parallel_for(static_cast<int>(subtrees_.size()), num_threads_, [&](int i) {
    for (int node = subtrees_[i].begin; node < subtrees_[i].end; ++node) f(node, 1);
  });
  for (const std::vector<int>& level : levels_) {
    const int size = static_cast<int>(level.size());
    const bool is_wide = size > 2;  // otherwise each of the few large matrices is divided among the threads
    parallel_for(size, is_wide ? num_threads_ : 1, [&](int i) { f(level[i], is_wide ? 1 : num_threads_); });
  }
}

void CondensedCholesky::downwards(const std::function<void(int)>& f) const {
  for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
    parallel_for(static_cast<int>(level->size()), num_threads_, [&](int i) { f((*level)[i]); });
  }
  parallel_for(static_cast<int>(subtrees_.size()), num_threads_, [&](int i) {
    for (int node = subtrees_[i].end - 1; node >= subtrees_[i].begin; --node) f(node);
  });
}

void CondensedCholesky::add_elements(const CondensedElements& elements, int node) {
  Part& part = parts_[node];
  const int k = part.num_eliminated;
  std::vector<std::pair<int, int>> free;  // positions in part.dofs, ascending, and modes of the element
  for (int place = tree_->nodes[node].begin; place < tree_->nodes[node].end; ++place) {
    const int elem = tree_->elements[place], offset = map_->elem2offset[elem];
    const double* signs = &map_->elem2signs[offset];
    const stiffness::SymmetricMatrix& schur = elements[elem]->schur;
    free.clear();
    for (int i = 0; i < map_->elem2offset[elem + 1] - offset; ++i) {
      const int dof = map_->elem2dofs[offset + i];
      if (dof < 0 || dof >= map_->num_unknowns) continue;
      const auto position = std::lower_bound(part.dofs.begin(), part.dofs.end(), dof) - part.dofs.begin();
      free.emplace_back(static_cast<int>(position), i);
    }
    std::sort(free.begin(), free.end());
    for (auto from = free.begin(); from != free.end(); ++from) {
      const auto [column, j] = *from;
      double* const target =
          column < k ? part.front.panel.col(column).data() : part.front.rest.col(column - k).data() - k;
      for (auto to = from; to != free.end(); ++to)
        target[to->first] += signs[to->second] * signs[j] * schur(to->second, j);
    }
  }
}

void CondensedCholesky::add_half(Part& half, Part& part) {
  const int n = half.num_shared(), k = part.num_eliminated;
  const std::vector<int>& positions = half.positions_in_parent;
  for (int j = 0; j < n; ++j) {
    const int column = positions[j];
    const double* const source = half.front.rest.col(j).data();
    double* const target =
        column < k ? part.front.panel.col(column).data() : part.front.rest.col(column - k).data() - k;
    for (int i = j; i < n; ++i) target[positions[i]] += source[i];
  }
  half.front.rest.resize(0, 0);
}

void CondensedCholesky::factor_part(const CondensedElements& elements, int n, int num_threads) {
  const mesh::EliminationTree::Node& node = tree_->nodes[n];
  Part& part = parts_[n];
  part.front.panel.setZero(static_cast<int>(part.dofs.size()), part.num_eliminated);
  part.front.rest.setZero(part.num_shared(), part.num_shared());
  if (node.first < 0) {
    add_elements(elements, n);
  } else {
    add_half(parts_[node.first], part);
    add_half(parts_[node.second], part);
  }
  if (!eliminate(part.front, num_threads)) throw ComputeError("the Laplace problem's matrix is not positive definite");
}

void CondensedCholesky::substitute_forward(const Eigen::MatrixXd& rhs, int n) {
  const mesh::EliminationTree::Node& node = tree_->nodes[n];
  Part& part = parts_[n];
  const int k = part.num_eliminated, shared = part.num_shared();
  const auto is_given = [&](int half) { return half >= 0 && parts_[half].values.size() > 0; };
  const auto is_zero = [&](int dof) { return rhs.row(dof).isZero(0); };
  if (!is_given(node.first) && !is_given(node.second) && std::all_of(part.dofs.begin(), part.dofs.begin() + k, is_zero))
    return;
  part.values.setZero(static_cast<int>(part.dofs.size()), rhs.cols());
  for (int i = 0; i < k; ++i) part.values.row(i) = rhs.row(part.dofs[i]);
  for (const int half : {node.first, node.second}) {
    if (!is_given(half)) continue;
    const Part& from = parts_[half];
    for (int i = 0; i < from.num_shared(); ++i)
      part.values.row(from.positions_in_parent[i]) += from.values.row(from.num_eliminated + i);
  }
  if (k == 0) return;
  part.front.panel.topRows(k).triangularView<Eigen::Lower>().solveInPlace(part.values.topRows(k));
  part.values.bottomRows(shared).noalias() -= part.front.panel.bottomRows(shared) * part.values.topRows(k);
}

void CondensedCholesky::substitute_back(Eigen::MatrixXd& solution, double negligible, int node) {
  Part& part = parts_[node];
  const int k = part.num_eliminated, shared = part.num_shared();
  if (part.values.size() == 0) {
    const auto is_negligible = [&](int dof) { return solution.row(dof).cwiseAbs().maxCoeff() <= negligible; };
    if (std::all_of(part.dofs.begin() + k, part.dofs.end(), is_negligible)) return;
    part.values.setZero(std::ssize(part.dofs), solution.cols());
  }
  for (int i = 0; i < shared; ++i) part.values.row(k + i) = solution.row(part.dofs[k + i]);
  part.values.topRows(k).noalias() -= part.front.panel.bottomRows(shared).transpose() * part.values.bottomRows(shared);
  part.front.panel.topRows(k).triangularView<Eigen::Lower>().transpose().solveInPlace(part.values.topRows(k));
  for (int i = 0; i < k; ++i) solution.row(part.dofs[i]) = part.values.row(i);
  part.values.resize(0, 0);
}

void CondensedCholesky::factor(const CondensedElements& elements, Progress* progress) {
  long long work = 0;
  for (const Part& part : parts_) work += part.work();
  const Progress::Part factorisation(progress, "factorisation", work);
  upwards([&](int node, int num_threads) {
    factor_part(elements, node, num_threads);
    factorisation.advance(parts_[node].work());
  });
}

Eigen::MatrixXd CondensedCholesky::solve(const Eigen::MatrixXd& rhs, double negligible) {
  Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(map_->num_unknowns, rhs.cols());
  upwards([&](int node, int) { substitute_forward(rhs, node); });
  downwards([&](int node) { substitute_back(solution, negligible, node); });
  return solution;
}

// The columns that have entries in the dofs of a part that are eliminated with it, or were carried there.
std::vector<int> CondensedCholesky::columns_in_part(const SparseColumns& b, const std::vector<Carried>& carried,
                                                    int n) const {
  std::vector<int> columns;
  for (int i = 0; i < parts_[n].num_eliminated; ++i) {
    for (SparseColumns::InnerIterator entry(b, parts_[n].dofs[i]); entry; ++entry)
      columns.push_back(static_cast<int>(entry.col()));
  }
  for (const int half : {tree_->nodes[n].first, tree_->nodes[n].second}) {
    if (half >= 0) columns.insert(columns.end(), carried[half].columns.begin(), carried[half].columns.end());
  }
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  return columns;
}

// Forward substitution. Frees what the halves carried.
CondensedCholesky::Carried CondensedCholesky::carry(const SparseColumns& b, std::vector<Carried>& carried,
                                                    int n) const {
  const Part& part = parts_[n];
  const int k = part.num_eliminated, shared = part.num_shared();
  Carried here{columns_in_part(b, carried, n), {}};
  const auto position_of = [&](int column) {
    return std::lower_bound(here.columns.begin(), here.columns.end(), column) - here.columns.begin();
  };
  here.values.setZero(static_cast<int>(part.dofs.size()), std::ssize(here.columns));
  for (int i = 0; i < k; ++i) {
    for (SparseColumns::InnerIterator entry(b, part.dofs[i]); entry; ++entry)
      here.values(i, position_of(static_cast<int>(entry.col()))) += entry.value();
  }
  for (const int half : {tree_->nodes[n].first, tree_->nodes[n].second}) {
    if (half < 0) continue;
    const Part& from = parts_[half];
    for (std::size_t c = 0; c < carried[half].columns.size(); ++c) {
      auto source = carried[half].values.col(static_cast<Eigen::Index>(c));
      auto target = here.values.col(position_of(carried[half].columns[c]));
      for (int i = 0; i < from.num_shared(); ++i)
        target[from.positions_in_parent[i]] += source[from.num_eliminated + i];
    }
    carried[half] = {};
  }
  if (k == 0 || here.columns.empty()) return here;
  part.front.panel.topRows(k).triangularView<Eigen::Lower>().solveInPlace(here.values.topRows(k));
  here.values.bottomRows(shared).noalias() -= part.front.panel.bottomRows(shared) * here.values.topRows(k);
  return here;
}

Eigen::MatrixXd CondensedCholesky::inverse_products(const SparseColumns& b) const {
  std::vector<Carried> carried(parts_.size()), products(parts_.size());
  upwards([&](int n, int) {
    carried[n] = carry(b, carried, n);
    const auto eliminated = carried[n].values.topRows(parts_[n].num_eliminated);
    products[n] = {carried[n].columns, eliminated.transpose() * eliminated};
  });
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(b.cols(), b.cols());
  for (const Carried& part : products) sum(part.columns, part.columns) += part.values;
  return sum;
}

}  // namespace

std::unique_ptr<SparseSolver> make_sparse_solver(const mesh::EliminationTree& tree, const DofMap& map,
                                                 int num_threads) {
  return std::make_unique<CondensedCholesky>(tree, map, num_threads);
}

}  // namespace quadrille::galerkin
