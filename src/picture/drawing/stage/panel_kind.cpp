#include "drawing/stage/panel_kind.h"

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

const PanelKind& panel_kind_named(std::string_view name) {
    if (const PanelKind* row = find_row(panel_kinds(), name)) return *row;
    throw InputError(unknown("panel", name, names_of(panel_kinds())));
}

std::string panels_where(const std::function<bool(const PanelKind&)>& holds,
                         std::string_view conjunction) {
    std::vector<std::string_view> names;
    for (const PanelKind& kind : panel_kinds())
        if (holds(kind)) names.push_back(kind.name);
    std::string words;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) words += i + 1 < names.size() ? ", " : fmt::format(" {} ", conjunction);
        words += fmt::format("\"{}\"", names[i]);
    }
    return words;
}

std::string panels_that_use(PanelUses key, std::string_view conjunction) {
    return panels_where([key](const PanelKind& kind) { return (kind.uses & key) != 0; },
                        conjunction);
}

}  // namespace poinsot
