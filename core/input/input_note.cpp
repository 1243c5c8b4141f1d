// Lengths in δ, since that is what they are judged by.
#include "input/input_note.h"

#include <cstdio>

namespace isoscope {

std::string told(const InputNote& note, double delta) {
  if (note.deviation == 0) return note.text;
  char length[40];
  std::snprintf(length, sizeof length, " %.2g δ.", note.deviation / delta);
  return note.text + length;
}

} // namespace isoscope
