#include "vector/svg_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "text/utf8.h"

namespace poinsot::vector::svg {

std::string share(double value) {
    std::string text = fmt::format("{:.3g}", value);
    if (text.starts_with("0.")) text.erase(0, 1);
    return text;
}

std::string matrix(const Eigen::Affine2d& map) {
    const Eigen::Matrix3d m =
        Eigen::Vector3d(units_per_pt, units_per_pt, 1.0).asDiagonal() * map.matrix();
    return fmt::format("matrix({:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g})", m(0, 0), m(1, 0),
                       m(0, 1), m(1, 1), m(0, 2), m(1, 2));
}

namespace {

// The characters of XML 1.0 (§2.2), production Char; a document with any other is not read at all.
bool is_xml(char32_t c) {
    return c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c != 0xfffe && c != 0xffff);
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const Utf8Character c = first_character(text);
        if (c.code == '&')
            out += "&amp;";
        else if (c.code == '<')
            out += "&lt;";
        else if (c.code == '>')
            out += "&gt;";
        else if (c.code == '\r')
            out += "&#13;";
        else if (!c.valid || !is_xml(c.code))
            out += "\ufffd";
        else
            out += text.substr(0, c.size);
        text.remove_prefix(c.size);
    }
    return out;
}

std::string unescaped(std::string_view text) {
    std::string out;
    const std::pair<std::string_view, char> names[] = {
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&#13;", '\r'}};
    for (std::size_t k = 0; k < text.size();) {
        std::size_t taken = 1;
        char c = text[k];
        for (const auto& [name, meant] : names)
            if (text.substr(k).starts_with(name)) c = meant, taken = name.size();
        out += c;
        k += taken;
    }
    return out;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = (group << 8U) |
                    (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            out += i <= std::min<std::size_t>(bytes.size() - k, 3)
                       ? digits[(group >> (18U - 6U * i)) & 63U]
                       : '=';
    }
    return out;
}

void PathData::add(const Path& path, const Eigen::Affine2d& map) {
    for (const Step& step : path.steps) {
        switch (step.kind) {
            case Step::Kind::move:
                begin('m', {map * step.to});
                start_x_ = x_, start_y_ = y_;
                break;
            case Step::Kind::line:
                line(map * step.to);
                break;
            case Step::Kind::cubic:
                begin('c', {map * step.control_1, map * step.control_2, map * step.to});
                break;
            case Step::Kind::close:
                text_ += 'z';
                last_ = 'z';
                x_ = start_x_, y_ = start_y_;
        }
    }
}

// Uses the horizontal or vertical command where possible.
void PathData::line(const Eigen::Vector2d& to) {
    const std::int64_t x = rounded(to.x()), y = rounded(to.y());
    if ((x == x_) == (y == y_)) {
        begin('l', {to});
        return;
    }
    const char command = y == y_ ? 'h' : 'v';
    const std::string digits = std::to_string(y == y_ ? x - x_ : y - y_);
    if (command != last_)
        text_ += command;
    else if (digits.front() != '-')
        text_ += ' ';
    text_ += digits;
    last_ = command;
    x_ = x, y_ = y;
}

void PathData::begin(char command, std::initializer_list<Eigen::Vector2d> points) {
    // The first move is relative to the origin, and lines may follow a move without a command
    // letter.
    bool separate = false;
    if (command != last_ || command == 'm') {
        text_ += command;
        last_ = command;
    } else {
        separate = true;
    }
    std::int64_t x = x_, y = y_;
    for (const Eigen::Vector2d& point : points) {
        x = rounded(point.x());
        y = rounded(point.y());
        for (const std::int64_t step : {x - x_, y - y_}) {
            const std::string digits = std::to_string(step);
            if (separate && digits.front() != '-') text_ += ' ';
            text_ += digits;
            separate = true;
        }
    }
    x_ = x, y_ = y;
}

std::string data_of(const Path& path) {
    PathData data;
    data.add(path);
    return data.take();
}

}  // namespace poinsot::vector::svg
