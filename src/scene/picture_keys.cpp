// Keys of what the picture is called, how it looks, and the panels that share it.
#include <fmt/format.h>

#include <vector>

#include "scene/given_value.h"
#include "scene/scene_draft.h"
#include "scene/scene_key_rows.h"
#include "scene/toml_text.h"

namespace poinsot {

namespace {

using std::size_t;

constexpr int most_cells = 64;  // columns or rows of a grid

int cell(const GivenValue& given, int least) { return given.integer_between(least, most_cells); }

std::vector<double> grid_sizes(const GivenValue& given) {
    std::vector<double> sizes = given.positive_numbers();
    if (sizes.empty() || sizes.size() > most_cells) {
        given.refuse(fmt::format("a list of {} numbers", sizes.size()),
                     fmt::format("give 1 to {} relative sizes", most_cells));
    }
    return sizes;
}

const SceneKey picture_rows[] = {
    {"title", "a string", "", R"("Tennis racket")",
     "heading of the picture; default: the file's name",
     [](const GivenValue& g, SceneDraft& d) { d.scene.title = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.title)); }},
    {"caption", "a string", "", R"("I = (3, 2, 1) kg m²")", "text below the picture; default: none",
     [](const GivenValue& g, SceneDraft& d) { d.scene.caption = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.caption)); }},
    {"accuracy_px", "a number", "pixels", "0.1",
     "largest distance of anything drawn from the truth; default 0.1",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.accuracy_px = g.number_between(1e-6, 100.0);
     },
     [](const Scene& s, size_t) { return toml_text(s.accuracy_px); }},
    {"theme", "a string", "", R"("light")", "colours and line styles, see `poinsot list themes`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.theme = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.theme)); }},
    {"show", "a list of strings", "", R"(["plane", "ellipsoid", "polhode"])",
     "elements drawn, see `poinsot list elements`; default: those that suit the motion",
     [](const GivenValue& g, SceneDraft& d) { d.scene.show = g.texts(); },
     [](const Scene& s, size_t) {
         return s.show.empty() ? "" : toml_text(std::span<const std::string>(s.show));
     }},
};

const SceneKey panel_rows[] = {
    // Several views of one motion, in the cells of a grid.
    {"grid.columns", "a list of numbers", "", "[2.0, 1.0]",
     "relative widths of the columns that panels stand in; default: equal ones",
     [](const GivenValue& g, SceneDraft& d) { d.scene.grid.columns = grid_sizes(g); },
     [](const Scene& s, size_t) { return toml_text(std::span<const double>(s.grid.columns)); }},
    {"grid.rows", "a list of numbers", "", "[1.0, 1.0]",
     "relative heights of the rows that panels stand in; default: equal ones",
     [](const GivenValue& g, SceneDraft& d) { d.scene.grid.rows = grid_sizes(g); },
     [](const Scene& s, size_t) { return toml_text(std::span<const double>(s.grid.rows)); }},
    {"panels[].kind", "a string", "", R"("space")",
     "what the panel shows, see `poinsot list panels`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).kind = g.text(); },
     [](const Scene& s, size_t i) { return toml_text(std::string_view(s.panels.at(i).kind)); }},
    {"panels[].column", "an integer", "", "0", "column of its upper left cell, from 0; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).column = cell(g, 0); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).column); }},
    {"panels[].row", "an integer", "", "0", "row of its upper left cell, from 0; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).row = cell(g, 0); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).row); }},
    {"panels[].columns", "an integer", "", "1", "number of columns that it spans; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).columns = cell(g, 1); },
     [](const Scene& s, size_t i) { return toml_text(s.panels.at(i).columns); }},
    {"panels[].rows", "an integer", "", "1", "number of rows that it spans; default 1",
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
    {"panels[].title", "a string", "", R"("Body axes")",
     "heading of the panel, \"\" for none; default: that of its kind",
     [](const GivenValue& g, SceneDraft& d) { d.scene.panels.at(g.item()).title = g.text(); },
     [](const Scene& s, size_t i) {
         const auto& title = s.panels.at(i).title;
         return title ? toml_text(std::string_view(*title)) : "";
     }},
};

}  // namespace

std::span<const SceneKey> picture_keys() { return picture_rows; }
std::span<const SceneKey> panel_keys() { return panel_rows; }

}  // namespace poinsot
