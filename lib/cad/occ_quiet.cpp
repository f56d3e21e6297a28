#include "cad/occ_quiet.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>

#ifdef __SANITIZE_ADDRESS__
// The kernel keeps tables until the process ends; its leaks would hide ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libTK\n"; }
#endif

namespace quadrille {

void quiet_kernel() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

}  // namespace quadrille
