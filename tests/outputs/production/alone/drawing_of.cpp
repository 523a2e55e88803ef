// drawing_of TIME_S: makes the drawing of a scene as a page in a browser would, with neither
// OpenGL, FFmpeg nor files, and prints its number of shapes. Reads fonts and the scene from
// standard input, each as a line "NAME N_BYTES" and its bytes; the scene comes last.
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "production/alone/count_shapes.h"
#include "production/session/picture_setting.h"
#include "production/session/session.h"
#include "scene/parse_scene.h"

namespace {

std::string standard_input() {
    std::string all;
    std::array<char, 1 << 16> block{};
    for (ssize_t n = 0; (n = ::read(STDIN_FILENO, block.data(), block.size())) > 0;)
        all.append(block.data(), static_cast<std::size_t>(n));
    return all;
}

// Takes a name with its bytes from the front of a text.
std::pair<std::string_view, std::string_view> take(std::string_view& from) {
    const std::size_t space = from.find(' '), line = from.find('\n');
    const std::string_view name = from.substr(0, space);
    const auto size = static_cast<std::size_t>(
        std::strtoul(std::string(from.substr(space, line - space)).c_str(), nullptr, 10));
    const std::string_view bytes = from.substr(line + 1, size);
    from.remove_prefix(line + 1 + size);
    return {name, bytes};
}

void draw(double time_s) {
    const std::string given = standard_input();
    std::string_view rest = given;
    std::vector<poinsot::FontBytes> fonts;
    auto [name, bytes] = take(rest);
    while (!rest.empty()) {
        fonts.push_back({name, bytes});
        std::tie(name, bytes) = take(rest);
    }
    poinsot::SessionRequest request;
    request.fonts = poinsot::fonts_in_memory(fonts);
    request.times_s = {time_s};
    const poinsot::Session session =
        poinsot::session_of(poinsot::parse_scene(bytes, std::string(name)), request);
    const poinsot::Stage stage = poinsot::stage_of(
        session, {.first_time_s = 0.0, .last_time_s = time_s}, poinsot::setting_of(session.scene));
    std::printf("%zu\n", poinsot::n_shapes(stage.at(time_s)));
}

}  // namespace

int main(int argc, char** argv) {
    // Nothing can be opened any more.
    const rlimit none{0, 0};
    if (argc != 2 || ::setrlimit(RLIMIT_NOFILE, &none) != 0) return 2;
    try {
        draw(std::strtod(argv[1], nullptr));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
