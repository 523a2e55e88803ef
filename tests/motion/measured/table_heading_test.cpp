// Headings of tables in the languages and apps that a class has.
#include "measured/table_heading.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace poinsot {
namespace {

void expect_omega(const std::string& cell, int component, double si_in_unit = 1.0) {
    const TableHeading heading = table_heading_of(cell);
    EXPECT_EQ(heading.kind, ColumnKind::omega) << cell;
    EXPECT_EQ(heading.component, component) << cell;
    EXPECT_TRUE(heading.is_unit_known) << cell;
    EXPECT_NEAR(heading.si_in_unit, si_in_unit, 1e-15 * si_in_unit) << cell;
}

void expect_time(const std::string& cell, double si_in_unit) {
    const TableHeading heading = table_heading_of(cell);
    EXPECT_EQ(heading.kind, ColumnKind::time) << cell;
    EXPECT_NEAR(heading.si_in_unit, si_in_unit, 1e-15 * si_in_unit) << cell;
}

TEST(TableHeading, IsReadInSixLanguages) {
    for (const char* time : {"Time (s)", "Zeit (s)", "Temps (s)", "Tiempo (s)", "Tempo (s)",
                             "時間 (s)", "時間（s）", "\"Zeit [s]\"", "経過時間"})
        expect_time(time, 1.0);
    for (const char* omega : {"Gyroscope y (rad/s)", "Gyroskop y (rad/s)", "Giroscope y (rad/s)",
                              "Giroscopio y (rad/s)", "ジャイロスコープ y (rad/s)",
                              "Winkelgeschwindigkeit y", "Drehrate Y-Achse", "Vitesse angulaire y",
                              "Velocidad angular y", "Velocità angolare y", "角速度 y", "ω_y"})
        expect_omega(omega, 1);
}

TEST(TableHeading, IsReadAsAppsWriteIt) {
    const double degree = std::numbers::pi / 180.0;
    expect_time("seconds_elapsed", 1.0);  // Sensor Logger
    expect_time("relative_time", 1e-3);   // Arduino's Science Journal
    expect_time("millis", 1e-3);          // Arduino
    expect_time("Timestamp (ns)", 1e-9);
    expect_omega("z", 2);   // Sensor Logger
    expect_omega("gx", 0);  // Arduino_LSM6DS3
    expect_omega("GyroX (dps)", 0, degree);
    expect_omega("gyro_z_deg_s", 2, degree);
    expect_omega("wx", 0);                          // Physics Toolbox
    expect_omega("motionRotationRateX(rad/s)", 0);  // SensorLog
}

TEST(TableHeading, PrefersNamesThatMeanOneThing) {
    EXPECT_GT(table_heading_of("seconds_elapsed").rank, table_heading_of("time").rank);
    EXPECT_GT(table_heading_of("Gyroscope x").rank, table_heading_of("gx").rank);
    EXPECT_GT(table_heading_of("gx").rank, table_heading_of("x").rank);
}

TEST(TableHeading, IsNothingOfOtherQuantities) {
    for (const char* other : {"Absolute (rad/s)", "Linear Acceleration x (m/s^2)", "gFx", "ax",
                              "Bx", "x (m)", "gx (m/s^2)", "herpolhode_x", "", "temperature"})
        EXPECT_EQ(table_heading_of(other).kind, ColumnKind::other) << other;
    EXPECT_FALSE(table_heading_of("Gyroscope x (m/s)").is_unit_known);
}

}  // namespace
}  // namespace poinsot
