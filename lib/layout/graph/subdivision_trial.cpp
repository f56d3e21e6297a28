// Trials of a subdivision: what is changed is recorded first, and restored in reverse order.

#include <utility>

#include "graph/subdivision.hpp"

namespace quadrille::graph {
namespace {

template <typename Saved, typename Values>
void restore(Saved& saved, std::size_t num, Values& values) {
  for (auto change = saved.rbegin(); change != saved.rend(); ++change)
    if (const auto number = static_cast<std::size_t>(change->first); number < num)
      values[number] = std::move(change->second);
  values.resize(num);
}

}  // namespace

void Subdivision::begin_trial() {
  Trial trial;
  trial.num_arcs = graph_.arcs.size(), trial.num_nodes = graph_.nodes.size();
  trial.num_faces = face_start_.size(), trial.num_splines = graph_.splines.size();
  trial_ = std::move(trial);
}

void Subdivision::undo_trial() {
  Trial trial = std::move(*trial_);
  trial_.reset();
  restore(trial.records, 2 * trial.num_arcs, records_);
  restore(trial.arcs, trial.num_arcs, graph_.arcs);
  restore(trial.nodes, trial.num_nodes, graph_.nodes);
  restore(trial.node_starts, trial.num_nodes, node_start_);
  restore(trial.face_starts, trial.num_faces, face_start_);
  graph_.splines.resize(trial.num_splines);
}

Subdivision::Record& Subdivision::record(HalfEdge h) {
  if (trial_) trial_->records.push_back({h.index(), records_[h.index()]});
  return records_[h.index()];
}

GraphArc& Subdivision::changing_arc(int arc) {
  if (trial_) trial_->arcs.push_back({arc, graph_.arcs[arc]});
  return graph_.arcs[arc];
}

GraphNode& Subdivision::changing_node(int node) {
  if (trial_) trial_->nodes.push_back({node, graph_.nodes[node]});
  return graph_.nodes[node];
}

HalfEdge& Subdivision::changing_node_start(int node) {
  if (trial_) trial_->node_starts.push_back({node, node_start_[node]});
  return node_start_[node];
}

HalfEdge& Subdivision::changing_face_start(int face) {
  if (trial_) trial_->face_starts.push_back({face, face_start_[face]});
  return face_start_[face];
}

}  // namespace quadrille::graph
