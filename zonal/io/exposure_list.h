#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "zonal/io/exposure_time.h"

namespace zonal {

/// Exposure times as a user lists them: "1/1000,1/250,0.5" in seconds, or "-2ev,0ev,+2ev" in exposure value steps, a
/// higher one being a longer exposure. Throws Error{kUsage}.
std::vector<double> parse_exposure_times(std::string_view text);

/// One line of an exposure list.
struct ListedExposure {
  std::string file;  ///< empty when the list only holds times
  ExposureSettings settings;
};

/// Reads a list of exposures, one a line, '#' starts a comment, a line with a single whole number above others of
/// several columns is a count:
///   TIME                                  seconds, fraction or ev step as above
///   FILE TIME
///   FILE 1/SECONDS F-NUMBER ISO DENSITY   as hdrgen and its relatives write it
///   FILE 1/SECONDS F-NUMBER GAIN DENSITY  the same with the gain in decibels (3 of them double the exposure), when a
///                                         comment of the list names its columns and one of them is "gain"
/// `name` is used in messages. Throws Error{kInput} with the line.
std::vector<ListedExposure> parse_exposure_list(const std::string& name, std::string_view text);

}  // namespace zonal
