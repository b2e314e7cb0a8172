#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "zonal/view/technique.h"

namespace zonal {

/// The homes of the shaders: the bodies are written once in what both languages share.
enum class ShaderHome {
  kDesktop,  ///< #version 410 core
  kWeb,      ///< #version 300 es, WebGL2
};

/// A shader in the order of its text. Shaders have pieces in common, which a page holds once.
using ShaderPieces = std::vector<std::string>;
std::string shader_text(const ShaderPieces&);

/// What a vertex goes through. Attributes 0 position, 1 normal, 2 texture coordinates.
ShaderPieces mesh_vertex_shader(ShaderHome);
/// The pixels of a surface: the technique, what it is compared with, exposure and tone curve.
ShaderPieces technique_fragment_shader(ShaderHome, const Technique&);
/// The same for pictures of the technique alone, in colours: software renderers work on both sides of every branch.
ShaderPieces lone_technique_fragment_shader(ShaderHome, const Technique&);
/// A triangle over the whole picture, without attributes, and the environment behind the object.
ShaderPieces background_vertex_shader(ShaderHome);
ShaderPieces background_fragment_shader(ShaderHome);
/// An arrow_mesh() for each of the first marked_lights instances, from its light toward the object. Its area is in
/// proportion to the light's share of all light, its hue is the light's; the tip is just outside the unit ball.
ShaderPieces arrow_vertex_shader(ShaderHome);
ShaderPieces arrow_fragment_shader(ShaderHome);

/// A body by its stem, as it is in zonal/view/shaders. std::logic_error when there is none.
std::string_view shader_body(std::string_view stem);

}  // namespace zonal
