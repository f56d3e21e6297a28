#include "cli/request.hpp"

#include <fmt/format.h>

#include "base/version.hpp"
#include "cli/messages.hpp"

namespace quadrille::cli {

namespace {

bool asks_for_help(const std::string& word) {
  const bool has_letters = word.size() > 1 && word[0] == '-' && word.find_first_not_of("vqh", 1) == std::string::npos;
  return word == "--help" || (has_letters && word.find('h') != std::string::npos);
}

}  // namespace

Request request_of(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (asks_for_help(word)) return Request::show_help;
    if (word == "--version") return Request::show_version;
    if (word == "--list-options") return Request::list_options;
  }
  return Request::run;
}

void answer(Request request, const std::string& name, const std::function<std::string()>& help,
            const std::function<std::string()>& options) {
  if (request == Request::show_help) print_to_stdout(help());
  if (request == Request::show_version) print_to_stdout(fmt::format("{} (Quadrille) {}\n", name, version));
  if (request == Request::list_options) print_to_stdout(options());
}

}  // namespace quadrille::cli
