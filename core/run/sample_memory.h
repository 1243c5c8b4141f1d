// Whether the samples of a density fit into memory.
#pragma once

#include "base/status.h"
#include "tolerance/sample_estimate.h"

namespace isoscope {

/// Fails with unsupported where so many samples take more than so many bytes, naming the σ that fits.
/// `sigma` and `delta` are absolute.
Status check_memory(const SampleEstimate& estimate, double sigma, double delta, double most_bytes);

} // namespace isoscope
