// Which of two surfaces is the outer one: the files are read for that on a worker, so that nobody has to say
// it.
#pragma once

#include "base/status.h"
#include "model/worker.h"

#include <functional>
#include <optional>
#include <string>

namespace isoscope {

class WallOrder {
 public:
  explicit WallOrder(std::function<void()> notify);

  void ask(std::string one, std::string other);
  bool idle() const { return worker_.idle(); }
  /// Begins its end, and waits for nothing.
  void abandon() { worker_.abandon(); }

  struct Walls {
    std::string outer, inner;
  };
  /// The answer, once.
  std::optional<Result<Walls>> take();

 private:
  struct Question {
    std::string one, other;
  };
  Worker<Question, Result<Walls>> worker_;
  std::shared_ptr<const void> taken_;
};

} // namespace isoscope
