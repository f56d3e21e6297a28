#pragma once
// One-forms on the triangles of a curved face: the coframe theta1, theta2 of a continuous frame, its connection omega,
// and their integrals against the gradients of the modes. The frame is e1 at the nodes: directions at the vertices,
// which the approximate image gives (that of its x axis), interpolated and projected onto the tangent plane; e2 = n x
// e1. Components are those of the reference coordinates xi1, xi2.

#include <Eigen/Dense>
#include <vector>

#include "chart/element_tables.hpp"
#include "chart/surface_mesh.hpp"

namespace quadrille::chart {

/// Components of a one-form at the points of the rule; one function a column.
struct OneForm {
  Eigen::MatrixXd xi1, xi2;
};

struct ElementForms {
  Eigen::VectorXd h11, h12, h22;  ///< the metric of one-forms times the area element, weights included
  OneForm theta1, theta2, omega;  ///< one column
};

/// Along an edge on the boundary, in the direction of the curve: values at the points of its EdgeTable, each times its
/// weight and d / ds.
struct EdgeForms {
  int elem = 0, edge = 0, hole = 0;  ///< `hole`: its loop, 1, 2, ...
  Eigen::VectorXd length, theta1, theta2, omega;
  Eigen::VectorXd turn;  ///< 2 pi times the part of the loop's length up to the point
};

struct SurfaceForms {
  std::vector<ElementForms> elems;
  std::vector<EdgeForms> hole_edges;  ///< loop after loop
  std::vector<double> hole_lengths;   ///< of loop 0 (not set), 1, ...
};

/// `loop_offsets`: of the face.
SurfaceForms surface_forms(const SurfaceMesh& mesh, const std::vector<int>& loop_offsets);

/// The integrals of <form, dq> over an element for its modes q.
Eigen::MatrixXd products_with_gradients(const ElementTables& tables, const ElementForms& elem, const OneForm& form);
/// The integrals of form ^ dq.
Eigen::MatrixXd wedges_with_gradients(const ElementTables& tables, const OneForm& form);
/// The integral of |form|^2, both columns together.
double square(const ElementForms& elem, const OneForm& form);
/// The stiffness matrix of an element, of its modes.
Eigen::MatrixXd stiffness_matrix(const ElementTables& tables, const ElementForms& elem);

}  // namespace quadrille::chart
