#include "cad/occ_quiet.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>

#ifdef __SANITIZE_ADDRESS__
// The kernel keeps tables until the process ends; its leaks would hide ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libTK\n"; }
// A list of what was suppressed, on stderr, is not a message of ours.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace quadrille::cad {

void quiet_kernel() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

}  // namespace quadrille::cad
