#include "production/records/record_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "text/json_text.h"
#include "text/numbers.h"

namespace poinsot {

namespace {

using Form = RecordField::Form;
using Span = std::pair<std::int64_t, std::int64_t>;

template <std::string Record::*member>
constexpr RecordField required_field(std::string_view key) {
    return {.key = key,
            .is_required = true,
            .text_of = [](const Record& record) { return std::optional(record.*member); },
            .read =
                [](std::string_view text, Record& record) {
                    record.*member = text;
                    return true;
                }};
}

template <std::string Record::*member>
constexpr RecordField text_field(std::string_view key) {
    return {.key = key,
            .text_of =
                [](const Record& record) {
                    return (record.*member).empty() ? std::nullopt : std::optional(record.*member);
                },
            .read =
                [](std::string_view text, Record& record) {
                    record.*member = text;
                    return true;
                }};
}

template <auto member>
constexpr RecordField number_field(std::string_view key) {
    return {.key = key,
            .form = Form::number,
            .text_of = [](const Record& record) -> std::optional<std::string> {
                if (!(record.*member)) return std::nullopt;
                return fmt::format("{}", *(record.*member));
            },
            .read =
                [](std::string_view text, Record& record) {
                    auto& value = record.*member;
                    value = number_of<std::remove_cvref_t<decltype(*value)>>(text);
                    return value.has_value();
                }};
}

// "640x360", "0-299".
template <typename Number>
std::optional<std::pair<Number, Number>> two_numbers(std::string_view text, char between) {
    const std::size_t at = text.find(between);
    if (at == std::string_view::npos) return std::nullopt;
    const auto first = number_of<Number>(text.substr(0, at));
    const auto second = number_of<Number>(text.substr(at + 1));
    if (!first || !second) return std::nullopt;
    return std::pair(*first, *second);
}

template <std::optional<Span> Record::*member>
constexpr RecordField frames_field(std::string_view key) {
    return {.key = key,
            .form = Form::two_numbers,
            .text_of = [](const Record& record) -> std::optional<std::string> {
                const std::optional<Span>& span = record.*member;
                if (!span) return std::nullopt;
                return fmt::format("{}-{}", span->first, span->second);
            },
            .read =
                [](std::string_view text, Record& record) {
                    record.*member = two_numbers<std::int64_t>(text, '-');
                    return (record.*member).has_value();
                }};
}

std::optional<std::string> profile_of(const Record& record) {
    return record.portable ? "portable" : "native";
}
bool read_profile(std::string_view text, Record& record) {
    record.portable = text == "portable";
    return true;
}

std::optional<std::string> size_of(const Record& record) {
    return fmt::format("{}x{}", record.width_px, record.height_px);
}
bool read_size(std::string_view text, Record& record) {
    const auto size = two_numbers<int>(text, 'x');
    if (size) std::tie(record.width_px, record.height_px) = *size;
    return size.has_value();
}

std::optional<std::string> depth_of(const Record& record) {
    if (record.bit_depth == 8) return std::nullopt;
    return fmt::format("{}", record.bit_depth);
}
bool read_depth(std::string_view text, Record& record) {
    const auto depth = number_of<int>(text);
    record.bit_depth = depth.value_or(record.bit_depth);
    return depth.has_value();
}

constexpr RecordField field_table[] = {
    required_field<&Record::scene_name>("scene"),
    required_field<&Record::scene_hash>("scene-sha256"),
    text_field<&Record::mesh_hash>("mesh-sha256"),
    required_field<&Record::method>("method"),
    required_field<&Record::bounds>("bounds"),
    {.key = "profile", .is_required = true, .text_of = profile_of, .read = read_profile},
    text_field<&Record::processor>("processor"),
    required_field<&Record::renderer>("renderer"),
    required_field<&Record::mesa>("mesa"),
    text_field<&Record::maker>("maker"),
    text_field<&Record::fonts>("fonts"),
    {.key = "size",
     .is_required = true,
     .form = Form::two_numbers,
     .text_of = size_of,
     .read = read_size},
    number_field<&Record::time_s>("time_s"),
    number_field<&Record::dpi>("dpi"),
    number_field<&Record::type_pt>("type-pt"),
    {.key = "depth", .form = Form::number, .text_of = depth_of, .read = read_depth},
    text_field<&Record::shading>("shading"),
    text_field<&Record::journal>("journal"),
    text_field<&Record::lettering>("type-as"),
    frames_field<&Record::frames>("frames"),
    frames_field<&Record::run>("run"),
    number_field<&Record::frame>("frame"),
    number_field<&Record::film_frames>("film-frames"),
    text_field<&Record::names>("names"),
    text_field<&Record::sheet>("sheet"),
    text_field<&Record::as_read>("scene-as-read"),
    text_field<&Record::pixels>("pixels-xxh64"),
    text_field<&Record::packets>("packets-sha256"),
    text_field<&Record::file>("file-sha256"),
    text_field<&Record::page>("page-sha256"),
};

}  // namespace

std::span<const RecordField> record_fields() { return field_table; }

std::string json_key_of(const RecordField& field) {
    std::string key(field.key);
    std::replace(key.begin(), key.end(), '-', '_');
    return key;
}

std::string json_of(const RecordField& field, const std::string& text) {
    if (field.form == Form::text) return json_string(text);
    if (field.form == Form::number)
        return std::isfinite(number_of<double>(text).value_or(0.0)) ? text : "null";
    const std::size_t between = text.find_first_of("x-");
    return fmt::format("[{}, {}]", text.substr(0, between), text.substr(between + 1));
}

}  // namespace poinsot
