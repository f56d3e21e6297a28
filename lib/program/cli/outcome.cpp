#include "cli/outcome.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <exception>
#include <filesystem>
#include <new>

#include "base/child_process.hpp"
#include "base/version.hpp"
#include "cli/messages.hpp"

namespace quadrille::cli {

namespace {

std::string out_of_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return fmt::format("out of memory, at {} MB: raise the limit, or ask for fewer elements or lower orders",
                     usage.ru_maxrss / 1024);
}

std::string internal_error(const std::string& what) {
  return fmt::format("internal error, please report it: {}", what);
}

}  // namespace

Outcome outcome_of(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const Defect& e) {
    return {ExitCode::defect, internal_error(e.what())};
  } catch (const Error& e) {
    return {e.code(), e.what()};
  } catch (const std::filesystem::filesystem_error& e) {
    return outcome_of([&] {
      require_resources(e.code().value(), e.path1().string());
      throw OutputError(fmt::format("{}: cannot be read or written: {}", e.path1().string(), e.code().message()));
    });
  } catch (const std::bad_alloc&) {
    return {ExitCode::no_result, out_of_memory(), true};
  } catch (const std::exception& e) {
    return {ExitCode::defect, internal_error(e.what())};
  } catch (...) {
    return {ExitCode::defect, internal_error("unknown exception")};
  }
}

std::string error_text(const std::string& name, const Outcome& outcome) {
  std::string text = fmt::format("{}: {}\n", name, outcome.message);
  if (outcome.code == ExitCode::usage) text += fmt::format("try '{} --help'\n", name);
  return text;
}

int print_failure(const std::string& name, const Outcome& outcome) {
  if (!outcome.is_success()) print_message(error_text(name, outcome));
  return static_cast<int>(outcome.code);
}

namespace {

bool asks_for_help(const std::string& word) {
  const bool has_letters = word.size() > 1 && word[0] == '-' && word.find_first_not_of("vqh", 1) == std::string::npos;
  return word == "--help" || word == "--help-all" || (has_letters && word.find('h') != std::string::npos);
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
