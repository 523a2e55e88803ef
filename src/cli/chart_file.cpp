#include "cli/chart_file.h"

#include "image/files/png_files.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {

void write_chart(const Chart& chart, const ContextChoice& context,
                 const std::filesystem::path& path) {
    const ChartSheet sheet(chart, theme_named("light"), installed_fonts(), 1600, 1000);
    const OffscreenContext offscreen = make_context(context);
    Renderer renderer(offscreen);
    write_png(path, renderer.render(sheet.drawing()));
}

}  // namespace poinsot
