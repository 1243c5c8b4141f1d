// What commands do that are made for scripts: values, expectations, waiting, mouse and keys.
#include "app/command_actions.h"
#include "command/named_values.h"
#include "command/usage.h"

namespace isoscope::actions {
namespace {

/// The first `count` arguments as numbers.
Result<std::vector<float>> numbers(const std::string& name, const Arguments& a, std::size_t count) {
  if (a.size() < count) return usage(name, "Numbers are missing.");
  std::vector<float> out;
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = parse_number(a[i]);
    if (!n) return n.error();
    out.push_back(static_cast<float>(*n));
  }
  return out;
}

bool has(const Arguments& a, std::string_view word) {
  for (const std::string& entry : a)
    if (entry == word) return true;
  return false;
}

} // namespace

Status set_value(AppModel& model, const Arguments& a) {
  if (a.size() != 2) return usage("set", "A name and a value are needed.");
  const NamedValue* value = find_value(a[0]);
  if (value == nullptr) return usage("set", "There is no value \"" + a[0] + "\".");
  if (!value->set) return usage("set", "\"" + a[0] + "\" can only be read.");
  return value->set(model, a[1]);
}

Status expect_value(AppModel& model, const Arguments& a) {
  if (a.size() != 1) return usage("expect", "A comparison is missing.");
  return expect(model, a[0]);
}

Status wait_for(AppModel& model, const Arguments& a) {
  if (a.empty() || a[0] == "settled") {
    model.wait_for = AppModel::Wait::settled;
    return {};
  }
  if (a[0] == "answers") {
    model.wait_for = AppModel::Wait::answers;
    return {};
  }
  const auto seconds = parse_number(a[0]);
  if (!seconds || *seconds < 0) return usage("wait", "\"" + a[0] + "\" is no time.");
  model.wait_until = model.clock + *seconds;
  return {};
}

Status move(AppModel& model, const Arguments& a) {
  const auto n = numbers("move", a, 2);
  if (!n) return n.error();
  // Two frames: the interface knows what is hovered one frame late.
  for (int i = 0; i < 2; ++i) model.requests.mouse.push_back({(*n)[0], (*n)[1]});
  return {};
}

Status click(AppModel& model, const Arguments& a) {
  const auto n = numbers("click", a, 2);
  if (!n) return n.error();
  const float x = (*n)[0], y = (*n)[1];
  const int button = has(a, "right") ? 1 : 0;
  auto& mouse = model.requests.mouse;
  mouse.push_back({x, y});
  mouse.push_back({x, y});
  mouse.push_back({x, y, button, true});
  mouse.push_back({x, y, button, false});
  mouse.push_back({x, y});
  return {};
}

Status drag(AppModel& model, const Arguments& a) {
  const auto n = numbers("drag", a, 4);
  if (!n) return n.error();
  const auto& p = *n;
  const int button = has(a, "right") ? 1 : 0;
  const bool shift = has(a, "shift");
  auto& mouse = model.requests.mouse;
  const auto add = [&](float t, bool down) {
    mouse.push_back({p[0] + t * (p[2] - p[0]), p[1] + t * (p[3] - p[1]), button, down, 0, shift, false});
  };
  add(0, false);
  add(0, false);
  constexpr int moves = 8;
  for (int i = 0; i <= moves; ++i) add(static_cast<float>(i) / moves, true);
  add(1, false);
  return {};
}

Status wheel(AppModel& model, const Arguments& a) {
  const auto n = numbers("wheel", a, 3);
  if (!n) return n.error();
  auto& mouse = model.requests.mouse;
  mouse.push_back({(*n)[0], (*n)[1]});
  mouse.push_back({(*n)[0], (*n)[1]});
  mouse.push_back({(*n)[0], (*n)[1], -1, false, (*n)[2]});
  return {};
}

Status give_hands(AppModel& model, const Arguments& a) {
  const auto n = numbers("hands", a, 1);
  if (!n) return n.error();
  model.requests.hands = static_cast<double>((*n)[0]);
  return {};
}

Status press_key(AppModel& model, const Arguments& a) {
  if (a.size() != 1) return usage("key", "Which key?");
  const Chord chord = parse_chord(a[0]);
  const Command* command = chord.key != 0 ? find_command(chord) : nullptr;
  if (command == nullptr) return usage("key", "The key \"" + a[0] + "\" does nothing.");
  return run_command(model, {std::string(command->name), {}});
}

} // namespace isoscope::actions
