// The list and its sidecar.
#include "talk/bookmarks.h"

#include "base/pending_file.h"
#include "input/gallery.h"
#include "journal/digest.h"
#include "model/words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace isoscope {
namespace {

using nlohmann::json;
constexpr const char* format_name = "isoscope-bookmarks";
constexpr std::uintmax_t file_limit = 64 << 20;

std::optional<std::uint32_t> whole(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_unsigned() || found->get<std::uint64_t>() > 0xffffffffu)
    return std::nullopt;
  return found->get<std::uint32_t>();
}

json selection_json(const Bookmark& b) {
  json object = {{"kind", std::string(pick_word(b.picked.kind))},
                 {"id", b.picked.id},
                 {"other", b.picked.other},
                 {"point", {b.picked.point.x, b.picked.point.y, b.picked.point.z}}};
  if (b.event) object["event"] = *b.event;
  return object;
}

bool read_selection(const json& object, Bookmark& b) {
  const auto kind = object.find("kind"), point = object.find("point");
  if (kind == object.end() || !kind->is_string()) return false;
  bool known = false;
  for (int k = 0; k <= static_cast<int>(Pick::Kind::over_rim); ++k)
    if (pick_word(static_cast<Pick::Kind>(k)) == kind->get<std::string>()) {
      b.picked.kind = static_cast<Pick::Kind>(k);
      known = true;
    }
  const auto id = whole(object, "id"), other = whole(object, "other");
  if (!known || !id || !other || point == object.end() || !point->is_array() || point->size() != 3)
    return false;
  b.picked.id = *id;
  b.picked.other = *other;
  for (int i = 0; i < 3; ++i) {
    const json& entry = (*point)[static_cast<std::size_t>(i)];
    if (!entry.is_number()) return false;
    b.picked.point[i] = entry.get<double>();
  }
  b.event = whole(object, "event");
  return true;
}

std::optional<Bookmark> read_bookmark(const json& object) {
  if (!object.is_object()) return std::nullopt;
  Bookmark b;
  const auto step = whole(object, "step");
  const auto view = object.find("view"), selection = object.find("selection"), note = object.find("note");
  if (!step || view == object.end()) return std::nullopt;
  const auto state = view_from_json(view->dump(), {});
  if (!state) return std::nullopt;
  b.step = *step;
  b.view = *state;
  if (selection != object.end() && !read_selection(*selection, b)) return std::nullopt;
  if (note != object.end()) {
    if (!note->is_string()) return std::nullopt;
    b.note = note->get<std::string>();
  }
  return b;
}

Error no_bookmarks(const std::string& why) {
  return {ErrorCode::bad_input, "This is no list of bookmarks: " + why + ".",
          "Write one with the command bookmarks save FILE."};
}

bool is_file(const std::string& input) {
  return !input.starts_with(gallery_prefix);
}

} // namespace

void Bookmarks::add(Bookmark bookmark) {
  all_.push_back(std::move(bookmark));
  current_ = all_.size() - 1;
}

bool Bookmarks::remove(std::size_t at) {
  if (at >= all_.size()) return false;
  all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(at));
  if (current_ && *current_ == at)
    current_.reset();
  else if (current_ && *current_ > at)
    --*current_;
  return true;
}

bool Bookmarks::move(std::size_t from, std::size_t to) {
  if (from >= all_.size() || to >= all_.size()) return false;
  const auto place = [&](std::size_t i) { return all_.begin() + static_cast<std::ptrdiff_t>(i); };
  if (from < to)
    std::rotate(place(from), place(from + 1), place(to + 1));
  else
    std::rotate(place(to), place(from), place(from + 1));
  if (current_) {
    std::size_t& c = *current_;
    if (c == from)
      c = to;
    else if (from < c && c <= to)
      --c;
    else if (to <= c && c < from)
      ++c;
  }
  return true;
}

bool Bookmarks::set_note(std::size_t at, std::string note) {
  if (at >= all_.size()) return false;
  all_[at].note = std::move(note);
  return true;
}

const Bookmark* Bookmarks::go(std::size_t at) {
  if (at >= all_.size()) return nullptr;
  current_ = at;
  return &all_[at];
}

std::optional<std::size_t> Bookmarks::neighbour(int direction) const {
  if (all_.empty()) return std::nullopt;
  if (!current_) return direction > 0 ? 0 : all_.size() - 1;
  if (direction > 0) return *current_ + 1 < all_.size() ? std::optional(*current_ + 1) : std::nullopt;
  return *current_ > 0 ? std::optional(*current_ - 1) : std::nullopt;
}

std::string run_key(const RunParameters& p) {
  RunParameters named = p;
  std::error_code ignored;
  if (is_file(p.input)) named.input = std::filesystem::weakly_canonical(p.input, ignored).string();
  Digest digest;
  digest.add(std::string_view(fields_key(named)));
  return digest_text(digest.value());
}

BookmarkFiles bookmark_files(const std::filesystem::path& settings, const std::filesystem::path& recording,
                             const RunParameters& p) {
  if (settings.empty() || (p.input.empty() && recording.empty())) return {};
  RunParameters named = p;
  if (!recording.empty()) named.input = recording.string();
  const std::string key = run_key(named);
  BookmarkFiles files{{}, settings.parent_path() / "bookmarks" / (key + ".json")};
  const std::string ending = ".bookmarks.json";
  if (!recording.empty())
    files.beside = recording.string() + ending;
  else if (is_file(p.input))
    files.beside = p.input + "." + key.substr(0, 8) + ending;
  return files;
}

std::string to_json(const Bookmarks& bookmarks, const RunParameters& parameters) {
  json list = json::array();
  for (const Bookmark& b : bookmarks.all())
    list.push_back({{"step", b.step},
                    {"note", b.note},
                    {"selection", selection_json(b)},
                    {"view", json::parse(to_json(b.view))}});
  const json object = {{"format", format_name},
                       {"version", 1},
                       {"input", parameters.input},
                       {"run", run_key(parameters)},
                       {"bookmarks", list}};
  return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<Bookmarks> bookmarks_from_json(const std::string& text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return no_bookmarks("it is no JSON object");
  const auto name = object.find("format"), version = object.find("version"), list = object.find("bookmarks");
  if (name == object.end() || !name->is_string() || name->get<std::string>() != format_name)
    return no_bookmarks("it does not say so");
  if (version == object.end() || !version->is_number_integer() || version->get<int>() != 1)
    return no_bookmarks("its version is not 1");
  if (list == object.end() || !list->is_array()) return no_bookmarks("it has no list");
  Bookmarks bookmarks;
  for (std::size_t i = 0; i < list->size(); ++i) {
    auto bookmark = read_bookmark((*list)[i]);
    if (!bookmark) return no_bookmarks("entry " + std::to_string(i + 1) + " cannot be read");
    bookmarks.add(std::move(*bookmark));
  }
  bookmarks.forget_current(); // nothing of what was read has been shown yet
  return bookmarks;
}

Status save_bookmarks(const std::filesystem::path& file, const Bookmarks& bookmarks,
                      const RunParameters& parameters) {
  std::error_code ignored;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  PendingFile pending;
  if (Status s = pending.open(file); !s) return s;
  pending.append(to_json(bookmarks, parameters));
  return pending.commit();
}

Result<Bookmarks> load_bookmarks(const std::filesystem::path& file) {
  std::error_code trouble;
  const auto bytes = std::filesystem::file_size(file, trouble);
  std::ifstream in(file, std::ios::binary);
  if (trouble || !in) return Error{ErrorCode::io, "The bookmarks " + file.string() + " cannot be read.", ""};
  if (bytes > file_limit) return no_bookmarks("it is too large");
  return bookmarks_from_json(std::string{std::istreambuf_iterator<char>(in), {}});
}

Result<std::filesystem::path> keep_bookmarks(const BookmarkFiles& files, const Bookmarks& bookmarks,
                                             const RunParameters& parameters) {
  if (!files.beside.empty() && save_bookmarks(files.beside, bookmarks, parameters)) return files.beside;
  if (files.fallback.empty()) return std::filesystem::path();
  if (Status s = save_bookmarks(files.fallback, bookmarks, parameters); !s) return s.error();
  return files.fallback;
}

Result<Bookmarks> kept_bookmarks(const BookmarkFiles& files) {
  std::error_code ignored;
  for (const std::filesystem::path& file : {files.beside, files.fallback})
    if (!file.empty() && std::filesystem::exists(file, ignored)) return load_bookmarks(file);
  return Bookmarks();
}

} // namespace isoscope
