#include "vector/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "text/utf8.h"
#include "vector/font_face.h"
#include "vector/pdf.h"

namespace poinsot::vector {

namespace {

constexpr std::string_view metadata_opening = "<metadata id=\"poinsot\">";
constexpr std::string_view metadata_end = "</metadata>";

// In units of 1/1000 pt, without needless characters.
std::string number(std::int64_t thousandths) {
    if (thousandths == 0) return "0";
    std::string text = thousandths < 0 ? "-" : "";
    const std::int64_t size = std::abs(thousandths);
    if (size >= 1000) text += std::to_string(size / 1000);
    if (size % 1000 != 0) {
        std::string part = fmt::format(".{:03}", size % 1000);
        part.erase(part.find_last_not_of('0') + 1);
        text += part;
    }
    return text;
}

std::int64_t rounded(double pt) { return std::llround(1000.0 * pt); }
std::string number(double pt) { return number(rounded(pt)); }

std::string hex(const Colour& colour) {
    const auto byte = [](double c) {
        return static_cast<int>(std::lround(255.0 * std::clamp(c, 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.r), byte(colour.g), byte(colour.b));
}

std::string matrix(const Eigen::Affine2d& map) {
    const auto& m = map.matrix();
    return fmt::format("matrix({:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g})", m(0, 0), m(1, 0),
                       m(0, 1), m(1, 1), m(0, 2), m(1, 2));
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '\r')
            out += "&#13;";
        else
            out += c;
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

// Path data, each step from the rounded end of the one before, so that roundings do not add up.
class PathData {
 public:
    void add(const Path& path, const Eigen::Affine2d& map = Eigen::Affine2d::Identity()) {
        for (const Step& step : path.steps) {
            switch (step.kind) {
                case Step::Kind::move:
                    begin('m', {map * step.to});
                    start_x_ = x_, start_y_ = y_;
                    break;
                case Step::Kind::line:
                    begin('l', {map * step.to});
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
    std::string take() { return std::move(text_); }

 private:
    void begin(char command, std::initializer_list<Eigen::Vector2d> points) {
        // The first move is from the origin, and lines may follow a move unnamed.
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
                const std::string digits = number(step);
                if (separate && digits.front() != '-') text_ += ' ';
                text_ += digits;
                separate = true;
            }
        }
        x_ = x, y_ = y;
    }

    std::string text_;
    char last_ = 0;
    std::int64_t x_ = 0, y_ = 0, start_x_ = 0, start_y_ = 0;
};

std::string data_of(const Path& path) {
    PathData data;
    data.add(path);
    return data.take();
}

class Writer {
 public:
    void operator()(const Fill& fill) {
        std::string rule = fill.even_odd ? " fill-rule=\"evenodd\"" : "";
        if (const Ink* ink = std::get_if<Ink>(&fill.paint); ink != nullptr && fill.seam_pt > 0.0)
            rule += fmt::format(" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                                hex(ink->colour), number(fill.seam_pt));
        if (const ShadedDisc* disc = std::get_if<ShadedDisc>(&fill.paint)) {
            shade(fill.path, *disc);
            return;
        }
        body_ +=
            fmt::format("<path d=\"{}\"{}{}/>\n", data_of(fill.path), paint_of(fill.paint), rule);
    }

    void operator()(const Stroke& stroke) {
        std::string look = fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", hex(stroke.ink.colour),
                                       number(stroke.width_pt));
        if (stroke.ink.alpha < 1.0)
            look += fmt::format(" stroke-opacity=\"{:.3g}\"", stroke.ink.alpha);
        if (stroke.round) look += " stroke-linecap=\"round\"";
        if (!stroke.dashes_pt.empty()) {
            std::string dashes;
            for (const double dash : stroke.dashes_pt)
                dashes += (dashes.empty() ? "" : " ") + number(dash);
            look += fmt::format(" stroke-dasharray=\"{}\"", dashes);
            if (stroke.dash_offset_pt != 0.0)
                look += fmt::format(" stroke-dashoffset=\"{}\"", number(stroke.dash_offset_pt));
        }
        body_ += fmt::format("<path class=\"l\" d=\"{}\"{}/>\n", data_of(stroke.path), look);
    }

    void operator()(const Type& type) {
        std::string look = fmt::format(" fill=\"{}\"", hex(type.ink.colour));
        if (type.ink.alpha < 1.0) look += fmt::format(" fill-opacity=\"{:.3g}\"", type.ink.alpha);
        if (type.halo.alpha > 0.0 && type.halo_pt > 0.0)
            look += fmt::format(
                " paint-order=\"stroke\" stroke=\"{}\" stroke-opacity=\"{:.3g}\" "
                "stroke-width=\"{}\" stroke-linejoin=\"round\"",
                hex(type.halo.colour), type.halo.alpha, number(1.5 * type.halo_pt));
        body_ += fmt::format("<g{}>\n", look);
        PathData shapes;
        bool any_shape = !type.rules.steps.empty();
        shapes.add(type.rules);
        for (std::size_t from = 0; from < type.letters.size();) {
            const PlacedLetter& letter = type.letters[from];
            FontFace& font = fonts_.of(*letter.font_file);
            if (font.character(letter.glyph) == 0) {
                // A form that no character stands for is drawn.
                any_shape = true;
                Eigen::Affine2d map = Eigen::Affine2d::Identity();
                map.translation() = Eigen::Vector2d(letter.x_pt, letter.y_pt);
                map.linear() *= letter.em_pt;
                shapes.add(font.outline(letter.glyph), map);
                ++from;
                continue;
            }
            from = add_run(type, from, font);
        }
        if (any_shape) body_ += fmt::format("<path d=\"{}\"/>\n", shapes.take());
        body_ += "</g>\n";
    }

    void operator()(const Picture& picture) {
        body_ += fmt::format(
            "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
            "href=\"data:image/png;base64,{}\"/>\n",
            number(picture.corner_pt.x()), number(picture.corner_pt.y()),
            number(picture.size_pt.x()), number(picture.size_pt.y()),
            base64(png_of(picture.raster)));
    }

    void operator()(const ClipBegin& clip) {
        body_ += fmt::format("<g clip-path=\"url(#{})\">\n", clip_id(clip.path, clip.even_odd));
    }
    void operator()(const ClipEnd&) { body_ += "</g>\n"; }

    std::string body() { return std::move(body_); }
    std::string defs() { return std::move(defs_); }

    // The fonts of the text, each with the characters that are used.
    std::string style() {
        std::string style = ".l{fill:none;stroke-linejoin:round}\n";
        for (const auto& [file, used] : used_) {
            const std::string font = fonts_.of(file).subset(used.characters);
            if (!font.empty())
                style +=
                    fmt::format("@font-face{{font-family:{};src:url(data:font/otf;base64,{})}}\n",
                                used.name, base64(font));
            style += fmt::format(
                ".{0}{{font-family:{0},\"{1}\";font-variant-ligatures:none;white-space:pre}}\n",
                used.name, fonts_.of(file).family());
        }
        return style;
    }

 private:
    struct UsedFont {
        std::string name;
        std::set<char32_t> characters;
    };
    // By the fonts' names, wherever they lie: the same bytes on machines that keep them elsewhere.
    struct ByName {
        bool operator()(const std::filesystem::path& a, const std::filesystem::path& b) const {
            const auto order = a.filename().compare(b.filename());
            return order != 0 ? order < 0 : a < b;
        }
    };

    // Of a clip; one that is there already serves again.
    const std::string& clip_id(const Path& path, bool even_odd) {
        const std::string shape = fmt::format("<path d=\"{}\"{}/>", data_of(path),
                                              even_odd ? " clip-rule=\"evenodd\"" : "");
        std::string& id = clips_[shape];
        if (id.empty()) {
            id = next_id();
            defs_ += fmt::format("<clipPath id=\"{}\">{}</clipPath>\n", id, shape);
        }
        return id;
    }

    std::string next_id() { return fmt::format("p{}", ++n_ids_); }

    std::string stops_of(const std::vector<Stop>& stops) {
        std::string text;
        for (const Stop& stop : stops) {
            text += fmt::format("<stop offset=\"{:.4g}\" stop-color=\"{}\"", stop.at,
                                hex(stop.ink.colour));
            if (stop.ink.alpha < 1.0)
                text += fmt::format(" stop-opacity=\"{:.3g}\"", stop.ink.alpha);
            text += "/>";
        }
        return text;
    }

    std::string paint_of(const Paint& paint) {
        if (const Ink* ink = std::get_if<Ink>(&paint)) {
            std::string text = fmt::format(" fill=\"{}\"", hex(ink->colour));
            if (ink->alpha < 1.0) text += fmt::format(" fill-opacity=\"{:.3g}\"", ink->alpha);
            return text;
        }
        const std::string id = next_id();
        if (const LinearFade* linear = std::get_if<LinearFade>(&paint)) {
            defs_ += fmt::format(
                "<linearGradient id=\"{}\" gradientUnits=\"userSpaceOnUse\" x1=\"{}\" y1=\"{}\" "
                "x2=\"{}\" y2=\"{}\">{}</linearGradient>\n",
                id, number(linear->from.x()), number(linear->from.y()), number(linear->to.x()),
                number(linear->to.y()), stops_of(linear->stops));
        } else if (const RadialFade* radial = std::get_if<RadialFade>(&paint)) {
            defs_ += fmt::format(
                "<radialGradient id=\"{}\" gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" "
                "r=\"1\" fx=\"{:.5g}\" fy=\"{:.5g}\" "
                "gradientTransform=\"{}\">{}</radialGradient>\n",
                id, radial->focus.x(), radial->focus.y(), matrix(radial->page_from_circle),
                stops_of(radial->stops));
        }
        return fmt::format(" fill=\"url(#{})\"", id);
    }

    // SVG has no patches: bands across the disc, each from where it begins down to the disc's end,
    // so that the next covers it and no seam is left.
    void shade(const Path& path, const ShadedDisc& disc) {
        constexpr int n_bands = 36, n_stops = 10;
        const std::string& clip = clip_id(path, false);
        body_ += fmt::format("<g clip-path=\"url(#{})\"><g transform=\"{}\" opacity=\"{:.3g}\">\n",
                             clip, matrix(disc.page_from_disc), disc.alpha);
        for (int k = 0; k < n_bands; ++k) {
            const double top = -1.0 + 2.0 * k / n_bands, middle = top + 1.0 / n_bands;
            const double half = std::sqrt(std::max(1.0 - middle * middle, 0.0));
            std::vector<Stop> stops;
            for (int i = 0; i <= n_stops; ++i) {
                const double x = -half * std::cos(std::numbers::pi * i / n_stops);
                stops.push_back({0.5 + 0.5 * x, {disc.at(Eigen::Vector2d(x, middle)), 1.0}});
            }
            const std::string id = next_id();
            defs_ += fmt::format(
                "<linearGradient id=\"{}\" gradientUnits=\"userSpaceOnUse\" x1=\"-1\" "
                "x2=\"1\">{}</linearGradient>\n",
                id, stops_of(stops));
            body_ += fmt::format(
                "<rect x=\"-1.1\" y=\"{:.4g}\" width=\"2.2\" height=\"{:.4g}\" "
                "fill=\"url(#{})\"/>\n",
                k == 0 ? -1.1 : top, (k == 0 ? 2.2 : 1.1 - top), id);
        }
        body_ += "</g></g>\n";
    }

    // Letters of one font, size and baseline, each at its place; returns where they end. A letter
    // beyond the first 65,536 characters stands alone: readers count its places differently.
    std::size_t add_run(const Type& type, std::size_t from, FontFace& font) {
        const PlacedLetter& first = type.letters[from];
        UsedFont& used = used_[*first.font_file];
        if (used.name.empty()) used.name = fmt::format("f{}", used_.size());
        std::string places, letters;
        std::size_t to = from;
        double pen_pt = 0.0;  // where the letter before ends
        for (; to < type.letters.size(); ++to) {
            const PlacedLetter& letter = type.letters[to];
            if (*letter.font_file != *first.font_file || letter.em_pt != first.em_pt ||
                rounded(letter.y_pt) != rounded(first.y_pt))
                break;
            const char32_t c = font.character(letter.glyph);
            if (c == 0 || (c > 0xffff && to > from)) break;
            // A gap between words is a space, so that they are found as words.
            constexpr double word_gap = 0.15;  // ems
            if (to > from && letter.x_pt - pen_pt > word_gap * letter.em_pt) {
                used.characters.insert(U' ');
                letters += ' ';
                places += " " + number(pen_pt);
            }
            pen_pt = letter.x_pt + letter.em_pt * font.advance(letter.glyph);
            used.characters.insert(c);
            letters += utf8_of(c);
            places += (places.empty() ? "" : " ") + number(letter.x_pt);
            if (c > 0xffff) {
                ++to;
                break;
            }
        }
        body_ += fmt::format("<text class=\"{}\" font-size=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n",
                             used.name, number(first.em_pt), places, number(first.y_pt),
                             escaped(letters));
        return to;
    }

    std::string defs_, body_;
    int n_ids_ = 0;
    std::map<std::string, std::string> clips_;  // ids by shape
    FontFaces fonts_;
    std::map<std::filesystem::path, UsedFont, ByName> used_;
};

}  // namespace

std::string svg_of(const Page& page, std::string_view title, std::string_view text) {
    Writer writer;
    for (const Item& item : page.items) std::visit(writer, item);
    constexpr double mm_per_pt = 25.4 / 72.0;
    std::string svg = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "width=\"{0:.6g}mm\" height=\"{1:.6g}mm\" viewBox=\"0 0 {2} {3}\">\n",
        mm_per_pt * page.width_pt, mm_per_pt * page.height_pt, number(page.width_pt),
        number(page.height_pt));
    if (!title.empty()) svg += fmt::format("<title>{}</title>\n", escaped(title));
    if (!text.empty())
        svg += fmt::format("{}{}{}\n", metadata_opening, escaped(text), metadata_end);
    svg += fmt::format("<style>\n{}</style>\n", writer.style());
    svg += fmt::format("<defs>\n{}</defs>\n", writer.defs());
    return svg + writer.body() + "</svg>\n";
}

std::string svg_text(std::string_view svg) {
    const std::size_t at = svg.find(metadata_opening);
    if (at == std::string_view::npos) return {};
    const std::size_t end = svg.find(metadata_end, at);
    if (end == std::string_view::npos) return {};
    const std::size_t from = at + metadata_opening.size();
    return unescaped(svg.substr(from, end - from));
}

}  // namespace poinsot::vector
