#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "zonal/io/output_folder.h"
#include "zonal/report/gallery.h"

namespace zonal {

/// What the page of a gallery says besides its figures.
struct GalleryOrigin {
  std::string probe;    ///< the name of the probe, for people
  std::string program;  ///< and version
};

/// The self-contained page: each figure with its pictures, its caption, its source and a table of the numbers printed
/// and computed. A number that does not hold is marked.
std::string gallery_page_html(const std::vector<GalleryFigure>&, const GalleryOrigin&);

struct GalleryFile {
  std::string name, what;
  std::uint64_t bytes = 0;
};

/// Adds each picture as NAME.svg or NAME.png and the page as index.html to a folder, which is the caller's to commit.
/// The page comes first in the list. Names of pictures must be unique, or std::logic_error.
std::vector<GalleryFile> write_gallery(const std::vector<GalleryFigure>&, const GalleryOrigin&, OutputFolder&);

}  // namespace zonal
