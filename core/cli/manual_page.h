// The manual page of a program, made from its command line.
#pragma once

#include <string>
#include <vector>

namespace isoscope {

/// An option or an argument as help lists it.
struct ManualEntry {
  std::string name;   ///< "-o,--output"
  std::string values; ///< "TEXT"; empty for a switch
  std::string text;
};

/// A verb of the program, which has a page of its own.
struct ManualVerb {
  std::string name;      ///< "replay"
  std::string arguments; ///< "RUN.isorun"
  std::string does;      ///< "reads a recording"
};

struct ManualPage {
  std::string program; ///< "isoscope-run", "isoscope-run replay"
  std::string version;
  std::string about; ///< its first sentence is what lists of pages show
  std::string usage; ///< what follows the program: "[OPTIONS] RUN"
  std::vector<ManualEntry> arguments, options;
  std::vector<ManualVerb> verbs;
  std::string notes;                 ///< paragraphs, an empty line between two; may be empty
  std::string exit_status;           ///< what each number means; may be empty
  std::vector<std::string> see_also; ///< other programs, besides the verbs and the one that this is a verb of

  /// "isoscope-run-replay", the page's name.
  std::string name() const;
  /// For man(1), in section 1: troff with the macros of man(7).
  std::string troff() const;
};

} // namespace isoscope
