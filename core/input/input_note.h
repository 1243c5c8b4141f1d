// What reading an input had to decide, for the user to know: told once, by every program, in the same words.
#pragma once

#include <string>

namespace isoscope {

/// One thing to tell. Notes travel with the soup, also into recordings.
struct InputNote {
  std::string text;     ///< a sentence; without its end where a length follows
  double deviation = 0; ///< a length of the input's unit that ends the sentence, told in δ; 0: none
  friend bool operator==(const InputNote&, const InputNote&) = default;
};

/// The note in full; `delta` is δ, absolute.
std::string told(const InputNote& note, double delta);

} // namespace isoscope
