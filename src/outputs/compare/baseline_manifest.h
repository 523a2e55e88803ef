// The manifest of a folder of baseline pictures, with the origin of each and the reason for its
// approval: TOML, one line per picture, sorted, so that one changed picture changes one line.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace poinsot {

struct Baseline {
    std::string pixels;  // hash of size and pixels; see pixels_sha256. Of films and vector
                         // figures, SHA-256 of the file
    std::string scene;   // SHA-256 of the complete scene
    std::string
        renderer;  // GL_RENDERER, or "vectors"; foreign_renderer for a picture by another program
    std::string mesa;     // version
    std::string version;  // of poinsot
    std::string why;      // the reason given

    bool operator==(const Baseline&) const = default;
};

// The renderer of a picture that has no record; its scene, mesa and version are empty.
inline constexpr std::string_view foreign_renderer = "another program";
inline bool is_foreign(const Baseline& baseline) { return baseline.renderer == foreign_renderer; }

using BaselineManifest = std::map<std::string, Baseline>;

inline constexpr const char* manifest_name = "manifest.toml";

// Returns the file's text.
std::string to_text(const BaselineManifest& manifest);

// Parses such a text: the lines that to_text writes, comments and empty lines. `name` is used in
// messages. Throws InputError `NAME:LINE: …`.
BaselineManifest parse_manifest(std::string_view text, const std::string& name);

// Reads the manifest of a folder of baselines; empty if there is none. Throws InputError,
// EnvironmentError.
BaselineManifest read_manifest(const std::filesystem::path& folder);

// Writes the manifest atomically. Throws EnvironmentError.
void write_manifest(const std::filesystem::path& folder, const BaselineManifest& manifest);

// The next manifest, a temporary file that exists while pictures are replaced: after an interrupted
// approval it contains the remaining changes. Throw like the functions above.
std::optional<BaselineManifest> read_next_manifest(const std::filesystem::path& folder);
void write_next_manifest(const std::filesystem::path& folder, const BaselineManifest& manifest);
void remove_next_manifest(const std::filesystem::path& folder);

// Removes the temporary files of a run that was killed while it wrote a manifest. Precondition: no
// process writes them.
void remove_half_manifests(const std::filesystem::path& folder);

}  // namespace poinsot
