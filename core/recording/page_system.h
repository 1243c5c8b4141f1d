// Pages as a file system of SQLite's, in which there is one file.
#pragma once

#include "recording/page_file.h"

#include <memory>

namespace isoscope {

/// While it lives, a database can be opened in it: read only, without locks, and without a look at any other
/// file. Pages that are cut off read as zeros, which SQLite then finds damaged.
class PageSystem {
 public:
  static std::shared_ptr<const PageSystem> add(PageFile pages);
  ~PageSystem();
  PageSystem(const PageSystem&) = delete;
  PageSystem& operator=(const PageSystem&) = delete;
  /// What SQLite calls it.
  const char* name() const;

 private:
  struct Impl;
  explicit PageSystem(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

} // namespace isoscope
