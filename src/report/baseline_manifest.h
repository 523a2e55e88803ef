// The list beside baseline pictures that says what each was made of and why it was taken: TOML, one
// line a picture, sorted, so that a change of one is a change of one line.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace poinsot {

struct Baseline {
    std::string pixels;    // hash of size and pixels; see pixel_hash
    std::string scene;     // SHA-256 of the scene as resolved
    std::string renderer;  // GL_RENDERER
    std::string mesa;      // version
    std::string version;   // of poinsot
    std::string why;       // the reason given

    bool operator==(const Baseline&) const = default;
};

using BaselineManifest = std::map<std::string, Baseline>;

inline constexpr const char* manifest_name = "manifest.toml";

// The file's text.
std::string to_text(const BaselineManifest& manifest);

// Reads such a text: the lines that to_text writes, comments and empty lines. `name` stands in
// messages. Throws InputError `NAME:LINE: …`.
BaselineManifest parse_manifest(std::string_view text, const std::string& name);

// The manifest of a folder of baselines; empty if there is none. Throws InputError,
// EnvironmentError.
BaselineManifest read_manifest(const std::filesystem::path& folder);

// Written aside and renamed. Throws EnvironmentError.
void write_manifest(const std::filesystem::path& folder, const BaselineManifest& manifest);

// The manifest as it is to become, which lies beside it while pictures are replaced: what an
// approval that was interrupted has left to do. Throws as the above.
std::optional<BaselineManifest> read_next_manifest(const std::filesystem::path& folder);
void write_next_manifest(const std::filesystem::path& folder, const BaselineManifest& manifest);
void remove_next_manifest(const std::filesystem::path& folder);

// What a run killed while it wrote one of the two has left. Precondition: nobody writes them.
void remove_half_manifests(const std::filesystem::path& folder);

}  // namespace poinsot
