// One set of words for phases, kinds and layers, so that panels, scripts and help never differ.
#pragma once

#include "base/numbers.h"
#include "journal/vocabulary.h"
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
/// "outer", "inner"; where there are several insides "room 1", "room 2".
std::string side_text(int label, bool rooms = false);

/// A layer by name.
struct LayerName {
  std::string_view name, title, tip;
  LayerSettings ViewSettings::*member;
};
std::span<const LayerName> layer_names();

/// Three significant digits, without needless exponents: "0.0123", "1.83", "12,300".
std::string short_number(double value);
/// The same with as many digits more as tell it apart from `limit`: "1.00023" beside 1.
std::string number_beside(double value, double limit);
/// Bytes in a readable unit: "412 MB".
std::string bytes_text(std::size_t bytes);

} // namespace isoscope
