// quadmesh: the whole chain in one command and one process (README, "One command").

#include "chain/run_chain.hpp"
#include "cli/messages.hpp"
#include "cli/process_setup.hpp"

int main(int argc, char** argv) {
  quadrille::cli::occupy_standard_streams();
  quadrille::cli::set_up_heap();
  return quadrille::chain::run_chain({argv + 1, argv + argc});
}
