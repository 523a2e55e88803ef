#include "compare/compare_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "error/error.h"
#include "scene/scene_error.h"
#include "scene/toml/toml_document.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

using Type = TomlValue::Type;

[[noreturn]] void refuse_type(const TomlEntry& entry, std::string_view wanted) {
    throw SceneError(entry.value.where, fmt::format("{} is {}; it must be {}", entry.key,
                                                    name_of(entry.value.type), wanted));
}

double number_in(const TomlEntry& entry, std::string_view wanted) {
    if (entry.value.type != Type::integer && entry.value.type != Type::number)
        refuse_type(entry, wanted);
    return entry.value.number;
}

// A share may be a text with a percent sign.
double number_limit_in(const TomlEntry& entry, const NumberLimit& limit) {
    if (limit.kind != LimitKind::share) return limit.checked(number_in(entry, limit.wanted));
    if (entry.value.type == Type::text) return parse_share(entry.value.text);
    return parse_share(fmt::format("{}", number_in(entry, limit.wanted)));
}

std::vector<IgnoredRegion> regions_in(const TomlEntry& entry) {
    constexpr std::string_view wanted = "a list of regions, as [\"clock\", \"0%,90%,100%,10%\"]";
    if (entry.value.type != Type::array) refuse_type(entry, wanted);
    std::vector<IgnoredRegion> regions;
    for (const TomlValue& item : entry.value.items) {
        if (item.type != Type::text) refuse_type(entry, wanted);
        try {
            regions.push_back(parse_region(item.text));
        } catch (const InputError& error) {
            throw SceneError(item.where, error.what());
        }
    }
    return regions;
}

// Returns false for a key that is no limit.
bool read_limit(const TomlEntry& entry, GivenLimits& given) {
    if (const NumberLimit* limit = find_row(number_limits(), entry.key)) {
        given.*limit->value = number_limit_in(entry, *limit);
    } else if (entry.key == "antialiasing") {
        if (entry.value.type != Type::boolean) refuse_type(entry, "true or false");
        given.antialiasing = entry.value.boolean;
    } else if (entry.key == "ignore") {
        given.ignore = regions_in(entry);
    } else {
        return false;
    }
    return true;
}

void read_key(const TomlEntry& entry, std::string_view besides, GivenLimits& given) {
    try {
        if (read_limit(entry, given)) return;
    } catch (const SceneError&) {
        throw;
    } catch (const InputError& error) {
        throw SceneError(entry.value.where, fmt::format("{}: {}", entry.key, error.what()));
    }
    std::vector<std::string_view> names = names_of(number_limits());
    names.insert(names.end(), {"antialiasing", "ignore", besides});
    throw SceneError(entry.where, unknown("key", entry.key, names));
}

CompareFile::Entry entry_of(const TomlValue& table) {
    CompareFile::Entry entry;
    for (const TomlEntry& key : table.entries) {
        if (key.key != "name") {
            read_key(key, "name", entry.given);
            continue;
        }
        if (key.value.type != Type::text || key.value.text.empty())
            throw SceneError(key.value.where,
                             "name must be the name of a picture, as \"generic\", or a pattern, "
                             "as \"generic_*\"");
        entry.glob = key.value.text;
        entry.where = key.value.where;
    }
    if (entry.glob.empty())
        throw SceneError(table.where,
                         "this entry has no name; say which pictures it is for, as name = "
                         "\"generic_*\"");
    if (entry.given == GivenLimits{})
        throw SceneError(entry.where, "this entry sets no limit; set one or remove the entry");
    return entry;
}

}  // namespace

bool matches_glob(std::string_view name, std::string_view glob) {
    // The last * and the place in the name where it stopped: there the match continues after a
    // failure.
    std::size_t at = 0, in_glob = 0, star = std::string_view::npos, after_star = 0;
    while (at < name.size()) {
        if (in_glob < glob.size() && (glob[in_glob] == '?' || glob[in_glob] == name[at]) &&
            glob[in_glob] != '*') {
            ++at, ++in_glob;
        } else if (in_glob < glob.size() && glob[in_glob] == '*') {
            star = in_glob++;
            after_star = at;
        } else if (star != std::string_view::npos) {
            in_glob = star + 1;
            at = ++after_star;
        } else {
            return false;
        }
    }
    return glob.find_first_not_of('*', in_glob) == std::string_view::npos;
}

GivenLimits CompareFile::given_limits_of(std::string_view picture) const {
    GivenLimits given = all;
    for (const Entry& entry : entries)
        if (matches_glob(picture, entry.glob)) given = entry.given.over(given);
    return given;
}

void CompareFile::check_used(const std::vector<std::string>& pictures) const {
    const std::vector<std::string_view> names(pictures.begin(), pictures.end());
    for (const Entry& entry : entries) {
        const bool is_used = std::any_of(names.begin(), names.end(), [&](std::string_view picture) {
            return matches_glob(picture, entry.glob);
        });
        if (is_used) continue;
        throw SceneError(entry.where, fmt::format("\"{}\" matches none of the {} pictures{}",
                                                  printable(entry.glob), names.size(),
                                                  did_you_mean(entry.glob, names)));
    }
}

CompareFile parse_compare_file(std::string_view text, const std::string& name) {
    CompareFile file;
    file.name = name;
    for (const TomlEntry& entry : parse_toml(text, name).entries) {
        if (entry.key != "pictures") {
            read_key(entry, "pictures", file.all);
            continue;
        }
        if (entry.value.type != Type::array)
            throw SceneError(entry.where,
                             "pictures must be a list of tables; write [[pictures]] above each");
        for (const TomlValue& item : entry.value.items) {
            if (item.type != Type::table)
                throw SceneError(item.where,
                                 "an entry of pictures must be a table; write [[pictures]]");
            file.entries.push_back(entry_of(item));
        }
    }
    return file;
}

std::optional<CompareFile> read_compare_file(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / compare_file_name;
    const FileKind kind = kind_of_file(path);
    if (kind == FileKind::missing) return std::nullopt;
    if (kind != FileKind::regular)
        throw InputError(fmt::format("{}: {}", printable(path.string()), in_words(kind)));
    return parse_compare_file(read_text(path), path.string());
}

}  // namespace poinsot
