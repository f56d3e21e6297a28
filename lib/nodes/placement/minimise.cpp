#include "placement/minimise.hpp"

#include "base/error.hpp"
#include "placement/descent.hpp"
#include "placement/newton.hpp"
#include "placement/quasi_newton.hpp"

namespace quadrille::placement {

Minimum minimise(const Minimand& f, const Eigen::VectorXd& x, const MinimiseOptions& options) {
  Descent descent{f, options, {}, {}};
  descent.found.x = x;
  const auto sample = evaluate(descent, x);
  if (!sample) throw Defect("a minimum is sought from a point where the function does not exist");
  descent.here = *sample;
  Minimum& found = descent.found;
  found.is_converged = x.size() == 0;
  double newton_gradient = options.newton_gradient;
  bool is_first = !options.begins_with_hessian;
  while (found.iterations < options.max_iterations && !found.is_converged) {
    const bool was_down = quasi_newton(descent, newton_gradient, is_first);
    is_first = false;
    const bool is_near = newton(descent);
    if (is_near || !was_down) break;
    newton_gradient /= 30;
  }
  found.value = descent.here.value;
  return found;
}

}  // namespace quadrille::placement
