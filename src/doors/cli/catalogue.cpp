#include "cli/catalogue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "bodies/named_objects.h"
#include "cli/documents.h"
#include "cli/scenes.h"
#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/style/theme.h"
#include "encoding/frame_sink.h"
#include "encoding/quality.h"
#include "error/error.h"
#include "mechanics/methods.h"
#include "mechanics/solids.h"
#include "production/sampling/sample_table.h"
#include "production/vectors/journal.h"
#include "scene/camera_views.h"
#include "scene/easing.h"
#include "scene/files/load_scene.h"
#include "scene/scene_keys.h"

namespace poinsot {

namespace {

// The name and summary of every row of a table.
template <typename Rows>
std::vector<CatalogueEntry> rows_of(const Rows& rows) {
    std::vector<CatalogueEntry> entries;
    for (const auto& row : rows)
        entries.push_back({std::string(row.name), std::string(row.summary)});
    return entries;
}

// The scenes supplied with the program, with their titles.
std::vector<CatalogueEntry> scene_entries() {
    std::vector<CatalogueEntry> entries;
    for (const std::filesystem::path& file : bundled_scenes())
        entries.push_back({file.stem().string(), load_scene(file, {}).title});
    return entries;
}

std::vector<CatalogueEntry> solid_entries() {
    std::vector<CatalogueEntry> entries;
    for (const Solid& solid : solids()) {
        entries.push_back({std::string(solid.name), std::string(solid.size_meaning)});
    }
    return entries;
}

std::vector<CatalogueEntry> object_entries() {
    std::vector<CatalogueEntry> entries;
    for (const NamedObject& object : named_objects()) {
        entries.push_back(
            {std::string(object.name), fmt::format("{}; {}", object.summary, object.source)});
    }
    return entries;
}

std::vector<CatalogueEntry> method_entries() {
    std::vector<CatalogueEntry> entries;
    for (const Method& method : methods()) {
        entries.push_back({std::string(method.name),
                           fmt::format("{}; conserves {}", method.summary, method.conserves)});
    }
    return entries;
}

// The qualities, with the cost relative to the default and the result.
std::vector<CatalogueEntry> quality_entries() {
    const QualityFigures& usual = quality_named(FilmSpec{}.quality).figures;
    std::vector<CatalogueEntry> entries;
    for (const Quality& quality : qualities()) {
        const QualityFigures& f = quality.figures;
        entries.push_back(
            {std::string(quality.name),
             fmt::format(
                 "{}; picture: relative time {:.2g}, rms error {:g} of 255 levels; film frame "
                 "of 960×540: relative time {:.2g}, {:g} kB, SSIM {:g} (times relative to {})",
                 quality.summary, f.picture_ms / usual.picture_ms, f.rms_levels,
                 f.film_ms / usual.film_ms, f.film_kB, f.film_ssim, FilmSpec{}.quality)});
    }
    return entries;
}

std::vector<CatalogueEntry> key_entries() {
    std::vector<CatalogueEntry> entries;
    for (const SceneKey& key : scene_keys()) {
        entries.push_back({std::string(key.path), key.explanation()});
    }
    return entries;
}

// The documents that the program generates, including "schema".
std::vector<CatalogueEntry> document_entries() {
    std::vector<CatalogueEntry> entries;
    for (const Document& document : documents())
        entries.push_back({document.name, document.summary});
    return entries;
}

std::vector<CatalogueEntry> column_entries() {
    std::vector<CatalogueEntry> entries;
    for (const Quantity& quantity : quantities()) {
        const std::string symbol = quantity.symbol.empty()
                                       ? std::string()
                                       : fmt::format("; also called {}", quantity.symbol);
        entries.push_back(
            {std::string(quantity.name), fmt::format("{}{} ({})", quantity.summary, symbol,
                                                     fmt::join(quantity.components, ", "))});
    }
    return entries;
}

// The journals, with their places.
std::vector<CatalogueEntry> journal_entries() {
    std::vector<CatalogueEntry> entries;
    for (const Journal& journal : journals())
        entries.push_back(
            {std::string(journal.name), fmt::format("{} ({})", journal.summary, journal.source)});
    return entries;
}

const auto catalogue_rows = std::to_array<Catalogue>({
    {"scenes", scene_entries},
    {"keys", key_entries},
    {"methods", method_entries},
    {"qualities", quality_entries},
    {"elements", [] { return rows_of(elements()); }},
    {"panels", [] { return rows_of(panel_kinds()); }},
    {"quantities", [] { return rows_of(plot_quantities()); }},
    {"columns", column_entries},
    {"overlays", [] { return rows_of(overlays()); }},
    {"views", [] { return rows_of(camera_views()); }},
    {"easings", [] { return rows_of(easings()); }},
    {"themes", [] { return rows_of(themes()); }},
    {"journals", journal_entries},
    {"formats", [] { return rows_of(output_formats()); }},
    {"solids", solid_entries},
    {"objects", object_entries},
    {"documents", document_entries},
});

}  // namespace

std::span<const Catalogue> catalogues() { return catalogue_rows; }

}  // namespace poinsot
