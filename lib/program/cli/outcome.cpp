#include "cli/outcome.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <exception>
#include <filesystem>
#include <new>

#include "base/resources.hpp"
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

}  // namespace quadrille::cli
