// Sorts more than fits into memory: runs in a scratch file, merged.
#pragma once

#include "base/scratch_file.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <queue>
#include <type_traits>
#include <vector>

namespace isoscope {

/// Records that come in any order and go in that of Less. Equal ones must be the same to whoever takes them.
template <class T, class Less> class ExternalSort {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// At most so many bytes of records are in memory, but at least a few thousand records.
  ExternalSort(std::size_t most_bytes, std::filesystem::path folder, Less less = {})
      : most_(std::max<std::size_t>(least_records, most_bytes / sizeof(T))), folder_(std::move(folder)),
        less_(less) {}

  void add(const T& record) {
    if (records_.empty()) records_.reserve(most_); // what is not written to takes no memory
    records_.push_back(record);
    ++size_;
    if (records_.size() >= most_) spill();
  }
  std::uint64_t size() const { return size_; }

  /// Once, in the end: all of them, ascending. Fails with io.
  Status each(const std::function<void(const T&)>& take) {
    if (!file_) {
      std::sort(records_.begin(), records_.end(), less_);
      for (const T& record : records_) take(record);
      return {};
    }
    if (!records_.empty()) spill();
    records_.shrink_to_fit();
    merge(take);
    return file_->status();
  }

 private:
  static constexpr std::size_t least_records = 4096;
  /// Of a run: what is left in the file, and what of it is in memory.
  struct Run {
    std::uint64_t at = 0, left = 0; ///< records
    std::vector<T> some;
    std::size_t next = 0;
  };

  void spill() {
    if (!file_) file_.emplace(folder_);
    std::sort(records_.begin(), records_.end(), less_);
    runs_.push_back({file_->size() / sizeof(T), records_.size(), {}, 0});
    file_->append(records_.data(), records_.size() * sizeof(T));
    records_.clear();
  }

  bool advance(Run& run, std::size_t at_once) {
    if (++run.next < run.some.size()) return true;
    if (run.left == 0) return false;
    run.some.resize(std::min<std::uint64_t>(run.left, at_once));
    file_->read(run.at * sizeof(T), run.some.data(), run.some.size() * sizeof(T));
    run.at += run.some.size();
    run.left -= run.some.size();
    run.next = 0;
    return true;
  }

  void merge(const std::function<void(const T&)>& take) {
    const std::size_t at_once = std::max<std::size_t>(16, most_ / (2 * runs_.size()));
    const auto later = [this](const Run* a, const Run* b) {
      return less_(b->some[b->next], a->some[a->next]);
    };
    std::priority_queue<Run*, std::vector<Run*>, decltype(later)> heads(later);
    for (Run& run : runs_)
      if (advance(run, at_once)) heads.push(&run);
    while (!heads.empty()) {
      Run* run = heads.top();
      heads.pop();
      take(run->some[run->next]);
      if (advance(*run, at_once)) heads.push(run);
    }
  }

  std::size_t most_;
  std::filesystem::path folder_;
  Less less_;
  std::vector<T> records_;
  std::uint64_t size_ = 0;
  std::optional<ScratchFile> file_;
  std::vector<Run> runs_;
};

} // namespace isoscope
