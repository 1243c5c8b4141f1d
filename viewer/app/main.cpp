// The window program: reads the command line, opens the window, runs, and turns what went wrong into a word
// and an exit status.
#include "app/app.h"
#include "app/last_wait.h"
#include "app/options.h"
#include "cli/exit_status.h"
#include "platform/endings.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <utility>

namespace {

int status_of(isoscope::ErrorCode code) {
  if (isoscope::refuses_input(code)) return 3;
  return code == isoscope::ErrorCode::cancelled ? 4 : 2;
}

int complain(const isoscope::Error& error) {
  std::fprintf(stderr, "isoscope: %s\n", error.line().c_str());
  return status_of(error.code);
}

} // namespace

int main(int argc, char** argv) {
  const auto parsed = isoscope::parse_options(argc, argv);
  if (!parsed) {
    complain(parsed.error());
    return status_of(isoscope::ErrorCode::usage);
  }
  if (parsed->print) {
    std::signal(SIGPIPE, SIG_IGN);
    const isoscope::Status printed = isoscope::print(*parsed->print);
    // A reader that has had enough, as `head` has, is no failure.
    return printed || errno == EPIPE ? 0 : complain(printed.error());
  }
  isoscope::note_signals();
  auto created = isoscope::App::create(parsed->options);
  if (!created) return complain(created.error());
  std::unique_ptr<isoscope::App> app = std::move(*created);
  const int status = app->run();
  app->close();
  const isoscope::LastWait wait(status);
  app.reset();
  return status;
}
