#include "orders/fitted_rows.h"

#include "production/fits/fitted_scene.h"
#include "system/files/file_contents.h"
#include "system/files/own_files.h"
#include "system/sha256.h"

namespace poinsot {

void check_rows_place(const std::filesystem::path& table, const std::filesystem::path& scene,
                      std::string_view rows) {
    const auto is_own = [&](const std::filesystem::path& file) {
        const std::string hash = sha256_of_file(file);
        return hash == sha256_of(rows) ||
               read_text(scene).find(hash_comment(hash)) != std::string::npos;
    };
    check_replaceable({.path = table, .is_own = is_own, .what = "the rows of the scene"});
}

}  // namespace poinsot
