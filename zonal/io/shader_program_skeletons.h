#pragma once

#include <string_view>

#include "zonal/io/shader.h"

namespace zonal {

/// The text of a program in one language, with $words for what shader_program.cpp fills in:
/// $about the comment at the top; $varying the name of what the first stage hands to the second; $to_varying and
/// $from_varying the expressions on either side; $shade_vertex and $shade_fragment the `shade` text in the stage that
/// has it, nothing in the other; $sh_vertex, $sh_fragment a parameter for the coefficients there.
struct ProgramSkeleton {
  std::string_view vertex, fragment;
  std::string_view shade;         ///< coefficients, constants and zonal_reflected(normal); $kdiff $fscale $k1 .. $k5
  std::string_view normal;        ///< mg * nv
  std::string_view sh_parameter;  ///< where coefficients are no global
  std::string_view sh_argument;   ///< and what is handed on
  std::string_view suffix;        ///< of a float
  int floats_apart = 4;           ///< from one colour of sh to the next
};

const ProgramSkeleton& program_skeleton(ShaderLanguage);

}  // namespace zonal
