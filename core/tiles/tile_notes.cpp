// One object of JSON a tile. A process is alive while the system knows one of its number that began when it
// did.
#include "tiles/tile_notes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include <unistd.h>

namespace isoscope {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const char* file) {
  std::ifstream in(file);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// In ticks of the system; empty where there is no such process.
std::string began(long process) {
  const std::string text = text_of(("/proc/" + std::to_string(process) + "/stat").c_str());
  const std::size_t name_ends = text.rfind(')'); // a name may hold anything
  if (name_ends == std::string::npos) return {};
  std::istringstream words(text.substr(name_ends + 1));
  constexpr int field_behind_the_name = 20;
  std::string word;
  for (int i = 0; i < field_behind_the_name; ++i) words >> word;
  return word;
}

/// Of the machine since it was started.
std::string boot() {
  return text_of("/proc/sys/kernel/random/boot_id");
}

double seconds_since_epoch() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// There whole or not at all, but not brought to the disk: the end of the machine may take it.
void write(const std::filesystem::path& file, const Json& note) {
  std::filesystem::path beside = file;
  beside += "." + std::to_string(getpid());
  std::ofstream(beside) << note.dump() << "\n";
  std::error_code failed;
  std::filesystem::rename(beside, file, failed);
}

void read(const Json& note, TileReport& report) {
  const std::string said = note.at("state").get<std::string>();
  const std::string host = note.at("host").get<std::string>();
  const long process = note.at("process").get<long>();
  report.who = host + ", process " + std::to_string(process);
  report.here = host == host_name();
  if (report.state == TileState::made) {
    if (said == name(TileState::made)) report.seconds = note.at("seconds").get<double>();
    return;
  }
  if (said == name(TileState::failed)) {
    report.state = TileState::failed;
    report.words = note.at("why").get<std::string>();
  }
  if (said != name(TileState::in_hand)) return;
  const bool alive = !report.here || (note.at("boot") == boot() && note.at("began") == began(process));
  report.state = alive ? TileState::in_hand : TileState::lost;
  if (alive) report.seconds = std::max(0.0, seconds_since_epoch() - note.at("since").get<double>());
}

} // namespace

std::string_view name(TileState state) {
  constexpr std::array<std::string_view, tile_state_count> words{"waiting", "in hand", "lost", "failed",
                                                                 "made"};
  return words.at(static_cast<std::size_t>(state));
}

TileReport report_of(const TileFolder& folder, std::uint32_t round, const GridPlace& tile) {
  TileReport report;
  std::error_code failed;
  if (std::filesystem::exists(folder.output(round, tile), failed)) report.state = TileState::made;
  std::ifstream in(folder.note(round, tile));
  if (!in) return report;
  const Json note = Json::parse(in, nullptr, false);
  const TileState by_file = report.state;
  try {
    if (!note.is_discarded()) read(note, report);
  } catch (const Json::exception&) { // as if nobody had said anything
    report = {};
    report.state = by_file;
  }
  return report;
}

TileInHand::TileInHand(const TileFolder& folder, std::uint32_t round, const GridPlace& tile)
    : file_(folder.note(round, tile)), begun_(std::chrono::steady_clock::now()) {
  const long process = getpid();
  write(file_, {{"state", name(TileState::in_hand)},
                {"host", host_name()},
                {"process", process},
                {"boot", boot()},
                {"began", began(process)},
                {"since", seconds_since_epoch()}});
}

TileInHand::~TileInHand() {
  std::error_code failed;
  if (!told_) std::filesystem::remove(file_, failed);
}

void TileInHand::made() {
  told_ = true;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  write(
      file_,
      {{"state", name(TileState::made)}, {"host", host_name()}, {"process", getpid()}, {"seconds", seconds}});
}

void TileInHand::failed(const Error& why) {
  told_ = true;
  write(file_, {{"state", name(TileState::failed)},
                {"host", host_name()},
                {"process", getpid()},
                {"why", why.line()}});
}

} // namespace isoscope
