#include "zonal/view/view_state.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "zonal/base/error.h"
#include "zonal/io/json_text.h"

namespace zonal {
namespace {

constexpr double kNear = 0.05, kFar = 100;

Matrix4 product(const Matrix4& a, const Matrix4& b) {
  Matrix4 result = {};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      for (int k = 0; k < 4; ++k) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    }
  }
  return result;
}

constexpr CameraField kCameraFields[] = {{"yaw", "around the object, degrees", &OrbitCamera::yaw_deg, -360, 360},
                                         {"pitch", "above it, degrees", &OrbitCamera::pitch_deg, -89, 89},
                                         {"distance", "distance, radii of the object", &OrbitCamera::distance, 1.2, 20},
                                         {"fov", "field of view, degrees", &OrbitCamera::fov_deg, 5, 120}};

double number_in(std::string_view text, std::string_view field) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw Error(ErrorKind::kUsage, fmt::format("'{}' is not a number for {}", text, field), "write it as 0.5");
  }
  return value;
}

void check_range(std::string_view field, double value, double least, double greatest) {
  if (value >= least && value <= greatest) return;
  throw Error(ErrorKind::kUsage, fmt::format("{} is {}", field, shortest(value)),
              fmt::format("it goes from {} to {}", shortest(least), shortest(greatest)));
}

const Control* find_control(std::string_view name) {
  for (const Control& control : all_controls()) {
    if (control.name == name) return &control;
  }
  return nullptr;
}

void set_field(ViewState& state, std::string_view field, std::string_view value) {
  if (field == "technique") {
    state.technique = technique_named(value);
    if (state.technique == nullptr) {
      throw Error(ErrorKind::kUsage, fmt::format("there is no technique '{}'", value), "zonal view --list shows all");
    }
    return;
  }
  if (field == "mesh") {
    state.mesh = value;
    return;
  }
  for (const CameraField& camera : kCameraFields) {
    if (camera.name != field) continue;
    const double number = number_in(value, field);
    check_range(field, number, camera.least, camera.greatest);
    state.camera.*camera.value = number;
    return;
  }
  state.set(field, number_in(value, field));
}

}  // namespace

std::span<const CameraField> camera_fields() { return kCameraFields; }

CameraMatrices camera_matrices(const OrbitCamera& camera, double aspect) {
  const double yaw = radians(camera.yaw_deg), pitch = radians(camera.pitch_deg);
  const Vec3 back = {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
  const Vec3 right = normalize(cross({0, 0, 1}, back)), up = cross(back, right);
  const Vec3 eye = camera.distance * back;
  const auto f = [](double x) { return static_cast<float>(x); };

  const double scale = 1 / std::tan(radians(camera.fov_deg) / 2);
  const double depth = (kFar + kNear) / (kNear - kFar), shift = 2 * kFar * kNear / (kNear - kFar);
  const Matrix4 clip_from_eye = {f(scale / aspect), 0, 0, 0, 0, f(scale), 0, 0, 0, 0, f(depth), -1, 0, 0, f(shift), 0};
  const Matrix4 eye_from_clip = {f(aspect / scale), 0, 0, 0, 0, f(1 / scale), 0, 0, 0, 0, 0, f(1 / shift), 0, 0, -1,
                                 f(depth / shift)};
  const Matrix4 eye_from_world = {f(right.x), f(up.x), f(back.x), 0, f(right.y), f(up.y), f(back.y),           0,
                                  f(right.z), f(up.z), f(back.z), 0, 0,          0,       f(-camera.distance), 1};
  const Matrix4 world_from_eye = {f(right.x), f(right.y), f(right.z), 0, f(up.x),  f(up.y),  f(up.z),  0,
                                  f(back.x),  f(back.y),  f(back.z),  0, f(eye.x), f(eye.y), f(eye.z), 1};
  return {eye,
          product(clip_from_eye, eye_from_world),
          product(world_from_eye, eye_from_clip),
          {f(right.x), f(up.x), f(back.x), f(right.y), f(up.y), f(back.y), f(right.z), f(up.z), f(back.z)}};
}

double ViewState::value(std::string_view control) const {
  const auto found = controls.find(control);
  return found == controls.end() ? control_named(control).initial : found->second;
}

void ViewState::set(std::string_view name, double value) {
  const Control* control = find_control(name);
  if (control == nullptr) {
    throw Error(ErrorKind::kUsage, fmt::format("there is no setting '{}'", name), "zonal view --list shows all");
  }
  check_range(name, value, control->least, control->greatest);
  if (control->kind != ControlKind::kSlider && value != std::floor(value)) {
    throw Error(ErrorKind::kUsage, fmt::format("{} is {}", name, shortest(value)), "it is a whole number");
  }
  if (value == control->initial) {
    const auto found = controls.find(name);
    if (found != controls.end()) controls.erase(found);
  } else {
    controls.insert_or_assign(std::string(name), value);
  }
}

int marked_lights(const ViewState& state) {
  if (state.technique->id == "extracted-lights") return static_cast<int>(std::lround(state.value("light_count")));
  return state.technique->id == "lambert" || state.technique->id == "near-lamp" ? 1 : 0;
}

std::string state_text(const ViewState& state) {
  std::string text = "technique=" + std::string(state.technique->id);
  const ViewState initial;
  if (state.mesh != initial.mesh) text += "&mesh=" + state.mesh;
  for (const CameraField& field : kCameraFields) {
    const double value = state.camera.*field.value;
    if (value != initial.camera.*field.value) text += fmt::format("&{}={}", field.name, shortest(value));
  }
  for (const auto& [name, value] : state.controls) text += fmt::format("&{}={}", name, shortest(value));
  return text;
}

ViewState parse_state(std::string_view text) {
  ViewState state;
  while (!text.empty()) {
    const std::string_view field = text.substr(0, text.find('&'));
    text.remove_prefix(std::min(text.size(), field.size() + 1));
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) {
      throw Error(ErrorKind::kUsage, fmt::format("'{}' is not a setting", field), "write name=value&name=value");
    }
    set_field(state, field.substr(0, equals), field.substr(equals + 1));
  }
  return state;
}

}  // namespace zonal
