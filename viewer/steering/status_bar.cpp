// What the run and the step shown say of themselves.
#include "steering/steering.h"

#include "journal/vocabulary.h"
#include "model/words.h"
#include "steering/copy_words.h"
#include "two_runs/comparison.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <string>
#include <vector>

namespace isoscope::panels {
namespace {

std::string phase_text(const WindowState& m) {
  switch (m.run.phase) {
  case SessionPhase::idle:
    return "no run";
  case SessionPhase::preparing:
    return "preparing " + m.run.part;
  case SessionPhase::running:
    if (m.run.improving) return "improving until it is stopped";
    return m.run.part.empty() ? "running" : "running: " + m.run.part;
  case SessionPhase::paused:
    return m.run.pause_note.empty() ? "held" : "held: " + m.run.pause_note;
  case SessionPhase::following:
    return "following";
  case SessionPhase::finished:
    if (m.run.recording && m.run.recording->cut_short) return "ended without finishing";
    return !m.run.result                       ? "finished"
           : m.run.result->certificate.holds() ? "finished, certified"
                                               : "finished, not certified";
  case SessionPhase::failed:
    return "failed";
  }
  return {};
}

/// The operation in a word or three.
std::string operation_words(const Event& e) {
  switch (e.kind) {
  case EventKind::insertion:
    return "insertion for " + std::string(words(e.condition).title);
  case EventKind::collapse:
    return "collapse: " + std::string(words(e.reason).title);
  default:
    return std::string(words(e.kind).one);
  }
}

/// "records torus.isorun 1.2 MB"
std::string recording_text(const RecordingState& r, SessionPhase phase) {
  if (r.copied) return std::string(icon::record) + " " + copy_text(r, phase);
  const char* verb = r.error ? "stopped " : r.opened ? "reads " : "records ";
  return std::string(icon::record) + " " + verb + r.file.filename().string() + " " + bytes_text(r.bytes);
}

/// Operations a second over the last tenth of the run.
std::string rate_text(const WindowState& m) {
  if (!m.run.journal || m.run.journal->operations().size() < 20) return {};
  const auto& operations = m.run.journal->operations();
  const std::size_t last = operations.size() - 1,
                    first = last - std::min<std::size_t>(last, std::max<std::size_t>(20, last / 10));
  const auto& seconds_by_step = m.index.values(Figure::seconds);
  if (seconds_by_step.size() <= last) return {};
  const double seconds = static_cast<double>(seconds_by_step[last] - seconds_by_step[first]);
  if (!(seconds > 0)) return {};
  const double rate = static_cast<double>(last - first) / seconds;
  return rate >= 1000 ? short_number(rate / 1000) + " k ops/s" : short_number(rate) + " ops/s";
}

/// A piece of the line.
struct Part {
  std::string text;
  Rgb color = 0;
  std::string_view title; ///< of what is said where the mouse rests, if anything
  std::string help;
};

/// Why samples are bad, and what becomes of them.
std::string bad_samples_help(const WindowState& m, std::size_t bad) {
  if (bad == 0) return "f has the right sign at every sample: Z separates those of the two labels. §2.3";
  const std::string may_stay = m.why_bad_may_stay();
  return "At a bad sample f has the wrong sign: Z passes it on the wrong side. " +
         (may_stay.empty() ? "Refinement inserts points until there is none. W selects the worst. §2.3"
                           : may_stay);
}

/// From left to right, the most asked for first.
std::vector<Part> status_parts(const Ui& ui, const HistoryMemory& h) {
  const WindowState& m = ui.window;
  std::vector<Part> parts;
  const auto put = [&](std::string text, Rgb color, std::string_view title = {}, std::string help = {}) {
    if (!text.empty()) parts.push_back({std::move(text), color, title, std::move(help)});
  };
  put("step " + grouped(m.transport.step()) + " of " + grouped(m.live_step()), ui.colors.text);
  const bool failed =
      m.run.phase == SessionPhase::failed ||
      (m.run.phase == SessionPhase::finished && m.run.result && !m.run.result->certificate.holds());
  const auto state = m.state();
  if (state && state->event) {
    put(std::string(words(state->event->stage).title), stage_color(ui.theme, state->event->stage));
    put(operation_words(*state->event), ui.colors.text);
  }
  put(phase_text(m), failed ? ui.colors.warning_text : ui.colors.quiet);
  if (state && state->samples && state->classifies())
    put(grouped(state->bad_samples) + " bad of " + grouped(state->samples->size()) + " samples",
        !m.why_bad_may_stay().empty() ? ui.colors.quiet
        : state->bad_samples          ? ui.colors.bad_text
                                      : ui.colors.good_text,
        "Bad samples", bad_samples_help(m, state->bad_samples));
  if (state && m.run.scene)
    put("Z " + grouped(state->zero_set.vertices.size()) + " vertices", ui.colors.quiet);
  put(rate_text(m), ui.colors.quiet);
  if (m.run.journal) {
    const bool over = h.journal > h.limit;
    put((over ? std::string(icon::warning) + " " : "") + "history " + bytes_text(h.bytes()) + " of " +
            bytes_text(h.limit) + (h.disk > 0 ? ", " + bytes_text(h.disk) + " on disk" : ""),
        over ? ui.colors.warning_text : ui.colors.quiet);
  }
  if (m.run.recording)
    put(recording_text(*m.run.recording, m.run.phase),
        m.run.recording->error || m.run.recording->cut_short ? ui.colors.warning_text : ui.colors.quiet);
  if (m.run.scene && m.run.scene->points) {
    const PointField& points = *m.run.scene->points;
    const std::size_t dropped = points.dropped_points();
    put(grouped(points.points->points.size()) + " points" +
            (dropped > 0 ? ", " + grouped(dropped) + " dropped" : ""),
        ui.colors.quiet);
  }
  if (const auto grid = m.grid.grid(); grid && !m.grid.working())
    put(coarseness_in_words(*grid, m.grid.detail().get()), ui.colors.warning_text);
  return parts;
}

} // namespace

void status_bar(Ui& ui, const HistoryMemory& h) {
  const std::vector<Part> parts = status_parts(ui, h);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float y = low.y + (size.y - ui.fonts.small->FontSize) / 2, between = ui.px(12 + 8);
  float x = low.x + ui.px(12);
  const float end = low.x + size.x - ui.px(12);
  const auto put = [&](std::string_view s, Rgb color) {
    widgets::draw_text(list, ui.fonts.small, {x, y}, to_u32(color), s);
    x += widgets::width_of(ui.fonts.small, s) + ui.px(8);
  };
  const auto dot = [&] {
    list.AddCircleFilled({x + ui.px(2), low.y + size.y / 2}, ui.px(1.5f), to_u32(ui.colors.quiet, 0.7f), 8);
    x += ui.px(12);
  };
  const std::string all_more = "+" + grouped(parts.size()) + " more";
  const float sign = between + widgets::width_of(ui.fonts.small, all_more);
  std::size_t shown = 0;
  for (; shown < parts.size(); ++shown) {
    const bool last = shown + 1 == parts.size();
    const float width = widgets::width_of(ui.fonts.small, parts[shown].text) + (shown > 0 ? between : 0);
    if (x + width + (last ? 0 : sign) > end) break;
    if (shown > 0) dot();
    const Part& part = parts[shown];
    const float from = x;
    put(part.text, part.color);
    if (part.help.empty()) continue;
    ImGui::SetCursorScreenPos({from, low.y});
    ImGui::PushID(static_cast<int>(shown));
    ImGui::InvisibleButton("part", {std::max(x - from, 1.0f), size.y});
    ImGui::PopID();
    widgets::tip(ui, part.title, part.help);
  }
  if (shown == parts.size()) return;
  // What does not fit is told where the mouse asks for it: nothing goes without a sign.
  if (shown > 0) dot();
  const float from = x;
  put("+" + grouped(parts.size() - shown) + " more", ui.colors.accent_text);
  ImGui::SetCursorScreenPos({from, low.y});
  ImGui::InvisibleButton("more", {std::max(x - from, 1.0f), size.y});
  std::string rest;
  for (std::size_t i = shown; i < parts.size(); ++i) rest += (rest.empty() ? "" : "\n") + parts[i].text;
  widgets::tip(ui, "What does not fit here", rest);
}

void messages(Ui& ui, ImVec2 low, float width) {
  WindowState& m = ui.window;
  float y = low.y;
  for (std::size_t i = 0; i < m.messages.size(); ++i) {
    const Message message = m.messages[i];
    const std::string name = "##message" + std::to_string(i);
    ImGui::SetNextWindowPos({low.x, y});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(12), ui.px(8)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(7));
    // A script's clock is not one that people read by.
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, m.scripted ? 1.0f : std::max(message.strength(m.clock), 0.02f));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, to_vec(ui.colors.raised));
    ImGui::Begin(name.c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    const Rgb color = message.error ? ui.colors.bad_text : ui.colors.accent_text;
    ImGui::TextColored(to_vec(color), "%s", message.error ? icon::error : icon::info);
    ImGui::SameLine(0, ui.px(10));
    ImGui::BeginGroup();
    const float room = width - ui.px(52) - ImGui::GetCursorPosX();
    const std::string again = message.times > 1 ? "  (" + grouped(message.times) + " times)" : "";
    widgets::wrapped_text(message.text + again, room);
    if (!message.remedy.empty()) {
      const widgets::Font small(ui.fonts.small);
      ImGui::PushStyleColor(ImGuiCol_Text, to_vec(ui.colors.quiet));
      widgets::wrapped_text(message.remedy, room);
      ImGui::PopStyleColor();
    }
    ImGui::EndGroup();
    ImGui::SetCursorPos({width - ui.px(38), ui.px(4)});
    const bool closed = widgets::icon_button(ui, "close", icon::close);
    y += ImGui::GetWindowHeight() + ui.px(6);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
    if (closed) {
      m.messages.erase(m.messages.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
}

} // namespace isoscope::panels
