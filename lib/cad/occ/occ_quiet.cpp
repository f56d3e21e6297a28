// The kernel keeps tables until the process ends; these leaks would hide leaks of the project.
// Disables the list of suppressed leaks, because stderr is reserved for messages of the tools.

#include "occ/occ_quiet.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>

#ifdef QUADRILLE_SANITIZE
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libTK\n"; }
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif
namespace quadrille::occ {

void quiet_kernel() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

}  // namespace quadrille::occ
