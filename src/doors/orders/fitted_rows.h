// The table of rows that is written beside a fitted scene, NAME.csv beside NAME.toml.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace poinsot {

// Throws as check_replaceable does unless nothing has the table's name, or the scene that the new
// one replaces names its hash, or it holds these rows already.
void check_rows_place(const std::filesystem::path& table, const std::filesystem::path& scene,
                      std::string_view rows);

}  // namespace poinsot
