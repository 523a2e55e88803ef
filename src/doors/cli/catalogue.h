// The lists that `poinsot list` prints, each generated from the table that the program itself uses.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

struct CatalogueEntry {
    std::string name;
    std::string summary;
};

struct Catalogue {
    std::string_view name;
    std::vector<CatalogueEntry> (*entries)();
};

std::span<const Catalogue> catalogues();

}  // namespace poinsot
