// Where shader texts come from: embedded files, or the source folder in developer builds.
#pragma once

#include "base/status.h"
#include "embedded_file.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace isoscope::gl {

/// Finds shader texts by file name and resolves their `#include "name"` lines (one level of nesting each, no
/// cycles).
class ShaderSource {
 public:
  /// `folder`: where developer builds read the files anew; empty to use the embedded ones.
  ShaderSource(std::span<const EmbeddedFile> embedded, std::filesystem::path folder);

  /// The whole text with its includes; fails with device and the missing name.
  Result<std::string> load(std::string_view name) const;
  /// Grows when a file in the folder changed; always 0 with embedded files.
  std::uint64_t revision() const;

 private:
  Result<std::string> read(std::string_view name) const;
  std::span<const EmbeddedFile> embedded_;
  std::filesystem::path folder_;
};

} // namespace isoscope::gl
