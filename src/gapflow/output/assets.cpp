// GNU as: .incbin takes the files in as they are.
#include "gapflow/output/assets.hpp"

#define GAPFLOW_ASSET(name, file)                                                                                              \
    __asm__(".pushsection .rodata\n"                                                                                           \
            "gapflow_asset_" #name ":\n"                                                                                       \
            ".incbin \"" GAPFLOW_ASSETS "/" file "\"\n"                                                                        \
            "gapflow_asset_" #name "_end:\n"                                                                                   \
            ".byte 0\n"                                                                                                        \
            ".popsection\n");                                                                                                  \
    extern "C" const char gapflow_asset_##name[];                                                                              \
    extern "C" const char gapflow_asset_##name##_end[];                                                                        \
    std::string_view name()                                                                                                    \
    {                                                                                                                          \
        return {gapflow_asset_##name, static_cast<std::size_t>(gapflow_asset_##name##_end - gapflow_asset_##name)};            \
    }

namespace gapflow::assets {

GAPFLOW_ASSET(page_html, "report.html")
GAPFLOW_ASSET(page_style, "report.css")
GAPFLOW_ASSET(page_script_2d, "report_2d.js")
GAPFLOW_ASSET(page_script_3d, "report_3d.js")
GAPFLOW_ASSET(font_pgm, "font.pgm")

} // namespace gapflow::assets
