#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace zonal {

/// Any bytes as text for HTML and SVG, in elements and in quoted attributes alike: & < > " ' become entities; control
/// characters and bytes that are not UTF-8 become U+FFFD, so that a hostile file name can neither leave its place nor
/// break the page. Line feeds and tabs stay.
std::string escape(std::string_view);

// Figures for people, with a typographic minus and powers of ten. The exact values belong in machine-readable files.

/// `digits` significant digits, none of them lost left of the point: 0.0123, 2048, -1.50, 3.2×10⁻⁵. Zero is "0", an
/// infinity "∞", NaN "not a number". digits in [1, 17].
std::string number(double value, int digits = 3);
/// A fraction as a percentage: 0.0123 is "1.23 %".
std::string percent(double fraction, int digits = 3);
/// A size: "512 B", "1.50 MB" (powers of 1000).
std::string byte_count(std::uint64_t bytes);
/// A duration: "41.0 ms", "1.20 s".
std::string duration(double seconds);
/// An angle given in radians, to a hundredth of a degree: "−36.01°", "0.00°".
std::string angle(double radians);
/// An integer power of ten: 10⁻³.
std::string power_of_ten(int exponent);

}  // namespace zonal
