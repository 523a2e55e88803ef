#include "production/session/resolve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "drawing/style/picture_quality.h"
#include "encoding/quality.h"
#include "production/records/record.h"
#include "production/session/picture_setting.h"
#include "scene/parse_scene.h"
#include "scene/write_scene.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

const std::string looping =
    "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [1.5, 0.3, 0.75]\n"
    "[film]\nloop = \"5/3\"\nsize = [640, 360]\n";

// The values of as_read, each as an override of a scene.
std::vector<Override> overrides_as_read(const std::string& as_read) {
    std::vector<Override> overrides;
    for (std::size_t from = 0; from < as_read.size();) {
        const std::size_t end = std::min(as_read.find("; ", from), as_read.size());
        std::string value = as_read.substr(from, end - from);
        value.erase(value.find(" = "), 1);
        overrides.push_back(override_of(value.erase(value.find("= ") + 1, 1)));
        from = end + 2;
    }
    return overrides;
}

SessionRequest of_width_mm(double width_mm) {
    SessionRequest request{installed_fonts()};
    request.print.width_mm = width_mm;
    return request;
}

TEST(Resolve, LeavesTheSceneThatWasReadAlone) {
    const Scene read = parse_scene(looping, "a.toml");
    const std::string before = to_toml(read);
    const ResolvedScene resolved = resolve(read, of_width_mm(85.0));
    EXPECT_EQ(to_toml(read), before);
    EXPECT_TRUE(read.notes.empty());
    ASSERT_TRUE(resolved.loop.has_value());
    EXPECT_NE(resolved.scene.start.omega_rad_s, read.start.omega_rad_s);
    EXPECT_EQ(resolved.scene.film.width_px, 1004);  // 85 mm at 300 dpi
    ASSERT_EQ(resolved.notes.size(), 1u);
    EXPECT_NE(resolved.notes[0].find("so that the herpolhode closes"), std::string::npos);
}

TEST(Resolve, SaysEveryValueThatItReplaced) {
    const std::string with_length = looping +
                                    "length_s = 6.0\nspeed = 2.0\n"
                                    "[[keyframes]]\nat_s = 3.0\nspeed = 1.0\n";
    const Scene read = parse_scene(with_length, "a.toml");
    const ResolvedScene resolved = resolve(read, of_width_mm(85.0));
    const std::vector<Override> before = overrides_as_read(resolved.as_read);
    EXPECT_EQ(before.size(), 4u) << resolved.as_read;
    EXPECT_NE(to_toml(resolved.scene), to_toml(read));
    const Scene again = parse_scene(to_toml(resolved.scene), "a.toml", before);
    EXPECT_EQ(to_toml(again), to_toml(read));
}

TEST(Resolve, ChangesNothingASecondTime) {
    const SessionRequest request{.fonts = installed_fonts()};
    const ResolvedScene once = resolve(parse_scene(looping, "a.toml"), request);
    const Scene drawn = parse_scene(to_toml(once.scene), "a.toml");
    const ResolvedScene twice = resolve(drawn, request);
    EXPECT_EQ(twice.as_read, "");
    EXPECT_EQ(to_toml(twice.scene), to_toml(once.scene));
    const std::string without = looping.substr(0, looping.find("[film]"));
    const ResolvedScene plain = resolve(parse_scene(without, "a.toml"), request);
    EXPECT_EQ(plain.as_read, "");
}

TEST(Resolve, RecordsSayBoth) {
    const Session session = session_of(parse_scene(looping, "a.toml"), {installed_fonts()});
    const Stage stage = stage_of(session, {}, setting_of(session.scene));
    Record record = record_of(session, stage, "within 1 px");
    record_without_context(record);
    record.time_s = 0.0;
    const std::string text = to_text(record);
    EXPECT_NE(text.find("\nscene-as-read: start.omega_rad_s = [1.5, 0.3, 0.75]; "
                        "film.duration_s not given\n"),
              std::string::npos)
        << text;
    const Record again = parse_record(text, "a.png");
    EXPECT_EQ(again.as_read, session.as_read);
    EXPECT_EQ(again.scene_toml, to_toml(session.scene));
}

TEST(Quality, NamesAreThoseOfPicturesAndOfEncoders) {
    std::vector<std::string_view> of_pictures, of_encoders;
    for (const PictureQuality& quality : picture_qualities()) of_pictures.push_back(quality.name);
    for (const Quality& quality : qualities()) of_encoders.push_back(quality.name);
    EXPECT_EQ(of_pictures, of_encoders);
}

// Stepping this scene would take hours, which is refused after the names.
TEST(Resolve, ChecksNamesBeforeItSteps) {
    const auto refusal = [](const std::string& more, const std::string& torque = "none") {
        const std::string text =
            "title = \"A title\"\n" + more +
            "\n[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [1.0, 2.0, 3.0]\n"
            "[torque]\nkind = \"" +
            torque + "\"\n[motion]\nmethod = \"rk4\"\nstep_s = 1e-9\n[film]\nduration_s = 100.0\n";
        try {
            resolve(parse_scene(text, "a.toml"), {.fonts = installed_fonts()});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("not refused");
    };
    EXPECT_NE(refusal("").find("stepping by rk4"), std::string::npos) << refusal("");
    for (const auto& [more, message] : std::vector<std::pair<std::string, std::string>>{
             {"show = [\"elipsoid\"]", "a.toml:2:1: unknown element \"elipsoid\""},
             {"unlabelled = [\"clokc\"]", "a.toml:2:1: no element shown is called \"clokc\""},
             {"unlabelled = [\"caption\"]", "a.toml:2:1: no element shown is called \"caption\""},
             {"show = [\"ellipsoid\"]\nunlabelled = [\"polhode\"]",
              "a.toml:3:1: no element shown is called \"polhode\""},
             {"[[panels]]\nkind = \"spce\"", "a.toml:3:1: unknown panel \"spce\""},
             {"[[panels]]\nkind = \"top\"", "panel \"top\" needs a heavy symmetric top"},
             {"[[panels]]\nkind = \"plot\"\nquantity = \"omga\"",
              "a.toml:4:1: unknown quantity \"omga\""}}) {
        EXPECT_NE(refusal(more).find(message), std::string::npos) << more << ": " << refusal(more);
    }
    const std::string pushed = refusal("[[panels]]\nkind = \"space\"",
                                       "constant_body\"\ntorque_body_N_m = [0.1, 0.0, 0.0] #");
    EXPECT_NE(pushed.find("panel \"space\" needs a "), std::string::npos) << pushed;
    // Names of what is shown are taken.
    EXPECT_NE(refusal("unlabelled = [\"polhode\", \"title\", \"space\"]").find("stepping by rk4"),
              std::string::npos);
    // Numbers can be had of a scene that no picture shows.
    const std::string undrawn =
        "show = [\"elipsoid\"]\n" + looping + "[motion]\nmethod = \"rk4\"\n";
    EXPECT_NO_THROW(resolve(parse_scene(undrawn, "a.toml"), {.draws = false}));
}

}  // namespace
}  // namespace poinsot
