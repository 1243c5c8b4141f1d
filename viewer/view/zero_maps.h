// What Z is coloured by at the step shown; a worker measures it.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "model/window_state.h"
#include "model/worker.h"
#include "questions/zero_map.h"

#include <functional>
#include <memory>

namespace isoscope {

/// What a map is called and what its numbers are.
struct ZeroMapWords {
  ZeroMapKind kind;
  std::string_view name, title, unit, help;
};
const ZeroMapWords& words(ZeroMapKind kind);

/// Methods are for one thread, the window's.
class ZeroMaps {
 public:
  /// `notify` is called from the worker.
  ZeroMaps(WindowState& shared, std::function<void()> notify);

  WindowState& window;

  /// Once a frame: asks for the chosen map of the state shown. True while it is made.
  bool update();
  /// Of the state shown; null where none is chosen, while it is made, and where it makes no sense.
  std::shared_ptr<const ZeroMap> map() const;
  /// It was asked for, and there is nothing to be measured.
  bool makes_no_sense() const;
  bool idle() const { return worker_.idle(); }
  void abandon() { worker_.abandon(); }

  void add_commands(CommandTable& table);
  void add_values(NamedValues& values);

 private:
  struct Question {
    std::shared_ptr<const StateSnapshot> state;
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Journal> journal;
    ZeroMapKind kind = ZeroMapKind::none;
    friend bool operator==(const Question&, const Question&) = default;
  };
  Question wanted() const;
  Worker<Question, ZeroMap> worker_;
  Question asked_;
};

} // namespace isoscope
