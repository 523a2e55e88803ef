#include "web/module/answers.h"

#include <algorithm>
#include <cstdlib>

#include "text/json_text.h"

namespace poinsot {

std::string& answer() {
    static std::string it;
    return it;
}

std::vector<double>& numbers() {
    static std::vector<double> it;
    return it;
}

std::string error_text(std::string_view kind, std::string_view message,
                       const SourceLocation& where) {
    return JsonObject()
        .add("kind", kind)
        .add("message", message)
        .add("file", where.file)
        .add("line", where.line)
        .add("column", where.column)
        .line();
}

std::vector<std::string> texts_at(const char* texts, std::uint32_t size) {
    std::vector<std::string> given;
    for (std::string_view rest = text_at(texts, size); !rest.empty();) {
        const std::size_t end = std::min(rest.find('\0'), rest.size() - 1);
        given.emplace_back(rest.substr(0, end));
        rest.remove_prefix(end + 1);
    }
    return given;
}

}  // namespace poinsot

using namespace poinsot;  // NOLINT(google-build-using-namespace)

POINSOT_EXPORT(take) void* take(std::uint32_t size) { return std::malloc(size); }
POINSOT_EXPORT(give_back) void give_back(void* memory) { std::free(memory); }
POINSOT_EXPORT(answer_at) const char* answer_at() { return answer().data(); }
POINSOT_EXPORT(answer_size) std::uint32_t answer_size() {
    return static_cast<std::uint32_t>(answer().size());
}
POINSOT_EXPORT(numbers_at) const double* numbers_at() { return numbers().data(); }
POINSOT_EXPORT(n_numbers) std::uint32_t n_numbers() {
    return static_cast<std::uint32_t>(numbers().size());
}
