// Compared pictures as test results in the XML that continuous integration reads.
#pragma once

#include <span>
#include <string>

#include "report/compared_picture.h"

namespace poinsot {

// One test suite, a test case each; a failure's type is its outcome. What could not be read is an
// error.
// Source: the JUnit XML format as written by Apache Ant and read by Jenkins and GitLab.
std::string junit_xml(const std::string& suite, std::span<const ComparedPicture> pictures);

}  // namespace poinsot
