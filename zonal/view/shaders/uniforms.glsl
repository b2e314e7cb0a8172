// The light as the library computed it (view/view_data.h), and the eye.

uniform sampler2D environment;         // panorama
uniform sampler2D environment_small;   // the same for the sums of the exact answers
uniform sampler2D environment_mips;    // the same with levels, each the mean of four texels of the last
uniform samplerCube environment_cube;
uniform sampler2D sphere_map;          // seen along +X
uniform sampler2D dual_paraboloid;     // front and back side by side, about +X
uniform samplerCube irradiance_map;    // E
uniform samplerCube ggx_chain;         // perceptual roughness from 0 to 1 over the levels
uniform samplerCube phong_chain;       // shininess phong_exponents over the levels
uniform sampler2D dfg_table;           // n.v across, roughness down: scale and bias of f0
uniform sampler2D ambient_table;       // n.v across; a band of rows for Lambert, Phong, Blinn-Phong, GGX
uniform sampler2D window_table;        // strength down; for Hann, Lanczos, Laplacian: bands 0..2, 3..5
uniform sampler2D bump_map;            // tangent-space normals' x and y, halved and shifted to 0..1; height, 0..1
uniform sampler2D highlight_map;       // a highlight as a sphere map in the eye's frame, computed
uniform sampler2D highlight_drawn;     // and drawn
uniform sampler2D highlight_own;       // and a person's own, 1 being highlight_unit
uniform sampler2D reflection_space;    // layers of tiles of eyes, each an octahedral map over the lobe's mean direction
uniform samplerCube reflection_chain;  // the split sum's map for the roughness of each layer, over the levels
uniform sampler2D lean_table;          // n.v across, roughness down: from the mirrored direction to that mean, radians
uniform sampler2D sky_maps;            // of the fisheye program, over black ground (view/sky_maps.h)
uniform sampler2D sky_shares;          // and the ground's share in them: as published, corrected
uniform sampler2D homework_table;      // a light set a row, its nine coefficients across

uniform vec3 sh[36];                   // radiance, six bands, l(l+1)+m
uniform vec3 sh_turned[36];            // the same, turned with the light where turn_by asks for it
uniform float cosine_factors[6];       // of the clamped cosine over pi
uniform float lecture_constants[5];    // k1..k5 of Ramamoorthi and Hanrahan's polynomial
uniform vec4 shading_constants[7];     // Sloan's seven vectors
uniform vec3 cube_sides[6];            // ambient cube of E/pi: +X -X +Y -Y +Z -Z
uniform vec3 mean_radiance;
uniform vec3 negative_tint;            // where light is below zero
uniform vec3 vector_irradiance[3];     // of red, green, blue
uniform vec3 light_directions[6];      // extracted: of the fit of one light, of two, of three; brightest first
uniform vec3 light_irradiance[6];
uniform float light_shares[6];         // of all light of the panorama, 4 pi times its mean, in luminance
uniform vec3 light_ambient[4];         // beside no light, one, two, three
uniform float phong_exponents[8];
uniform float chain_levels;            // of ggx_chain
uniform float phong_levels;
uniform float ambient_bands;           // of rows in ambient_table
uniform float greatest_shininess;      // in the last row of two of them
uniform float bump_height;             // of a whole of bump_map's height, in widths of its tile
uniform float reflection_views;        // tiles along a side of reflection_space
uniform float reflection_roughnesses[4];  // of the layers
uniform float highlight_unit;          // radiance
uniform float sky_exponents[8];        // shininess of the sky_maps, sky_levels of them
uniform float sky_levels;
uniform vec3 sky_mean;                 // of the upper half
uniform vec3 ground_mean;              // and of the lower
uniform float homework_scale;          // f_scale: as bright as the panorama
uniform float time_s;                  // since the viewer was opened, for what moves by itself
uniform int marked_lights;             // so many of the extracted lights are marked: rings in the background, arrows

uniform mat3 light_from_world;
uniform vec3 eye;
uniform mat3 eye_from_world;           // right, up, toward the eye
uniform mat4 world_from_clip;
uniform float split_px;                // where the picture turns to the exact answer
uniform int measure;                   // 0: colours for a screen; 1: squares of error and truth; 2..6: technique, exact
                                       // answer, normal, position, texture coordinates as they are
