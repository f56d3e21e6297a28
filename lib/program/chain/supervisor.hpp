#pragma once
// A process that outlives the work that it supervises, whatever ends that.

#include <functional>
#include <string>

namespace quadrille::chain {

/// Runs `work` in a copy of this process and returns its value. If the copy is killed, or crashes, the scratch folder
/// is emptied and another copy runs `work` with true. INT, TERM, HUP and QUIT are passed on to the copy, whose end is
/// awaited. The scratch folder, if it exists, is removed at the end. If a signal arrived here, or ended the last copy,
/// this process ends by the same signal. The copy gets TERM when this process ends.
int supervise(const std::function<int(bool is_second_try)>& work, const std::string& scratch_folder);

}  // namespace quadrille::chain
