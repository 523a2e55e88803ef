// The choice of a table's columns by name.
#include <fmt/format.h>

#include <algorithm>

#include "error/error.h"
#include "production/sampling/sample_table.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// The columns of a name: all of a quantity's, or one. Empty for an unknown name.
std::vector<ChosenColumn> columns_called(std::string_view name) {
    std::vector<ChosenColumn> found;
    if (name.empty()) return found;
    for (const Quantity& quantity : quantities()) {
        const bool all = name == quantity.name || name == quantity.symbol;
        for (std::size_t i = 0; i < quantity.components.size(); ++i) {
            const std::string heading = name_with_unit(quantity, i);
            if (all || name == quantity.components[i] || name == heading)
                found.push_back({&quantity, i, heading});
        }
        if (!found.empty()) return found;
    }
    return found;
}

[[noreturn]] void throw_unknown(std::string_view name) {
    std::vector<std::string_view> known;
    for (const Quantity& quantity : quantities()) {
        known.push_back(quantity.name);
        known.insert(known.end(), quantity.components.begin(), quantity.components.end());
    }
    throw InputError(
        fmt::format("--columns: no column is called \"{}\"{}; poinsot list columns names all",
                    printable(name), did_you_mean(name, known)));
}

}  // namespace

std::vector<ChosenColumn> default_columns(const Motion& motion) {
    std::vector<ChosenColumn> columns;
    // These headings have no units, for compatibility with existing scripts.
    const auto take = [&columns](std::string_view name, bool with_unit) {
        const Quantity& quantity = *find_row(quantities(), name);
        for (std::size_t i = 0; i < quantity.components.size(); ++i)
            columns.push_back(
                {&quantity, i,
                 with_unit ? name_with_unit(quantity, i) : std::string(quantity.components[i])});
    };
    take("time", true);
    take("omega_body", false);
    take("q", false);
    take("herpolhode", false);
    if (motion.regime() == Regime::heavy_top) take("euler", true);
    return columns;
}

std::vector<ChosenColumn> columns_named(const Motion& motion, std::span<const std::string> names) {
    std::vector<ChosenColumn> columns;
    for (const std::string& name : names) {
        const std::vector<ChosenColumn> called = columns_called(name);
        if (called.empty()) throw_unknown(name);
        for (const ChosenColumn& column : called) {
            const Quantity& quantity = *column.quantity;
            if (quantity.offered != nullptr && !quantity.offered(motion))
                throw InputError(fmt::format("--columns: only {} has {}; leave it out",
                                             quantity.offered_by, quantity.name));
            const bool twice = std::any_of(
                columns.begin(), columns.end(),
                [&column](const ChosenColumn& other) { return other.heading == column.heading; });
            if (twice)
                throw InputError(
                    fmt::format("--columns: {} is given twice; leave one out", column.heading));
            columns.push_back(column);
        }
    }
    return columns;
}

}  // namespace poinsot
