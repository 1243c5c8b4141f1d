// A recording shown as if it were a run: read, and followed while another program writes it.
#pragma once

#include "run/session.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace isoscope {

/// Who watches; both are called on the thread that reads.
struct RecordingAudience {
  /// Changes what is shown. Its `recording` is there.
  std::function<void(const std::function<void(SessionSnapshot&)>& edit)> publish;
  /// Waits a little for more of the file; false, at once, where nobody wants more.
  std::function<bool()> wait;
};

/// Reads all that there is into the journal, makes Ω again, waits for the run's end, and leaves the phase
/// `finished`. Damage ends the reading and is shown. Fails, with nothing to show, as RecordingReader::open()
/// and rebuild_scene() do.
Status show_recording(const std::filesystem::path& file, const std::shared_ptr<Journal>& journal,
                      RunControl& control, const RecordingAudience& audience);

} // namespace isoscope
