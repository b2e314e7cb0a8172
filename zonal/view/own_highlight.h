#pragma once

#include "zonal/image/image.h"
#include "zonal/view/view_data.h"

namespace zonal {

// A person's own highlight: a picture of any origin as a sphere map in the eye's frame (right, up, toward the eye).
// What is 1 in it, the white of a photograph, is kOwnHighlight times as bright as the light's mean, so that a picture
// goes with every light.

inline constexpr int kOwnHighlightPx = 128;  ///< along each side
inline constexpr double kOwnHighlight = 3;

/// The middle square of a picture (linear light) in kOwnHighlightPx texels a side, each the mean of what is under it.
/// Throws Error{kInput} for a picture with values that are not finite or below zero: they are no light.
Image<Rgb> own_highlight(const Image<Rgb>& picture);

/// The texture of the shaders. std::logic_error for another size than own_highlight() gives.
ViewTexture own_highlight_texture(Image<Rgb>);

/// In place of the black one that view_data() gives.
void set_own_highlight(ViewData&, Image<Rgb>);

}  // namespace zonal
