#pragma once

#include <vector>

#include "zonal/report/gallery.h"

namespace zonal {

// The rooms of gallery_plots(), one for each family of figures.

std::vector<GalleryFigure> basis_figures();
std::vector<GalleryFigure> cosine_figures();
std::vector<GalleryFigure> light_model_figures();
std::vector<GalleryFigure> window_figures();
std::vector<GalleryFigure> legendre_figures();

}  // namespace zonal
