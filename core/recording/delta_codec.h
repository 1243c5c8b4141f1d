// Deltas as compact bytes: what the state before already says is left out.
#pragma once

#include "mesh/complex.h"
#include "recording/bytes.h"

#include <string_view>
#include <vector>

namespace isoscope {

/// The part of the state that deltas repeat: what vertices, tetrahedra and facets are before an operation.
class DeltaMirror {
 public:
  struct Cell {
    std::array<VertexId, 4> v;
    std::int8_t side = 0;
    std::uint8_t dropped = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  std::vector<Vec3> positions;
  std::vector<double> values;
  std::vector<Cell> cells;
  std::vector<std::array<VertexId, 3>> facets;

  void add(const std::vector<Vertex>& vertices);
  void put(const TetRecord& record);
  void put(const FacetRecord& record);
  bool holds(const TetRecord& record) const;
  bool holds(const FacetRecord& record) const;
  /// Fills a record from its id; false beyond what is held.
  bool recall(TetRecord& record) const;
  bool recall(FacetRecord& record) const;
};

/// Writes the deltas of one run in their order.
class DeltaEncoder {
 public:
  /// The bytes are valid until the next call.
  std::string_view encode(const Delta& delta);

 private:
  DeltaMirror mirror_;
  ByteWriter out_;
};

/// Reads them back, bit for bit, in the same order.
class DeltaDecoder {
 public:
  /// False when the bytes are not what an encoder wrote after the same deltas; nothing more can be read then.
  bool decode(std::string_view bytes, Delta& delta);

 private:
  DeltaMirror mirror_;
  std::size_t bytes_ = 0; ///< of all deltas so far
};

} // namespace isoscope
