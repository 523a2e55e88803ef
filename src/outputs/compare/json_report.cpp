#include "compare/json_report.h"

#include "text/json_text.h"

namespace poinsot {

namespace {

std::string json_of(const std::optional<double>& value) {
    return value ? json_number(*value) : "null";
}

std::string json_of(const CompareLimits& limits) {
    JsonObject object;
    for (const NumberLimit& limit : number_limits())
        std::visit(
            [&](const auto member) {
                object.json(std::string(limit.json_name),
                            json_of(std::optional<double>(limits.*member)));
            },
            limit.limits);
    return object.add("antialiasing", limits.antialiasing).line();
}

std::string json_strings(const std::vector<std::string>& texts) {
    std::vector<std::string> values;
    values.reserve(texts.size());
    for (const std::string& text : texts) values.push_back(json_string(text));
    return json_list(values);
}

std::string json_of(const FilmDifferences& film) {
    const auto frame = [&film](std::int64_t number) {
        return film.n_differing > 0 ? std::to_string(number) : std::string("null");
    };
    return JsonObject()
        .add("frames_expected", film.n_expected)
        .add("frames_actual", film.n_actual)
        .add("frames_differing", film.n_differing)
        .add("frames_failing", film.n_failing)
        .json("first", frame(film.first))
        .json("worst", frame(film.worst))
        .json("frames_per_second", film.rate ? json_number(film.rate->per_second()) : "null")
        .line();
}

}  // namespace

std::string json_report(std::span<const ComparedPicture> pictures,
                        const std::optional<CompareLimits>& limits) {
    std::vector<std::string> rows;
    for (const ComparedPicture& p : pictures) {
        const Comparison& m = p.measured;
        JsonObject row;
        row.add("name", p.name).add("outcome", name_of(p.outcome));
        row.add("passes", p.passes()).add("reason", p.reason);
        row.json("changes", p.changes ? json_strings(*p.changes) : "null");
        row.json("expected_size", json_numbers(m.expected_width, m.expected_height));
        row.json("actual_size", json_numbers(m.actual_width, m.actual_height));
        row.add("n_pixels", m.n_pixels).add("n_differing", m.n_differing);
        row.add("n_over_level", m.n_over_level).add("n_antialiased", m.n_antialiased);
        row.add("n_ignored", m.n_ignored);
        row.add("largest_difference", m.largest_difference);
        row.add("mean_difference", m.mean_difference);
        row.json("ssim", json_of(m.ssim)).json("flip", json_of(m.flip));
        row.json("limits", json_of(p.limits)).json("ignored", json_strings(p.ignored));
        if (p.film) row.json("film", json_of(*p.film));
        rows.push_back(row.line());
    }
    return JsonObject()
        .add("passes", all_pass(pictures))
        .json("limits", limits ? json_of(*limits) : "null")
        .json("pictures", json_lines(rows, 2))
        .lines();
}

}  // namespace poinsot
