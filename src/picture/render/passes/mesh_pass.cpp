#include "render/passes/mesh_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "error/error.h"
#include "numerics/srgb.h"
#include "render/context/dialect.h"
#include "render/passes/colour.h"
#include "render/to_glm.h"

namespace poinsot {
namespace {

constexpr std::uint64_t kept_mesh_pictures = 120;
constexpr GLsizei n_samples = 4;
constexpr GLenum multisampled = 0x9100;  // GL_TEXTURE_2D_MULTISAMPLE, which OpenGL ES 3.0 lacks

bool has_picture(const MeshGeometry& geometry) {
    return !geometry.picture.rgb.empty() && geometry.places.size() == geometry.positions.size();
}

// A picture as a texture in linear light, with mipmaps.
GlTexture texture_of(const SurfacePicture& picture, const LightFormat& format) {
    std::array<std::uint16_t, 256> light{};
    for (std::size_t level = 0; level < light.size(); ++level)
        light[level] = static_cast<std::uint16_t>(
            std::lround(65535.0 * linear_from_srgb(static_cast<double>(level) / 255.0)));
    // With a fourth component, of which OpenGL ES makes mipmaps.
    std::vector<std::uint16_t> samples;
    samples.reserve(picture.rgb.size() / 3 * 4);
    for (std::size_t k = 0; k < picture.rgb.size(); ++k) {
        samples.push_back(light[picture.rgb[k]]);
        if (k % 3 == 2) samples.push_back(65535);
    }
    GlTexture texture = GlTexture::make();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    const auto upload = [&](GLenum type, const void* pixels) {
        glTexImage2D(GL_TEXTURE_2D, 0, format.internal, picture.width_px, picture.height_px, 0,
                     GL_RGBA, type, pixels);
    };
    if (format.type == GL_UNSIGNED_SHORT) {
        upload(GL_UNSIGNED_SHORT, samples.data());
    } else {
        std::vector<float> numbers;
        numbers.reserve(samples.size());
        for (const std::uint16_t sample : samples)
            numbers.push_back(static_cast<float>(sample) / 65535.0f);
        upload(GL_FLOAT, numbers.data());
    }
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

void make_texture(const GlTexture& texture, GLint format, GLenum components, GLenum type,
                  int width_px, int height_px) {
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, format, width_px, height_px, 0, components, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

bool shows(const Mesh& mesh) {
    return mesh.geometry != nullptr && !mesh.geometry->positions.empty() && mesh.opacity > 0.0;
}

Eigen::AlignedBox3d box_of(const MeshGeometry& geometry) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& p : geometry.positions) box.extend(p.cast<double>());
    return box;
}

// A bounding sphere of the placed mesh.
struct Ball {
    Eigen::Vector3d centre;
    double radius;
};

Ball ball_of(const Mesh& mesh, const Eigen::AlignedBox3d& box) {
    const double scale = mesh.placement.linear().colwise().norm().maxCoeff();
    return {mesh.placement * box.center().eval(), scale * 0.5 * box.diagonal().norm()};
}

// An ellipsoid with nearly the same shadow as the placed mesh.
Ellipsoid ellipsoid_of(const Mesh& mesh, const Eigen::AlignedBox3d& box) {
    Ellipsoid ellipsoid;
    ellipsoid.centre = mesh.placement * box.center().eval();
    ellipsoid.half_axes = mesh.placement.linear() * (0.5 * box.sizes()).eval().asDiagonal();
    return ellipsoid;
}

// The pixels that the placed mesh's box may touch; the whole view if it extends behind the eye.
PixelBox pixels_of(const Projection& p, const Mesh& mesh, const Eigen::AlignedBox3d& box) {
    PixelBox pixels;
    for (int k = 0; k < 8; ++k) {
        const Eigen::Vector3d corner =
            mesh.placement * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)).eval();
        if (p.perspective && p.depth(corner) <= p.near_depth) return box_of(p);
        pixels.add(p.place(corner), 1.0);
    }
    return pixels.within(box_of(p));
}

}  // namespace

MeshPass::Drawer::Drawer(const std::vector<std::string>& defines)
    : program("mesh.vert", "mesh.frag", defines),
      placement(program.at("placement")),
      normal_map(program.at("normal_map")),
      view(program.at("view")),
      projection(program.at("projection")),
      look(program.at("look")) {}

MeshPass::MeshPass(LightBits light)
    : light_(light_format(light)), plain_({}), over_("layer.frag", 1) {}

void MeshPass::begin_picture() {
    ++picture_number_;
    std::erase_if(uploads_, [this](const auto& entry) {
        return entry.second.last_picture + kept_mesh_pictures < picture_number_;
    });
}

MeshPass::Uploaded& MeshPass::uploaded(const MeshGeometry& geometry) {
    Uploaded& upload = uploads_[geometry.id];
    upload.last_picture = picture_number_;
    if (upload.buffer) return upload;
    std::vector<glm::vec3> vertices;
    vertices.reserve(2 * geometry.positions.size());
    for (std::size_t k = 0; k < geometry.positions.size(); ++k) {
        vertices.push_back(to_glm(geometry.positions[k]));
        vertices.push_back(k < geometry.normals.size() ? to_glm(geometry.normals[k])
                                                       : glm::vec3(0.0f, 0.0f, 1.0f));
    }
    upload.n_vertices = static_cast<GLsizei>(geometry.positions.size() / 3 * 3);
    upload.box = box_of(geometry);
    upload.buffer = GlBuffer::make();
    upload.vertex_array = GlVertexArray::make();
    glBindVertexArray(upload.vertex_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, upload.buffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(glm::vec3)),
                 vertices.data(), GL_STATIC_DRAW);
    constexpr GLsizei stride = 2 * sizeof(glm::vec3);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
    glEnableVertexAttribArray(1);
    // OpenGL takes an offset into the buffer as a pointer.
    const void* after_position =
        reinterpret_cast<const void*>(sizeof(glm::vec3));  // NOLINT(performance-no-int-to-ptr)
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, after_position);
    if (!has_picture(geometry)) return upload;
    upload.places = GlBuffer::make();
    glBindBuffer(GL_ARRAY_BUFFER, upload.places.id());
    std::vector<glm::vec2> places;
    for (const Eigen::Vector2f& place : geometry.places) places.push_back(to_glm(place));
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(glm::vec2)),
                 places.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    upload.picture = texture_of(geometry.picture, light_);
    return upload;
}

void MeshPass::resize(int width_px, int height_px) {
    if (width_px <= width_px_ && height_px <= height_px_) return;
    // Rounded up, so that a rotating body does not need a slightly larger layer each time.
    const auto rounded = [](int px) { return (px + 127) / 128 * 128; };
    width_px_ = std::max(width_px_, rounded(width_px));
    height_px_ = std::max(height_px_, rounded(height_px));
    samples_ = GlTexture::make();
    depth_ = GlTexture::make();
    sampled_ = GlFramebuffer::make();
    if constexpr (dialect == Dialect::desktop)
        make_multisampled();
    else
        make_side_by_side();
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw EnvironmentError("OpenGL gives no layer of four samples a pixel for meshes");
}

void MeshPass::make_side_by_side() {
    make_texture(samples_, light_.internal, GL_RGBA, light_.type, 2 * width_px_, 2 * height_px_);
    make_texture(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 2 * width_px_,
                 2 * height_px_);
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, samples_.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
}

#ifdef GL_TEXTURE_2D_MULTISAMPLE
void MeshPass::make_multisampled() {
    resolved_ = GlTexture::make();
    single_ = GlFramebuffer::make();
    glBindTexture(multisampled, samples_.id());
    glTexImage2DMultisample(multisampled, n_samples, GL_RGBA16, width_px_, height_px_, GL_TRUE);
    glBindTexture(multisampled, depth_.id());
    glTexImage2DMultisample(multisampled, n_samples, GL_DEPTH_COMPONENT32F, width_px_, height_px_,
                            GL_TRUE);
    make_texture(resolved_, light_.internal, GL_RGBA, light_.type, width_px_, height_px_);
    glBindFramebuffer(GL_FRAMEBUFFER, single_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, resolved_.id(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, multisampled, samples_.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, multisampled, depth_.id(), 0);
}
#else
void MeshPass::make_multisampled() {}
#endif

void MeshPass::prepare(ViewScene& scene) {
    const Projection& p = scene.projection;
    MeshLayer layer;
    PixelBox box;
    double nearest = 1e300, farthest = -1e300, transmitted = 1.0;
    for (const Mesh& mesh : scene.view->meshes) {
        if (!shows(mesh)) continue;
        const Uploaded& upload = uploaded(*mesh.geometry);
        const PixelBox part = pixels_of(p, mesh, upload.box);
        if (part.empty()) continue;
        box.add({part.left, part.top});
        box.add({part.right, part.bottom});
        const Ball ball = ball_of(mesh, upload.box);
        nearest = std::min(nearest, p.depth(ball.centre) - ball.radius);
        farthest = std::max(farthest, p.depth(ball.centre) + ball.radius);
        transmitted = std::min(transmitted, 1.0 - mesh.opacity);
        if (mesh.casts_shadow && !scene.view->planes.empty())
            scene.casters.emplace_back(ellipsoid_of(mesh, upload.box), p);
    }
    if (box.empty()) return;
    layer.left = static_cast<int>(std::floor(box.left));
    layer.top = static_cast<int>(std::floor(box.top));
    layer.width = static_cast<int>(std::ceil(box.right)) - layer.left;
    layer.height = static_cast<int>(std::ceil(box.bottom)) - layer.top;
    layer.opacity = 1.0 - transmitted;

    if (p.perspective) nearest = std::max(nearest, p.near_depth);
    const double margin = 1e-3 * (farthest - nearest) + 1e-9;
    layer.nearest = nearest - margin;
    layer.farthest = farthest + margin;
    if (p.perspective) layer.nearest = std::max(layer.nearest, 0.5 * p.near_depth);
    scene.mesh_layer = layer;
}

void MeshPass::draw_layer(const ViewScene& scene) {
    const MeshLayer& layer = scene.mesh_layer;
    if (layer.width == 0) return;
    resize(layer.width, layer.height);
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_.id());
    glEnable(GL_SCISSOR_TEST);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    const auto draw_at = [&](int left, int top, const glm::dvec2& shift_px) {
        glViewport(left, top, layer.width, layer.height);
        glScissor(left, top, layer.width, layer.height);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_meshes(scene, layer.projection(scene.projection, shift_px));
    };
    if constexpr (dialect == Dialect::desktop) {
        draw_at(0, 0, {0.0, 0.0});
    } else {
        // Where the middle of a pixel is displaced to: the samples of Mesa's software renderer.
        const std::array<glm::dvec2, n_samples> samples{{{0.375 - 0.5, 0.125 - 0.5},
                                                         {0.875 - 0.5, 0.375 - 0.5},
                                                         {0.125 - 0.5, 0.625 - 0.5},
                                                         {0.625 - 0.5, 0.875 - 0.5}}};
        for (int k = 0; k < n_samples; ++k)
            draw_at((k & 1) * width_px_, (k >> 1) * height_px_,
                    samples[static_cast<std::size_t>(k)]);
    }
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    if constexpr (dialect == Dialect::es) return;  // shaders/layer.frag takes the mean
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single_.id());
    glBlitFramebuffer(0, 0, layer.width, layer.height, 0, 0, layer.width, layer.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void MeshPass::draw_meshes(const ViewScene& scene, const glm::mat4& projection) {
    for (const bool with_picture : {false, true}) {
        const auto is_drawn = [with_picture](const Mesh& mesh) {
            return shows(mesh) && has_picture(*mesh.geometry) == with_picture;
        };
        const auto& meshes = scene.view->meshes;
        if (std::none_of(meshes.begin(), meshes.end(), is_drawn)) continue;
        if (with_picture && !pictured_) pictured_.emplace(std::vector<std::string>{"PICTURE"});
        const Drawer& drawer = with_picture ? *pictured_ : plain_;
        drawer.program.use();
        set_uniform(drawer.view, glm::mat4(scene.camera_from_view()));
        set_uniform(drawer.projection, projection);
        for (const Mesh& mesh : meshes)
            if (is_drawn(mesh)) draw_mesh(drawer, scene, mesh);
    }
}

void MeshPass::draw_mesh(const Drawer& drawer, const ViewScene& scene, const Mesh& mesh) {
    const Uploaded& upload = uploaded(*mesh.geometry);
    set_uniform(drawer.placement, glm::mat4(to_glm(mesh.placement.matrix())));
    set_uniform(drawer.normal_map,
                glm::mat3(to_glm(mesh.placement.linear().inverse().transpose().eval())));
    Constants look;
    const Projection& p = scene.projection;
    look.add(p.perspective ? p.eye : Eigen::Vector3d(-p.forward), p.perspective ? 1.0 : 0.0);
    scene.add_light(look);
    look.add(linear_from_srgb(mesh.colour, 1.0));
    set_uniform(drawer.look, look.values());
    if (upload.picture) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, upload.picture.id());
    }
    glBindVertexArray(upload.vertex_array.id());
    glDrawArrays(GL_TRIANGLES, 0, upload.n_vertices);
}

void MeshPass::draw(const ViewScene& scene) const {
    const MeshLayer& layer = scene.mesh_layer;
    if (layer.width == 0) return;
    glActiveTexture(GL_TEXTURE1);
    if constexpr (dialect == Dialect::desktop) {
        glBindTexture(multisampled, depth_.id());
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, resolved_.id());
    } else {
        glBindTexture(GL_TEXTURE_2D, depth_.id());
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, samples_.id());
    }
    Constants constants;
    constants.add(layer.left, layer.top, layer.opacity, 0.0);
    PixelBox box;
    box.add({static_cast<double>(layer.left), static_cast<double>(layer.top)});
    box.add({static_cast<double>(layer.left + layer.width),
             static_cast<double>(layer.top + layer.height)});
    over_.draw(polygon_of(box), constants, *scene.drawing);
}

void MeshPass::mark(const ViewScene& scene, TileMask& marks) const {
    const MeshLayer& layer = scene.mesh_layer;
    if (layer.width == 0) return;
    PixelBox box;
    box.add({static_cast<double>(layer.left), static_cast<double>(layer.top)});
    box.add({static_cast<double>(layer.left + layer.width),
             static_cast<double>(layer.top + layer.height)});
    marks.mark(box);
}

}  // namespace poinsot
