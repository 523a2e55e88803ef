#include "production/stills/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawing/stage/framing.h"
#include "drawing/stage/type/labels.h"
#include "encoding/film_metadata.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_xxh64.h"
#include "production/records/record.h"
#include "production/stills/prepared_still.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "system/files/own_files.h"
#include "system/interrupt.h"
#include "text/printable.h"
#include "typeset/files/installed_fonts.h"
#include "typeset/typesetter.h"

namespace poinsot {

namespace {

constexpr int most_pixels = 16384;  // per side

// A caption's share of a picture's height, and its font size as a share of that.
constexpr double caption_share = 0.09, type_share = 0.62;

class ContactSheet {
 public:
    // For pictures of the first one's size, on the colour of its corner.
    ContactSheet(const SheetRequest& request, const Image& first)
        : request_(&request),
          width_px_(first.width()),
          height_px_(first.height()),
          caption_px_(std::max(14, static_cast<int>(caption_share * first.height()))),
          ground_(first.at(0, 0)) {
        const std::int64_t width = std::int64_t{width_px_} * request.n_columns;
        const std::int64_t height = std::int64_t{height_px_ + caption_px_} * request.n_rows;
        if (width > most_pixels || height > most_pixels)
            throw InputError(fmt::format(
                "--sheet {}x{}: the sheet would have {}×{} pixels, more than {} a side; draw "
                "smaller pictures with --size",
                request.n_columns, request.n_rows, width, height, most_pixels));
        image_ = Image(static_cast<int>(width), static_cast<int>(height));
        for (int y = 0; y < image_.height(); ++y)
            for (int x = 0; x < image_.width(); ++x) image_.set(x, y, ground_);
    }

    void put(std::size_t index, const Image& picture) {
        if (picture.width() != width_px_ || picture.height() != height_px_)
            throw InputError(fmt::format(
                "--sheet: all pictures must have one size, but {}×{} differs from {}×{}",
                picture.width(), picture.height(), width_px_, height_px_));
        const auto columns = static_cast<std::size_t>(request_->n_columns);
        const int left = static_cast<int>(index % columns) * width_px_;
        const int top = static_cast<int>(index / columns) * (height_px_ + caption_px_);
        for (int y = 0; y < height_px_; ++y)
            for (int x = 0; x < width_px_; ++x) image_.set(left + x, top + y, picture.at(x, y));
        write(request_->cells[index].caption, left, top + height_px_);
    }

    const Image& image() const { return image_; }

 private:
    // Centred, at the largest size that fits.
    void write(const std::string& caption, int left, int top) {
        TypeStyle style;
        style.mode = TypeMode::text;
        style.size_px = type_share * caption_px_;
        const std::string& text = caption;
        const double room_px = 0.94 * width_px_;
        const TypeExtent extent = typesetter_.measure(text, style);
        if (extent.width > room_px) style.size_px *= room_px / extent.width;
        style.size_px = std::max(1.0, style.size_px);
        const TypesetMask mask = typesetter_.set(text, style);
        const int x0 = left + (width_px_ - mask.width) / 2;
        const int y0 = top + (caption_px_ - mask.height) / 2;
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x)
                ink(x0 + x, y0 + y,
                    mask.coverage[static_cast<std::size_t>(y) *
                                      static_cast<std::size_t>(mask.width) +
                                  static_cast<std::size_t>(x)]);
    }

    // Dark text on a light background, light text on a dark one.
    void ink(int x, int y, int coverage) {
        if (x < 0 || y < 0 || x >= image_.width() || y >= image_.height() || coverage == 0) return;
        const int brightness = (2 * ground_.r + 5 * ground_.g + ground_.b) / 8;
        const int shade = ground_.a < 128 || brightness > 127 ? 24 : 232;
        const auto mixed = [&](int under) {
            return static_cast<std::uint8_t>((under * (255 - coverage) + shade * coverage) / 255);
        };
        const Rgba8 under = image_.at(x, y);
        image_.set(x, y,
                   {mixed(under.r), mixed(under.g), mixed(under.b),
                    std::max(under.a, static_cast<std::uint8_t>(coverage))});
    }

    const SheetRequest* request_;
    int width_px_, height_px_, caption_px_;
    Rgba8 ground_;
    Image image_;
    Typesetter typesetter_{installed_fonts()};
};

// The drawings of all cells in one, each with its caption. Refers to the stills.
class VectorSheet {
 public:
    VectorSheet(const SheetRequest& request, const Drawing& first, double dpi)
        : request_(&request),
          width_px_(first.width_px),
          height_px_(first.height_px),
          type_px_(request.print.type_pt.value_or(default_type_pt) * dpi / pt_per_inch) {
        // One height for all captions: that of the one with most lines.
        for (const SheetCell& cell : request.cells)
            caption_px_ = std::max(caption_px_, set(cell.caption).mask->height_px());
        caption_px_ += static_cast<int>(std::ceil(1.2 * type_px_));
        drawing_.width_px = width_px_ * request.n_columns;
        drawing_.height_px = (height_px_ + caption_px_) * request.n_rows;
        if (std::max(drawing_.width_px, drawing_.height_px) > longest_inches * dpi)
            throw InputError(fmt::format(
                "--sheet: a side of {:.0f} mm: a page has {:.0f} mm at most; make the cells "
                "smaller, or take fewer",
                std::max(drawing_.width_px, drawing_.height_px) / dpi * mm_per_inch,
                longest_inches * mm_per_inch));
        drawing_.background = first.background;
        captions_.width_px = drawing_.width_px;
        captions_.height_px = drawing_.height_px;
        captions_.background.alpha = 0.0;
    }

    void put(std::size_t index, Drawing&& cell) {
        if (cell.width_px != width_px_ || cell.height_px != height_px_)
            throw InputError(fmt::format(
                "--sheet: all pictures must have one size, but {}×{} differs from {}×{}",
                cell.width_px, cell.height_px, width_px_, height_px_));
        const auto columns = static_cast<std::size_t>(request_->n_columns);
        const int left = static_cast<int>(index % columns) * width_px_;
        const int top = static_cast<int>(index / columns) * (height_px_ + caption_px_);
        for (View& view : cell.views) {
            view.x_px += left;
            view.y_px += top;
            for (Label& label : view.labels) label.top_left_px += Eigen::Vector2d(left, top);
        }
        cells_.push_back(std::move(cell));
        write(request_->cells[index].caption, left, top + height_px_);
    }

    Drawing take() {
        // Labels refer to masks of their own view, so reallocation must not copy the views.
        std::size_t n_views = 1;
        for (const Drawing& cell : cells_) n_views += cell.views.size();
        drawing_.views.reserve(n_views);
        for (Drawing& cell : cells_)
            for (View& view : cell.views) drawing_.views.push_back(std::move(view));
        drawing_.views.push_back(std::move(captions_));
        return std::move(drawing_);
    }

 private:
    TextBlock set(const std::string& caption) {
        TypeStyle style;
        style.mode = TypeMode::text;
        style.size_px = type_px_;
        style.alignment = TypeAlignment::centre;
        style.max_width_px = 0.94 * width_px_;
        return text_.set(caption, style);
    }

    // Centred below the cell.
    void write(const std::string& caption, int left, int top) {
        const TextBlock type = set(caption);
        Label& label = captions_.labels.emplace_back();
        label.mask = type.mask;
        label.top_left_px = {left + 0.5 * (width_px_ - type.width_px()),
                             top + 0.5 * (caption_px_ - type.height_px())};
        const Colour& ground = drawing_.background.bottom;
        const bool is_dark = drawing_.background.alpha > 0.5 &&
                             0.25 * ground.r + 0.625 * ground.g + 0.125 * ground.b < 0.5;
        constexpr Colour light{0.91, 0.91, 0.91}, dark{0.1, 0.1, 0.1};
        label.colour = is_dark ? light : dark;
        label.name = {"cell", static_cast<int>(captions_.labels.size()), {}};
    }

    const SheetRequest* request_;
    int width_px_, height_px_;
    double type_px_;
    int caption_px_ = 0;
    Drawing drawing_;
    std::vector<Drawing> cells_;
    View captions_;
    TextCache text_{installed_fonts()};
};

PreparedStill prepare_cell(const SheetRequest& sheet, const SheetCell& cell,
                           const StillRequest& still, const Task& task) {
    stop_if_interrupted();
    SceneRequest scene = cell.scene;
    scene.print = still.print;
    Session session = open_session(scene, task);
    check_replaceable({.path = sheet.output, .inputs = files_read_for(session.scene)});
    return prepare_still(std::move(session), still);
}

// For each panel the camera that sees in every cell what that cell's own camera sees: only then can
// the pictures be compared. None for a panel whose camera moves, and none at all if the cells have
// different panels.
std::vector<std::optional<Camera>> common_views(const SheetRequest& request,
                                                const StillRequest& still, const Task& task) {
    std::vector<PanelBox> boxes;
    std::vector<std::string> kinds;
    std::vector<std::vector<Camera>> cameras;
    std::vector<bool> moves;
    for (const SheetCell& cell : request.cells) {
        const PreparedStill of_cell = prepare_cell(request, cell, still, task);
        const std::deque<Panel>& panels = of_cell.picture.stage.panels();
        if (cameras.empty()) {
            cameras.resize(panels.size());
            moves.resize(panels.size());
            for (const Panel& panel : panels) {
                boxes.push_back(panel.box);
                kinds.push_back(panel.spec.kind);
            }
        }
        if (panels.size() != boxes.size()) return {};
        for (std::size_t k = 0; k < panels.size(); ++k) {
            const PanelBox &a = boxes[k], &b = panels[k].box;
            if (panels[k].spec.kind != kinds[k] ||
                a.width_px * b.height_px != b.width_px * a.height_px)
                return {};
            cameras[k].push_back(panels[k].camera);
            moves[k] = moves[k] || panels[k].camera_at;
        }
    }
    std::vector<std::optional<Camera>> views(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k)
        if (!moves[k]) views[k] = common_view(boxes[k], cameras[k]);
    return views;
}

void draw_vector_sheet(const SheetRequest& request, const Task& task) {
    if (has_pixels(request.vectors))
        throw InputError("--sheet: --shading picture is for single figures; leave it out");
    if (request.vectors.text == "latex")
        throw InputError("--sheet: --text latex is for single figures; take font or paths");
    StillRequest still{.output = request.output,
                       .time_s = request.time_s,
                       .print = request.print,
                       .vectors = request.vectors,
                       .when = request.when};
    // A cell has its share of the sheet's width.
    if (still.print.width_mm) *still.print.width_mm /= request.n_columns;
    const OutputPlace place(request.output, Scene{}, ".pdf");
    task.begin("sheet", static_cast<std::int64_t>(request.cells.size()));
    still.views = common_views(request, still, task);
    std::vector<PreparedStill> stills;  // to which the drawings refer
    std::optional<VectorSheet> sheet;
    Record record;
    for (std::size_t k = 0; k < request.cells.size(); ++k) {
        stills.push_back(prepare_cell(request, request.cells[k], still, task));
        Drawing drawing = drawing_of(stills[k]);
        if (!sheet) {
            record = vector_record_of(stills[k]);
            sheet.emplace(request, drawing, record.dpi.value_or(default_dpi));
            record.sheet = fmt::format("{}x{}: ", request.n_columns, request.n_rows);
        }
        record.sheet += (k > 0 ? "; " : "") + request.cells[k].values;
        sheet->put(k, std::move(drawing));
        task.done(static_cast<std::int64_t>(k + 1));
    }
    record_without_context(record);
    const Drawing drawing = sheet->take();
    record.width_px = drawing.width_px;
    record.height_px = drawing.height_px;
    const VectorStill page = vector_still(place.path(), title_of(stills.front().session->scene),
                                          drawing, request.vectors, std::move(record), {});
    write_whole(place.path(), page.bytes);
    task.finish(printable(request.output));
}

}  // namespace

void draw_sheet(const SheetRequest& request, LazyRenderer& renderer, const Task& task) {
    const auto n_places =
        static_cast<std::size_t>(request.n_columns) * static_cast<std::size_t>(request.n_rows);
    if (request.cells.size() > n_places)
        throw InputError(
            fmt::format("--sheet {}x{}: has {} places for {} pictures; give more columns or rows",
                        request.n_columns, request.n_rows, n_places, request.cells.size()));
    watch_for_interrupts();
    if (is_vector_name(request.output)) {
        draw_vector_sheet(request, task);
        return;
    }
    if (suffix_of(request.output) != ".png")
        throw InputError(
            fmt::format("{}: a sheet is a PNG, a PDF or an SVG; name it with -o FILE.png, FILE.pdf "
                        "or FILE.svg",
                        printable(request.output)));
    task.begin("sheet", static_cast<std::int64_t>(request.cells.size()));
    StillRequest still;
    still.time_s = request.time_s;
    still.when = request.when;
    still.views = common_views(request, still, task);
    std::optional<ContactSheet> sheet;
    Record record;
    Image picture;
    for (std::size_t k = 0; k < request.cells.size(); ++k) {
        const SheetCell& cell = request.cells[k];
        const Record of_cell =
            draw_into(prepare_cell(request, cell, still, task), renderer, picture);
        if (!sheet) {
            sheet.emplace(request, picture);
            record = of_cell;
            record.sheet = fmt::format("{}x{}: ", request.n_columns, request.n_rows);
        }
        record.sheet += (k > 0 ? "; " : "") + cell.values;
        sheet->put(k, picture);
        task.done(static_cast<std::int64_t>(k + 1));
    }
    record.width_px = sheet->image().width();
    record.height_px = sheet->image().height();
    record.pixels = pixels_xxh64(sheet->image());
    PngOptions png;
    png.texts[metadata_name] = sealed_text(record);
    write_png(request.output, sheet->image(), png);
    task.finish(printable(request.output));
}

}  // namespace poinsot
