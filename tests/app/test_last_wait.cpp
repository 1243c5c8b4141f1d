// The last wait ends a program whose threads do not, and stays out of the way of one whose threads do.
#include "app/last_wait.h"

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

using namespace isoscope;

namespace {

constexpr int status = 7, other_status = 3;

/// The exit status of a child that does `work`; -1 where a signal ended it.
template <class Work> int status_of(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(other_status);
  }
  int ended = 0;
  waitpid(child, &ended, 0);
  return WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
}

} // namespace

TEST_CASE("A program whose threads do not end exits with its status all the same") {
  CHECK(status_of([] {
          const LastWait wait(status, std::chrono::milliseconds(20));
          for (;;) pause();
        }) == status);
}

TEST_CASE("A program that ends in time is left alone") {
  CHECK(status_of([] { const LastWait wait(status, std::chrono::hours(1)); }) == other_status);
}
