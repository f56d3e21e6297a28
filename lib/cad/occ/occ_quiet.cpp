#include "occ/occ_quiet.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>

namespace quadrille::occ {

void quiet_kernel() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

}  // namespace quadrille::occ
