// The window program: reads the command line, opens the window, runs, and turns what went wrong into a word
// and an exit status.
#include "app/app.h"
#include "app/options.h"

#include <cstdio>

namespace {

int exit_status(isoscope::ErrorCode code) {
  switch (code) {
  case isoscope::ErrorCode::bad_input:
  case isoscope::ErrorCode::unsupported:
    return 3;
  case isoscope::ErrorCode::cancelled:
    return 4;
  case isoscope::ErrorCode::usage:
  case isoscope::ErrorCode::device:
  case isoscope::ErrorCode::io:
  case isoscope::ErrorCode::internal:
    break;
  }
  return 2;
}

int complain(const isoscope::Error& error) {
  std::fprintf(stderr, "isoscope: %s\n", error.line().c_str());
  return exit_status(error.code);
}

} // namespace

int main(int argc, char** argv) {
  const auto parsed = isoscope::parse_options(argc, argv);
  if (!parsed) {
    complain(parsed.error());
    return exit_status(isoscope::ErrorCode::usage);
  }
  if (parsed->print) {
    std::fputs(parsed->print->c_str(), stdout);
    return 0;
  }
  const auto app = isoscope::App::create(parsed->options);
  if (!app) return complain(app.error());
  return (*app)->run();
}
