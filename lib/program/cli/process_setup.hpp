#pragma once
// How the process of a command is set up: its signals, and its heap.

#include <cstddef>
#include <string_view>

namespace quadrille::cli {

/// Installs the handlers for INT, TERM, HUP, QUIT, PIPE and XCPU; a signal that was ignored at the start stays
/// ignored. XFSZ is ignored, so that a file size limit becomes an error of write() like a full disk.
void install_signal_handlers();

/// Takes the heap in huge pages, where the system has them, and keeps what was taken until the process ends.
///
/// By default the C library returns the memory of large matrices to the system each time and takes it again in pages of
/// 4 KiB. On a virtual machine the page faults of that cost more than half of the CPU time of padapt (a plate with 100
/// holes: 1.3 s of CPU, with huge pages 0.45 s). Addresses are reserved for at most 3 GiB; memory is only what is used.
void set_up_heap();

/// Bytes (unit: byte) in free blocks of 2 MiB or more, from the text of /proc/buddyinfo: one line for each zone, "Node
/// N, zone NAME" and the numbers of free blocks of 1, 2, 4, ... pages of 4 KiB. Lines of another form count nothing.
/// Source: proc(5).
std::size_t free_huge_page_bytes(std::string_view buddy_info);

}  // namespace quadrille::cli
