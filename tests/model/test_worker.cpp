// A worker answers the newest question; what is overtaken is cancelled or finished.
#include "model/worker.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

using namespace isoscope;

namespace {

/// Answers the first question when it is let go, the others at once.
struct Gate {
  std::atomic<bool> begun = false, open = false;
  Worker<int, int>::Work work() {
    return [this](int question, RunControl&) {
      begun = true;
      while (question == 1 && !open) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return std::make_shared<const int>(10 * question);
    };
  }
};

/// The questions whose answers were told while 1 was overtaken by 2 and 3.
std::vector<int> told(Overtaken overtaken) {
  Gate gate;
  std::vector<int> questions;
  Worker<int, int>* asked = nullptr;
  Worker<int, int> worker(
      gate.work(),
      [&] {
        if (const auto answered = asked->answered()) questions.push_back(answered->question);
      },
      overtaken);
  asked = &worker;
  CHECK(worker.idle());
  worker.ask(1);
  while (!gate.begun) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  worker.ask(2);
  worker.ask(3);
  CHECK(!worker.idle());
  gate.open = true;
  worker.wait();
  CHECK(*worker.answered()->answer == 30);
  worker.abandon();
  return questions;
}

} // namespace

TEST_CASE("the newest question wins, one that was not begun is replaced") {
  CHECK(told(Overtaken::cancelled).size() <= 1);
  const std::vector<int> finished = told(Overtaken::finished);
  REQUIRE(!finished.empty());
  CHECK(finished.front() == 1);
}
