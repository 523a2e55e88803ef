// Results of a comparison as test results, in the XML that continuous integration systems read.
#pragma once

#include <span>
#include <string>

#include "compare/compared_picture.h"

namespace poinsot {

// Returns one test suite with one test case per picture; a failure's type is its outcome. A picture
// that could not be read is an error. Source: the JUnit XML format as written by Apache Ant and
// read by Jenkins and GitLab.
std::string junit_xml(const std::string& suite, std::span<const ComparedPicture> pictures);

}  // namespace poinsot
