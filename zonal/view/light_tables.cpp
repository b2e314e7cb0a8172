#include "zonal/view/light_tables.h"

#include <bit>
#include <cstdint>
#include <vector>

#include "zonal/io/half.h"
#include "zonal/view/opening_exposure.h"
#include "zonal/view/rgb9e5.h"

namespace zonal {
namespace {

using Array = JsonValue::Array;
using Object = JsonValue::Object;

std::size_t add_table(PageBytes& bytes, const Image<Rgb>& image) {
  std::vector<float> numbers;
  for (const Rgb& texel : image.values()) numbers.insert(numbers.end(), {texel.r, texel.g, texel.b});
  std::vector<std::uint16_t> halves(numbers.size());
  (void)halves_from_floats(numbers, halves);  // tables hold no number near the largest half
  return bytes.add(halves);
}

std::size_t add_light(PageBytes& bytes, const Image<Rgb>& image, std::size_t& cut_off) {
  std::vector<std::uint32_t> packed;
  for (const Rgb& texel : image.values()) {
    packed.push_back(rgb9e5(texel));
    if (max_channel(texel) > kRgb9e5Max) ++cut_off;
  }
  return bytes.add(packed);
}

Array textures(const ViewData& light, PageBytes& bytes, std::size_t& cut_off) {
  Array list;
  for (const ViewTexture& texture : light.textures) {
    Array levels;
    for (const Image<Rgb>& image : texture.levels) {
      const std::size_t at = texture.table ? add_table(bytes, image) : add_light(bytes, image, cut_off);
      levels.push_back(Array{at, image.width(), image.height()});
    }
    list.push_back(Object{{"name", texture.name},
                          {"cube", texture.shape == TextureShape::kCube},
                          {"repeats_x", texture.repeats_x},
                          {"repeats_y", texture.repeats_y},
                          {"table", texture.table},
                          {"levels", std::move(levels)}});
  }
  return list;
}

/// Where they begin and how many there are. As bytes, since code that writes decimals would be a tenth of the module.
Array floats(const std::vector<float>& values, PageBytes& bytes) {
  std::vector<std::uint32_t> bits;
  for (const float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
  return {bytes.add(bits), bits.size()};
}

Array uniforms(const ViewData& light, PageBytes& bytes) {
  Array list;
  for (const ViewUniform& uniform : light.uniforms) {
    list.push_back(Object{{"name", uniform.name}, {"floats", floats(uniform.values, bytes)}});
  }
  return list;
}

std::string cut_off_words(std::size_t texels) {
  if (texels == 0) return "";
  return std::to_string(texels) + " texels of its maps are brighter than " +
         std::to_string(static_cast<int>(kRgb9e5Max)) + " and were cut off there.";
}

}  // namespace

ViewDataOptions view_page_data_options() { return {.panorama_px = 256, .cube_px = 96, .chain_px = 64}; }

JsonValue::Object light_tables(const ViewData& light, PageBytes& bytes) {
  std::size_t cut_off = 0;
  Array pictures = textures(light, bytes, cut_off);
  return {{"textures", std::move(pictures)},
          {"uniforms", uniforms(light, bytes)},
          {"exposure_ev", floats(std::vector{static_cast<float>(opening_exposure_ev(light))}, bytes)},
          {"cut_off", cut_off_words(cut_off)}};
}

}  // namespace zonal
