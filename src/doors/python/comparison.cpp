// Comparison of pictures, reports, and approval of baselines.
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "compare/approval.h"
#include "compare/compared_picture.h"
#include "compare/html_report.h"
#include "compare/report_pictures.h"
#include "image/files/png_files.h"
#include "orders/compare.h"
#include "python/bindings.h"
#include "system/files/atomic_file.h"

namespace poinsot::python {

namespace {

namespace fs = std::filesystem;
using Pixels = py::array_t<std::uint8_t, py::array::c_style>;

py::array array_of_image(const Image& image) {
    const auto bytes = image.bytes();
    return array_of(std::vector<std::uint8_t>(bytes.begin(), bytes.end()),
                    {py::ssize_t{image.height()}, py::ssize_t{image.width()}, py::ssize_t{4}});
}

// Reads a limit by a function of report/given_limits.h; an error names the limit.
template <typename Read>
auto named(const std::string& name, Read read) {
    try {
        return read();
    } catch (const InputError& error) {
        throw InputError(name + ": " + error.what());
    }
}

// The limits, under the names of the options of `poinsot compare`.
GivenLimits given_limits_of(const py::dict& options) {
    GivenLimits given;
    for (const NumberLimit& limit : number_limits()) {
        const std::string name(limit.name);
        std::optional<double>& value = given.*limit.value;
        if (limit.kind == LimitKind::share && options.contains(name) &&
            py::isinstance<py::str>(options[name.c_str()])) {
            value =
                named(name, [&] { return parse_share(options[name.c_str()].cast<std::string>()); });
            continue;
        }
        if (limit.kind == LimitKind::level)
            value = option<int>(options, name.c_str());
        else
            value = option<double>(options, name.c_str());
        if (value) value = named(name, [&] { return limit.checked(*value); });
    }
    given.antialiasing = option<bool>(options, "antialiasing");
    if (options.contains("ignore"))
        for (const py::handle region : options["ignore"]) {
            if (!py::isinstance<py::str>(region))
                throw InputError("ignore: a region is a text, and this is " + shown(region));
            given.ignore.push_back(
                named("ignore", [&] { return parse_region(region.cast<std::string>()); }));
        }
    return given;
}

CompareRequest request_of(const std::string& profile, const py::dict& limits, bool measures) {
    CompareRequest request{.given = given_limits_of(limits)};
    request.limits = named("profile", [&] { return limits_of_profile(profile); });
    request.ssim = request.flip = measures;
    return request;
}

// The name of a file as Python holds it, whatever its bytes (PEP 383).
py::str name_text(const std::string& name) {
    PyObject* text =
        PyUnicode_DecodeUTF8(name.data(), static_cast<py::ssize_t>(name.size()), "surrogateescape");
    if (text == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::str>(text);
}

py::dict dict_of(const ComparedPicture& compared) {
    using namespace py::literals;
    const Comparison& measured = compared.measured;
    return py::dict(
        "name"_a = name_text(compared.name), "outcome"_a = std::string(name_of(compared.outcome)),
        "passes"_a = compared.passes(), "reason"_a = in_keywords(compared.reason),
        "changes"_a = compared.changes, "n_pixels"_a = measured.n_pixels,
        "n_differing"_a = measured.n_differing, "n_over_level"_a = measured.n_over_level,
        "n_ignored"_a = measured.n_ignored, "largest_difference"_a = measured.largest_difference,
        "mean_difference"_a = measured.mean_difference, "ssim"_a = measured.ssim,
        "flip"_a = measured.flip);
}

// The manifest and the compare.toml beside the expected picture hold.
ComparedPicture compare_with_baseline(const std::string& name, const fs::path& expected,
                                      const fs::path& actual, CompareRequest& request) {
    const fs::path folder = expected.parent_path();
    request.file = read_compare_file(folder);
    const Baselines baselines(folder);
    return compare_files(name, expected, actual, request, &baselines, expected.stem().string());
}

py::dict compare_pair(const std::string& name, const std::string& expected,
                      const std::string& actual, const std::string& profile, const py::dict& limits,
                      bool measures) {
    CompareRequest request = request_of(profile, limits, measures);
    Image difference;
    request.seen = [&difference](ComparedPicture&, const PicturePair& pair) {
        if (pair.strip.empty())
            difference = difference_picture(pair.expected, pair.actual, pair.ignored);
    };
    ComparedPicture compared;
    run_interruptibly([&] { compared = compare_with_baseline(name, expected, actual, request); });
    if (compared.outcome == Outcome::unreadable) throw InputError(compared.reason);
    py::dict answer = dict_of(compared);
    answer["difference"] = difference.empty() ? py::object(py::none()) : array_of_image(difference);
    return answer;
}

py::list compare_all(const std::string& expected, const std::string& actual,
                     const std::string& profile, const py::dict& limits, bool measures,
                     const py::dict& outputs) {
    const ComparisonOrder order{
        .expected = expected,
        .actual = actual,
        .are_folders = true,
        .request = request_of(profile, limits, measures),
        .outputs = {.title = option<std::string>(outputs, "title").value_or(""),
                    .report = option<std::string>(outputs, "report").value_or(""),
                    .junit = option<std::string>(outputs, "junit").value_or(""),
                    .single_file = option<bool>(outputs, "single_file").value_or(false)}};
    ComparisonResult result;
    run_interruptibly([&] { result = compare(order); });
    py::list answers;
    for (const ComparedPicture& picture : result.pictures) answers.append(dict_of(picture));
    return answers;
}

// Writes a report of pairs, each with limits of its own: (name, expected, actual, profile, limits).
void report_pairs(
    const std::vector<std::tuple<std::string, std::string, std::string, std::string, py::dict>>&
        pairs,
    const std::string& report, const std::string& title) {
    std::vector<CompareRequest> requests;
    requests.reserve(pairs.size());
    for (const auto& [name, expected, actual, profile, limits] : pairs)
        requests.push_back(request_of(profile, limits, false));
    run_interruptibly([&] {
        for (const auto& [name, expected, actual, profile, limits] : pairs)
            check_outputs({.expected = expected, .actual = actual, .outputs = {.report = report}});
        ReportPictures shown(report, false);
        std::vector<ComparedPicture> pictures;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const auto& [name, expected, actual, profile, limits] = pairs[i];
            requests[i].seen = [&shown](ComparedPicture& picture, const PicturePair& pair) {
                shown.add(picture, pair);
            };
            pictures.push_back(compare_with_baseline(name, expected, actual, requests[i]));
        }
        sort_by_severity(pictures);
        write_whole(report, html_report(title, pictures, shown));
    });
}

py::bytes png_of_pixels(const Pixels& pixels) {
    if (pixels.ndim() != 3 || pixels.shape(2) != 4)
        throw InputError("an array of pixels has the shape (height, width, 4)");
    constexpr py::ssize_t most_side = 1 << 16;
    if (pixels.shape(0) < 1 || pixels.shape(1) < 1 || pixels.shape(0) > most_side ||
        pixels.shape(1) > most_side)
        throw InputError("a picture has 1 to 65536 pixels per side");
    Image image(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)));
    std::copy_n(pixels.data(), pixels.size(), image.bytes().begin());
    std::vector<std::uint8_t> png;
    {
        const WithoutLock without_lock;
        png = encode_png(image);
    }
    return py::bytes(reinterpret_cast<const char*>(png.data()), png.size());
}

// Refuses limits that no comparison with this picture could use.
void check_limits(const std::string& picture, const std::string& profile, const py::dict& limits) {
    const CompareRequest request = request_of(profile, limits, false);
    named("ignore", [&] { check_regions(request.given, picture); });
}

using Outcomes = std::vector<std::pair<std::string, std::string>>;

ApprovalTelling settled_into(Outcomes& outcomes) {
    return {
        .settled = [&outcomes](const std::string& name,
                               std::string_view outcome) { outcomes.emplace_back(name, outcome); },
        .note = [](const std::string&) {}};
}

Outcomes approve_pictures(const std::string& results, const std::string& baselines,
                          const std::vector<std::string>& names, const std::string& why,
                          bool any_renderer, bool foreign) {
    Outcomes outcomes;
    const WithoutLock without_lock;
    approve({.results = results,
             .baselines = baselines,
             .names = names,
             .why = why,
             .any_renderer = any_renderer,
             .foreign = foreign},
            settled_into(outcomes));
    return outcomes;
}

Outcomes remove_pictures(const std::string& baselines, const std::vector<std::string>& names,
                         const std::string& why) {
    Outcomes outcomes;
    const WithoutLock without_lock;
    remove_baselines(baselines, names, why, settled_into(outcomes));
    return outcomes;
}

}  // namespace

void add_comparison(py::module_& module) {
    using namespace py::literals;
    module.def("compare_pair", compare_pair, "name"_a, "expected"_a, "actual"_a, "profile"_a,
               "limits"_a, "measures"_a);
    module.def("compare_all", compare_all, "expected"_a, "actual"_a, "profile"_a, "limits"_a,
               "measures"_a, "outputs"_a);
    module.def("report_pairs", report_pairs, "pairs"_a, "report"_a, "title"_a);
    module.def("png_of", png_of_pixels, "pixels"_a);
    module.def(
        "write_whole",
        [](const std::string& file, const py::bytes& contents) {
            const std::string_view bytes = contents;
            // It waits for the reader of a pipe.
            run_interruptibly([&] { write_whole(file, bytes); });
        },
        "file"_a, "contents"_a);
    module.def("check_limits", check_limits, "picture"_a, "profile"_a, "limits"_a);
    module.def("approve", approve_pictures, "results"_a, "baselines"_a, "names"_a, "why"_a,
               "any_renderer"_a, "foreign"_a);
    module.def("remove_baselines", remove_pictures, "baselines"_a, "names"_a, "why"_a);
}

}  // namespace poinsot::python
