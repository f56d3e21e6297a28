#pragma once
// Temporaries that a signal must remove. Async-signal-safe: fixed storage, unlink only.

#include <string>

namespace quadrille {

/// Registers a path for removal when the process is ended by a signal; returns a slot, or -1 when all are taken.
int register_temporary(const std::string& path);
/// Forgets it (after rename or removal).
void release_temporary(int slot);
/// Removes what is registered. Called by the signal handlers that cli installs.
void remove_temporaries() noexcept;

}  // namespace quadrille
