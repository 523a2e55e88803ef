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
                         "give units as in \"rpm\", \"deg\", \"g cm²\"");
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
            .default_is("the file's name")
            .written_if_empty(),
        text("caption", &Scene::caption, R"("I = (3, 2, 1) kg m²")", "text below the picture")
            .default_is("none")
            .written_if_empty(),
        number("accuracy_px", &Scene::accuracy_px, within(1e-6, 100.0), "pixels", "0.1",
               "largest distance of the motion from the truth, and half of it of curves"),
        text("theme", &Scene::theme, R"("light")",
             "colours and line styles, or the file of one's own, in .toml")
            .from_list("themes")
            .or_text("a file's name", R"(\.toml$)"),
        one_of("hidden", &Scene::hidden, hidden_styles, R"("dashed")",
               "lines where something hides them: pale, dashed (a broken line then means that and "
               "nothing else) or omitted")
            .default_is("the theme's, which is pale"),
        one_of("crossings", &Scene::crossings, crossing_styles, R"("gap")",
               "lines that pass under others: through (drawn on) or gap (broken beside them)")
            .default_is("the theme's, which is through"),
        boolean("clock", &Scene::clock, "false", "whether the clock is shown")
            .default_is("yes, but for films that loop"),
        number("type_scale", &Scene::type_scale, within(0.25, 8.0), "", "1.25",
               "factor on all type in the picture, as for a hall")
            .omitted_if_default(),
        one_of("language", &Scene::language, languages(), R"("de")",
               "of the words that are not the scene's own, and of decimal marks (a comma in de, "
               "fr, es "
               "and it)")
            .omitted_if_default(),
        texts("units", &Scene::units, R"(["rpm", "deg", "g cm²"])",
              "units in which charts and live numbers are shown, each for what it measures; a unit "
              "of "
              "angle also gives that of rates: deg/s")
            .default_is("SI")
            .read_by(read_units),
        text("symbols.omega", symbol(&SymbolsSpec::omega), R"('\Omega')",
             "what ω is called in labels, as a formula"),
        text("symbols.momentum", symbol(&SymbolsSpec::momentum), R"('\mathbf{J}')",
             "what L is called, likewise"),
        text("symbols.rho", symbol(&SymbolsSpec::rho), R"('\mathbf{r}')",
             "what ρ is called, likewise"),
        text("symbols.e1", symbol(&SymbolsSpec::e1), R"("x")",
             "what the first principal axis is called, likewise"),
        text("symbols.e2", symbol(&SymbolsSpec::e2), R"("y")",
             "what the second principal axis is called, likewise"),
        text("symbols.e3", symbol(&SymbolsSpec::e3), R"("z")",
             "what the third principal axis is called, likewise"),
        texts("show", &Scene::show, R"(["plane", "ellipsoid", "polhode"])", "elements drawn")
            .from_list("elements")
            .default_is("those that suit the motion"),
        boolean("labels", &Scene::labels, "false", "whether elements have their names beside them")
            .omitted_if_default(),
        texts("unlabelled", &Scene::unlabelled, R"(["omega", "momentum"])",
              "elements, or kinds of panels, that stay without their names")
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
                "relative widths of the columns that panels stand in")
            .with_size({1, most_cells})
            .default_is("equal ones"),
        numbers("grid.rows", in(&Scene::grid, &GridSpec::rows), positive, "", "[1.0, 1.0]",
                "relative heights of the rows that panels stand in")
            .with_size({1, most_cells})
            .default_is("equal ones"),
        text("panels[].kind", panel(&PanelSpec::kind), R"("space")", "what the panel shows")
            .from_list("panels"),
        integer("panels[].column", panel(&PanelSpec::column), cell, "0",
                "column of its upper left cell, from 0"),
        integer("panels[].row", panel(&PanelSpec::row), cell, "0",
                "row of its upper left cell, from 0"),
        integer("panels[].columns", panel(&PanelSpec::columns), cells, "1",
                "number of columns that it spans"),
        integer("panels[].rows", panel(&PanelSpec::rows), cells, "1",
                "number of rows that it spans"),
        text("panels[].quantity", panel(&PanelSpec::quantity), R"("omega")",
             "what a plot shows against time")
            .from_list("quantities")
            .default_is("what suits the motion"),
        integer("panels[].curves", panel(&PanelSpec::curves), within(0, 40), "6",
                "body: polhodes shown beside the motion's, to either side of the separatrices")
            .default_is("as many as fill the ellipsoid evenly"),
        text("panels[].title", panel(&PanelSpec::title), R"("Body axes")",
             "heading of the panel, \"\" for none")
            .default_is("that of its kind"),
        // The camera of one panel, where it differs from [camera]; in body axes for body and
        // momentum.
        number("panels[].camera.azimuth_deg", camera_of_panel(&PanelCameraSpec::azimuth_deg),
               within(-3600.0, 3600.0), "degrees", "30.0",
               "as in [camera], for this panel alone; about e3 from e1 where it shows body axes"),
        number("panels[].camera.elevation_deg", camera_of_panel(&PanelCameraSpec::elevation_deg),
               elevations_deg, "degrees", "20.0",
               "likewise; from the plane of e1 and e2 towards e3 where it shows body axes"),
        number("panels[].camera.distance", camera_of_panel(&PanelCameraSpec::distance), distances,
               "largest half-axes", "4.0", "likewise; of space alone, the others are framed"),
        number("panels[].camera.field_deg", camera_of_panel(&PanelCameraSpec::field_deg),
               fields_deg, "degrees", "20.0", "as in [camera]"),
        numbers("panels[].camera.target", camera_of_panel(&PanelCameraSpec::target), coordinates,
                "largest half-axes", "[0.0, 0.0, 0.5]", "as in [camera]; of space alone"),
        one_of("panels[].camera.look_at", camera_of_panel(&PanelCameraSpec::look_at), camera_aims(),
               R"("centre")", "as in [camera]; of space alone"),
        text("panels[].camera.view", camera_of_panel(&PanelCameraSpec::view), R"("high")",
             "a view by name, for all that this panel's camera does not say otherwise")
            .from_list("views")
            .checked_by(camera_view_named),
        one_of("panels[].camera.projection", camera_of_panel(&PanelCameraSpec::projection),
               camera_projections(), R"("orthographic")", "as in [camera]"),
    };
    return rows;
}

}  // namespace poinsot
