#pragma once
// A process that outlives the work that it supervises, whatever ends that.

#include <functional>
#include <string>

namespace quadrille::chain {

/// Makes the scratch folder, runs `work` in a copy of this process and returns its value. If the copy is killed, or
/// crashes, the scratch folder is emptied and another copy runs `work` with true. INT, TERM, HUP and QUIT are passed on
/// to the copy, whose end is awaited. Processes that a copy left are ended. `make_scratch` returns the path of the
/// folder, which is removed at the end; what it throws is thrown here. If a signal arrived here, or ended the last
/// copy, this process ends by the same signal. The copy gets TERM when this process ends.
int supervise(const std::function<int(bool is_second_try)>& work, const std::function<std::string()>& make_scratch);

}  // namespace quadrille::chain
