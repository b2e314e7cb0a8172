#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "zonal/io/file.h"
#include "zonal/view/mesh_file_gltf.h"

namespace zonal {
namespace {

constexpr const char* kDamaged = "the glTF file is damaged: export it again";

// Components as OpenGL names them (glTF 2.0, 3.6.2.2).
constexpr int kInt8 = 5120, kUint8 = 5121, kInt16 = 5122, kUint16 = 5123, kUint32 = 5125, kFloat = 5126;

std::size_t bytes_of(std::uint64_t type) {
  switch (type) {
    case kInt8:
    case kUint8:
      return 1;
    case kInt16:
    case kUint16:
      return 2;
    case kUint32:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

/// What 1 is as an integer that stands for -1..1 or 0..1.
double greatest_of(std::uint64_t type) {
  switch (type) {
    case kInt8:
      return 127;
    case kUint8:
      return 255;
    case kInt16:
      return 32767;
    case kUint16:
      return 65535;
    default:
      return 1;
  }
}

/// Little endian, as all of glTF.
template <class T>
T little(const std::byte* at) {
  std::uint32_t bits = 0;
  for (std::size_t i = sizeof(T); i-- > 0;) bits = bits << 8 | std::to_integer<std::uint32_t>(at[i]);
  if constexpr (std::is_same_v<T, float>) {
    return std::bit_cast<float>(bits);
  } else {
    return static_cast<T>(bits);
  }
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::vector<std::byte> base64_bytes(std::string_view text, const MeshSoup& soup) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::vector<std::byte> bytes;  // shorter than the text, whose length is limited
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) soup.fail("a buffer is no base64", kDamaged);
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> held & 0xff));
  }
  return bytes;
}

/// "%20" and its like.
std::string decoded(std::string_view address, const MeshSoup& soup) {
  const auto hex = [](char c) {
    const std::string_view digits = "0123456789abcdef";
    return digits.find(static_cast<char>(c >= 'A' && c <= 'F' ? c + 32 : c));
  };
  std::string text;
  for (std::size_t i = 0; i < address.size(); ++i) {
    if (address[i] != '%') {
      text += address[i];
      continue;
    }
    if (i + 2 >= address.size() || hex(address[i + 1]) > 15 || hex(address[i + 2]) > 15) {
      soup.fail("the address of a buffer is broken", kDamaged);
    }
    text += static_cast<char>(16 * hex(address[i + 1]) + hex(address[i + 2]));
    i += 2;
  }
  return text;
}

}  // namespace

double GltfNumbers::operator()(std::size_t i, int k) const {
  const std::byte* at =
      first_ + i * stride_ + static_cast<std::size_t>(k) * bytes_of(static_cast<std::uint64_t>(type_));
  switch (type_) {
    case kInt8:
      return std::max(-1.0, scale_ * little<std::int8_t>(at));
    case kUint8:
      return scale_ * little<std::uint8_t>(at);
    case kInt16:
      return std::max(-1.0, scale_ * little<std::int16_t>(at));
    case kUint16:
      return scale_ * little<std::uint16_t>(at);
    case kUint32:
      return little<std::uint32_t>(at);
    default:
      return little<float>(at);
  }
}

GltfNumbers GltfBuffers::numbers(std::uint64_t index, int components) {
  const GltfJson& accessor = gltf_member(soup_, document_, "accessors", index);
  if (accessor.contains("sparse") || !accessor.contains("bufferView")) {
    soup_.fail("it has sparse accessors, which are not read here", "export it without");
  }
  constexpr std::array<std::string_view, 3> kShapes = {"SCALAR", "VEC2", "VEC3"};
  const auto shape = accessor.find("type");
  if (shape == accessor.end() || *shape != kShapes[static_cast<std::size_t>(components - 1)]) {
    soup_.fail(fmt::format("accessor {} has not {} components", index, components), kDamaged);
  }
  const auto number = [&](const GltfJson& object, const char* key, std::uint64_t otherwise) {
    return gltf_number(soup_, object, key, otherwise);
  };
  const std::uint64_t type = number(accessor, "componentType", 0);
  const std::size_t element = bytes_of(type) * static_cast<std::size_t>(components);
  if (element == 0) soup_.fail(fmt::format("there is no type {} of numbers", type), kDamaged);
  const auto normalised = accessor.find("normalized");
  const bool fractions = normalised != accessor.end() && normalised->is_boolean() && normalised->get<bool>();
  if (components > 1 && type != kFloat && !fractions) {
    soup_.fail("its vertices are integers of another scale", "export it without compression");
  }

  const GltfJson& view = gltf_member(soup_, document_, "bufferViews", number(accessor, "bufferView", 0));
  const std::span<const std::byte> bytes = buffer(number(view, "buffer", ~std::uint64_t{0}));
  const std::uint64_t begin = number(view, "byteOffset", 0), size = number(view, "byteLength", 0);
  const std::uint64_t offset = number(accessor, "byteOffset", 0), count = number(accessor, "count", 0);
  const std::uint64_t stride = number(view, "byteStride", element);
  // Each difference is taken after what makes it positive; no sum and no product can overflow.
  const bool view_fits = begin <= bytes.size() && size <= bytes.size() - begin;
  const bool fits = view_fits && offset <= size && stride >= element && stride <= 252 &&
                    (count == 0 || (element <= size - offset && count - 1 <= (size - offset - element) / stride));
  if (!fits) soup_.fail(fmt::format("accessor {} reaches out of its buffer", index), kDamaged);
  GltfNumbers numbers;
  numbers.first_ = bytes.data() + begin + offset;
  numbers.count_ = count;
  numbers.stride_ = stride;
  numbers.type_ = static_cast<int>(type);
  if (components > 1 && type != kFloat) numbers.scale_ = 1 / greatest_of(type);
  return numbers;
}

std::span<const std::byte> GltfBuffers::buffer(std::uint64_t index) {
  const GltfJson& buffer = gltf_member(soup_, document_, "buffers", index);
  std::span<const std::byte> bytes;
  const auto address = buffer.find("uri");
  if (address == buffer.end()) {
    if (index != 0 || glb_buffer_.empty()) soup_.fail(fmt::format("buffer {} is nowhere", index), kDamaged);
    bytes = glb_buffer_;
  } else {
    if (!address->is_string()) soup_.fail("the address of a buffer is no text", kDamaged);
    const auto [found, is_new] = loaded_.try_emplace(index);
    if (is_new) {
      found->second = read(address->get_ref<const std::string&>());
      loaded_bytes_ += found->second.size();
    }
    bytes = found->second;
  }
  const std::uint64_t size = gltf_number(soup_, buffer, "byteLength", 0);
  if (size > bytes.size()) soup_.fail(fmt::format("buffer {} ends early", index), kDamaged);
  return bytes.first(size);
}

std::vector<std::byte> GltfBuffers::read(const std::string& address) const {
  if (!address.starts_with("data:")) return read_beside(address);
  const std::string_view text = address;
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || !text.substr(0, comma).ends_with(";base64")) {
    soup_.fail("a buffer is no base64", kDamaged);
  }
  return base64_bytes(text.substr(comma + 1), soup_);
}

std::vector<std::byte> GltfBuffers::read_beside(const std::string& address) const {
  namespace fs = std::filesystem;
  const std::string name = decoded(address, soup_);
  const auto refuse = [&] {
    soup_.fail(fmt::format("it asks for '{}', which is not in its folder", address.substr(0, 200)),
               "put all of its files into one folder, or export it as one file (.glb)");
  };
  const fs::path path = name;
  const bool has_nul = name.find('\0') != std::string::npos, has_scheme = name.find(':') != std::string::npos;
  if (name.empty() || has_nul || has_scheme || name.find('\\') != std::string::npos || path.is_absolute()) refuse();
  // What the name stands for, links followed, lies under what the folder stands for.
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(folder_), error);
  if (error) refuse();
  const fs::path file = fs::weakly_canonical(folder / path, error);
  if (error) refuse();
  const auto [end, in_file] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  if (end != folder.end() || in_file == file.end()) refuse();
  return read_file(file, soup_.options().max_bytes - loaded_bytes_);
}

}  // namespace zonal
