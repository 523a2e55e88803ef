#!/usr/bin/env python3
"""Makes scenes/measured_gyro.csv: the gyroscope's table of a thrown phone, in the form in which phyphox exports it.

It is synthetic. The phone is a uniform box with the published sizes and mass of an iPhone 13 (146.7 x 71.5 x 7.65 mm, 174 g). Its
sensor is mounted 6 degrees off the edges, air takes 5 % of L a second, each component has noise of 0.12 rad/s, and 0.03 s of rows are
lost. Euler's equations are stepped by the classical Runge-Kutta method with 40 steps a row.
"""
import math
import random
import sys

MASS_KG, WIDTH_M, HEIGHT_M, DEPTH_M = 0.174, 0.0715, 0.1467, 0.00765
MOMENTS = [MASS_KG / 12 * (a * a + b * b) for a, b in ((HEIGHT_M, DEPTH_M), (WIDTH_M, DEPTH_M), (WIDTH_M, HEIGHT_M))]
MOUNTED_RAD = math.radians(6.0)  # about the axis across the screen
DAMPING_1_S = 0.05
NOISE_RAD_S = 0.12
OMEGA_RAD_S = [16.0, 0.9, 0.5]  # along the edges: width, height, depth
ROWS, ROWS_A_SECOND, LOST = 401, 400, range(238, 250)
STEPS_A_ROW = 40


def rate(momentum):
    omega = [l / i for l, i in zip(momentum, MOMENTS)]
    return [momentum[(k + 1) % 3] * omega[(k + 2) % 3] - momentum[(k + 2) % 3] * omega[(k + 1) % 3] - DAMPING_1_S * momentum[k]
            for k in range(3)]


def stepped(momentum, step_s):
    def moved(slope, share):
        return [l + share * step_s * s for l, s in zip(momentum, slope)]
    a = rate(momentum)
    b = rate(moved(a, 0.5))
    c = rate(moved(b, 0.5))
    d = rate(moved(c, 1.0))
    return [l + step_s / 6 * (p + 2 * q + 2 * r + s) for l, p, q, r, s in zip(momentum, a, b, c, d)]


def main():
    scatter = random.Random(4)
    out = open(sys.argv[1], "w", encoding="ascii", newline="\n")
    out.write('"Time (s)","Gyroscope x (rad/s)","Gyroscope y (rad/s)","Gyroscope z (rad/s)"\n')
    momentum = [i * w for i, w in zip(MOMENTS, OMEGA_RAD_S)]
    cosine, sine = math.cos(MOUNTED_RAD), math.sin(MOUNTED_RAD)
    for row in range(ROWS):
        x, y, z = (l / i for l, i in zip(momentum, MOMENTS))
        seen = [cosine * x - sine * y, sine * x + cosine * y, z]
        noisy = [w + scatter.gauss(0.0, NOISE_RAD_S) for w in seen]
        if row not in LOST:
            out.write(",".join(f"{value:.5E}".replace("E+0", "E").replace("E-0", "E-")
                               for value in [row / ROWS_A_SECOND] + noisy) + "\n")
        for _ in range(STEPS_A_ROW):
            momentum = stepped(momentum, 1 / ROWS_A_SECOND / STEPS_A_ROW)


main()
