// A head of counts, then each list as it lies in memory.
#include "journal/stored_delta.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace isoscope {

namespace {

constexpr std::size_t segment_bytes = std::size_t{1} << 19;

/// The lists of a delta, in the order of their bytes.
template <class D> auto lists_of(D& d) {
  return std::tie(d.added_vertices, d.killed_vertices, d.values, d.moves, d.removed, d.added, d.sides,
                  d.dropped, d.removed_facets, d.added_facets, d.facet_labels);
}
constexpr std::size_t list_count = std::tuple_size_v<decltype(lists_of(std::declval<Delta&>()))>;

struct Head {
  std::uint32_t counts[list_count];
  std::uint32_t slots_before, facet_slots_before;
  Delta::SampleSetChange sample_set;
  Delta::FormChange form;
  bool has_sample_set, has_form;
};
static_assert(std::is_trivially_copyable_v<Head>);

template <class T> std::size_t bytes_of(const std::vector<T>& list) {
  static_assert(std::is_trivially_copyable_v<T>);
  return list.size() * sizeof(T);
}

Head head_of(const Delta& d) {
  Head head{};
  std::size_t i = 0;
  std::apply(
      [&](const auto&... list) { ((head.counts[i++] = static_cast<std::uint32_t>(list.size())), ...); },
      lists_of(d));
  head.slots_before = d.slots_before;
  head.facet_slots_before = d.facet_slots_before;
  head.has_sample_set = d.sample_set.has_value();
  head.has_form = d.form.has_value();
  if (d.sample_set) head.sample_set = *d.sample_set;
  if (d.form) head.form = *d.form;
  return head;
}

} // namespace

void StoredDelta::read(Delta& into) const {
  if (at == nullptr) {
    into = {};
    return;
  }
  Head head;
  std::memcpy(&head, at, sizeof head);
  const std::byte* from = at + sizeof head;
  std::size_t i = 0;
  const auto take = [&](auto& list) {
    list.resize(head.counts[i++]);
    if (!list.empty()) std::memcpy(list.data(), from, bytes_of(list));
    from += bytes_of(list);
  };
  std::apply([&](auto&... list) { (take(list), ...); }, lists_of(into));
  into.slots_before = head.slots_before;
  into.facet_slots_before = head.facet_slots_before;
  into.sample_set.reset();
  into.form.reset();
  if (head.has_sample_set) into.sample_set = head.sample_set;
  if (head.has_form) into.form = head.form;
}

Delta StoredDelta::read() const {
  Delta delta;
  read(delta);
  return delta;
}

std::byte* DeltaStore::room(std::size_t bytes) {
  if (bytes > std::numeric_limits<std::uint32_t>::max()) throw std::length_error("a delta of 4 GiB or more");
  if (segment_ == nullptr || used_ + bytes > size_) {
    if (segment_ != nullptr) pool_->seal(segment_, used_);
    size_ = std::max(bytes, segment_bytes);
    segment_ = pool_->take(size_);
    used_ = 0;
  }
  std::byte* at = segment_ + used_;
  used_ += bytes;
  return at;
}

StoredDelta DeltaStore::add(const Delta& delta) {
  const Head head = head_of(delta);
  std::size_t bytes = sizeof head;
  std::apply([&](const auto&... list) { ((bytes += bytes_of(list)), ...); }, lists_of(delta));
  std::byte* const at = room(bytes);
  std::byte* to = at;
  std::memcpy(to, &head, sizeof head);
  to += sizeof head;
  const auto put = [&](const auto& list) {
    if (!list.empty()) std::memcpy(to, list.data(), bytes_of(list));
    to += bytes_of(list);
  };
  std::apply([&](const auto&... list) { (put(list), ...); }, lists_of(delta));
  return {at, static_cast<std::uint32_t>(bytes)};
}

StoredDelta DeltaStore::add(const StoredDelta& delta) {
  if (delta.at == nullptr) return {};
  std::byte* const at = room(delta.size);
  std::memcpy(at, delta.at, delta.size);
  return {at, delta.size};
}

} // namespace isoscope
