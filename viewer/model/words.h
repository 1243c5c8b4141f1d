// One set of words for phases, kinds and layers, so that panels, scripts and help never differ.
#pragma once

#include "base/numbers.h"
#include "collapse/collapse_attempt.h"
#include "journal/event.h"
#include "model/transport.h"
#include "run/session.h"
#include "scene/view_settings.h"

#include <span>
#include <string>
#include <string_view>

namespace isoscope {

std::string_view phase_word(SessionPhase phase);       ///< "running"
std::string_view transport_word(Transport::Mode mode); ///< "following"
std::string_view pick_word(Pick::Kind kind);           ///< "tet"

/// A layer by name.
struct LayerName {
  std::string_view name, title, tip;
  LayerSettings ViewSettings::*member;
};
std::span<const LayerName> layer_names();

/// The chip and menu title of a stage: "refine", "∂Γ", "tessellate", "Z", "all", "improve".
std::string_view stage_title(Stage stage);
/// What a stage does, in one sentence.
std::string_view stage_help(Stage stage);
/// A check of a collapse in a few words: "link condition in T".
std::string_view check_title(CollapseCheck check);
/// How a check is judged, for tooltips.
std::string_view check_help(CollapseCheck check);
/// A condition in a few words: "1 classification".
std::string_view condition_title(Condition condition);

/// Three significant digits, without needless exponents: "0.0123", "1.83", "12,300".
std::string short_number(double value);
/// The same with as many digits more as tell it apart from `limit`: "1.00023" beside 1.
std::string number_beside(double value, double limit);
/// Bytes in a readable unit: "412 MB".
std::string bytes_text(std::size_t bytes);

} // namespace isoscope
