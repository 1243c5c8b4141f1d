// Bookmarks of a run: a step with its view, selection and a note; in order they are the slides of a talk.
// Kept as a JSON sidecar.
#pragma once

#include "base/status.h"
#include "model/view_state.h"
#include "run/parameters.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

struct Bookmark {
  Step step = 0;
  Pick picked;
  std::optional<std::uint32_t> event; ///< the selection speaks of this event of the journal
  ViewState view;
  std::string note;
};

/// The list and the one shown last. Indices from 0.
class Bookmarks {
 public:
  const std::vector<Bookmark>& all() const { return all_; }
  std::size_t size() const { return all_.size(); }
  /// The bookmark shown last, nullopt when none was.
  std::optional<std::size_t> current() const { return current_; }

  /// Appends it and makes it current.
  void add(Bookmark bookmark);
  /// These three return false where there is no such bookmark.
  bool remove(std::size_t at);
  bool move(std::size_t from, std::size_t to);
  bool set_note(std::size_t at, std::string note);
  /// Makes a bookmark current; null where there is none.
  const Bookmark* go(std::size_t at);
  /// The slide `direction` (1 or -1) of the current one, first or last without one; nullopt at the end.
  std::optional<std::size_t> neighbour(int direction) const;
  void forget_current() { current_.reset(); }

 private:
  std::vector<Bookmark> all_;
  std::optional<std::size_t> current_;
};

/// What tells runs apart: the input (files by absolute path) and every parameter that changes the journal.
/// 16 hexadecimal digits.
std::string run_key(const RunParameters& parameters);
/// Where the bookmarks of a run are kept.
struct BookmarkFiles {
  /// A sidecar: RUN.isorun.bookmarks.json beside a recording, model.off.KEY.bookmarks.json beside an input
  /// file (its runs with other parameters have other steps); empty for bundled models.
  std::filesystem::path beside;
  std::filesystem::path fallback; ///< among the settings, where nothing can be written beside
};
/// Both empty where settings have no place. `recording`: the file shown, empty for a run.
BookmarkFiles bookmark_files(const std::filesystem::path& settings, const std::filesystem::path& recording,
                             const RunParameters& parameters);

std::string to_json(const Bookmarks& bookmarks, const RunParameters& parameters);
/// Fails with bad_input on text that is no list of bookmarks.
Result<Bookmarks> bookmarks_from_json(const std::string& text);
/// Written beside the target and renamed; fails with io.
Status save_bookmarks(const std::filesystem::path& file, const Bookmarks& bookmarks,
                      const RunParameters& parameters);
Result<Bookmarks> load_bookmarks(const std::filesystem::path& file);
/// Saves them in the sidecar, else in the fallback; the file it was, empty where both are. Fails with io.
Result<std::filesystem::path> keep_bookmarks(const BookmarkFiles& files, const Bookmarks& bookmarks,
                                             const RunParameters& parameters);
/// What is kept: of the sidecar, else of the fallback; empty without either.
Result<Bookmarks> kept_bookmarks(const BookmarkFiles& files);

} // namespace isoscope
