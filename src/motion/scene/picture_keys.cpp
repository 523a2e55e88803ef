// Keys of the picture's title, its look, and its panels.
#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "scene/camera_views.h"
#include "scene/scene_key_rows.h"
#include "text/languages.h"
#include "text/printable.h"
#include "text/units.h"

namespace poinsot {

namespace {

// The units for displayed numbers, each of a different kind of quantity.
void read_units(const GivenValue& given, SceneDraft& draft) {
    std::vector<std::string> units = given.texts();
    for (std::size_t i = 0; i < units.size(); ++i) {
        const auto unit = unit_named(units[i]);
        if (!unit)
            given.refuse(fmt::format("a list with \"{}\"", printable(units[i])),
                         fmt::format("give products of powers of these units, as \"g cm²/s\" or "
                                     "\"1/s\": {}",
                                     known_units()));
        for (std::size_t j = 0; j < i; ++j)
            if (unit_named(units[j])->dimension == unit->dimension)
                given.refuse(fmt::format("a list with \"{}\" and \"{}\"", printable(units[j]),
                                         printable(units[i])),
                             "both measure the same; leave one out");
    }
    draft.scene.units = std::move(units);
}

constexpr std::array<std::string_view, 3> hidden_styles{"pale", "dashed", "omitted"};
constexpr std::array<std::string_view, 2> crossing_styles{"through", "gap"};
constexpr std::array<std::string_view, 4> corners{"top left", "top right", "bottom left",
                                                  "bottom right"};

constexpr auto symbol(std::string SymbolsSpec::*member) { return in(&Scene::symbols, member); }

template <typename... Members>
constexpr auto panel(Members... members) {
    return in(&Scene::panels, members...);
}
template <typename Value>
constexpr auto camera_of_panel(Value PanelCameraSpec::*member) {
    return panel(&PanelSpec::camera, member);
}

}  // namespace

std::span<const SceneKey> picture_keys() {
    using namespace key_rows;
    static const SceneKey rows[] = {
        text("title", &Scene::title, R"("Tennis racket")", "heading of the picture")
            .default_is("the name of the file")
            .written_if_empty(),
        text("caption", &Scene::caption, R"("I = (3, 2, 1) kg m²")", "text below the picture")
            .default_is("none")
            .written_if_empty(),
        number("accuracy_px", &Scene::accuracy_px, within(1e-6, 100.0), "pixels", "0.1",
               "largest position error of the motion in the picture; curves are drawn within half "
               "of this value"),
        text("theme", &Scene::theme, R"("light")",
             "theme (colours and line styles), by name or as the path of a theme file (.toml)")
            .from_list("themes")
            .or_text("a file name", R"(\.toml$)"),
        one_of("hidden", &Scene::hidden, hidden_styles, R"("dashed")",
               "style of hidden lines; if dashed, all other broken lines become thin solid lines")
            .default_is("that of the theme (dashed in print, pale in the others)"),
        one_of("hidden_arrows", &Scene::hidden_arrows, hidden_styles, R"("pale")",
               "style of the hidden shafts and heads of arrows")
            .default_is("as `hidden`, if the scene gives it; else that of the theme (pale in every "
                        "supplied theme)"),
        one_of("crossings", &Scene::crossings, crossing_styles, R"("gap")",
               "how the line that is farther from the viewer is drawn at a crossing: through, or "
               "with a gap on both sides of the nearer line")
            .default_is("that of the theme (gap in every supplied theme)"),
        boolean("overlays", &Scene::overlays, "false",
                "whether the title, the chapter, the captions and the clock are drawn; the title "
                "is also the document title of a PDF or SVG")
            .omitted_if_default(),
        boolean("panel_letters", &Scene::panel_letters, "true",
                "whether the headings of several panels begin with (a), (b), … in reading order")
            .omitted_if_default(),
        boolean("clock", &Scene::clock, "false",
                "whether the clock, which shows the time of the motion, is drawn")
            .default_is("true, except in films that loop"),
        number("type_scale", &Scene::type_scale, within(0.25, 8.0), "", "1.25",
               "factor on the size of all type, such as 1.25 for a large room")
            .omitted_if_default(),
        one_of("language", &Scene::language, languages(), R"("de")",
               "language of the built-in headings and labels, and of decimal marks (a comma in de, "
               "fr, es and it)")
            .omitted_if_default(),
        texts("units", &Scene::units, R"(["rpm", "deg", "g cm²/s"])",
              "units of charts and live numbers; each unit is used for the quantity that it "
              "measures, and a unit of angle also for rates (deg/s)")
            .default_is("SI")
            .read_by(read_units),
        text("symbols.omega", symbol(&SymbolsSpec::omega), R"('\Omega')", "symbol for ω"),
        text("symbols.momentum", symbol(&SymbolsSpec::momentum), R"('\mathbf{J}')", "symbol for L"),
        text("symbols.rho", symbol(&SymbolsSpec::rho), R"('\mathbf{r}')", "symbol for ρ"),
        text("symbols.e1", symbol(&SymbolsSpec::e1), R"("x")",
             "symbol for the first principal axis"),
        text("symbols.e2", symbol(&SymbolsSpec::e2), R"("y")",
             "symbol for the second principal axis"),
        text("symbols.e3", symbol(&SymbolsSpec::e3), R"("z")",
             "symbol for the third principal axis"),
        texts("show", &Scene::show, R"(["plane", "ellipsoid", "polhode"])",
              "elements to draw, and overlays (`poinsot list overlays`)")
            .from_list("elements")
            .default_is("those that suit the motion"),
        boolean("labels", &Scene::labels, "false", "whether elements have labels")
            .omitted_if_default(),
        texts("unlabelled", &Scene::unlabelled, R"(["omega", "momentum"])",
              "elements without a label; the name of a kind of panel hides all labels in panels of "
              "this kind")
            .default_is("none"),
    };
    return rows;
}

std::span<const SceneKey> panel_keys() {
    using namespace key_rows;
    constexpr Bounds cell = within(0, most_cells), cells = within(1, most_cells);
    static const SceneKey rows[] = {
        // Several views of one motion, in the cells of a grid.
        numbers("grid.columns", in(&Scene::grid, &GridSpec::columns), positive, "", "[2.0, 1.0]",
                "relative widths of the grid's columns")
            .with_size({1, most_cells})
            .default_is("equal"),
        numbers("grid.rows", in(&Scene::grid, &GridSpec::rows), positive, "", "[1.0, 1.0]",
                "relative heights of the grid's rows")
            .with_size({1, most_cells})
            .default_is("equal"),
        text("panels[].kind", panel(&PanelSpec::kind), R"("space")", "what the panel shows")
            .from_list("panels"),
        integer("panels[].column", panel(&PanelSpec::column), cell, "0",
                "column of the panel's upper left cell, counted from 0"),
        integer("panels[].row", panel(&PanelSpec::row), cell, "0",
                "row of the panel's upper left cell, counted from 0"),
        integer("panels[].columns", panel(&PanelSpec::columns), cells, "1",
                "number of columns that the panel spans"),
        integer("panels[].rows", panel(&PanelSpec::rows), cells, "1",
                "number of rows that the panel spans"),
        text("panels[].quantity", panel(&PanelSpec::quantity), R"("omega")",
             "quantity that a plot shows against time")
            .from_list("quantities")
            .default_is("a quantity that suits the motion"),
        integer("panels[].curves", panel(&PanelSpec::curves), within(0, 40), "6",
                "in body panels: number of additional polhodes on each side of the separatrices")
            .default_is("as many as fill the ellipsoid evenly"),
        text("panels[].title", panel(&PanelSpec::title), R"("Body axes")",
             "heading of the panel; \"\" hides it")
            .default_is("the heading of its kind"),
        one_of("panels[].inset", panel(&PanelSpec::inset), corners, R"("top right")",
               "in space panels: corner with a small view of the herpolhode from above")
            .default_is("none"),
        // The camera of one panel, where it differs from [camera]; in body axes for body and
        // momentum.
        number("panels[].camera.azimuth_deg", camera_of_panel(&PanelCameraSpec::azimuth_deg),
               within(-3600.0, 3600.0), "degrees", "30.0",
               "as in [camera]; in body and momentum: angle about e3, from e1"),
        number(
            "panels[].camera.elevation_deg", camera_of_panel(&PanelCameraSpec::elevation_deg),
            elevations_deg, "degrees", "20.0",
            "as in [camera]; in body and momentum: angle from the plane of e1 and e2 towards e3"),
        number("panels[].camera.distance", camera_of_panel(&PanelCameraSpec::distance), distances,
               "units of the largest half-axis", "4.0",
               "as in [camera]; only for panels of kind space, because poinsot chooses the "
               "distance in all others"),
        number("panels[].camera.field_deg", camera_of_panel(&PanelCameraSpec::field_deg),
               fields_deg, "degrees", "20.0", "as in [camera]"),
        numbers("panels[].camera.target", camera_of_panel(&PanelCameraSpec::target), coordinates,
                "units of the largest half-axis", "[0.0, 0.0, 0.5]",
                "as in [camera]; only for panels of kind space"),
        one_of("panels[].camera.look_at", camera_of_panel(&PanelCameraSpec::look_at), camera_aims(),
               R"("centre")", "as in [camera]; only for panels of kind space"),
        text("panels[].camera.view", camera_of_panel(&PanelCameraSpec::view), R"("high")",
             "named view, which supplies the values that this table does not set")
            .from_list("views")
            .checked_by(camera_view_named),
        one_of("panels[].camera.projection", camera_of_panel(&PanelCameraSpec::projection),
               camera_projections(), R"("orthographic")", "as in [camera]"),
    };
    return rows;
}

}  // namespace poinsot
