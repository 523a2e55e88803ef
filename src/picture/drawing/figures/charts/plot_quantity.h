// The table of the quantities that a plot can show against time.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "drawing/stage/panel.h"
#include "text/languages.h"
#include "text/units.h"

namespace poinsot {

struct PlotCurve {
    Phrase label;  // a formula; words in \mathrm{}
    LineStyle (*ink)(const Theme& theme);
    DashPattern style;
};

constexpr std::size_t most_plot_curves = 6;
using PlotValues = std::array<double, most_plot_curves>;

// A row of the table of quantities.
struct PlotQuantity {
    std::string_view name;
    std::string_view summary;
    Phrase title;             // of the axis: text with $formulas$
    std::string_view unit{};  // SI; empty: none, or the title names it
    bool stacked = false;     // one chart per curve, each with its own scale
    bool decades = false;     // values are logarithms to base 10
    bool from_zero = false;   // the axis includes 0
    Quantities needs;
    bool (*possible)(const StageContext& stage);
    std::string_view requirement{};
    std::span<const PlotCurve> curves;
    PlotValues (*values)(const StageContext& stage, const FrameInput& instant);
    bool of_measured = true;  // whether it is shown of a measured motion, too
};

std::span<const PlotQuantity> plot_quantities();

// The quantity with this name, or the default one for the motion if the name is empty. Throws
// InputError with the nearest name and the list, or if the motion has no such quantity.
const PlotQuantity& plot_quantity_of(const StageContext& stage, std::string_view name);

// The unit in which a scene shows a quantity, and its values in that unit. Quantities with several
// units are not converted.
ShownUnit unit_of(const StageContext& stage, const PlotQuantity& quantity);
PlotValues shown_values(const StageContext& stage, const PlotQuantity& quantity,
                        const FrameInput& instant);

}  // namespace poinsot
