// What the experiments compare with: every peer under one name, measured in one way.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"
#include "run/parameter_values.h"
#include "run/reverse_distance.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope::bench {

enum class Peer {
  lindstrom_turk, ///< CGAL's collapse without a bound, down to a number of vertices
  certificate,    ///< the same where each new triangle is proven within δ
  envelope,       ///< the same within CGAL's polyhedral envelope
  meshoptimizer,
  alpha_wrap
};

/// By the names of the command line: "lindstrom-turk" and so on.
std::optional<Peer> peer_of(std::string_view name);
std::vector<std::string> peer_names();

/// What a peer is asked: a tolerance, or of lindstrom_turk a number of vertices.
struct Asked {
  Peer peer = Peer::certificate;
  std::optional<Tolerance> tolerance;
  std::optional<std::size_t> vertices;
};

/// A peer's mesh and what is measured of it.
struct PeerResult {
  TriangleMesh mesh;
  bool intersects_itself = false; ///< exact
  double cpu_seconds = 0;         ///< of the simplification alone
  double longest_edge = 0;        ///< of the input's box
  DistanceBounds output_distance; ///< of the mesh to the input
  DistanceBounds input_distance;  ///< of the input to the mesh
};

/// Fails with usage where tolerance or vertices are missing, else as the peer does.
Result<PeerResult> ask_peer(const TriangleSoup& input, const Asked& asked);

/// The result without the mesh as one line of JSON.
std::string json_line(const PeerResult& result);

} // namespace isoscope::bench
