#include "production/vectors/flight_page.h"

#include "measured/prediction.h"
#include "typeset/files/installed_fonts.h"
#include "vector/pdf.h"
#include "vector/picture.h"
#include "vector/svg.h"

namespace poinsot {

ChartedFlight charted(const FittedMotion& fit, std::span<const MeasuredRow> rows) {
    ChartedFlight made;
    for (const MeasuredRow& row : rows) {
        made.times_s.push_back(row.time_s);
        made.measured.push_back(row.omega_body);
    }
    made.residuals = residuals_of(fit, rows);
    made.residual_unit = fit.unit();
    constexpr int n_curve = 600;
    const double first_s = made.times_s.front(), span_s = made.times_s.back() - first_s;
    for (int i = 0; i <= n_curve; ++i) made.curve_times_s.push_back(first_s + span_s * i / n_curve);
    made.curve = omega_of(fit, made.curve_times_s);
    return made;
}

std::string flight_page(const FlightChart& chart, const std::string& title, bool is_svg) {
    const FlightSheet sheet(chart, theme_named("light"), installed_fonts());
    const Drawing drawing = sheet.drawing();
    constexpr double pt_per_px = 0.36;  // type of 9 pt and more
    const vector::SheetOfPaper page = vector::paper_of(drawing, {.pt_per_px = pt_per_px});
    return is_svg ? vector::svg_of(page, title, "") : vector::pdf_of(page);
}

}  // namespace poinsot
