// Keys of the picture's title, its look, and its panels.
#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "scene/camera_views.h"
#include "scene/given_value.h"
#include "scene/scene_draft.h"
#include "scene/scene_key_rows.h"
#include "scene/toml_text.h"
#include "text/languages.h"
#include "text/units.h"

namespace poinsot {

namespace {

using std::size_t;

int cell(const GivenValue& given, int least) { return given.integer_between(least, most_cells); }

std::vector<double> grid_sizes(const GivenValue& given) {
    std::vector<double> sizes = given.positive_numbers();
    if (sizes.empty() || sizes.size() > most_cells) {
        given.refuse(fmt::format("a list of {} numbers", sizes.size()),
                     fmt::format("give 1 to {} relative sizes", most_cells));
    }
    return sizes;
}

// The units for displayed numbers, each of a different kind of quantity.
std::vector<std::string> shown_units(const GivenValue& given) {
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
    return units;
}

constexpr std::array<std::string_view, 3> hidden_styles{"pale", "dashed", "omitted"};
constexpr std::array<std::string_view, 2> crossing_styles{"through", "gap"};

const SceneKey picture_rows[] = {
    {"title", "a string", "", R"("Tennis racket")",
     "heading of the picture; default: the file's name",
     [](const GivenValue& g, SceneDraft& d) { d.scene.title = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.title)); }},
    {"caption", "a string", "", R"("I = (3, 2, 1) kg m²")", "text below the picture; default: none",
     [](const GivenValue& g, SceneDraft& d) { d.scene.caption = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.caption)); }},
    {"accuracy_px", "a number from 1e-6 to 100", "pixels", "0.1",
     "largest distance of the motion from the truth, and half of it of curves; default 0.1",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.accuracy_px = g.number_between(1e-6, 100.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.accuracy_px); }},
    {"theme", "a string or a file's name", "", R"("light")",
     "colours and line styles, see `poinsot list themes`, or the file of one's own, in .toml",
     [](const GivenValue& g, SceneDraft& d) { d.scene.theme = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.theme)); }},
    {"hidden", "a string", "", R"("dashed")",
     "lines where something hides them: pale, dashed (a broken line then means that and nothing "
     "else) or omitted; default: the theme's, which is pale",
     [](const GivenValue& g, SceneDraft& d) { d.scene.hidden = g.one_of(hidden_styles); },
     [](const Scene& s, size_t) { return text_unless_empty(s.hidden); }, hidden_styles},
    {"crossings", "a string", "", R"("gap")",
     "lines that pass under others: through (drawn on) or gap (broken beside them); default: the "
     "theme's, which is through",
     [](const GivenValue& g, SceneDraft& d) { d.scene.crossings = g.one_of(crossing_styles); },
     [](const Scene& s, size_t) { return text_unless_empty(s.crossings); }, crossing_styles},
    {"clock", "true or false", "", "false",
     "whether the clock is shown; default: yes, but for films that loop",
     [](const GivenValue& g, SceneDraft& d) { d.scene.clock = g.boolean(); },
     [](const Scene& s, size_t) { return s.clock ? toml_text(*s.clock) : ""; }},
    {"type_scale", "a number from 0.25 to 8", "", "1.25",
     "factor on all type in the picture, as for a hall; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.type_scale = g.number_between(0.25, 8.0); },
     [](const Scene& s, size_t) { return s.type_scale == 1.0 ? "" : toml_text(s.type_scale); }},
    {"language", "a string", "", R"("de")",
     "of the words that are not the scene's own: en, de, fr, es, it or ja; default en",
     [](const GivenValue& g, SceneDraft& d) { d.scene.language = g.one_of(languages()); },
     [](const Scene& s, size_t) {
         return s.language == "en" ? "" : toml_text(std::string_view(s.language));
     },
     languages()},
    {"units", "a list of strings", "", R"(["rpm", "deg", "g cm²"])",
     "units in which charts and live numbers are shown, each for what it measures; default: SI",
     [](const GivenValue& g, SceneDraft& d) { d.scene.units = shown_units(g); },
     [](const Scene& s, size_t) {
         return s.units.empty() ? "" : toml_text(std::span<const std::string>(s.units));
     }},
    {"symbols.omega", "a string", "", R"('\Omega')", "what ω is called in labels, as a formula",
     [](const GivenValue& g, SceneDraft& d) { d.scene.symbols.omega = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.symbols.omega); }},
    {"symbols.momentum", "a string", "", R"('\mathbf{J}')", "what L is called, likewise",
     [](const GivenValue& g, SceneDraft& d) { d.scene.symbols.momentum = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.symbols.momentum); }},
    {"symbols.rho", "a string", "", R"('\mathbf{r}')", "what ρ is called, likewise",
     [](const GivenValue& g, SceneDraft& d) { d.scene.symbols.rho = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.symbols.rho); }},
    {"symbols.e1", "a string", "", R"("x")", "what the first principal axis is called, likewise",
     [](const GivenValue& g, SceneDraft& d) { d.scene.symbols.e1 = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.symbols.e1); }},
    {"symbols.e2", "a string", "", R"("y")", "what the second principal axis is called, likewise",
     [](const GivenValue& g, SceneDraft& d) { d.scene.symbols.e2 = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.symbols.e2); }},
    {"symbols.e3", "a string", "", R"("z")", "what the third principal axis is called, likewise",
     [](const GivenValue& g, SceneDraft& d) { d.scene.symbols.e3 = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.symbols.e3); }},
    {"show", "a list of strings", "", R"(["plane", "ellipsoid", "polhode"])",
     "elements drawn, see `poinsot list elements`; default: those that suit the motion",
     [](const GivenValue& g, SceneDraft& d) { d.scene.show = g.texts(); },
     [](const Scene& s, size_t) {
         return s.show.empty() ? "" : toml_text(std::span<const std::string>(s.show));
     }},
    {"labels", "true or false", "", "false",
     "whether elements have their names beside them; default true",
     [](const GivenValue& g, SceneDraft& d) { d.scene.labels = g.boolean(); },
     [](const Scene& s, size_t) { return s.labels ? "" : toml_text(false); }},
    {"unlabelled", "a list of strings", "", R"(["omega", "momentum"])",
     "elements, or kinds of panels, that stay without their names; default: none",
     [](const GivenValue& g, SceneDraft& d) { d.scene.unlabelled = g.texts(); },
     [](const Scene& s, size_t) {
         return s.unlabelled.empty() ? "" : toml_text(std::span<const std::string>(s.unlabelled));
     }},
};

PanelCameraSpec& camera(const GivenValue& given, SceneDraft& draft) {
    return draft.scene.panels.at(given.item()).camera;
}

const SceneKey panel_rows[] = {
    // Several views of one motion, in the cells of a grid.
    {"grid.columns", "a list of positive numbers", "", "[2.0, 1.0]",
     "relative widths of the columns that panels stand in; default: equal ones",
     [](const GivenValue& g, SceneDraft& d) { d.scene.grid.columns = grid_sizes(g); },
     [](const Scene& s, size_t) { return toml_text(std::span<const double>(s.grid.columns)); }},
    {"grid.rows", "a list of positive numbers", "", "[1.0, 1.0]",
     "relative heights of the rows that panels stand in; default: equal ones",
     [](const GivenValue& g, SceneDraft& d) { d.scene.grid.rows = grid_sizes(g); },
     [](const Scene& s, size_t) { return toml_text(std::span<const double>(s.grid.rows)); }},
    {"panels[].kind", "a string", "", R"("space")",
     "what the panel shows, see `poinsot list panels`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).kind = g.text(); },
     [](const Scene& s, size_t i) { return toml_text(std::string_view(s.panels.at(i).kind)); }},
    {"panels[].column", "an integer from 0 to 64", "", "0",
     "column of its upper left cell, from 0; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).column = cell(g, 0); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).column); }},
    {"panels[].row", "an integer from 0 to 64", "", "0",
     "row of its upper left cell, from 0; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).row = cell(g, 0); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).row); }},
    {"panels[].columns", "an integer from 1 to 64", "", "1",
     "number of columns that it spans; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).columns = cell(g, 1); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).columns); }},
    {"panels[].rows", "an integer from 1 to 64", "", "1", "number of rows that it spans; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).rows = cell(g, 1); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).rows); }},
    {"panels[].quantity", "a string", "", R"("omega")",
     "what a plot shows against time, see `poinsot list quantities`; default: what suits the "
     "motion",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).quantity = g.text(); },
     [](const Scene& s, size_t i) {
         const std::string& quantity = s.panels.at(i).quantity;
         return quantity.empty() ? "" : toml_text(std::string_view(quantity));
     }},
    {"panels[].curves", "an integer from 0 to 40", "", "6",
     "body: polhodes shown beside the motion's, to either side of the separatrices; "
     "default: as many as fill the ellipsoid evenly",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.panels.at(g.item()).curves = g.integer_between(0, 40);
     },
     [](const Scene& s, size_t i) {
         const auto& curves = s.panels.at(i).curves;
         return curves ? toml_text(*curves) : "";
     }},
    {"panels[].title", "a string", "", R"("Body axes")",
     "heading of the panel, \"\" for none; default: that of its kind",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).title = g.text(); },
     [](const Scene& s, size_t i) {
         const auto& title = s.panels.at(i).title;
         return title ? toml_text(std::string_view(*title)) : "";
     }},
    // The camera of one panel, where it differs from [camera]; in body axes for body and momentum.
    {"panels[].camera.azimuth_deg", "a number from -3600 to 3600", "degrees", "30.0",
     "as in [camera], for this panel alone; about e3 from e1 where it shows body axes",
     [](const GivenValue& g, SceneDraft& d) {
         camera(g, d).azimuth_deg = g.number_between(-3600.0, 3600.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.panels.at(i).camera.azimuth_deg); }},
    {"panels[].camera.elevation_deg", "a number from -90 to 90", "degrees", "20.0",
     "likewise; from the plane of e1 and e2 towards e3 where it shows body axes",
     [](const GivenValue& g, SceneDraft& d) {
         camera(g, d).elevation_deg = g.number_between(-90.0, 90.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.panels.at(i).camera.elevation_deg); }},
    {"panels[].camera.distance", "a number from 0.01 to 10000", "largest half-axes", "4.0",
     "likewise; of space alone, the others are framed",
     [](const GivenValue& g, SceneDraft& d) {
         camera(g, d).distance = g.number_between(0.01, 10000.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.panels.at(i).camera.distance); }},
    {"panels[].camera.field_deg", "a number from 0.1 to 150", "degrees", "20.0", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) {
         camera(g, d).field_deg = g.number_between(0.1, 150.0);
     },
     [](const Scene& s, size_t i) { return optional_text(s.panels.at(i).camera.field_deg); }},
    {"panels[].camera.target", "three numbers", "largest half-axes", "[0.0, 0.0, 0.5]",
     "as in [camera]; of space alone",
     [](const GivenValue& g, SceneDraft& d) { camera(g, d).target = target_of(g); },
     [](const Scene& s, size_t i) { return optional_text(s.panels.at(i).camera.target); }},
    {"panels[].camera.look_at", "a string", "", R"("centre")", "as in [camera]; of space alone",
     [](const GivenValue& g, SceneDraft& d) { camera(g, d).look_at = g.one_of(camera_aims()); },
     [](const Scene& s, size_t i) { return text_unless_empty(s.panels.at(i).camera.look_at); },
     camera_aims()},
    {"panels[].camera.view", "a string", "", R"("high")",
     "a view by name, see `poinsot list views`, for all that this panel's camera does not say "
     "otherwise",
     [](const GivenValue& g, SceneDraft& d) {
         camera(g, d).view = name_in_table(g, camera_view_named);
     },
     [](const Scene& s, size_t i) { return text_unless_empty(s.panels.at(i).camera.view); }},
    {"panels[].camera.projection", "a string", "", R"("orthographic")", "as in [camera]",
     [](const GivenValue& g, SceneDraft& d) {
         camera(g, d).projection = g.one_of(camera_projections());
     },
     [](const Scene& s, size_t i) { return text_unless_empty(s.panels.at(i).camera.projection); },
     camera_projections()},
};

}  // namespace

std::span<const SceneKey> picture_keys() { return picture_rows; }
std::span<const SceneKey> panel_keys() { return panel_rows; }

}  // namespace poinsot
