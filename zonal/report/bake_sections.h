#pragma once

#include <string>
#include <vector>

#include "zonal/report/bake_page.h"
#include "zonal/report/bake_pictures.h"

namespace zonal {

// The sections of a bake's page, as markup. Pictures first, then figures.

std::string panorama_section(const BakePage&, const BakePictures&);
std::string irradiance_section(const BakePage&, const BakePictures&);
std::string chain_section(const BakePage&, const BakePictures&);
std::string sh_section(const BakePage&, const BakePictures&);
std::string split_sum_section(const BakePage&, const BakePictures&);

std::string histogram_section(const Survey&);
std::string energy_section(const BakePage&);
std::string sun_section(const Survey&);
std::string warnings_section(const BakePage&);
std::string files_section(const std::vector<WrittenFile>&);
std::string accuracy_section(const BakePage&);
std::string timings_section(const std::vector<Timing>&);
std::string loading_section(const std::vector<Snippet>&);

}  // namespace zonal
