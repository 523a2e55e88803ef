// poinsot doctor: prints the capabilities of this machine.
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/options.h"
#include "encoding/codecs.h"
#include "error/error.h"
#include "render/renderer.h"
#include "text/json_text.h"
#include "typeset/files/font_search.h"
#include "typeset/font_source.h"

namespace poinsot {

namespace {

struct DoctorChoices {
    std::vector<std::string> arguments;  // none
    bool json = false;
};

struct Finding {
    std::string what;
    bool works;
    std::string detail;
};

Finding try_backend(const char* name, Backend backend) {
    try {
        const OffscreenContext context(backend);
        const ContextInfo& info = context.info();
        return {name, true,
                fmt::format("{}; {}; pictures up to {} px; device: {}", info.renderer, info.version,
                            info.largest_picture_px, info.device)};
    } catch (const Error& error) {
        return {name, false, error.what()};
    }
}

Finding try_font(std::string_view name) {
    try {
        return {fmt::format("font {}", name), true, find_font(name).string()};
    } catch (const Error& error) {
        return {fmt::format("font {}", name), false, error.what()};
    }
}

int run(const DoctorChoices& choices) {
    std::vector<Finding> findings;
    findings.push_back(try_backend("context OSMesa", Backend::osmesa));
    findings.push_back(try_backend("context EGL", Backend::egl));
    findings.push_back(try_backend("context GPU (--backend gpu)", Backend::gpu));
    const bool draws = findings[0].works || findings[1].works;
    // One of the two is enough, and new distributions have only the second.
    if (draws && !findings[0].works)
        findings[0].detail = "not needed: EGL works and draws the same pictures";
    if (draws && !findings[1].works) findings[1].detail += "; not needed: OSMesa works";

    bool encodes = true;
    for (const CodecStatus& codec : codec_statuses()) {
        findings.push_back({"codec " + codec.name, codec.available, codec.detail});
        encodes = encodes && codec.available;
    }
    bool sets_type = true;
    for (const std::string_view font : font_names()) {
        findings.push_back(try_font(font));
        sets_type = sets_type && findings.back().works;
    }

    if (choices.json) {
        std::vector<std::string> rows;
        rows.reserve(findings.size());
        for (const Finding& finding : findings) {
            rows.push_back(JsonObject()
                               .add("what", finding.what)
                               .add("works", finding.works)
                               .add("detail", finding.detail)
                               .line());
        }
        fmt::print("{}\n", json_lines(rows));
    } else {
        for (const Finding& finding : findings) {
            fmt::print("{:34} {:8} {}\n", finding.what, finding.works ? "works" : "MISSING",
                       printable(finding.detail, most_of_a_message));
        }
    }
    return draws && encodes && sets_type ? 0 : 1;
}

CommandLine doctor_line() {
    const auto choices = std::make_shared<DoctorChoices>();
    DoctorChoices& c = *choices;
    return {&c.arguments, {json_option(c.json)}, [choices] { return run(*choices); }};
}

}  // namespace

extern const Command doctor_command{
    "doctor",
    "",
    0,
    0,
    "report which OpenGL backends, codecs and fonts this machine has",
    doctor_line,
    {{{"poinsot doctor", "tests every OpenGL backend, codec and font"},
      {"poinsot doctor --json", "the same as JSON"}}}};

}  // namespace poinsot
