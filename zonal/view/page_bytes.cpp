#include "zonal/view/page_bytes.h"

#include <bit>

namespace zonal {

std::size_t PageBytes::add_planes(std::span<const std::byte> numbers, std::size_t width) {
  const std::size_t count = numbers.size() / width;
  std::string planes(numbers.size(), 0);
  for (std::size_t plane = 0; plane < width; ++plane) {
    const std::size_t place = std::endian::native == std::endian::little ? plane : width - 1 - plane;
    for (std::size_t i = 0; i < count; ++i)
      planes[plane * count + i] = std::to_integer<char>(numbers[i * width + place]);
  }
  const auto [found, is_new] = known_.try_emplace(std::move(planes), bytes_.size());
  if (is_new) bytes_ += found->first;
  return found->second;
}

}  // namespace zonal
