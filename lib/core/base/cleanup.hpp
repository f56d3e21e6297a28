#pragma once
// Temporary files that are removed when a signal ends the process. Async-signal-safe: fixed storage, unlink only.

#include <string>

namespace quadrille {

/// Registers a path for removal if a signal ends the process; returns its slot, or -1 if all slots are in use.
int register_temporary(const std::string& path);
/// Unregisters the path of a slot, after the file was renamed or removed.
void release_temporary(int slot);
/// Removes all registered files. Called by the signal handlers that cli installs.
void remove_temporaries() noexcept;

}  // namespace quadrille
