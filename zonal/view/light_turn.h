#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "zonal/light/orient.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {

// The light of a view can be turned freely, by three controls in the order of turned(): first light_roll_deg about +X,
// then light_pitch_deg, which lifts what is at +X, then light_yaw_deg about the vertical.

/// Whether a control is one of these three.
bool turns_light(std::string_view control);

Turn light_turn(const ViewState&);
/// Throws Error{kUsage} for angles outside the range of their control.
void set_light_turn(ViewState&, const Turn&);

/// What the light has at d the world has at the result times d.
Rotation world_from_light(const ViewState&);
/// The uniform of this name: the inverse, nine numbers, columns first.
std::array<float, 9> light_from_world(const ViewState&);

/// The uniform sh_turned: the coefficients of the uniform `sh`, three numbers each, turned with the light where the
/// control turn_by asks for it, so that directions of the world look them up; else as they are. O(bands^3).
std::vector<float> turned_coefficients(const ViewUniform& sh, const ViewState&);

/// The matrices by which a quarter turn about +X (from +Y to +Z) turns the coefficients of the bands of `sh`, as
/// rotation_blocks() orders them. With turns about Z they make every rotation, for homes without the library.
std::vector<double> quarter_turn_blocks();

}  // namespace zonal
