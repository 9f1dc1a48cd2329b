// Files that are part of the program. web/build makes those of the page from web/src; their licences are in
// assets/LICENSES.txt.
#pragma once

#include <string_view>

namespace gapflow::assets {

std::string_view page_html(); ///< template of the page, with {{names}} of what goes in
std::string_view page_style();
std::string_view page_script_2d();
std::string_view page_script_3d();
std::string_view font_pgm(); ///< printable ASCII, a glyph below the other (assets/make_font)

} // namespace gapflow::assets
