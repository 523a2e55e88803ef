// The page's template, embedded at build time.
#pragma once

#include <string_view>
#include <vector>

namespace poinsot {

struct ReportPage {
    std::string_view name;  // file name: "report_page.html"
    std::string_view text;  // with the placeholders @TITLE@ and @DATA@
};

// One row.
const std::vector<ReportPage>& report_pages();

}  // namespace poinsot
