#include "compare/baseline_manifest.h"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "error/error.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr std::string_view heading_lines =
    "# What each picture beside this file was made of, and why it was taken; see `poinsot approve "
    "--help`.\n";

// A field of a baseline with its name, in the order of writing.
struct Field {
    std::string_view name;
    std::string Baseline::*value;
};
constexpr std::array<Field, 6> baseline_fields{{{"pixels", &Baseline::pixels},
                                                {"scene", &Baseline::scene},
                                                {"renderer", &Baseline::renderer},
                                                {"mesa", &Baseline::mesa},
                                                {"version", &Baseline::version},
                                                {"why", &Baseline::why}}};

// A basic string (TOML 1.0, "String").
std::string toml_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (code < 0x20 || code == 0x7f) {
            result += fmt::format("\\u{:04X}", code);
        } else {
            result += c;
        }
    }
    return result + "\"";
}

// Parses one line from the left. Each function returns whether it found its text.
class LineReader {
 public:
    explicit LineReader(std::string_view line) : rest_(line) {}

    bool skip(std::string_view word) {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size()));
        if (!rest_.starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        return true;
    }

    // Parses the output of toml_string().
    std::optional<std::string> string() {
        if (!skip("\"")) return std::nullopt;
        std::string text;
        while (!rest_.empty()) {
            const char c = rest_.front();
            rest_.remove_prefix(1);
            if (c == '"') return text;
            if (c != '\\') {
                text += c;
            } else if (rest_.starts_with('"') || rest_.starts_with('\\')) {
                text += rest_.front();
                rest_.remove_prefix(1);
            } else if (const auto code = control_code()) {
                text += *code;
            } else {
                return std::nullopt;
            }
        }
        return std::nullopt;
    }

    bool at_end() { return skip("") && rest_.empty(); }

 private:
    std::optional<char> control_code() {
        constexpr std::string_view hexadecimal = "0123456789ABCDEF";
        if (!rest_.starts_with("u00") || rest_.size() < 5) return std::nullopt;
        const std::size_t high = hexadecimal.find(rest_[3]), low = hexadecimal.find(rest_[4]);
        if (high > 7 || low > 15) return std::nullopt;
        rest_.remove_prefix(5);
        return static_cast<char>(16 * high + low);
    }

    std::string_view rest_;
};

std::optional<std::pair<std::string, Baseline>> parse_line(std::string_view line) {
    LineReader reader(line);
    auto name = reader.string();
    if (!name || !reader.skip("=") || !reader.skip("{")) return std::nullopt;
    Baseline baseline;
    for (std::size_t i = 0; i < baseline_fields.size(); ++i) {
        if ((i > 0 && !reader.skip(",")) || !reader.skip(baseline_fields[i].name) ||
            !reader.skip("="))
            return std::nullopt;
        auto value = reader.string();
        if (!value) return std::nullopt;
        baseline.*baseline_fields[i].value = std::move(*value);
    }
    if (!reader.skip("}") || !reader.at_end()) return std::nullopt;
    return std::make_pair(std::move(*name), std::move(baseline));
}

}  // namespace

std::string to_text(const BaselineManifest& manifest) {
    std::string text(heading_lines);
    for (const auto& [name, baseline] : manifest) {
        text += toml_string(name) + " = { ";
        for (const Field& field : baseline_fields)
            text += fmt::format("{}{} = {}", &field == baseline_fields.data() ? "" : ", ",
                                field.name, toml_string(baseline.*field.value));
        text += " }\n";
    }
    return text;
}

BaselineManifest parse_manifest(std::string_view text, const std::string& name) {
    BaselineManifest manifest;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.starts_with('#')) continue;
        auto entry = parse_line(line);
        if (!entry)
            throw InputError(fmt::format(
                "{}:{}: not a line of `poinsot approve`; take the file back from version control",
                printable(name), number));
        if (!manifest.insert(std::move(*entry)).second)
            throw InputError(fmt::format("{}:{}: an earlier line has this picture, too",
                                         printable(name), number));
    }
    return manifest;
}

namespace {

std::filesystem::path next_path(const std::filesystem::path& folder) {
    return folder / fmt::format(".{}.next", manifest_name);
}

std::optional<BaselineManifest> read_if_there(const std::filesystem::path& path) {
    const FileKind kind = kind_of_file(path);
    if (kind == FileKind::missing) return std::nullopt;
    if (kind != FileKind::regular)
        throw InputError(fmt::format("{}: {}", printable(path.string()), in_words(kind)));
    return parse_manifest(read_text(path), path.string());
}

void write(const std::filesystem::path& path, const BaselineManifest& manifest) {
    write_whole(path, to_text(manifest));
}

}  // namespace

BaselineManifest read_manifest(const std::filesystem::path& folder) {
    return read_if_there(folder / manifest_name).value_or(BaselineManifest{});
}

void write_manifest(const std::filesystem::path& folder, const BaselineManifest& manifest) {
    write(folder / manifest_name, manifest);
}

std::optional<BaselineManifest> read_next_manifest(const std::filesystem::path& folder) {
    return read_if_there(next_path(folder));
}

void write_next_manifest(const std::filesystem::path& folder, const BaselineManifest& manifest) {
    write(next_path(folder), manifest);
}

void remove_next_manifest(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::remove(next_path(folder), error);
    if (error) throw_write_error(folder / manifest_name, error.value());
}

void remove_half_manifests(const std::filesystem::path& folder) {
    for (const std::filesystem::path& path : {folder / manifest_name, next_path(folder)})
        remove_left_aside(path);
}

}  // namespace poinsot
