#include "production/records/record.h"

#include <fmt/format.h>

#include <map>

#include "encoding/frame_sink.h"
#include "error/error.h"
#include "production/records/record_fields.h"
#include "scene/toml/toml_document.h"
#include "scene/write_scene.h"
#include "system/sha256.h"
#include "text/numbers.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// The method of the motion, with its step or tolerance.
std::string method_in_words(const Motion& motion) {
    const MethodChoice& choice = motion.problem().method;
    std::string text = choice.name;
    if (choice.order) text += fmt::format(", order {}", *choice.order);
    if (const IntegratedRotation* integrated = motion.integrated()) {
        if (integrated->method().takes_step)
            text += fmt::format(", step {} s", integrated->step_s());
        if (choice.tolerance) text += fmt::format(", tolerance {}", *choice.tolerance);
    }
    return text;
}

// The lines before the scene, by their keys.
using Fields = std::map<std::string, std::string, std::less<>>;

// The key of the hash line.
constexpr std::string_view seal_key = "record-sha256: ";

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw InputError(
        fmt::format("{}: its record {}; the file was not written by poinsot, or was changed",
                    printable(name), what));
}

}  // namespace

std::string mesh_hash_of(const Scene& scene) {
    const bool has_mesh = !scene.body.mesh.empty() || !scene.object.mesh.empty();
    if (!has_mesh && scene.object.pictures.empty() && !scene.measured.given()) return "";
    Sha256 hash;
    const auto add = [&hash](const auto* items, std::size_t n_items) {
        hash.add({reinterpret_cast<const std::uint8_t*>(items), n_items * sizeof *items});
    };
    for (const FacePictureSpec& picture : scene.object.pictures) {
        const int size[] = {picture.image.width(), picture.image.height()};
        add(size, 2);
        hash.add(picture.image.bytes());
    }
    for (const MeasuredRow& row : scene.measured.motion.rows) {
        add(&row.time_s, 1);
        add(row.omega_body.data(), 3);
        add(row.space_from_body.coeffs().data(), 4);
    }
    if (!has_mesh) return hash.finish();
    for (const BodySurface& surface : scene.surfaces) {
        for (const Eigen::Vector3d& vertex : surface.mesh.vertices) add(vertex.data(), 3);
        for (const auto& triangle : surface.mesh.triangles) add(triangle.data(), triangle.size());
    }
    add(scene.body.inertia.moments_kg_m2().data(), 3);
    const Eigen::Matrix3d axes = scene.body.inertia.body_from_principal();
    add(axes.data(), 9);
    return hash.finish();
}

void record_without_context(Record& record) {
    record.portable = true;
    record.renderer = vectors_renderer;
    record.mesa = "none";
}

std::string scene_hash_of(const Scene& scene) {
    return sha256_of(to_toml(scene) + mesh_hash_of(scene));
}

Record record_of(const Session& session, const Stage& stage, const std::string& bounds) {
    Record record;
    record.version = POINSOT_VERSION;
    record.scene_name = session.scene.name;
    record.scene_toml = to_toml(session.scene);
    record.as_read = session.as_read;
    // Rejected before anything is drawn: every picture must contain its complete record.
    if (record.scene_toml.size() > most_scene_bytes)
        throw InputError(fmt::format(
            "{}: written out in full the scene has {} bytes, and a picture's record holds at most "
            "{}; shorten the scene",
            printable(session.scene.file.string()), record.scene_toml.size(), most_scene_bytes));
    record.mesh_hash = mesh_hash_of(session.scene);
    record.scene_hash = sha256_of(record.scene_toml + record.mesh_hash);
    record.method = method_in_words(session.motion);
    record.bounds = bounds;
    record.fonts = fonts_in_words(stage);
    record.width_px = session.scene.film.width_px;
    record.height_px = session.scene.film.height_px;
    return record;
}

std::string to_text(const Record& record) {
    std::string text = fmt::format("poinsot {}\n", record.version);
    const auto add = [&text](std::string_view key, std::string_view value) {
        // A line break in a name would start another field.
        text += fmt::format("{}: {}\n", key, printable(value, any_length));
    };
    for (const RecordField& field : record_fields())
        if (const auto said = field.text_of(record)) add(field.key, *said);
    return text + "\n" + record.scene_toml;
}

std::string sealed_text(const Record& record) {
    std::string text = to_text(record);
    const std::string seal = fmt::format("{}{}\n", seal_key, sha256_of(text));
    return text.insert(text.find("\n\n") + 1, seal);
}

std::string sealed_metadata(const std::string& metadata, const EncodedMetadata& contents) {
    Record record = parse_record(metadata, "the unfinished output");
    if (record.frames && contents.n_frames > 0) {
        const auto run = *record.frames;
        record.frames->second = run.first + contents.n_frames - 1;
        if (record.frames->second != run.second) record.run = run;
    }
    record.frame = contents.frame;
    record.pixels = contents.pixels;
    record.packets = contents.packets;
    record.file = contents.file;
    return sealed_text(record);
}

namespace {

// Checks frame numbers, which are used in arithmetic: they are not negative, and those of a run
// start where the run starts.
void check_frames(const Record& record, const std::string& name) {
    constexpr std::int64_t most = std::int64_t{1} << 53;
    const auto is_span = [](const auto& span) {
        return !span || (0 <= span->first && span->first <= span->second && span->second < most);
    };
    bool right = is_span(record.frames) && is_span(record.run);
    if (right && record.frames && record.run)
        right =
            record.run->first == record.frames->first && record.frames->second < record.run->second;
    if (right && record.frames && record.frame)
        right = record.frames->first <= *record.frame && *record.frame <= record.frames->second;
    if (right && record.film_frames) {
        const std::int64_t last = record.frames ? record.frames->second : record.frame.value_or(-1);
        right = 0 <= last && last < *record.film_frames && *record.film_frames < most;
    }
    const bool frame_is_alone = record.frame && !record.frames && !record.film_frames;
    if (!right || (record.run && !record.frames) || frame_is_alone)
        refuse(name, "has impossible frame numbers");
}

}  // namespace

Record parse_record(std::string_view text, const std::string& name) {
    constexpr std::string_view opening = "poinsot ";
    if (!text.starts_with(opening)) refuse(name, "does not begin with \"poinsot\"");
    const std::size_t blank = text.find("\n\n");
    if (blank == std::string_view::npos) refuse(name, "has no scene");

    Record record;
    record.text = text;
    // The hash is that of the text around its own line.
    if (const std::size_t seal = text.find(fmt::format("\n{}", seal_key)); seal < blank) {
        const std::size_t end = text.find('\n', seal + 1);
        Sha256 hash;
        hash.add(text.substr(0, seal + 1));
        hash.add(text.substr(end + 1));
        const std::size_t digits = seal + 1 + seal_key.size();
        record.sealed = hash.finish() == text.substr(digits, end - digits);
        if (!record.sealed) refuse(name, "does not match its own hash");
    }

    std::string_view head = text.substr(opening.size(), blank + 1 - opening.size());
    record.version = head.substr(0, head.find('\n'));
    Fields fields;
    while (!(head = head.substr(head.find('\n') + 1)).empty()) {
        const std::string_view line = head.substr(0, head.find('\n'));
        const std::size_t colon = line.find(": ");
        if (colon == std::string_view::npos)
            refuse(name, fmt::format("has the line \"{}\"", printable(line)));
        fields.emplace(line.substr(0, colon), line.substr(colon + 2));
    }

    record.scene_toml = text.substr(blank + 2);
    for (const RecordField& field : record_fields()) {
        const auto found = fields.find(field.key);
        if (found == fields.end()) {
            if (field.is_required) refuse(name, fmt::format("has no \"{}\"", field.key));
        } else if (!field.read(found->second, record)) {
            refuse(name, fmt::format("says \"{}\"", printable(found->second)));
        }
    }
    if (record.scene_hash != sha256_of(record.scene_toml + record.mesh_hash))
        refuse(name, "has a scene that does not match its hash");
    if (record.time_s.has_value() == record.frames.has_value())
        refuse(name, "must name either an instant or frames");
    check_frames(record, name);
    return record;
}

}  // namespace poinsot
