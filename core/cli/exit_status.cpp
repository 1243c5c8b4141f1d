// One line an error.
#include "cli/exit_status.h"

#include <cerrno>
#include <csignal>
#include <cstdio>

namespace isoscope {

int exit_status(ErrorCode code) {
  if (refuses_input(code)) return 3;
  switch (code) {
  case ErrorCode::usage:
    return 2;
  case ErrorCode::cancelled:
    return 4;
  default:
    return 1;
  }
}

int fail(const Error& error, int status) {
  std::fprintf(stderr, "%s: %s\n", program_invocation_short_name, error.line().c_str());
  return status;
}

int fail(const Error& error) {
  return fail(error, exit_status(error.code));
}

Status print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return {};
  return Error{ErrorCode::io, "Cannot write to standard output.", "Is the disk full, or the reader gone?"};
}

int answer(const std::string& text) {
  std::signal(SIGPIPE, SIG_IGN);
  const Status printed = print(text);
  if (printed || errno == EPIPE) return 0;
  return fail(printed.error(), 1);
}

std::string line(std::string_view label, const std::string& text) {
  constexpr std::size_t column = 13;
  std::string result(label);
  result.resize(column, ' ');
  return result + text + "\n";
}

} // namespace isoscope
