// [object] marked_face and [[object.pictures]]: marks and pictures on flat faces of the body.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bodies/flat_face.h"
#include "bodies/solid_meshes.h"
#include "image/png.h"
#include "scene/body_faces.h"
#include "scene/draft_checks.h"

namespace poinsot {

namespace {

// The largest picture of a face: both the program and the renderer hold it in memory.
constexpr int most_picture_px = 4096;  // a side

// Refuses a face where the body is not flat. Bodies of moments and tensors are drawn as boxes.
void check_face(const Scene& scene, const std::string& key, const std::string& name) {
    const BodySpec& body = scene.body;
    const bool is_flat = [&] {
        if (scene.surfaces.empty() && body.given != BodySpec::Given::solid)
            return body.given != BodySpec::Given::masses;
        std::vector<TriangleMesh> meshes;
        for (const BodySurface& surface : scene.surfaces) meshes.push_back(surface.mesh);
        if (meshes.empty()) meshes.push_back(solid_mesh(body.shape, body.size_m));
        const BodyFace face = body_face_named(name);
        return has_flat_face(joined(meshes), body.inertia.body_from_principal(), face.axis,
                             face.sign);
    }();
    if (!is_flat)
        refuse(scene, key,
               fmt::format("{} = \"{}\": the body has no flat face there; choose a face that is "
                           "flat, as a box's are, or remove it",
                           key, name));
}

// Throws InputError with the reason for a picture that cannot be used.
Image picture_in(const FileBytes& file, const std::string& shown) {
    if (file.bytes.size() > most_face_picture_bytes)
        throw InputError(fmt::format("{} is larger than {} MiB; make it smaller", shown,
                                     most_face_picture_bytes >> 20));
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(file.bytes.data()),
                          file.bytes.size());
    const auto read = [&](auto call) {
        try {
            return call();
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}; name a whole PNG picture", error.what()));
        }
    };
    const PngInfo info = read([&] { return decode_png_info(bytes, file.name); });
    if (info.width_px > most_picture_px || info.height_px > most_picture_px)
        throw InputError(fmt::format(
            "{} is {}×{} pixels; a picture on a face has at most {} per side, so make it smaller",
            shown, info.width_px, info.height_px, most_picture_px));
    return read([&] { return decode_png(bytes, file.name); });
}

void complete_picture(SceneDraft& draft, std::size_t number) {
    Scene& scene = draft.scene;
    FacePictureSpec& picture = scene.object.pictures[number];
    const std::string item = fmt::format("object.pictures[{}]", number);
    if (picture.face.empty())
        refuse(scene, item,
               fmt::format("{}.face is missing; say where the picture is, as in face = \"+e3\"",
                           item));
    if (picture.file.empty())
        refuse(scene, draft.has(item + ".file") ? item + ".file" : item,
               fmt::format("{}.file is missing; name a PNG in the scene's folder", item));
    check_face(scene, item + ".face", picture.face);
    for (std::size_t k = 0; k < number; ++k)
        if (scene.object.pictures[k].face == picture.face)
            refuse(scene, item + ".face",
                   fmt::format("{}.face = \"{}\" has object.pictures[{}] already; choose another",
                               item, picture.face, k));
    if (!picture.up.empty() &&
        body_face_named(picture.up).axis == body_face_named(picture.face).axis)
        refuse(scene, item + ".up",
               fmt::format("{}.up = \"{}\" points through the face {}; give a direction along it",
                           item, picture.up, picture.face));
    const FileBytes file =
        file_named(draft, NamedFile::Kind::picture, item + ".file", picture.file);
    picture.image = at_file_key(scene, item + ".file",
                                [&] { return picture_in(file, printable(picture.file)); });
}

}  // namespace

std::span<const std::string_view> body_faces() {
    static constexpr std::array<std::string_view, 6> faces{"+e1", "-e1", "+e2",
                                                           "-e2", "+e3", "-e3"};
    return faces;
}

BodyFace body_face_named(std::string_view name) {
    const auto faces = body_faces();
    const auto number = std::find(faces.begin(), faces.end(), name) - faces.begin();
    return {static_cast<int>(number / 2), number % 2 == 0 ? 1.0 : -1.0};
}

void complete_faces(SceneDraft& draft) {
    const Scene& scene = draft.scene;
    const std::string& marked = scene.object.marked_face;
    if (!marked.empty()) check_face(scene, "object.marked_face", marked);
    for (std::size_t i = 0; i < scene.object.pictures.size(); ++i) {
        complete_picture(draft, i);
        if (scene.object.pictures[i].face == marked)
            refuse(scene, fmt::format("object.pictures[{}].face", i),
                   fmt::format("object.pictures[{}].face = \"{}\" is the marked face, which it "
                               "would cover; choose another, or remove object.marked_face",
                               i, marked));
    }
}

}  // namespace poinsot
