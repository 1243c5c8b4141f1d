// What the commands on the play head do, and their table.
#include "steering/steering.h"

#include "command/commands.h"
#include "command/named_values.h"
#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// A breakpoint that speaks when another condition or stage than at the beginning asks for an operation.
Breakpoint at_change() {
  struct Seen {
    bool any = false;
    Condition condition = Condition::none;
    Stage stage = Stage::refinement;
  };
  auto seen = std::make_shared<Seen>();
  return [seen](const Journal&, const Event& event) -> std::string {
    if (!event.operation) return {};
    const bool change = seen->any && (event.condition != seen->condition || event.stage != seen->stage);
    *seen = {true, event.condition, event.stage};
    return change ? "another condition or stage" : "";
  };
}

Status play_or_pause(WindowState& m, const Arguments&) {
  if (m.playing()) {
    m.transport.pause();
  } else if (m.transport.at_live_end(m.live_step())) {
    if (m.run.phase == SessionPhase::paused) m.session.resume();
    if (m.running() || m.run.phase == SessionPhase::paused) {
      m.transport.follow();
    } else {
      m.transport.jump(0);
      m.transport.play();
    }
  } else {
    m.transport.play();
  }
  return {};
}

Status step_forward(WindowState& m, const Arguments& a) {
  const auto n = count_argument(a, "operations");
  if (!n) return n.error();
  const Step live = m.live_step();
  const long ahead = static_cast<long>(live) - static_cast<long>(m.transport.step());
  if (*n > ahead && m.run.phase == SessionPhase::paused) {
    m.session.step(static_cast<std::uint32_t>(*n - ahead));
    m.transport.follow();
  } else {
    m.transport.step_by(*n, live);
  }
  return {};
}

Status step_back(WindowState& m, const Arguments& a) {
  const auto n = count_argument(a, "operations");
  if (!n) return n.error();
  m.transport.step_by(-*n, m.live_step());
  return {};
}

Status next_change(WindowState& m, const Arguments&) {
  if (const auto step = m.index.next_change(m.transport.step())) {
    m.transport.jump(*step);
  } else if (m.run.phase == SessionPhase::paused) {
    m.session.run_until(at_change());
    m.transport.follow();
  } else {
    m.transport.follow();
  }
  return {};
}

Status previous_change(WindowState& m, const Arguments&) {
  const Step at = std::min(m.transport.step(), m.index.steps());
  if (at == 0) return {};
  Step k = at - 1;
  while (k > 0 && m.index.condition(k - 1) == m.index.condition(at - 1)) --k;
  m.transport.jump(k);
  return {};
}

Status seek(WindowState& m, const Arguments& a) {
  if (a.size() != 1) return wrong_arguments("A step is missing.");
  const auto step = number_argument(a, 0, 0, 4e9);
  if (!step) return wrong_arguments("\"" + a[0] + "\" is not a step.");
  m.transport.jump(std::min(static_cast<Step>(*step), m.live_step()));
  return {};
}

Status set_speed(WindowState& m, const Arguments& a) {
  if (a.size() != 1) return wrong_arguments("A speed is missing.");
  if (a[0] == "automatic") {
    m.transport.set_speed(Transport::automatic);
  } else if (a[0] == "unlimited") {
    m.transport.set_speed(Transport::unlimited);
  } else {
    const auto speed = read_number(a[0]);
    if (!speed || *speed <= 0) return wrong_arguments("\"" + a[0] + "\" is not a speed.");
    m.transport.set_speed(*speed);
  }
  return {};
}

Status change_speed(WindowState& m, int direction) {
  const auto offered = Transport::speeds();
  const auto at = std::lower_bound(offered.begin(), offered.end(), m.transport.speed());
  const auto place = std::clamp<std::ptrdiff_t>(at - offered.begin() + direction, 0, std::ssize(offered) - 1);
  m.transport.set_speed(offered[static_cast<std::size_t>(place)]);
  return {};
}

Status hold_or_resume(WindowState& m, const Arguments&) {
  if (m.run.phase == SessionPhase::paused)
    m.session.resume();
  else
    m.session.pause();
  return {};
}

} // namespace

void add_transport_commands(CommandTable& table, WindowState& m) {
  const auto has_run = [&m] { return m.has_run(); };
  add_group(table, {.menu = "Run", .enabled = has_run},
            {{.name = "play",
              .title = "Play / pause",
              .help = "Lets the play head run, or holds it.",
              .icon = icon::play,
              .keys = {{GLFW_KEY_SPACE}},
              .run = on(m, play_or_pause),
              .checked = [&m] { return m.playing(); }},
             {.name = "step",
              .title = "Next operation",
              .usage = "[N]",
              .help = "Goes N operations on; at the live end of a held run it makes them happen.",
              .icon = icon::forward,
              .keys = {{GLFW_KEY_RIGHT}},
              .run = on(m, step_forward)},
             {.name = "back",
              .title = "Previous operation",
              .usage = "[N]",
              .help = "Goes N operations back.",
              .icon = icon::back,
              .keys = {{GLFW_KEY_LEFT}},
              .run = on(m, step_back)},
             {.name = "next-change",
              .title = "To the next change",
              .help = "Goes on until another condition or stage asks for the operation.",
              .icon = icon::next_change,
              .keys = {{GLFW_KEY_RIGHT, true}},
              .run = on(m, next_change)},
             {.name = "previous-change",
              .title = "To the previous change",
              .help = "Goes back to where the present condition or stage began.",
              .keys = {{GLFW_KEY_LEFT, true}},
              .run = on(m, previous_change)},
             {.name = "first",
              .title = "To the start",
              .help = "Goes to step 0.",
              .icon = icon::first,
              .keys = {{GLFW_KEY_HOME}},
              .run = does([&m] { m.transport.jump(0); })},
             {.name = "end",
              .title = "Follow the live end",
              .help = "Goes to the newest step and stays there.",
              .icon = icon::last,
              .keys = {{GLFW_KEY_END}},
              .run = does([&m] { m.transport.follow(); }),
              .checked = [&m] { return m.transport.mode() == Transport::Mode::following; }}});
}

void add_pace_commands(CommandTable& table, WindowState& m) {
  const auto has_run = [&m] { return m.has_run(); };
  table.add({{.name = "seek",
              .title = "Go to step…",
              .usage = "STEP",
              .help = "Goes to a step.",
              .run = on(m, seek),
              .enabled = has_run},
             {.name = "speed",
              .title = "Speed",
              .usage = "automatic | unlimited | STEPS",
              .help = "Sets the play head's speed in steps a second.",
              .run = on(m, set_speed)}});
  add_group(
      table, {.menu = "Run"},
      {{.name = "faster",
        .title = "Faster",
        .help = "Takes the next higher speed.",
        .keys = {{GLFW_KEY_PERIOD}},
        .run = [&m](const Arguments&) { return change_speed(m, 1); }},
       {.name = "slower",
        .title = "Slower",
        .help = "Takes the next lower speed.",
        .keys = {{GLFW_KEY_COMMA}},
        .run = [&m](const Arguments&) { return change_speed(m, -1); }},
       {.name = "hold",
        .title = "Hold or let go the run",
        .help = "Stops the computation between two operations, or lets it go on.",
        .icon = icon::pause,
        .keys = {{GLFW_KEY_SPACE, false, true}},
        .run = on(m, hold_or_resume),
        .enabled =
            [&m] { return m.run.phase == SessionPhase::running || m.run.phase == SessionPhase::paused; },
        .checked = [&m] { return m.run.phase == SessionPhase::paused; }}});
}

} // namespace isoscope
