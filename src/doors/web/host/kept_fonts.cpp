#include "web/host/kept_fonts.h"

#include <algorithm>
#include <deque>

#include "error/error.h"

namespace poinsot {

namespace {

struct Table {
    std::string name;
    std::string_view bytes;
    KeptFont font;
};

std::deque<Table>& tables() {
    static std::deque<Table> all;
    return all;
}

bool is_fallback(const std::string& name) {
    return std::ranges::find(font_names(), name) == font_names().end();
}

const Table* find_table(std::string_view name) {
    for (const Table& table : tables())
        if (table.name == name) return &table;
    return nullptr;
}

FontFile opened(std::string_view name) {
    const Table* const table = find_table(name);
    if (table == nullptr) no_font(name);
    return {table->bytes, table->name};
}

}  // namespace

void add_kept_font(std::string_view name, std::string_view table) {
    tables().push_back({std::string(name), table, KeptFont(table)});
}

FontSource kept_fonts() {
    FontSource source;
    source.open = opened;
    source.fallbacks = [] {
        std::vector<std::filesystem::path> names;
        for (const Table& table : tables())
            if (is_fallback(table.name)) names.emplace_back(table.name);
        return names;
    };
    source.open_fallback = [](const std::filesystem::path& name) { return opened(name.string()); };
    return source;
}

const KeptFont& kept_font_named(std::string_view name) {
    const Table* const table = find_table(name);
    if (table == nullptr) throw EnvironmentError("no kept font " + std::string(name));
    return table->font;
}

}  // namespace poinsot
