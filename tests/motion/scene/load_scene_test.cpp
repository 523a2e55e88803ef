// Scenes are read with exact numbers and with overrides; an error gives a message of one line with
// its place, cause and remedy.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "scene/toml/toml_document.h"
#include "scene_text.h"
#include "text/random_decimals.h"

namespace poinsot {
namespace {

TEST(BadScene, UnknownKeyGetsTheNearestOne) {
    EXPECT_EQ(refusal("# a\n\n\ntitel = \"x\"\n" + a_scene),
              "scenes/a.toml:4:1: unknown key \"titel\"; did you mean \"title\"?");
    EXPECT_EQ(refusal("[body]\nmoment_kg_m2 = [3, 2, 1]\n"),
              "scenes/a.toml:2:1: unknown key \"moment_kg_m2\" in [body]; did you mean "
              "\"moments_kg_m2\"?");
}

TEST(BadScene, KeyWithoutItsUnitIsRecognised) {
    EXPECT_EQ(refusal("[start]\nomega = [1, 2, 3]\n"),
              "scenes/a.toml:2:1: unknown key \"omega\" in [start]; did you mean \"omega_rad_s\"?");
    EXPECT_EQ(refusal("[film]\nduration_min = 3\n"),
              "scenes/a.toml:2:1: unknown key \"duration_min\" in [film]; did you mean "
              "\"duration_s\"?");
}

TEST(BadScene, KeyOfAnotherTableIsPointedThere) {
    EXPECT_EQ(refusal("omega_rad_s = [1, 2, 3]\n"),
              "scenes/a.toml:1:1: unknown key \"omega_rad_s\"; \"omega_rad_s\" belongs in [start]");
    EXPECT_EQ(refusal("[film]\ncaption = \"x\"\n"),
              "scenes/a.toml:2:1: unknown key \"caption\" in [film]; \"caption\" stands above the "
              "first [table]");
}

TEST(BadScene, UnknownKeyWithoutANearOneGetsTheList) {
    EXPECT_EQ(refusal(a_scene + "\n[grid]\nqwertyuiop = 1\n"),
              "scenes/a.toml:8:1: unknown key \"qwertyuiop\" in [grid]; [grid] has: columns, rows");
}

TEST(BadScene, UnknownTableGetsTheNearestOne) {
    EXPECT_EQ(refusal("[boddy]\nmoments_kg_m2 = [3, 2, 1]\n"),
              "scenes/a.toml:1:2: unknown table \"boddy\"; did you mean \"body\"?");
}

TEST(BadScene, DotWithinQuotesIsNotAPath) {
    EXPECT_EQ(refusal("\"body.moments_kg_m2\" = [3, 2, 1]\n")
                  .rfind("scenes/a.toml:1:1: unknown key \"body.moments_kg_m2\";", 0),
              0u);
}

TEST(BadScene, WrongTypeNamesTheExpectedOne) {
    EXPECT_EQ(
        refusal("[body]\nmoments_kg_m2 = \"big\"\n"),
        "scenes/a.toml:2:17: body.moments_kg_m2 is a string; it must be three positive numbers "
        "in kg m², as in moments_kg_m2 = [3.0, 2.0, 1.0]");
    EXPECT_EQ(
        refusal("[body]\nmoments_kg_m2 = [3.0, true, 1.0]\n"),
        "scenes/a.toml:2:23: body.moments_kg_m2[1] is a boolean; it must be three positive numbers "
        "in kg m², as in moments_kg_m2 = [3.0, 2.0, 1.0]");
    EXPECT_EQ(refusal("title = 3\n" + a_scene),
              "scenes/a.toml:1:9: title is an integer; it must be a string, as in title = "
              "\"Tennis racket\"");
    EXPECT_EQ(refusal("body = 3\n"),
              "scenes/a.toml:1:1: body is an integer; it must be a table, as in [body]");
    EXPECT_EQ(refusal("[body.masses]\nmass_kg = 1\n"),
              "scenes/a.toml:1:7: body.masses is a table; it must be an array of tables, as in "
              "[[body.masses]]");
    EXPECT_EQ(refusal("[body.moments_kg_m2]\nx = 1\n"),
              "scenes/a.toml:1:1: body.moments_kg_m2 is a table; it must be three positive "
              "numbers in kg m², as in moments_kg_m2 = [3.0, 2.0, 1.0]");
    EXPECT_EQ(refusal("[film]\nstart_s = 1979-05-27\n"),
              "scenes/a.toml:2:11: film.start_s is a date or time; it must be a number in s, as in "
              "start_s = 0.0");
}

TEST(BadScene, WrongCountNamesTheExpectedOne) {
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3.0]\n"),
              "scenes/a.toml:2:17: body.moments_kg_m2 has 1 entry; it must be three positive "
              "numbers in kg m², as in moments_kg_m2 = [3.0, 2.0, 1.0]");
    EXPECT_EQ(refusal(a_body + "[start]\nomega_rad_s = [1, 2, 3]\nattitude = [1, 0, 0]\n"),
              "scenes/a.toml:5:12: start.attitude has 3 entries; it must be four numbers w, x, y, "
              "z, as in attitude = [0.5, 0.5, 0.5, 0.5]");
}

TEST(BadScene, MomentsOutOfRangeAreRefusedAtTheirPlace) {
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3.0, 0.0, 1.0]\n"),
              "scenes/a.toml:2:23: body.moments_kg_m2[1] is 0; give a number greater than 0");
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3.0, 2.0, -1.0]\n"),
              "scenes/a.toml:2:28: body.moments_kg_m2[2] is -1; give a number greater than 0");
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [nan, 2.0, 1.0]\n"),
              "scenes/a.toml:2:18: body.moments_kg_m2[0] is nan; give a finite number");
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3.0, inf, 1.0]\n"),
              "scenes/a.toml:2:23: body.moments_kg_m2[1] is infinite; give a finite number");
}

TEST(BadScene, BrokenTriangleIsExplained) {
    const std::string message = refusal("[body]\nmoments_kg_m2 = [1.0, 2.0, 3.5]\n" + a_start);
    EXPECT_EQ(message.rfind("scenes/a.toml:2:1: moments_kg_m2: no distribution of mass", 0), 0u)
        << message;
    EXPECT_NE(message.find("allow_unphysical = true"), std::string::npos) << message;
    EXPECT_NO_THROW(
        scene_of("[body]\nmoments_kg_m2 = [1.0, 2.0, 3.5]\nallow_unphysical = true\n" + a_start));
}

TEST(BadScene, AsymmetricTensorIsRefused) {
    const std::string message =
        refusal("[body]\ntensor_kg_m2 = [[2, 0.5, 0], [0.25, 2, 0], [0, 0, 2]]\n" + a_start);
    EXPECT_EQ(message.rfind("scenes/a.toml:2:1: tensor_kg_m2 is not symmetric: [0][1] = 0.5 but "
                            "[1][0] = 0.25;",
                            0),
              0u)
        << message;
}

TEST(BadScene, IndefiniteTensorShowsItsEigenvalues) {
    const std::string message =
        refusal("[body]\ntensor_kg_m2 = [[1, 2, 0], [2, 1, 0], [0, 0, 2]]\n" + a_start);
    EXPECT_EQ(message.rfind("scenes/a.toml:2:1: tensor_kg_m2 is not positive definite", 0), 0u)
        << message;
    EXPECT_NE(message.find("-1"), std::string::npos) << message;
}

TEST(BadScene, BodyGivenTwiceNamesBothPlaces) {
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3, 2, 1]\ntensor_kg_m2 = [[1, 0, 0], [0, 1, 0], "
                      "[0, 0, 1]]\n"),
              "scenes/a.toml:3:1: body.tensor_kg_m2 contradicts body.moments_kg_m2 (at line 2); "
              "give the body in one way only");
    EXPECT_EQ(refusal("[body]\nshape = \"box\"\nmoments_kg_m2 = [3, 2, 1]\n"),
              "scenes/a.toml:3:1: body.moments_kg_m2 contradicts body.shape (at line 2); give the "
              "body in one way only");
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3, 2, 1]\n[[body.masses]]\nmass_kg = 1\nat_m = "
                      "[0, 0, 0]\n"),
              "scenes/a.toml:3:8: body.masses contradicts body.moments_kg_m2 (at line 2); give the "
              "body in one way only");
}

TEST(BadScene, MissingBodyAndStartAreNamed) {
    EXPECT_EQ(refusal("title = \"x\"\n"),
              "scenes/a.toml:1:1: the body is missing; under [body] give moments_kg_m2, "
              "tensor_kg_m2, shape with size_m and mass_kg, object, mesh, or [[body.masses]]");
    EXPECT_EQ(refusal(a_body + "[start]\nattitude = [1, 0, 0, 0]\n"),
              "scenes/a.toml:3:2: start.omega_rad_s is missing; under [start] give the angular "
              "velocity at t = 0 in body axes, as in omega_rad_s = [0.01, 2.0, 0.01]");
    EXPECT_EQ(refusal(a_body),
              "scenes/a.toml:1:1: start.omega_rad_s is missing; under [start] give the angular "
              "velocity at t = 0 in body axes, as in omega_rad_s = [0.01, 2.0, 0.01]");
}

TEST(BadScene, SolidNeedsShapeSizeAndMass) {
    EXPECT_EQ(refusal("[body]\nshape = \"box\"\nmass_kg = 1\n"),
              "scenes/a.toml:2:1: body.size_m is missing; give the box's edge lengths along e1, "
              "e2, e3 in m");
    EXPECT_EQ(refusal("[body]\nshape = \"box\"\nsize_m = [1, 1, 1]\n"),
              "scenes/a.toml:2:1: body.mass_kg is missing; give the solid's mass in kg");
    EXPECT_EQ(refusal("[body]\nsize_m = [1, 1, 1]\nmass_kg = 1\n"),
              "scenes/a.toml:2:1: body.size_m is given but body.shape is not; name the solid, as "
              "in shape = \"box\"");
    EXPECT_EQ(refusal("[body]\nshape = \"elipsoid\"\nsize_m = [1, 1, 1]\nmass_kg = 1\n"),
              "scenes/a.toml:2:1: unknown shape \"elipsoid\"; did you mean \"ellipsoid\"?");
    EXPECT_EQ(refusal("[body]\nshape = \"sphere\"\nsize_m = [1, 1, 1]\nmass_kg = 1\n"),
              "scenes/a.toml:3:1: body.size_m has 3 entries; a sphere has 1: radius");
    EXPECT_EQ(refusal("[body]\nshape = \"box\"\nsize_m = [1, 0, 1]\nmass_kg = 1\n"),
              "scenes/a.toml:3:14: body.size_m[1] is 0; give a number greater than 0");
    EXPECT_EQ(refusal("[body]\nshape = \"box\"\nsize_m = [1, 1, 1]\nmass_kg = -1\n"),
              "scenes/a.toml:4:11: body.mass_kg is -1; give a number greater than 0");
}

// The masses of a scene, one mass of 1 kg at each place.
std::string masses(const std::vector<std::string>& places) {
    std::string text;
    for (const std::string& place : places) {
        text += "[[body.masses]]\nmass_kg = 1.0\nat_m = " + place + "\n";
    }
    return text + a_start;
}

TEST(BadScene, MassesWithoutExtentAreRefused) {
    const std::string single = refusal(masses({"[1, 2, 3]"}));
    EXPECT_EQ(single.rfind("scenes/a.toml:1:8: body.masses: ", 0), 0u) << single;
    const std::string collinear = refusal(masses({"[0, 0, 0]", "[1, 1, 0]", "[3, 3, 0]"}));
    EXPECT_EQ(collinear.rfind("scenes/a.toml:1:8: body.masses: all masses lie on one line", 0), 0u)
        << collinear;
}

TEST(BadScene, CoplanarMassesAreALamina) {
    const Scene scene = scene_of(masses({"[0, 0, 0]", "[1, 0, 0]", "[0, 2, 0]"}));
    EXPECT_TRUE(scene.body.inertia.planar());
}

TEST(BadScene, MassesNeedMassAndPlace) {
    EXPECT_EQ(refusal("[[body.masses]]\nmass_kg = 1\nat_m = [0, 0, 0]\n[[body.masses]]\nmass_kg = "
                      "2\n"),
              "scenes/a.toml:4:1: body.masses[1].at_m is missing; each mass has mass_kg and at_m");
    EXPECT_EQ(refusal("[[body.masses]]\nmass_kg = 0\nat_m = [0, 0, 0]\n"),
              "scenes/a.toml:2:11: body.masses[0].mass_kg is 0; give a number greater than 0");
    EXPECT_EQ(refusal("[[body.masses]]\nmass = 0\n"),
              "scenes/a.toml:2:1: unknown key \"mass\" in [[body.masses]]; did you mean "
              "\"mass_kg\"?");
}

TEST(BadScene, StartGivenTwiceNamesBothPlaces) {
    EXPECT_EQ(refusal(a_scene + "theta_rad = 0.7\n"),
              "scenes/a.toml:6:1: start.theta_rad contradicts start.omega_rad_s (at line 5); give "
              "omega_rad_s, or the Euler angles and rates of a top, not both");
    EXPECT_EQ(refusal(a_body + "[start]\nattitude = [1, 0, 0, 0]\ntheta_rad = 0.7\n"),
              "scenes/a.toml:5:1: start.theta_rad contradicts start.attitude (at line 4); give the "
              "attitude in one way only");
    EXPECT_EQ(refusal(a_body + "[start]\nomega3_rad_s = 1\n"),
              "scenes/a.toml:4:1: start.omega3_rad_s is given but start.theta_rad is not; give the "
              "tilt at t = 0, as in theta_rad = 0.7");
}

TEST(BadScene, ImproperRotationMatrixIsRefused) {
    EXPECT_EQ(refusal(a_scene + "attitude = [0, 0, 0, 0]\n"),
              "scenes/a.toml:6:1: start.attitude is zero; give one that has a direction");
    EXPECT_EQ(refusal(a_scene + "attitude_matrix = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]\n"),
              "scenes/a.toml:6:1: start.attitude_matrix is a reflection (determinant -1), not a "
              "rotation; change the sign of one column");
    EXPECT_EQ(refusal(a_scene + "attitude_matrix = [[1, 0, 0], [0, 1, 0], [0, 0.5, 1]]\n"),
              "scenes/a.toml:6:1: start.attitude_matrix is not a rotation: its columns are not "
              "unit vectors at right angles (off by 0.5); give an orthogonal matrix");
    EXPECT_EQ(refusal(a_scene + "attitude_matrix = [[1e200, 0, 0], [0, 1, 0], [0, 0, 1]]\n"),
              "scenes/a.toml:6:1: start.attitude_matrix is not a rotation: its columns are not "
              "unit vectors at right angles (off by 1e+200); give an orthogonal matrix");
}

TEST(BadScene, TorqueKeysBelongToTheirKind) {
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"gravty\"\n"),
              "scenes/a.toml:7:8: torque.kind is \"gravty\"; did you mean \"gravity\"?");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"gravity\"\n"),
              "scenes/a.toml:7:1: torque.mgl_N_m is missing; a torque of kind \"gravity\" needs "
              "it");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"gravity\"\nmgl_N_m = 1\nrate_1_s = 2\n"),
              "scenes/a.toml:9:1: torque.rate_1_s belongs to kind = \"dissipation\", but "
              "torque.kind is \"gravity\"; remove one of them");
    EXPECT_EQ(refusal(a_scene + "[torque]\nmgl_N_m = 1\n"),
              "scenes/a.toml:7:1: torque.mgl_N_m belongs to kind = \"gravity\", but torque.kind is "
              "not given; remove one of them");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"gravity\"\nmgl_N_m = 1\narm_body = [0, 0, "
                                "0]\n"),
              "scenes/a.toml:9:1: torque.arm_body is zero; give one that has a direction");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"drag\"\ngrowth_1_s = 1\n"),
              "scenes/a.toml:7:1: torque.linear_1_s or torque.quadratic_1_rad is missing; a torque "
              "of kind \"drag\" needs it");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"drag\"\nlinear_1_s = [1, 2]\n"),
              "scenes/a.toml:8:14: torque.linear_1_s has 2 entries; it must be three numbers of at "
              "least 0 in 1/s, as in linear_1_s = [0.2, 0.1, 0.1]");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"drag\"\nlinear_1_s = [1, -2, 1]\n"),
              "scenes/a.toml:8:18: torque.linear_1_s[1] is -2; give a number of at least 0");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"drag\"\nquadratic_1_rad = [1, 1, -1e-300]\n")
                  .substr(0, 19),
              "scenes/a.toml:8:26:");
    EXPECT_EQ(
        refusal(a_scene + "[torque]\nkind = \"drag\"\nlinear_1_s = [1, 1, 1]\nrate_1_s = 1\n"),
        "scenes/a.toml:9:1: torque.rate_1_s belongs to kind = \"dissipation\", but "
        "torque.kind is \"drag\"; remove one of them");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"drag\"\nlinear_1_s = [1, 1, 1]\n"),
              "scenes/a.toml:7:1: a torque of kind \"drag\" has no exact solution; set "
              "motion.method to one of euler, rk4, dopri5, rkmk4");
}

TEST(BadScene, UnknownMethodGetsTheNearest) {
    const std::string message = refusal(a_scene + "[motion]\nmethod = \"exakt\"\n");
    EXPECT_EQ(
        message.rfind("scenes/a.toml:7:1: unknown method \"exakt\"; did you mean \"exact\"?", 0),
        0u)
        << message;
}

TEST(BadScene, TorqueWithoutExactSolutionNamesTheMethodsThatCan) {
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"gravity\"\nmgl_N_m = 1\n"),
              "scenes/a.toml:7:1: gravity on a body that is not symmetric about the arm of its "
              "weight has no exact solution; set motion.method to one of euler, rk4, dopri5, "
              "splitting, rkmk4");
    EXPECT_EQ(
        refusal(a_scene + "[torque]\nkind = \"dissipation\"\nrate_1_s = 1\n[motion]\nmethod = "
                          "\"exact\"\n"),
        "scenes/a.toml:10:1: a torque of kind \"dissipation\" has no exact solution; set "
        "motion.method to one of euler, rk4, dopri5, rkmk4");
    EXPECT_EQ(refusal(a_scene + "[torque]\nkind = \"gravity\"\nmgl_N_m = 1\n[motion]\nmethod = "
                                "\"dmv\"\n"),
              "scenes/a.toml:10:1: a torque of kind \"gravity\" has no solution by dmv; set "
              "motion.method to one of euler, rk4, dopri5, splitting, rkmk4");
    EXPECT_NO_THROW(scene_of("[body]\nmoments_kg_m2 = [2.0, 2.0, 1.0]\n" + a_start +
                             "[torque]\nkind = \"gravity\"\nmgl_N_m = 1\n"));
}

TEST(BadScene, MethodOptionsAreRefusedAtTheirOwnPlace) {
    const auto beginning = [](const std::string& lines) {
        return refusal(a_scene + "[motion]\n" + lines).substr(0, 20);
    };
    EXPECT_EQ(beginning("step_s = 0.5\n"), "scenes/a.toml:7:1: m");  // exact accepts none
    EXPECT_EQ(beginning("method = \"rk4\"\nstep_s = 0.0\n"), "scenes/a.toml:8:10: ");
    EXPECT_EQ(beginning("method = \"rk4\"\nstep_s = -0.5\n"), "scenes/a.toml:8:10: ");
    EXPECT_EQ(beginning("method = \"rk4\"\norder = 3\n"), "scenes/a.toml:8:1: m");
    EXPECT_EQ(beginning("method = \"dopri5\"\ntolerance = 1e-20\n"), "scenes/a.toml:8:1: t");
    EXPECT_EQ(beginning("method = \"dopri5\"\ntolerance = 0\n"), "scenes/a.toml:8:13: ");
}

TEST(BadScene, FrameRateOutOfRangeIsRefused) {
    const std::string rule =
        "; give video frames a second from 0.001 to 1000, with at most three decimals or as a "
        "ratio of whole numbers up to a million, as 30, 29.97 or \"30000/1001\"";
    EXPECT_EQ(refusal(a_scene + "[film]\nfps = 0\n"),
              "scenes/a.toml:7:7: film.fps is 0; give a number from 0.001 to 1000");
    EXPECT_EQ(refusal(a_scene + "[film]\nfps = -25\n"),
              "scenes/a.toml:7:7: film.fps is -25; give a number from 0.001 to 1000");
    EXPECT_EQ(refusal(a_scene + "[film]\nfps = \"30/0\"\n"),
              "scenes/a.toml:7:7: film.fps is \"30/0\"" + rule);
    EXPECT_EQ(refusal(a_scene + "[film]\nfps = 17.332092036203907\n"),
              "scenes/a.toml:7:7: film.fps is 17.332092036203907" + rule);
    EXPECT_EQ(refusal(a_scene + "[film]\nfps = \"1000001/40000\"\n"),
              "scenes/a.toml:7:7: film.fps is \"1000001/40000\"" + rule);
    EXPECT_EQ(refusal(a_scene + "[film]\nfps = nan\n"),
              "scenes/a.toml:7:7: film.fps is nan; give a finite number");
}

TEST(BadScene, SizeOutOfRangeIsRefused) {
    const std::string rule = "; give a width and a height from 1 to 65536 pixels";
    EXPECT_EQ(refusal(a_scene + "[film]\nsize = [0, 1080]\n"),
              "scenes/a.toml:7:8: film.size is 0x1080" + rule);
    EXPECT_EQ(refusal(a_scene + "[film]\nsize = \"100000x1080\"\n"),
              "scenes/a.toml:7:8: film.size is 100000x1080" + rule);
    EXPECT_EQ(refusal(a_scene + "[film]\nsize = \"1920 by 1080\"\n"),
              "scenes/a.toml:7:8: film.size is \"1920 by 1080\"; give width and height in pixels, "
              "as in \"1920x1080\"");
    EXPECT_EQ(refusal(a_scene, {"film.size=0x0"}), "--set film.size=0x0: film.size is 0x0" + rule);
}

TEST(BadScene, FilmOfTooManyFramesIsRefused) {
    EXPECT_EQ(refusal(a_scene + "[film]\nduration_s = 1e9\n"),
              "scenes/a.toml:7:1: the film would have 3e+10 frames; a film has at most 1e+07, so "
              "shorten film.duration_s or raise film.speed");
    EXPECT_EQ(refusal(a_scene + "[film]\nspeed = 1e-300\nduration_s = 1e300\n").substr(0, 46),
              "scenes/a.toml:8:1: the film would have inf fra");
}

TEST(BadScene, PanelsThatDoNotFitAreRefused) {
    EXPECT_EQ(refusal(a_scene + "[grid]\ncolumns = [1, 1]\n[[panels]]\ncolumn = 2\n"),
              "scenes/a.toml:8:1: panels[0] reaches to cell 3 of grid.columns, which has 2; move "
              "it or extend the grid");
    // No given grid may have so many cells, so the automatic one could not be written.
    EXPECT_EQ(refusal(a_scene + "[[panels]]\ncolumn = 60\ncolumns = 5\n"),
              "scenes/a.toml:6:1: panels[0] reaches to cell 65 of grid.columns, and a grid has at "
              "most 64; move it or let it span fewer");
    EXPECT_EQ(refusal(a_scene + "[[panels]]\ncolumns = 2\n[[panels]]\ncolumn = 1\n"),
              "scenes/a.toml:8:1: panels[1] covers a cell of panels[0]; give each panel cells of "
              "its own by column and row");
}

TEST(BadScene, SyntaxErrorsKeepTheirPlace) {
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = 3.0, 2.0\n")
                  .rfind("scenes/a.toml:2:20: not valid TOML: parsing ", 0),
              0u);
    EXPECT_EQ(refusal("title = \"a\"\ntitle = \"b\"\n").rfind("scenes/a.toml:2:", 0), 0u);
}

TEST(BadScene, AMissingBracketIsMarkedWhereItsArrayBegins) {
    const std::string missing = "not valid TOML: this array has no closing ']'; write it";
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3.0, 2.0\ntitle = 3\n"),
              "scenes/a.toml:2:17: " + missing);
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3.0, 2.0\n\n# ] in a comment\n[start]\n"),
              "scenes/a.toml:2:17: " + missing);
    EXPECT_EQ(
        refusal("title = \"[ \\\" [\"\n[a]\nx = [ [1, 2], ']', \"\"\"\n]\"\"\",\n  [ 3\n y = 1\n"),
        "scenes/a.toml:5:3: " + missing);
    // In one line, the place itself is marked.
    EXPECT_EQ(refusal("[body]\nmoments_kg_m2 = [3.0, 2.0 x]\n").rfind("scenes/a.toml:2:27: ", 0),
              0u);
}

TEST(BadScene, ADecimalCommaIsNamed) {
    const std::string points = "numbers have decimal points, as in 16.0, and commas separate them";
    for (const std::string value : {"16,0", "[0,8; 0,9; 1,0]", "1,5 # s"}) {
        const std::string said = refusal("[film]\nduration_s = " + value + "\n");
        EXPECT_TRUE(said.starts_with("scenes/a.toml:2:") && said.ends_with(points)) << said;
    }
    const std::string other = refusal("[film]\nduration_s = 1 ; 2\n");
    EXPECT_TRUE(other.ends_with("correct this line")) << other;
}

TEST(BadScene, OverrideNamesItself) {
    EXPECT_EQ(refusal(a_scene, {"film.fpz=3"}),
              "--set film.fpz=3: unknown key \"film.fpz\"; did you mean \"film.fps\"?");
    EXPECT_EQ(refusal(a_scene, {"body.moments=[1,2,3]"}),
              "--set body.moments=[1,2,3]: unknown key \"body.moments\"; did you mean "
              "\"body.moments_kg_m2\"?");
    EXPECT_EQ(refusal(a_scene, {"fps=3"}),
              "--set fps=3: unknown key \"fps\"; did you mean \"film.fps\"?");
    EXPECT_EQ(refusal(a_scene, {"title=\"$\\vec{H}$\""}),
              "--set title=\"$\\vec{H}$\": the quoted text is not a TOML string; leave the quotes "
              "out, or double each backslash");
    EXPECT_EQ(parse_scene(a_scene, "a.toml", std::vector<Override>{{"title", "'a' or 'b'"}}).title,
              "'a' or 'b'");
    EXPECT_EQ(refusal(a_scene, {"film"}), "--set film: no \"=\"; write --set key=value");
    EXPECT_EQ(refusal(a_scene, {"film=3"}),
              "--set film=3: [film] is a table; set one of its keys, see `poinsot list keys`");
    EXPECT_EQ(refusal(a_scene, {"body.tensor_kg_m2=[[1,0,0],[0,1,0],[0,0,1]]"}),
              "--set body.tensor_kg_m2=[[1,0,0],[0,1,0],[0,0,1]]: body.tensor_kg_m2 contradicts "
              "body.moments_kg_m2 (at line 2); give the body in one way only");
    EXPECT_EQ(refusal(a_scene, {"body.masses[3].mass_kg=1"}),
              "--set body.masses[3].mass_kg=1: there is no masses[3]: the scene has 0 of them, "
              "counted from 0; name one of those");
}

TEST(BadScene, ErrorCarriesItsLocation) {
    try {
        scene_of("# é\n  titel = 1\n");
        FAIL() << "accepted";
    } catch (const SceneError& error) {
        EXPECT_EQ(error.where().file, "scenes/a.toml");
        EXPECT_EQ(error.where().line, 2);
        EXPECT_EQ(error.where().column, 3);
    }
}

// A separate file for each test, removed at its end.
class SceneFile {
 public:
    SceneFile(const std::string& name, const std::string& content)
        : path_(std::filesystem::path(::testing::TempDir()) / name) {
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~SceneFile() { std::filesystem::remove(path_); }
    SceneFile(const SceneFile&) = delete;
    SceneFile& operator=(const SceneFile&) = delete;
    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

std::string file_refusal(const std::filesystem::path& path) {
    try {
        load_scene(path);
    } catch (const SceneError& error) {
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << path;
    return "";
}

TEST(BadSceneFile, MissingFileIsReportedWithTheNearestName) {
    EXPECT_EQ(file_refusal("nosuchfolder/a.toml"),
              "nosuchfolder/a.toml: no such file; name a scene file, see `poinsot list scenes`");
    const SceneFile near("poinsot_racket.toml", a_scene);
    const std::string missing =
        (std::filesystem::path(::testing::TempDir()) / "poinsot_raket.toml").string();
    EXPECT_EQ(file_refusal(missing),
              missing + ": no such file; did you mean \"" + near.path().string() + "\"?");
    // The folder's name is not part of the comparison, however long it is.
    const std::filesystem::path folder =
        std::filesystem::path(::testing::TempDir()) / std::string(70, 'd');
    std::filesystem::create_directory(folder);
    std::ofstream(folder / "racket.toml") << a_scene;
    const std::string in_folder = (folder / "raket.toml").string();
    EXPECT_EQ(file_refusal(in_folder), in_folder + ": no such file; did you mean \"" +
                                           (folder / "racket.toml").string() + "\"?");
    const std::string unlike = (folder / "gyroscope.toml").string();
    EXPECT_EQ(file_refusal(unlike),
              unlike + ": no such file; name a scene file, see `poinsot list scenes`");
    std::filesystem::remove_all(folder);
}

TEST(BadSceneFile, EmptyFileIsReported) {
    for (const char* const content : {"", "\n \t\r\n"}) {
        const SceneFile file("poinsot_empty.toml", content);
        EXPECT_EQ(file_refusal(file.path()),
                  file.path().string() +
                      ":1:1: the file is empty; a scene needs at least [body] and [start]");
    }
}

TEST(BadSceneFile, FolderIsReported) {
    const std::filesystem::path folder =
        std::filesystem::path(::testing::TempDir()) / "poinsot_folder";
    std::filesystem::create_directory(folder);
    EXPECT_EQ(file_refusal(folder),
              folder.string() + ": this is a folder; name a scene file in it, ending in .toml");
    std::filesystem::remove(folder);
}

TEST(BadSceneFile, BinaryContentIsReported) {
    const SceneFile nul("poinsot_nul.toml", std::string("title = 1\n\0\1", 12));
    EXPECT_EQ(file_refusal(nul.path()),
              nul.path().string() + ":2:1: control character U+0000; remove it");
    const SceneFile png("poinsot_png.toml", "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(file_refusal(png.path()),
              png.path().string() + ":1:1: byte 0x89 is not UTF-8; save this text as UTF-8");
}

TEST(BadSceneFile, LargeFileIsNotRead) {
    const SceneFile large("poinsot_large.toml", std::string((1 << 20) + 1, '#'));
    EXPECT_EQ(
        file_refusal(large.path()),
        large.path().string() + ": larger than 1 MiB; a scene is a short text file, name that one");
}

TEST(SceneValues, NumbersMayBeWrittenAsIntegers) {
    const Scene scene = scene_of(
        "[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nomega_rad_s = [1, 2, "
        "0x10]\n"
        "[film]\nfps = 25\n");
    EXPECT_EQ(scene.body.inertia.moments_kg_m2(), Eigen::Vector3d(3.0, 2.0, 1.0));
    EXPECT_EQ(scene.film.fps_numerator, 25);
}

TEST(SceneValues, OverridesReplaceAndExtendTheFile) {
    const Scene scene =
        scene_of("title = \"a\"\n" + a_scene,
                 {"title=2024", "film.size=640x480", "film.fps=30000/1001", "show=plane,omega",
                  "camera.distance=.5", "start.omega_rad_s=[1,2,3]", "film.quality=\"draft\"",
                  "theme=dark", "theme=light"});
    EXPECT_EQ(scene.title, "2024");
    EXPECT_EQ(scene.film.width_px, 640);
    EXPECT_EQ(scene.film.fps_denominator, 1001);
    EXPECT_EQ(scene.show, (std::vector<std::string>{"plane", "omega"}));
    EXPECT_EQ(scene.camera.distance, 0.5);
    EXPECT_EQ(scene.start.omega_rad_s, Eigen::Vector3d(1.0, 2.0, 3.0));
    EXPECT_EQ(scene.film.quality, "draft");
    EXPECT_EQ(scene.theme, "light");
    EXPECT_EQ(scene.where("theme"), "--set theme=light: ");
}

TEST(SceneValues, OverridesReachItemsOfArrays) {
    const Scene scene = scene_of(
        "[[body.masses]]\nmass_kg = 1\nat_m = [1, 0, 0]\n[[body.masses]]\nmass_kg = "
        "1\nat_m = [0, 1, 0]\n[[body.masses]]\nmass_kg = 1\nat_m = [0, 0, 1]\n" +
            a_start,
        {"body.masses[1].mass_kg=2.5"});
    EXPECT_EQ(scene.body.masses.at(0).mass_kg, 1.0);
    EXPECT_EQ(scene.body.masses.at(1).mass_kg, 2.5);
}

TEST(SceneValues, LocationFallsBackToTheNearestTableAbove) {
    const Scene scene = scene_of(a_scene);
    EXPECT_EQ(scene.where("start.omega_rad_s"), "scenes/a.toml:5:1: ");
    EXPECT_EQ(scene.where("start.attitude"), "scenes/a.toml:4:2: ");
    EXPECT_EQ(scene.where("film.fps"), "scenes/a.toml:1:1: ");
}

TEST(SceneNumbers, AreTheNearestDoubles) {
    testing::RandomDecimals random(39);
    int n_in_files = 0;
    for (int i = 0; i < 30'000; ++i) {
        const std::string text = i % 3 == 0   ? random.near_a_middle(random.ordinary_double())
                                 : i % 3 == 1 ? random.any(320)
                                              : random.any(3);
        const double right = testing::read_by_mpfr(text);
        if (!std::isfinite(right)) continue;
        ASSERT_EQ(parse_override_value(text, {}).number, right) << text;
        // toml++ accepts integers of 64 bits, and 128 characters.
        if (text.find_first_of(".e") == std::string::npos || text.size() > 120) continue;
        ++n_in_files;
        ASSERT_EQ(parse_toml("value = " + text, "a.toml").entries.at(0).value.number, right)
            << text;
    }
    EXPECT_GT(n_in_files, 20'000);
    EXPECT_EQ(parse_toml("value = 9007199254740993", "a.toml").entries.at(0).value.number,
              9007199254740992.0);
}

}  // namespace
}  // namespace poinsot
