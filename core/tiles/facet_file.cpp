// A head with a digest of itself, the bricks, then nine doubles a facet.
#include "tiles/facet_file.h"

#include "base/pending_file.h"
#include "base/point_order.h"
#include "journal/digest.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>

namespace isoscope {
namespace {

constexpr std::array<char, 8> magic{'i', 's', 'o', 't', 'i', 'l', 'e', '1'};

constexpr std::uint64_t facets_at_once = 4096;

struct Head {
  std::array<char, 8> name = magic;
  std::uint64_t bricks = 0, facets = 0;
  std::uint64_t digest = 0; ///< of the entries
};

/// As it stands in the file.
struct StoredEntry {
  std::int32_t x = 0, y = 0, z = 0;
  std::uint32_t count = 0;
  std::uint64_t first = 0;
  std::array<double, 6> box{};
};
static_assert(sizeof(StoredEntry) == 72 && sizeof(Head) == 32 && sizeof(Triangle3) == 72);

std::uint64_t digest_of(const std::vector<StoredEntry>& entries) {
  Digest d;
  for (const StoredEntry& e : entries) {
    d.add(e.x, e.y, e.z, e.count, e.first);
    for (const double b : e.box) d.add(b);
  }
  return d.value();
}

Error damaged(const std::filesystem::path& file) {
  return {ErrorCode::bad_input, file.string() + " is no sound file of a tile.",
          "Delete it: its tile is then made again."};
}

Result<std::vector<BrickEntry>> read_entries(std::ifstream& in, const std::filesystem::path& file) {
  Head head;
  if (!in) return Error{ErrorCode::io, file.string() + " cannot be opened.", ""};
  in.read(reinterpret_cast<char*>(&head), sizeof head);
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  if (!in || failed || head.name != magic || head.bricks > size / sizeof(StoredEntry) ||
      head.facets > size / sizeof(Triangle3) ||
      size != sizeof head + head.bricks * sizeof(StoredEntry) + head.facets * sizeof(Triangle3))
    return damaged(file);
  std::vector<StoredEntry> stored(head.bricks);
  in.read(reinterpret_cast<char*>(stored.data()),
          static_cast<std::streamsize>(stored.size() * sizeof(StoredEntry)));
  if (!in || digest_of(stored) != head.digest) return damaged(file);
  std::vector<BrickEntry> entries;
  for (const StoredEntry& s : stored)
    entries.push_back({{s.x, s.y, s.z},
                       s.count,
                       s.first,
                       {{s.box[0], s.box[1], s.box[2]}, {s.box[3], s.box[4], s.box[5]}}});
  return entries;
}

} // namespace

Triangle3 canonical(const Triangle3& facet) {
  Triangle3 turned = facet;
  std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end(), lies_before), turned.end());
  return turned;
}

bool comes_before(const Triangle3& a, const Triangle3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lies_before);
}

void make_canonical(std::vector<Triangle3>& facets) {
  for (Triangle3& f : facets) f = canonical(f);
  std::sort(facets.begin(), facets.end(), comes_before);
}

Status write_facets(const std::filesystem::path& file, const TileGrid& grid, std::vector<Triangle3> facets) {
  make_canonical(facets);
  std::map<GridPlace, std::vector<std::uint32_t>> bricks;
  for (std::uint32_t f = 0; f < facets.size(); ++f) bricks[grid.brick_of(facets[f][0])].push_back(f);
  std::vector<StoredEntry> entries;
  std::uint64_t first = 0;
  for (const auto& [brick, own] : bricks) {
    Box3 box;
    for (const std::uint32_t f : own)
      for (const Vec3 p : facets[f]) box.add(p);
    entries.push_back({brick[0],
                       brick[1],
                       brick[2],
                       static_cast<std::uint32_t>(own.size()),
                       first,
                       {box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z}});
    first += own.size();
  }
  Head head;
  head.bricks = entries.size();
  head.facets = facets.size();
  head.digest = digest_of(entries);
  PendingFile out;
  if (Status opened = out.open(file); !opened) return opened;
  out.append(&head, sizeof head);
  out.append(entries.data(), entries.size() * sizeof(StoredEntry));
  for (const auto& [brick, own] : bricks)
    for (const std::uint32_t f : own) out.append(&facets[f], sizeof(Triangle3));
  return out.commit();
}

Result<std::vector<BrickEntry>> read_bricks(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return read_entries(in, file);
}

Status each_facet(const std::filesystem::path& file, const std::function<void(const Triangle3&)>& take) {
  std::ifstream in(file, std::ios::binary);
  const auto entries = read_entries(in, file);
  if (!entries) return entries.error();
  std::uint64_t left = 0;
  for (const BrickEntry& e : *entries) left += e.count;
  std::vector<Triangle3> some;
  for (; left > 0; left -= some.size()) {
    some.resize(std::min<std::uint64_t>(left, facets_at_once));
    in.read(reinterpret_cast<char*>(some.data()),
            static_cast<std::streamsize>(some.size() * sizeof(Triangle3)));
    if (!in) return damaged(file);
    for (const Triangle3& f : some) take(f);
  }
  return {};
}

Status read_facets(const std::filesystem::path& file, const Box3& box, std::vector<Triangle3>& facets) {
  std::ifstream in(file, std::ios::binary);
  const auto entries = read_entries(in, file);
  if (!entries) return entries.error();
  const std::streamoff begin = in.tellg();
  for (const BrickEntry& e : *entries) {
    if (!e.box.meets(box)) continue;
    const std::size_t at = facets.size();
    facets.resize(at + e.count);
    in.seekg(begin + static_cast<std::streamoff>(e.first * sizeof(Triangle3)));
    in.read(reinterpret_cast<char*>(facets.data() + at),
            static_cast<std::streamsize>(e.count * sizeof(Triangle3)));
    if (!in) return damaged(file);
  }
  return {};
}

} // namespace isoscope
