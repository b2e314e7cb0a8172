#include "zonal/report/gallery_plots.h"

#include <array>
#include <iterator>

#include "zonal/base/parallel.h"

namespace zonal {

std::vector<GalleryFigure> gallery_plots(const Run& run) {
  constexpr std::array kFamilies = {basis_figures, cosine_figures, light_model_figures, window_figures,
                                    legendre_figures};
  std::array<std::vector<GalleryFigure>, kFamilies.size()> drawn;
  for_each_block(run, "gallery of functions", static_cast<int>(kFamilies.size()), 1,
                 [&](Block block) { drawn[block.index] = kFamilies[block.index](); });
  std::vector<GalleryFigure> all;
  for (std::vector<GalleryFigure>& figures : drawn) {
    all.insert(all.end(), std::make_move_iterator(figures.begin()), std::make_move_iterator(figures.end()));
  }
  return all;
}

}  // namespace zonal
