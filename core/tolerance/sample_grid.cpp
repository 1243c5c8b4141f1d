// Open-addressing hash grid.
#include "tolerance/sample_grid.h"

namespace isoscope {
namespace {

constexpr std::size_t first_slots = 1024;
constexpr unsigned axis_bits = 21;
constexpr std::int64_t axis_offset = 1 << (axis_bits - 1);

std::uint64_t pack(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto part = [](std::int64_t i) { return static_cast<std::uint64_t>(i + axis_offset); };
  return part(x) | part(y) << axis_bits | part(z) << (2 * axis_bits);
}

std::uint64_t scramble(std::uint64_t key) {
  key ^= key >> 31;
  key *= 0x9e3779b97f4a7c15u;
  return key ^ key >> 29;
}

} // namespace

SampleGrid::SampleGrid(Vec3 origin, double side) : origin_(origin), side_(side), slots_(first_slots, none) {}

std::int64_t SampleGrid::coordinate(double x, double origin) const {
  return static_cast<std::int64_t>(std::floor((x - origin) / side_));
}

std::size_t SampleGrid::find(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = scramble(key) & mask;
  while (slots_[i] != none && keys_[slots_[i]] != key) i = (i + 1) & mask;
  return i;
}

void SampleGrid::grow() {
  slots_.assign(2 * slots_.size(), none);
  for (std::uint32_t cell = 0; cell < keys_.size(); ++cell) slots_[find(keys_[cell])] = cell;
}

void SampleGrid::add(Vec3 p) {
  const std::uint64_t key =
      pack(coordinate(p.x, origin_.x), coordinate(p.y, origin_.y), coordinate(p.z, origin_.z));
  std::size_t i = find(key);
  if (slots_[i] == none) {
    if (2 * (keys_.size() + 1) > slots_.size()) {
      grow();
      i = find(key);
    }
    slots_[i] = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    last_.push_back(none);
  }
  std::uint32_t& last = last_[slots_[i]];
  next_.push_back(last);
  last = static_cast<std::uint32_t>(next_.size() - 1);
}

void SampleGrid::gather(const Box3& box, std::vector<std::uint32_t>& found) const {
  const auto x0 = coordinate(box.lo.x, origin_.x), x1 = coordinate(box.hi.x, origin_.x);
  const auto y0 = coordinate(box.lo.y, origin_.y), y1 = coordinate(box.hi.y, origin_.y);
  const auto z0 = coordinate(box.lo.z, origin_.z), z1 = coordinate(box.hi.z, origin_.z);
  for (auto z = z0; z <= z1; ++z)
    for (auto y = y0; y <= y1; ++y)
      for (auto x = x0; x <= x1; ++x) {
        const std::uint32_t cell = slots_[find(pack(x, y, z))];
        if (cell == none) continue;
        for (std::uint32_t i = last_[cell]; i != none; i = next_[i]) found.push_back(i);
      }
}

} // namespace isoscope
