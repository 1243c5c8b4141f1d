// Finds the real models of Debian's libcgal-demo for tests.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace isoscope {

/// The path of a mesh such as "elephant.off", unpacked once into the build folder (safe when several programs
/// ask at the same time); nullopt, with a line on standard output, where the package or the model is absent.
std::optional<std::filesystem::path> demo_model(std::string_view name);

} // namespace isoscope
