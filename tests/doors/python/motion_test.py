"""Motions without a scene: each number is a closed form's or has the digits of a scene's."""
import copy
import json
import math
import pathlib
import pickle
import pydoc
import re

import numpy as np
import pytest

import poinsot

TRIAXIAL = [1.0, 2.0, 2.5]
OMEGA = [0.7, 1.9, -0.4]
TORQUES = [
    {"kind": "gravity", "mgl_N_m": 1.5, "arm_body": [0.0, 3.0, 4.0]},
    {"kind": "constant_body", "torque_body_N_m": [0.1, 0.2, 0.3]},
    {"kind": "constant_space", "torque_space_N_m": [0.1, 0.2, 0.3]},
    {"kind": "dissipation", "rate_1_s": 0.2},
    {"kind": "drag", "linear_1_s": [0.2, 0.1, 0.1], "quadratic_1_rad": [0.02, 0.01, 0.01], "growth_1_s": 0.5},
]
TIMES = np.array([-50.0, -1.0, 0.0, 0.3, 7.0, 1234.5])


def test_the_constants_are_those_of_the_start():
    moments, omega = np.array(TRIAXIAL), np.array(OMEGA)
    motion = poinsot.Motion(moments, omega)
    constants = motion.constants
    energy2, momentum = (moments * omega**2).sum(), np.linalg.norm(moments * omega)
    assert constants.kinetic_energy_J == pytest.approx(0.5 * energy2, rel=1e-15)
    assert constants.momentum_kg_m2_s == pytest.approx(momentum, rel=1e-15)
    np.testing.assert_allclose(constants.momentum_space, moments * omega, rtol=1e-15)
    assert constants.plane_distance == pytest.approx(np.sqrt(energy2) / momentum, rel=1e-15)
    np.testing.assert_allclose(constants.half_axes, 1 / np.sqrt(moments), rtol=1e-15)
    radii = np.linalg.norm(motion.at(np.linspace(0, 100, 1000)).herpolhode, axis=1)
    least, greatest = constants.herpolhode_radii_rad_s
    assert least * (1 - 1e-12) <= radii.min() < least * 1.01 and greatest * 0.99 < radii.max() <= greatest * (1 + 1e-12)


def test_a_spin_of_any_size_has_its_states():
    """The motion scales with time, and constants beyond the range of a float are infinite."""
    fast, slow = poinsot.Motion([1, 2, 3], [1e160, 1e157, 2e160]), poinsot.Motion([1, 2, 3], [1, 1e-3, 2])
    assert fast.constants.kinetic_energy_J == math.inf
    times = np.linspace(0.0, 20.0, 40)
    np.testing.assert_allclose(fast.at(times * 1e-160).omega_body * 1e-160, slow.at(times).omega_body, rtol=0, atol=1e-12)
    np.testing.assert_allclose(fast.at(times * 1e-160).space_from_body, slow.at(times).space_from_body, rtol=0, atol=1e-12)


@pytest.mark.parametrize("omega, axis, regime", [
    ([0.7, 1.9, -0.4], 1, "elliptic, about the axis of the smallest moment"),
    ([0.4, 1.9, -0.8], 3, "elliptic, about the axis of the largest moment"),
])
def test_the_period_is_that_of_the_elliptic_integral(omega, axis, regime):
    special = pytest.importorskip("scipy.special")
    i1, i2, i3 = TRIAXIAL if axis == 3 else TRIAXIAL[::-1]
    t2 = (np.array(TRIAXIAL) * np.array(omega) ** 2).sum()
    m2 = ((np.array(TRIAXIAL) * np.array(omega)) ** 2).sum()
    # Landau & Lifshitz, Mechanics (37.8), (37.12); for the other side, 1 and 3 change places.
    k2 = (i2 - i1) * (t2 * i3 - m2) / ((i3 - i2) * (m2 - t2 * i1))
    period = 4 * special.ellipk(k2) * np.sqrt(i1 * i2 * i3 / ((i3 - i2) * (m2 - t2 * i1)))
    motion = poinsot.Motion(TRIAXIAL, omega)
    assert motion.period_s == motion.constants.polhode_period_s == pytest.approx(period, rel=1e-12)
    assert motion.constants.modulus == pytest.approx(np.sqrt(k2), rel=1e-12)
    assert motion.constants.encircled_axis == axis
    assert motion.regime == regime


def test_the_curves_are_on_both_quadrics_and_in_the_plane():
    moments = np.array(TRIAXIAL)
    motion = poinsot.Motion(moments, OMEGA)
    constants = motion.constants
    plane2 = constants.plane_distance**-2
    points, contact = motion.polhode(), motion.contact(TIMES)
    for curve in (points, contact):
        np.testing.assert_allclose((moments * curve**2).sum(axis=1), 1.0, rtol=1e-14)  # the ellipsoid
        np.testing.assert_allclose((moments**2 * curve**2).sum(axis=1), plane2, rtol=1e-14)
    np.testing.assert_array_equal(points[0], points[-1])
    assert len(motion.polhode(1e-6)) > len(points) > len(motion.polhode(1e-2)) > 20
    assert poinsot.Motion(moments, [0, 1.5, 0]).polhode().shape == (1, 3)
    height = motion.herpolhode(TIMES) @ constants.momentum_space / constants.momentum_kg_m2_s
    np.testing.assert_allclose(height, constants.plane_distance, rtol=1e-13)


def test_the_certificate_holds():
    claims = poinsot.Motion(TRIAXIAL, OMEGA).certificate(np.linspace(-1e6, 1e6, 100))
    assert len(claims) >= 5
    for claim in claims:
        assert claim.holds and 0 <= claim.worst <= claim.bound <= 1e-9
        assert -1e6 <= claim.at_time_s <= 1e6 and claim.means
    assert poinsot.Motion(TRIAXIAL, OMEGA).certificate([]) == []


def test_a_tensor_is_its_moments_in_turned_axes():
    c, s = np.cos(0.4), np.sin(0.4)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])  # given axes from principal axes
    tensor = turn @ np.diag(TRIAXIAL) @ turn.T
    motion = poinsot.Motion((tensor + tensor.T) / 2, turn @ OMEGA)
    # The tensor's rounding, 1e-16, changes the periods by as much: 1e-13 after 1e3 s.
    in_principal = poinsot.Motion(TRIAXIAL, OMEGA).at(TIMES).omega_body
    np.testing.assert_allclose(motion.at(TIMES).omega_body, in_principal @ turn.T, rtol=0, atol=1e-11)
    # Up to their signs and their order.
    axes = motion.principal_axes
    np.testing.assert_allclose(axes.T @ tensor @ axes, np.diag(motion.moments), rtol=0, atol=1e-14)
    np.testing.assert_allclose(motion.moments, 1 / motion.constants.half_axes**2, rtol=1e-14)
    assert (poinsot.Motion(TRIAXIAL, OMEGA).principal_axes == np.eye(3)).all()


def test_principal_axes_are_columns_wherever_they_are_a_matrix(program, tmp_path):
    # A slab that is turned by its own axes only: e1, e2, e3 of all are those of the tensor.
    turn = np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    tensor = turn @ np.diag([3.0, 2.0, 1.0]) @ turn.T
    motion = poinsot.Motion(tensor, [1.0, 6.0, 2.0])
    times = np.arange(0.0, 8.0, 0.02)
    found = poinsot.fit(times, motion.at(times).omega_body)
    scene = tmp_path / "turned.toml"
    scene.write_text(f"[body]\ntensor_kg_m2 = {tensor.tolist()}\n[start]\nomega_rad_s = [1.0, 6.0, 2.0]\n")
    table = tmp_path / "turned.csv"
    table.write_text("t,w_x,w_y,w_z\n" + "\n".join(f"{t},{w[0]},{w[1]},{w[2]}" for t, w in zip(times.tolist(), motion.at(times).omega_body.tolist())))
    said = json.loads(program("check", scene, "--json"))
    for axes, moments in (
        (motion.principal_axes, motion.moments),
        (found.axes, 3.0 * found.moments),
        (said["principal_axes"], said["moments_kg_m2"]),
        (json.loads(program("fit", table, "--json"))["axes"], 3.0 * found.moments),
    ):
        axes = np.array(axes)
        np.testing.assert_allclose(axes @ np.diag(moments) @ axes.T, tensor, rtol=0, atol=1e-6)


def conventions():
    """The rows of the table of docs/python.md: value, shape, unit, axes."""
    page = (pathlib.Path(__file__).resolve().parents[3] / "docs" / "python.md").read_text(encoding="utf-8")
    table = page.partition("| value | shape | unit | axes |")[2].split("\n\n")[0].splitlines()[2:]
    return [tuple(cell.replace("`", "").strip() for cell in row.strip("|").split("|")) for row in table]


def test_the_page_says_axes_units_and_order():
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    rows = conventions()
    assert len(rows) > 15
    start = rotation.from_euler("xyz", [0.3, -0.2, 0.9])

    def values(turn, mass, speed):
        """Of the same motion, seen in turned body axes, of a heavier body and faster."""
        times = np.arange(0.0, 4.0, 0.02) / speed
        tensor = mass * turn.as_matrix() @ np.diag([3.0, 2.0, 1.0]) @ turn.as_matrix().T
        motion = poinsot.Motion(tensor, speed * turn.apply([1.0, 6.0, 2.0]), attitude=start * turn.inv())
        found = poinsot.fit(times, motion.at(times).omega_body)
        known = {"motion": motion, "found": found, "times": times}
        return {row[0]: np.asarray(eval(row[0], known)) for row in rows}

    turn, mass, speed = rotation.from_rotvec([0.06, 0.12, 0.13]), 4.0, 2.0
    first, second = values(rotation.identity(), 1.0, 1.0), values(turn, mass, speed)
    units = {"": 1.0, "kg m²": mass, "1/√(kg m²)": mass**-0.5, "rad/s": speed, "1/s, or 1/rad": speed, "rad/s, or rad": speed,
             "I1, or kg m²": 1.0, "as moments": 1.0}
    matrix = turn.as_matrix()
    for name, shape, unit, axes in rows:
        wide = shape.replace("S + ", "200, ").replace("(3", "3").replace("(4", "4") if "S" in shape else shape.strip("()")
        assert first[name].shape == tuple(int(n) for n in wide.strip("()").split(",") if n.strip()), name
        one, other = units[unit] * first[name], second[name]
        if axes in ("body", "instrument"):
            one = matrix @ one @ matrix.T if shape == "(3, 3)" else one @ matrix.T
        elif axes.startswith("columns e1, e2, e3 in "):
            one = matrix @ one
        elif axes == "space from body":
            one = (rotation.from_quat(np.roll(one, -1, axis=-1)) * turn.inv()).as_matrix()
            other = rotation.from_quat(np.roll(other, -1, axis=-1)).as_matrix()
        else:
            assert axes in ("e1, e2, e3", "space"), axes
        np.testing.assert_allclose(other, one, rtol=0, atol=1e-5, err_msg=name)
    # The columns belong to the moments of their order.
    for axes, moments in (("motion.principal_axes", "motion.moments"), ("found.axes", "found.moments")):
        turned = second[axes] @ np.diag(second[moments] / second[moments].max()) @ second[axes].T
        np.testing.assert_allclose(turned, matrix @ np.diag([1.0, 2.0 / 3.0, 1.0 / 3.0]) @ matrix.T, rtol=0, atol=1e-5)


def test_a_motion_says_its_start():
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    start = rotation.from_euler("xyz", [0.3, -0.2, 0.9])
    motion = poinsot.Motion(TRIAXIAL, OMEGA, attitude=start)
    np.testing.assert_array_equal(motion.omega, OMEGA)
    np.testing.assert_array_equal(motion.moments, TRIAXIAL)
    assert (motion.at(0.0).rotation * start.inv()).magnitude() < 1e-15
    np.testing.assert_allclose(motion.attitude, np.roll(start.as_quat(), 1), rtol=0, atol=1e-15)
    states = motion.at(np.arange(6.0).reshape(2, 3))
    # e3 of the body in space, by the matrix and by the quaternion's own formula.
    w, x, y, z = states.space_from_body.reshape(-1, 4).T
    np.testing.assert_allclose(states.rotation.apply([0, 0, 1]), np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], axis=1), atol=1e-14)


def test_the_attitude_at_the_start_is_the_one_given():
    attitude = np.array([0.1, -0.5, 0.7, 0.5])
    attitude /= np.linalg.norm(attitude)
    np.testing.assert_allclose(poinsot.Motion(TRIAXIAL, OMEGA, attitude=attitude).at(0.0).space_from_body, attitude, rtol=0, atol=2e-16)


@pytest.mark.parametrize("times", [1.5, 2, np.float32(1.5), np.array(1.5), [], [1, 2], np.zeros((2, 3)), np.zeros((0, 3)),
                                   np.linspace(0, 1, 24).reshape(2, 3, 4).T, np.arange(10.0)[::-3]],
                         ids=lambda times: f"{type(times).__name__}{np.shape(times)}")
def test_states_have_the_shape_of_the_times(times):
    motion = poinsot.Motion(TRIAXIAL, OMEGA)
    shape = np.shape(times)
    states = motion.at(times)
    arrays = {(): [states.time_s], (3,): [states.omega_body, states.herpolhode, motion.herpolhode(times), motion.contact(times)],
              (4,): [states.space_from_body]}
    for width, found in arrays.items():
        for array in found:
            assert array.shape == shape + width
            assert array.dtype == np.float64 and array.flags.c_contiguous
    np.testing.assert_array_equal(states.time_s, np.asarray(times, np.float64))
    one_by_one = [motion.at(float(t)).omega_body for t in np.asarray(times).ravel()]
    np.testing.assert_array_equal(states.omega_body.reshape(-1, 3), np.array(one_by_one).reshape(-1, 3))


def test_a_body_at_rest_stays_and_has_no_plane():
    motion = poinsot.Motion(TRIAXIAL, [0, 0, 0])
    np.testing.assert_array_equal(motion.at(1e9).space_from_body, [1, 0, 0, 0])
    for ask in (lambda: motion.constants, lambda: motion.period_s, motion.polhode, lambda: motion.herpolhode(0.0),
                lambda: motion.certificate([0.0])):
        with pytest.raises(poinsot.InputError, match="at rest"):
            ask()


def test_tensors_out_of_computations_are_taken():
    """R diag(I) R^T as NumPy computes it is not symmetric to the last bit."""
    random = np.random.default_rng(8)
    for _ in range(200):
        axes = np.linalg.qr(random.normal(size=(3, 3)))[0]
        motion = poinsot.Motion(axes @ np.diag(TRIAXIAL) @ axes.T, OMEGA)
        np.testing.assert_allclose(sorted(np.asarray(motion.constants.half_axes) ** -2.0), TRIAXIAL, rtol=1e-14)


def test_the_largest_omega_in_turned_axes_ends():
    tensor = [[3, 0.1, 0], [0.1, 2, 0], [0, 0, 2]]
    fast, slow = poinsot.Motion(tensor, [0, 2.0**999, 2.0**999]), poinsot.Motion(tensor, [0, 0.5, 0.5])
    np.testing.assert_array_equal(fast.at(3 * 2.0**-1000).space_from_body, slow.at(3.0).space_from_body)


@pytest.mark.parametrize("moments, omega, options, sentence", [
    ([1, 2], OMEGA, {}, "moments: give the three principal moments"),
    (1.0, OMEGA, {}, "moments: give the three principal moments"),
    (np.ones((3, 2)), OMEGA, {}, "moments: give the three principal moments"),
    (np.ones((2, 3, 3)), OMEGA, {}, "moments: give the three principal moments"),
    ("abc", OMEGA, {}, "moments: numbers are needed"),
    (None, OMEGA, {}, "moments: numbers are needed"),
    ([1, 2j, 3], OMEGA, {}, "moments: numbers are needed"),
    ([0, 1, 1], OMEGA, {}, "must be positive"),
    ([[2, 1, 0], [0, 2, 0], [0, 0, 2]], OMEGA, {}, "not symmetric"),
    (TRIAXIAL, [1, 2], {}, "omega: give three numbers"),
    (TRIAXIAL, [[1, 2, 3]], {}, "omega: give three numbers"),
    (TRIAXIAL, [1, 2, math.nan], {}, "must be finite"),
    (TRIAXIAL, [[1], [2, 3]], {}, "omega: not an array of numbers"),
    (TRIAXIAL, OMEGA, {"attitude": [1, 0, 0]}, "attitude: give a quaternion"),
    (TRIAXIAL, OMEGA, {"method": "rk5"}, "rk4"),
    (TRIAXIAL, OMEGA, {"torque": "gravity"}, "torque: give a dict with a kind"),
    (TRIAXIAL, OMEGA, {"torque": {"kind": "wind"}}, 'torque: unknown kind "wind"; give one of none, gravity, '),
    (TRIAXIAL, OMEGA, {"torque": {"kind": "drag"}}, "needs its numbers: linear_1_s, quadratic_1_rad, growth_1_s"),
    (TRIAXIAL, OMEGA, {"torque": {"kind": "drag", "rate_1_s": 1.0}}, 'of kind "drag" has no rate_1_s; it takes linear_1_s'),
    (TRIAXIAL, OMEGA, {"torque": {"kind": "drag", "linear_1_s": 1.0}}, "torque: linear_1_s is three numbers"),
    (TRIAXIAL, OMEGA, {"torque": {"kind": "dissipation", "rate_1_s": -1.0}, "method": "rk4"}, "give a rate ≥ 0"),
    (TRIAXIAL, OMEGA, {"torque": {"kind": "dissipation", "rate_1_s": 1.0}}, 'has no solution for the torque "internal friction"'),
])
def test_a_wrong_motion_is_refused_with_one_line(moments, omega, options, sentence):
    with pytest.raises(poinsot.InputError, match=sentence) as caught:
        poinsot.Motion(moments, omega, **options)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("times", [math.nan, math.inf, [0.0, math.nan], "soon", None, [1j], [True], [[1], [2, 3]], [object()]], ids=repr)
def test_wrong_times_are_refused(times):
    motion = poinsot.Motion(TRIAXIAL, OMEGA)
    for ask in (motion.at, motion.herpolhode, motion.contact, motion.certificate):
        with pytest.raises(poinsot.InputError):
            ask(times)


def test_the_cones_are_those_of_the_textbook():
    i1, i3, w3 = 2.0, 3.0, 1.7
    motion = poinsot.Motion([i1, i1, i3], [0.3, 0.0, w3])
    cones = motion.cones
    # Landau & Lifshitz, Mechanics (33.4), (35): Omega = (I3 - I1) w3 / I1, and L/I1 about L.
    assert cones.symmetry_axis == 3
    assert cones.body_precession_rad_s == pytest.approx((i3 - i1) * w3 / i1, rel=1e-14)
    assert cones.space_precession_rad_s == pytest.approx(np.hypot(i1 * 0.3, i3 * w3) / i1, rel=1e-14)
    assert cones.body_half_angle_rad == pytest.approx(np.arctan2(0.3, w3), rel=1e-14)
    assert poinsot.Motion(TRIAXIAL, OMEGA).cones is None


def test_a_flip_is_where_omega_along_the_middle_axis_changes_its_sign():
    motion = poinsot.Motion([3.0, 2.0, 1.0], [0.01, 2.0, 0.01])
    flips = motion.flips(0.0, 100.0)
    assert len(flips) >= 4
    np.testing.assert_allclose(motion.at(flips).omega_body[:, 1], 0.0, rtol=0, atol=1e-12)


@pytest.mark.parametrize("motion", [
    poinsot.Motion([1.0, 2.0, 2.5], [0.1, 2.0, 0.3]),
    poinsot.Motion([[3.0, 0.1, 0.2], [0.1, 2.0, 0.3], [0.2, 0.3, 1.5]], [1.0, 2.0, 3.0], attitude=[0.5, 0.5, 0.1, 0.2]),
    poinsot.Motion([1.0, 2.0, 9.0], [0.1, 2.0, 0.3], allow_unphysical=True),
    poinsot.Motion([1.0, 2.0, 2.5], [0.1, 2.0, 0.3], method="rk4", step_s=0.01, span_s=(0.0, 5.0)),
    poinsot.Motion.heavy_top(1.0, 0.5, 2.0, theta_rad=0.5, omega3_rad_s=20.0, phi_dot_rad_s=0.1),
    *(poinsot.Motion([1.0, 2.0, 2.5], [0.1, 2.0, 0.3], method="rk4", step_s=0.01, span_s=(0.0, 5.0), torque=torque) for torque in TORQUES),
])
def test_the_scene_of_a_motion_has_its_digits(motion):
    times = np.linspace(0.0, 5.0, 11)
    sampled, states = poinsot.Scene(motion).sample(times), motion.at(times)
    np.testing.assert_array_equal(sampled["omega_body"], states.omega_body)
    np.testing.assert_array_equal(sampled["q"], states.space_from_body)
    np.testing.assert_allclose(sampled["herpolhode"], states.herpolhode, rtol=0, atol=1e-15)
    assert poinsot.Scene(motion).still(size=(64, 36)).pixels.any()


def test_motions_are_equal_if_all_that_they_were_made_of_is():
    given = {"moments": [1.0, 2.0, 3.0], "omega": [0.1, 2.0, 0.0]}
    motion = poinsot.Motion(**given)
    assert motion == poinsot.Motion(np.array([1, 2, 3]), (0.1, 2, 0)) and len({motion, poinsot.Motion(**given)}) == 1
    assert motion == pickle.loads(pickle.dumps(motion))
    for other in (poinsot.Motion([1.0, 2.0, 3.0], [0.1, 2.0, 1e-300]), poinsot.Motion(**given, attitude=[0.0, 1.0, 0.0, 0.0]),
                  poinsot.Motion(**given, allow_unphysical=True), "motion", None):
        assert motion != other


def test_an_attitude_may_be_a_rotation_of_scipy():
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation.from_euler("xyz", [0.1, -0.2, 2.9])
    start = poinsot.Motion([1.0, 2.0, 3.0], [0.1, 2.0, 0.0], attitude=rotation).at(0.0).space_from_body
    # SciPy's matrix of the rotation, against that of the quaternion w, x, y, z.
    w, x, y, z = start
    matrix = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
              [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
              [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    np.testing.assert_allclose(rotation.as_matrix(), matrix, rtol=0, atol=1e-15)


def test_the_constants_of_a_top_are_those_of_its_start():
    transverse, axial, mgl, theta, spin, phi_dot = 1.0, 0.5, 2.0, 0.5, 20.0, 0.3
    top = poinsot.Motion.heavy_top(transverse, axial, mgl, theta_rad=theta, omega3_rad_s=spin, phi_dot_rad_s=phi_dot)
    constants = top.top_constants
    across = phi_dot * math.sin(theta)  # ω across the axis, which lies in the plane of the axis and the vertical
    assert constants.p_phi_kg_m2_s == pytest.approx(axial * spin * math.cos(theta) + transverse * across * math.sin(theta), rel=1e-14)
    assert constants.p_psi_kg_m2_s == pytest.approx(axial * spin, rel=1e-14)
    assert constants.energy_J == pytest.approx(0.5 * (transverse * across**2 + axial * spin**2) + mgl * math.cos(theta), rel=1e-14)
    assert constants.theta_min_rad <= theta <= constants.theta_max_rad
    with pytest.raises(poinsot.InputError):
        poinsot.Motion(TRIAXIAL, OMEGA).top_constants


@pytest.mark.parametrize("make", [
    lambda: poinsot.Motion(TRIAXIAL, OMEGA, attitude=[1.0, 0.2, 0.3, 0.4]),
    lambda: poinsot.Motion([1, 1.5, 5], OMEGA, allow_unphysical=True),
    lambda: poinsot.Motion(TRIAXIAL, OMEGA, method="rk4", step_s=1e-2, span_s=(-50.0, 1234.5)),
    lambda: poinsot.Motion.heavy_top(1.0, 0.5, 2.0, theta_rad=0.5, omega3_rad_s=20.0),
], ids=["attitude", "unphysical", "stepped", "top"])
def test_a_copy_of_a_motion_has_its_digits(make):
    motion = make()
    for same in (pickle.loads(pickle.dumps(motion)), copy.copy(motion), copy.deepcopy(motion)):
        assert type(same) is poinsot.Motion and same.description == motion.description
        for one, other in ((same, motion), (pickle.loads(pickle.dumps(same)), motion)):
            np.testing.assert_array_equal(one.at(TIMES).omega_body, other.at(TIMES).omega_body)
            np.testing.assert_array_equal(one.at(TIMES).space_from_body, other.at(TIMES).space_from_body)


def test_a_copy_of_a_motion_keeps_the_start_that_its_array_had():
    omega = np.array(OMEGA)
    motion = poinsot.Motion(TRIAXIAL, omega)
    omega[:] = 9.0
    np.testing.assert_array_equal(copy.deepcopy(motion).at(0.0).omega_body, OMEGA)


@pytest.mark.parametrize("wrong, sentence", [
    (lambda m: m.polhode("a"), "tolerance: is a number, and this is 'a'"),
    (lambda m: m.flips(None, 1), "first_s: is a number, and this is None"),
    (lambda m: m.flips(0, [1, 2]), r"last_s: is a number, and this is \[1, 2\]"),
    (lambda m: m.certificate([0.0], "a"), "attitude_error_rad: is a number, and this is 'a'"),
    (lambda m: m.heavy_top(1.0, "a", 2.0, theta_rad=0.5, omega3_rad_s=20.0), "axial: is a number, and this is 'a'"),
    (lambda m: m.polhode(0), "tolerance: a share of the longest half-axis"),
    (lambda m: m.polhode(2.0), "tolerance: a share of the longest half-axis"),
    (lambda m: m.polhode(math.nan), "tolerance: a share of the longest half-axis"),
])
def test_wrong_numbers_are_refused(wrong, sentence):
    with pytest.raises(poinsot.InputError, match=sentence):
        wrong(poinsot.Motion(TRIAXIAL, OMEGA))


def test_an_array_of_which_nothing_is_masked_counts_as_its_numbers():
    times = np.ma.array(TIMES, mask=False)
    motion = poinsot.Motion(TRIAXIAL, OMEGA)
    np.testing.assert_array_equal(motion.contact(times), motion.contact(TIMES))


def test_help_says_the_units_of_each_field():
    for kind in (poinsot.Constants, poinsot.TopConstants, poinsot.Cones):
        for name in kind._fields:
            assert re.search(rf"^ +(\w+, )*{name}(, \w+)*: ", kind.__doc__, re.MULTILINE), name
    assert "rad/s, body axes" in pydoc.render_doc(poinsot.Motion.at)
