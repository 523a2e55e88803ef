#include "cli/chart_file.h"

#include "image/files/png_files.h"
#include "production/vectors/flight_page.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {

void write_chart(const Chart& chart, const ContextChoice& context,
                 const std::filesystem::path& path) {
    const ChartSheet sheet(chart, theme_named("light"), installed_fonts(), 1600, 1000);
    const OffscreenContext offscreen = make_context(context);
    Renderer renderer(offscreen);
    write_png(path, renderer.render(sheet.drawing()));
}

bool is_flight_chart_name(const std::filesystem::path& path) {
    const std::string suffix = suffix_of(path);
    return suffix == ".svg" || suffix == ".pdf" || suffix == ".png";
}

void write_chart(const FlightChart& chart, const std::string& title,
                 const std::filesystem::path& path) {
    if (suffix_of(path) != ".png")
        return write_whole(path, flight_page(chart, title, suffix_of(path) == ".svg"));
    const FlightSheet sheet(chart, theme_named("light"), installed_fonts());
    const OffscreenContext offscreen = make_context({});
    Renderer renderer(offscreen);
    write_png(path, renderer.render(sheet.drawing()));
}

}  // namespace poinsot
