#pragma once
// Loops over independent pieces of work, on one thread or several.
//
// The partition never depends on the number of threads, and each piece writes to its own slot: so the same bytes come
// out, whoever did what.

#include <functional>

namespace quadrille {

/// Calls f(i) once for each i in [0, n), on up to `num_threads` threads, the calling one included. Where calls throw,
/// the exception of the lowest i is thrown again, after the others have ended; later calls may not have been made.
void parallel_for(int n, int num_threads, const std::function<void(int)>& f);

}  // namespace quadrille
