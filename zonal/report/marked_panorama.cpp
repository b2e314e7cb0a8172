#include "zonal/report/marked_panorama.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "zonal/base/check.h"

namespace zonal {
namespace {

constexpr int kLeastWidth = 1024, kMostWidth = 16384;
// In pixels. A line is its bright core and a dark border on either side.
constexpr double kCore = 1.2, kBorder = 2.4;
constexpr double kLeastRadius = 9, kGap = 7;
constexpr double kDigitWidth = 9, kDigitHeight = 15, kDigitStep = 14;
constexpr Rgb8 kBright = {255, 225, 40}, kDark = {0, 0, 0};

/// How much of a pixel at this distance from the middle of a line it covers, with a soft edge.
double coverage(double distance, double half_width) { return std::clamp(half_width + 0.5 - distance, 0.0, 1.0); }

std::uint8_t blend(std::uint8_t under, std::uint8_t over, double part) {
  return static_cast<std::uint8_t>(std::lround(under + part * (over - under)));
}

void blend(Rgb8& pixel, Rgb8 over, double part) {
  pixel = {blend(pixel.r, over.r, part), blend(pixel.g, over.g, part), blend(pixel.b, over.b, part)};
}

/// What the marks cover of a pixel: first all borders, then all cores, so that lines cross without gaps.
struct Ink {
  float border = 0, core = 0;
};

class Sheet {
 public:
  Sheet(int width, int height) : ink_(width, height), width_(width), height_(height) {}

  int width() const { return width_; }
  int height() const { return height_; }

  /// Across the seam; nothing above and below.
  void draw(int x, int y, double distance) {
    if (y < 0 || y >= height_ || distance > kBorder + 0.5) return;
    Ink& ink = ink_(((x % width_) + width_) % width_, y);
    ink.border = std::max(ink.border, static_cast<float>(coverage(distance, kBorder)));
    ink.core = std::max(ink.core, static_cast<float>(coverage(distance, kCore)));
  }

  void print_on(Image<Rgb8>& picture) const {
    for (std::size_t i = 0; i < ink_.size(); ++i) {
      if (ink_.values()[i].border > 0) blend(picture.values()[i], kDark, ink_.values()[i].border);
      if (ink_.values()[i].core > 0) blend(picture.values()[i], kBright, ink_.values()[i].core);
    }
  }

 private:
  Grid<Ink> ink_;
  int width_, height_;
};

/// The circle as the curve where the angle from the mark is the radius. The distance of a pixel from it, in pixels, is
/// the difference of the angles over the angle's slope there, so that lines are equally wide everywhere.
void draw_circle(Sheet& sheet, Vec3 center, double radius) {
  const double row = kPi / sheet.height(), column = 2 * kPi / sheet.width();
  const double polar = std::atan2(std::hypot(center.x, center.y), center.z), margin = (kBorder + 1) * row;
  const int first = std::max(0, static_cast<int>((polar - radius - margin) / row));
  const int last = std::min(sheet.height() - 1, static_cast<int>((polar + radius + margin) / row));
  std::vector<Vec3> around(static_cast<std::size_t>(sheet.width()));  // the horizontal direction of each column
  for (int x = 0; x < sheet.width(); ++x) {
    const double azimuth = kPi - (x + 0.5) * column;
    around[x] = {std::cos(azimuth), std::sin(azimuth), 0};
  }
  for (int y = first; y <= last; ++y) {
    const double sine = std::sin((y + 0.5) * row), cosine = std::cos((y + 0.5) * row);
    for (int x = 0; x < sheet.width(); ++x) {
      const Vec3 out = around[x], toward = sine * out + Vec3{0, 0, cosine};
      const double angle = angle_between(toward, center), off = std::abs(angle - radius);
      if (off > margin) continue;
      const double scale = std::max(std::sin(angle), 1e-9);
      const double along_row = sine * column * dot(Vec3{-out.y, out.x, 0}, center) / scale;
      const double along_column = row * dot(cosine * out - Vec3{0, 0, sine}, center) / scale;
      sheet.draw(x, y, off / std::max(std::hypot(along_row, along_column), 1e-3 * row));
    }
  }
}

struct Point {
  double x = 0, y = 0;
};

/// Seven segments of the unit square (y down): top, right above, right below, bottom, left below, left above, middle.
constexpr std::array<std::array<Point, 2>, 7> kSegments = {{{{{0, 0}, {1, 0}}},
                                                            {{{1, 0}, {1, 0.5}}},
                                                            {{{1, 0.5}, {1, 1}}},
                                                            {{{0, 1}, {1, 1}}},
                                                            {{{0, 0.5}, {0, 1}}},
                                                            {{{0, 0}, {0, 0.5}}},
                                                            {{{0, 0.5}, {1, 0.5}}}}};
/// Bit s: segment s is lit.
constexpr std::array<unsigned, 10> kDigits = {0x3f, 0x06, 0x5b, 0x4f, 0x66, 0x6d, 0x7d, 0x07, 0x7f, 0x6f};

double distance_to_segment(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

struct Box {
  double left = 0, top = 0, width = 0, height = 0;
};

bool overlap(const Box& a, const Box& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;
}

void draw_number(Sheet& sheet, const std::string& digits, const Box& box) {
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const double left = box.left + kDigitStep * static_cast<double>(i);
    for (int s = 0; s < 7; ++s) {
      if ((kDigits[digits[i] - '0'] >> s & 1) == 0) continue;
      const auto place = [&](Point p) { return Point{left + kDigitWidth * p.x, box.top + kDigitHeight * p.y}; };
      const Point a = place(kSegments[s][0]), b = place(kSegments[s][1]);
      const int margin = static_cast<int>(std::ceil(kBorder)) + 1;
      for (int y = static_cast<int>(a.y) - margin; y <= static_cast<int>(b.y) + margin; ++y) {
        for (int x = static_cast<int>(std::floor(a.x)) - margin; x <= static_cast<int>(b.x) + margin; ++x)
          sheet.draw(x, y, distance_to_segment({x + 0.5, y + 0.5}, a, b));
      }
    }
  }
}

Point center_of(const Sheet& sheet, Vec3 toward) {
  return {sheet.width() * (0.5 - std::atan2(toward.y, toward.x) / (2 * kPi)),
          sheet.height() * (std::atan2(std::hypot(toward.x, toward.y), toward.z) / kPi)};
}

/// Around a circle with some air. Far up and down it is wider than high; one around a pole has no sides.
Box box_around(const Sheet& sheet, Vec3 toward, double radius) {
  const Point center = center_of(sheet, toward);
  const double px_per_radian = sheet.height() / kPi, level = std::hypot(toward.x, toward.y);
  const double half_height = radius * px_per_radian + kGap;
  const double half_width = (std::sin(radius) < level ? std::asin(std::sin(radius) / level) * px_per_radian : 0) + kGap;
  return {center.x - half_width, center.y - half_height, 2 * half_width, 2 * half_height};
}

/// Beside the circle, inside the picture, and clear of what is there already if that can be.
Box place_number(const Sheet& sheet, const Box& circle, std::size_t digits, const std::vector<Box>& taken) {
  const double width = kDigitWidth + kDigitStep * static_cast<double>(digits - 1), height = kDigitHeight;
  const double right = circle.left + circle.width, bottom = circle.top + circle.height;
  const double across = circle.left + (circle.width - width) / 2, along = circle.top + (circle.height - height) / 2;
  const double left = circle.left - width, above = circle.top - height;
  const std::array<Point, 8> places = {{{right, along},
                                        {left, along},
                                        {across, above},
                                        {across, bottom},
                                        {right, above},
                                        {right, bottom},
                                        {left, above},
                                        {left, bottom}}};
  const auto inside = [&](const Box& box) {
    return box.top >= kGap && box.top + box.height <= sheet.height() - kGap && box.left >= kGap &&
           box.left + box.width <= sheet.width() - kGap;
  };
  for (const Point& place : places) {
    const Box box = {place.x, place.y, width, height};
    if (inside(box) && std::ranges::none_of(taken, [&](const Box& other) { return overlap(box, other); })) return box;
  }
  return {std::clamp(right, kGap, std::max(kGap, sheet.width() - kGap - width)),
          std::clamp(along, kGap, std::max(kGap, sheet.height() - kGap - height)), width, height};
}

Image<Rgb8> enlarged(const Image<Rgb8>& picture) {
  const int times = std::clamp((kLeastWidth + picture.width() - 1) / picture.width(), 1,
                               std::max(1, kMostWidth / std::max(picture.width(), picture.height())));
  if (times == 1) return picture;
  Image<Rgb8> large(times * picture.width(), times * picture.height());
  for (int y = 0; y < large.height(); ++y) {
    for (int x = 0; x < large.width(); ++x) large(x, y) = picture(x / times, y / times);
  }
  return large;
}

}  // namespace

Image<Rgb8> marked_panorama(const Image<Rgb>& panorama, std::span<const PanoramaMark> marks) {
  check(!panorama.empty(), "a panorama to mark must not be empty");
  for (const PanoramaMark& mark : marks) {
    check(std::abs(length(mark.direction) - 1) <= 1e-6, "a mark needs a unit direction");
    check(mark.half_angle >= 0 && mark.half_angle <= kPi, "a mark's half angle is from 0 to pi");
    check(mark.number >= 0, "a mark's number must not be negative");
  }
  Image<Rgb8> picture = enlarged(tonemap(panorama, {.exposure_ev = auto_exposure_ev(panorama)}));
  Sheet sheet(picture.width(), picture.height());
  std::vector<Box> circles;
  for (const PanoramaMark& mark : marks) {
    const double radius = std::max(mark.half_angle, kLeastRadius * kPi / sheet.height());
    draw_circle(sheet, mark.direction, radius);
    circles.push_back(box_around(sheet, mark.direction, radius));
  }
  std::vector<Box> taken = circles;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const std::string digits = std::to_string(marks[i].number);
    taken.push_back(place_number(sheet, circles[i], digits.size(), taken));
    draw_number(sheet, digits, taken.back());
  }
  sheet.print_on(picture);
  return picture;
}

}  // namespace zonal
