#pragma once
// Signal handling of a command: it removes its temporary files, then ends by the same signal (exit code 128 + n).

namespace quadrille::cli {

/// Installs the handlers for INT, TERM, HUP, QUIT, PIPE and XCPU; a signal that was ignored at the start stays
/// ignored. XFSZ is ignored, so that a file size limit becomes an error of write() like a full disk.
void install_signal_handlers();

}  // namespace quadrille::cli
