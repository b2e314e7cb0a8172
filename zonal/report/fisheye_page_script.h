#pragma once

#include <string_view>

namespace zonal {

/// The script of fisheye_page_html(): reads the data- attributes of #circle-tool and the controls below it.
std::string_view fisheye_page_script();

}  // namespace zonal
