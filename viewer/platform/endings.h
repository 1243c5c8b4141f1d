// What ends the window program from outside: signals, and a display that is gone.
#pragma once

#include <functional>
#include <string_view>

namespace isoscope {

/// From now on SIGINT, SIGTERM and SIGHUP are noted; a SIGHUP that was ignored, as under nohup, stays so. A
/// second SIGINT or SIGTERM ends the program at once with status 4.
void note_signals();
/// The signal that asks the program to end; 0 while there is none.
int noted_signal();
/// "SIGTERM", for those above.
std::string_view signal_name(int signal);

/// Calls `act` once the X server does not answer any more, on the thread that has asked it something, and
/// ends the program with status 2, after ten seconds at the latest: Xlib does not come back from there. `act`
/// must ask nothing of the window or of OpenGL.
void on_display_lost(std::function<void()> act);
/// Whether that has happened.
bool display_lost();

} // namespace isoscope
