// A file without a name for what does not fit into memory: gone when its object is, or the program is killed.
#pragma once

#include "base/status.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace isoscope {

/// Written at its end, read anywhere. One thread. What goes wrong is kept: status() tells, and nothing is
/// written or read any more.
class ScratchFile {
 public:
  /// In a folder that is there.
  explicit ScratchFile(const std::filesystem::path& folder);
  ~ScratchFile();
  ScratchFile(ScratchFile&& other) noexcept;
  ScratchFile& operator=(ScratchFile&&) = delete;

  void append(const void* data, std::size_t bytes);
  /// Zeros where it could not be read.
  void read(std::uint64_t at, void* data, std::size_t bytes) const;
  std::uint64_t size() const { return written_ + buffer_.size(); }
  Status status() const;

 private:
  void flush() const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
  mutable int error_ = 0;
  mutable std::uint64_t written_ = 0;
  mutable std::vector<char> buffer_; ///< of what is to be written
};

/// Reads records of a scratch file here and there, keeping the blocks that were read last.
class BlockReader {
 public:
  /// The file must outlive it and stay as it is. At most so many bytes of it are kept, and at least a block.
  BlockReader(const ScratchFile& file, std::size_t most_bytes);

  void read(std::uint64_t at, void* data, std::size_t bytes);
  /// The i-th of records that fill the file from its beginning.
  template <class T> T record(std::uint64_t i) {
    T value;
    read(i * sizeof(T), &value, sizeof(T));
    return value;
  }

 private:
  static constexpr std::uint64_t block_bytes = 1 << 14, no_block = ~std::uint64_t{0};
  struct Slot {
    std::uint64_t block = no_block;
    std::vector<char> bytes;
  };
  const std::vector<char>& block(std::uint64_t number);

  const ScratchFile& file_;
  std::vector<Slot> slots_;
};

} // namespace isoscope
