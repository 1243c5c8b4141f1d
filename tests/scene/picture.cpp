// Pictures of the renderer under test: pixels, comparison, reference files.
#include "scene/picture.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <cstdlib>
#include <filesystem>

namespace isoscope::testing {

Picture take(const Renderer& renderer, const Renderer::Frame& frame) {
  return {frame.width, frame.height, renderer.read_pixels(frame)};
}

double difference(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height || a.rgba.empty()) return 255;
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    if (i % 4 != 3) sum += std::abs(int(a.rgba[i]) - int(b.rgba[i]));
  return sum / (0.75 * static_cast<double>(a.rgba.size()));
}

double compare_with_reference(const Picture& picture, const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(ISOSCOPE_REFERENCE_FOLDER) / (name + ".png");
  if (std::getenv("ISOSCOPE_UPDATE_REFERENCES")) {
    std::filesystem::create_directories(file.parent_path());
    stbi_write_png(file.c_str(), picture.width, picture.height, 4, picture.rgba.data(), 4 * picture.width);
    return 0;
  }
  Picture reference;
  int channels = 0;
  stbi_uc* pixels = stbi_load(file.c_str(), &reference.width, &reference.height, &channels, 4);
  if (!pixels) return 255;
  reference.rgba.assign(pixels, pixels + 4 * reference.width * reference.height);
  stbi_image_free(pixels);
  const double found = difference(picture, reference);
  if (found > 1)
    stbi_write_png((std::string(ISOSCOPE_PICTURE_FOLDER) + "/differs_" + name + ".png").c_str(),
                   picture.width, picture.height, 4, picture.rgba.data(), 4 * picture.width);
  return found;
}

} // namespace isoscope::testing
