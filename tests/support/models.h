// Finds the real models of Debian's libcgal-demo for tests.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace isoscope {

/// The path of a mesh such as "elephant.off", unpacked once into the build folder (safe when several programs
/// ask at the same time); nullopt, with a line on standard output, where the package or the model is absent.
std::optional<std::filesystem::path> demo_model(std::string_view name);

/// All mesh files of the package that we read, by name; none where it is absent.
std::vector<std::filesystem::path> demo_models();

} // namespace isoscope
