#include "compare/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/markup.h"

namespace poinsot {

std::string junit_xml(const std::string& suite, std::span<const ComparedPicture> pictures) {
    const auto n_errors = std::count_if(pictures.begin(), pictures.end(), [](const auto& p) {
        return p.outcome == Outcome::unreadable;
    });
    const auto n_failures = std::count_if(pictures.begin(), pictures.end(), [](const auto& p) {
        return !p.passes() && p.outcome != Outcome::unreadable;
    });
    const std::string name = escaped_markup(suite);
    std::string xml = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
        name, pictures.size(), n_failures, n_errors);
    for (const ComparedPicture& picture : pictures) {
        xml += fmt::format("<testcase classname=\"{}\" name=\"{}\"", name,
                           escaped_markup(picture.name));
        if (picture.passes()) {
            xml += "/>\n";
            continue;
        }
        const char* const element = picture.outcome == Outcome::unreadable ? "error" : "failure";
        xml += fmt::format("><{} type=\"{}\" message=\"{}\"/></testcase>\n", element,
                           name_of(picture.outcome), escaped_markup(picture.line()));
    }
    return xml + "</testsuite>\n</testsuites>\n";
}

}  // namespace poinsot
