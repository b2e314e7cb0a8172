#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "apps/zonal/call.h"
#include "apps/zonal/input.h"
#include "zonal/io/sh_json.h"

namespace CLI {
class App;
}

namespace zonal {

/// What a user says about coefficients that are to be read, or taken from a picture.
struct CoefficientOptions {
  InputOptions input;
  std::optional<int> bands;
  int picture_bands = 3;  ///< of a picture if not said; of a file all that it has
};

/// IN, --bands, and what describes and turns the input.
void add_coefficient_options(CLI::App&, CoefficientOptions&);

struct Coefficients {
  ShFile sh;
  std::optional<Environment> picture;  ///< what they were taken from, turned as asked
};

/// Coefficients from a file (its name ends in .json, or it begins as JSON does), from standard input ("-") or from a
/// picture. Turned as --rotate says: a picture by its pixels, coefficients exactly, to the same effect. Says when there
/// are now fewer or more bands than in the file. Throws Error{kUsage} where options describe a picture and there is
/// none.
Coefficients read_coefficients(const CoefficientOptions&, Call&);

/// A file of coefficients, or standard input. Throws Error{kInput}.
ShFile read_sh_file(const std::filesystem::path&);
/// All of a file of text, or of standard input for "-". Throws Error{kInput}.
std::string read_text(const std::filesystem::path&);

/// "[[r, g, b], ...]"
JsonValue coefficients_json(std::span<const RgbD>);

/// Text that ends in a newline, into a file or, where the path is empty or "-", as the answer.
void write_text(const std::string& text, const std::filesystem::path&, const std::string& what, Call&);
/// The same of coefficients as a file of them; and their fields for machines.
void write_coefficients(const ShFile&, const std::filesystem::path&, Call&);
/// The option for that path.
void add_text_output(CLI::App&, std::filesystem::path&);

}  // namespace zonal
