#pragma once

#include <string>
#include <vector>

#include "zonal/image/image.h"
#include "zonal/image/tonemap.h"

namespace zonal {

// Small pictures in rows and columns with words around them, as one drawing of svg.h that holds the pictures inside.

/// A place in a picture: 0..1 from the left and from the top.
struct SheetMark {
  double x = 0, y = 0;
};

struct SheetCell {
  Image<Rgb8> picture;                ///< as it is shown; empty: a gap
  std::string label = {};             ///< words under it; a line feed starts a second line
  bool round = true;                  ///< only the disc that touches the edges is shown: a ball
  std::vector<SheetMark> marks = {};  ///< rings, visible on bright and dark
};

struct SheetRow {
  std::string heading;  ///< words over the row; may be empty
  std::vector<SheetCell> cells;
};

struct PictureSheet {
  std::string name;                       ///< letters, digits and hyphens; unique in a page
  std::string description;                ///< what the sheet shows, for those who cannot see it
  std::vector<std::string> columns = {};  ///< words over the columns; may be empty
  std::vector<SheetRow> rows;
};

/// An SVG of class "sheet", up to seven columns. Throws std::logic_error for a name with other letters, for no cells
/// and for more columns.
std::string picture_sheet(const PictureSheet&);

}  // namespace zonal
