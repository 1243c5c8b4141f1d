// Files that are no mesh files of ours but are often given as one, told by their first bytes.
#pragma once

#include <string_view>

namespace isoscope {

/// A kind of file and what its owner can do.
struct ForeignFormat {
  std::string_view marker; ///< bytes at `offset`; those of markup in any case
  std::size_t offset;
  std::string_view name;   ///< "a zip archive"
  std::string_view remedy; ///< a sentence
};

/// The kind that `head`, the first bytes of a file, belongs to; null when it is none of those known here.
const ForeignFormat* foreign_format(std::string_view head);

} // namespace isoscope
