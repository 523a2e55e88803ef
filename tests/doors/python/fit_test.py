"""Fits of measured motions, against motions that are integrated here and against the program."""
import json
import pickle

import numpy as np
import pytest

import poinsot
from conftest import ROOT

RACKET = sorted((ROOT / "tests" / "motion" / "measured" / "racket").glob("*.csv"))[0]
RECORDING = ROOT / "tests" / "motion" / "measured" / "recording" / "round3_093502.csv"
MOMENTS = np.array([1.0, 0.7, 0.4])  # in units of I1
# The principal axes as columns, in the axes of the instrument: a turn by 0.8 rad about (1, 2, 2)/3.
AXIS = np.array([1.0, 2.0, 2.0]) / 3.0
CROSS = np.array([[0, -AXIS[2], AXIS[1]], [AXIS[2], 0, -AXIS[0]], [-AXIS[1], AXIS[0], 0]])
AXES = np.eye(3) + np.sin(0.8) * CROSS + (1 - np.cos(0.8)) * CROSS @ CROSS


def thrown(times, start, rates=(0.0, 0.0, 0.0), moments=MOMENTS):
    """ω in the axes of the instrument, by Euler's equations with torques −γ_i I_i ω_i and RK4 in small steps."""
    i1, i2, i3 = moments
    factors, rates = np.array([(i2 - i3) / i1, (i3 - i1) / i2, (i1 - i2) / i3]), np.array(rates)

    def slope(w):
        return factors * w[[1, 2, 0]] * w[[2, 0, 1]] - rates * w

    w, omegas = np.array(start, float), []
    for before, now in zip(np.concatenate([times[:1], times]), times):
        for _ in range(20):
            h = (now - before) / 20
            a = slope(w)
            b = slope(w + h / 2 * a)
            c = slope(w + h / 2 * b)
            w = w + h / 6 * (a + 2 * b + 2 * c + slope(w + h * c))
        omegas.append(w)
    return np.array(omegas) @ AXES.T


TIMES = 3.0 + np.arange(0.0, 2.5, 0.01)
NOISE = 0.02


@pytest.fixture(scope="module")
def throw():
    noise = np.random.default_rng(5).normal(0.0, NOISE, (len(TIMES), 3))
    return thrown(TIMES, [0.5, 8.0, 0.6], [0.05, 0.05, 0.05]) + noise


def up_to_sign(found, true):
    """Whether the columns are the same axes: an axis and its opposite are the same."""
    return np.abs(np.abs(np.sum(found * true, axis=0)) - 1.0).max()


@pytest.mark.parametrize("rates, model", [((0.08, 0.08, 0.08), "linear"), ((0.05, 0.2, 0.1), "axes")])
def test_rows_without_noise_give_back_the_body(rates, model):
    omega = thrown(TIMES, [0.5, 8.0, 0.6], rates)
    found = poinsot.fit(TIMES, omega)
    np.testing.assert_allclose(found.ratios, MOMENTS[1:], rtol=1e-6)
    assert up_to_sign(found.axes, AXES) < 1e-12
    assert found.drag.model == model
    np.testing.assert_allclose(found.drag.rates, rates, atol=1e-6)
    np.testing.assert_allclose(found.axes @ np.diag(found.moments) @ found.axes.T, AXES @ np.diag(MOMENTS) @ AXES.T, atol=1e-6)
    np.testing.assert_allclose(found.tensor, found.tensor.T)
    assert found.start.time_s == TIMES[0] and found.residual < 1e-6
    np.testing.assert_allclose(found.start.omega, omega[0], atol=1e-5)
    # Beyond the rows, where the fit knows nothing but the body.
    later = np.arange(TIMES[0], 8.0, 0.01)
    np.testing.assert_allclose(found.predict(later), thrown(later, [0.5, 8.0, 0.6], rates), atol=2e-3)


def test_noise_is_found_and_the_truth_lies_within_the_deviations(throw):
    found = poinsot.fit(TIMES, throw)
    assert found.n_rows == len(TIMES)
    assert found.residual == pytest.approx(NOISE, rel=0.1) and found.noise == pytest.approx(NOISE, rel=0.1)
    assert np.all(np.abs(found.ratios - MOMENTS[1:]) < 4 * found.ratios_sd) and np.all(found.ratios_sd < 0.01)
    assert abs(found.drag.rates[0] - 0.05) < 4 * found.drag.rates_sd[0]
    assert np.all(np.abs(found.start.omega - AXES @ [0.5, 8.0, 0.6]) < 4 * found.start.omega_sd)
    assert found.residuals.shape == (len(TIMES), 3)
    np.testing.assert_allclose(found.residuals, throw - found.predict(TIMES))
    assert np.linalg.det(found.axes) == pytest.approx(1.0)
    assert found.moments_sd[0] == 0.0 and np.all(found.axes_sd > 0)


def test_known_moments_leave_axes_start_and_drag(throw):
    known = poinsot.fit(TIMES, throw, moments=[0.004, 0.01, 0.007], drag="linear")
    np.testing.assert_allclose(known.moments, [0.01, 0.007, 0.004])
    np.testing.assert_array_equal(known.moments_sd, 0.0)
    assert up_to_sign(known.axes, AXES) < 1e-4
    assert "kg m², as given" in repr(known)


def test_shapes_of_predictions_and_of_the_rotation(throw):
    found = poinsot.fit(TIMES, throw)
    assert found.predict(3.5).shape == (3,) and found.predict([[3.5, 4.0]]).shape == (1, 2, 3)
    # Linear drag reaches back, too.
    np.testing.assert_allclose(found.predict([4.0, 2.0, 3.0])[2], found.start.omega)
    rotation = pytest.importorskip("scipy.spatial.transform")
    assert isinstance(found.rotation, rotation.Rotation)
    np.testing.assert_allclose(found.rotation.apply([0, 1, 0]), found.axes[:, 1], atol=1e-15)


def test_stepped_drag_is_followed_forwards_in_any_order():
    found = poinsot.fit(TIMES, thrown(TIMES, [0.5, 8.0, 0.6], [0.05, 0.2, 0.1]), drag="axes")
    order = np.array([7, 0, 200, 3])
    np.testing.assert_allclose(found.predict(TIMES[order]), found.omega[order], atol=1e-5)
    with pytest.raises(poinsot.InputError, match="before the first row"):
        found.predict(2.0)


def test_the_first_rows_predict_the_others(throw):
    made = poinsot.fit(TIMES, throw, predict=80).prediction
    assert (made.n_fitted, made.n_predicted) == (80, len(TIMES) - 80)
    assert made.rms < 10 * NOISE and made.largest[0] >= made.rms and TIMES[80] <= made.largest[1] <= TIMES[-1]
    along = throw @ AXES[:, 1]
    [flip] = np.flatnonzero((along[80:] < 0) != (along[79:-1] < 0))
    assert TIMES[79 + flip] <= made.measured_flip_s <= TIMES[80 + flip]
    assert made.flip_s[0] == pytest.approx(made.measured_flip_s, abs=4 * made.flip_s[1])
    assert made.period_s[0] == pytest.approx(poinsot.Motion(MOMENTS, [0.5, 8.0, 0.6]).period_s, rel=0.05)


@pytest.fixture(scope="module")
def throws():
    random = np.random.default_rng(11)
    starts = [[0.5, 8.0, 0.6], [0.9, -7.0, 0.4], [0.3, 9.0, -0.8]]
    return [(TIMES[:200], thrown(TIMES[:200], w, [0.05] * 3) + random.normal(0, NOISE, (200, 3))) for w in starts]


def test_several_flights_have_one_body(throws):
    joint = poinsot.fit(throws, share_drag=True, predict=20)
    assert isinstance(joint, poinsot.JointFit) and joint.n_used == 3 and len(joint.flights) == 3
    assert np.all(np.abs(joint.ratios - MOMENTS[1:]) < 4 * joint.ratios_sd)
    assert up_to_sign(joint.axes, AXES) < 1e-4
    assert joint.drag.rates[0] == pytest.approx(0.05, abs=4 * joint.drag.rates_sd[0])
    for flight, (times, omega) in zip(joint.flights, throws):
        np.testing.assert_array_equal(flight.ratios, joint.ratios)
        assert flight.left_out == "" and flight.start.omega_sd is None
        assert np.sqrt(np.mean(flight.residuals**2)) == pytest.approx(NOISE, rel=0.1)
        np.testing.assert_array_equal(flight.omega, omega)
        assert flight.prediction.rms < 20 * NOISE
        assert np.all(np.abs(flight.own.ratios - MOMENTS[1:]) < 4 * flight.own.ratios_sd)
    assert poinsot.fit(throws).drag.rates is None


def test_tables_name_their_columns(throw, tmp_path):
    pandas = pytest.importorskip("pandas")
    found = poinsot.fit(TIMES, throw)
    columns = {"Time (ms)": 1000 * TIMES, **{f"Gyroscope {x} (deg/s)": np.degrees(throw[:, k]) for k, x in enumerate("xyz")}}
    frame = pandas.DataFrame({**columns, "note": ["a\n,\"b"] * len(TIMES)})
    indexed = pandas.DataFrame({f"w{k + 1}": throw[:, k] for k in range(3)}, index=pandas.Index(TIMES, name="t"))
    file = tmp_path / "throw.csv"
    frame.drop(columns="note").to_csv(file, index=False)
    for given in (frame, indexed, file, str(file)):
        np.testing.assert_allclose(poinsot.fit(given).ratios, found.ratios, rtol=1e-9)
    with pytest.raises(poinsot.InputError, match="flights 0 and 1 hold the same rows; give each flight once"):
        poinsot.fit([frame, (TIMES, throw)])
    with pytest.raises(poinsot.InputError, match="names no column for the time"):
        poinsot.fit(frame.drop(columns="Time (ms)"))
    with pytest.raises(poinsot.InputError, match="no columns of numbers"):
        poinsot.fit(frame[["note"]])
    frame.iloc[3, 1] = np.nan
    with pytest.raises(poinsot.InputError, match="the cell is empty"):
        poinsot.fit(frame)


def test_attitudes_are_fitted_themselves(tmp_path):
    motion = poinsot.Motion([3.0, 2.0, 1.0], [1.0, 6.0, 2.0])
    times = np.arange(0.0, 8.0, 1.0 / 30.0)
    attitude = motion.at(times).space_from_body
    found = poinsot.fit(times, attitude=attitude)
    np.testing.assert_allclose(found.ratios, [2.0 / 3.0, 1.0 / 3.0], rtol=1e-7)
    assert found.drag.model == "linear" and found.measured == "attitude" and "rad a component" in repr(found)
    np.testing.assert_allclose(found.predict(times), motion.at(times).omega_body, atol=1e-5)
    assert found.attitude.shape == (240, 4) and found.residuals.shape == (240, 3)
    assert "the table has no ω, so that its attitudes are fitted" in found.notes
    # The scene begins with the fitted attitude, and its table has no ω that nobody measured.
    scene = found.scene(tmp_path / "filmed.toml")
    assert scene.departure(times, attitude=attitude)["attitude_rad"].max() < 1e-6
    again = poinsot.fit(tmp_path / "filmed.csv")
    assert again.measured == "attitude"
    np.testing.assert_allclose(again.ratios, found.ratios, rtol=1e-9)
    [flight] = poinsot.flights(times, attitude=attitude)
    assert flight.measured == "attitude" and poinsot.fit(flight).measured == "attitude"
    halves = [{"time": times[part], **dict(zip(("q_w", "q_x", "q_y", "q_z"), attitude[part].T))} for part in (slice(150), slice(150, None))]
    joint = poinsot.fit(halves)
    np.testing.assert_allclose(joint.ratios, [2.0 / 3.0, 1.0 / 3.0], rtol=1e-7)
    assert found.chart().svg.count("<svg") == 1


def turns(rotations, rotation_of):
    """The turns from measured to computed attitudes as one row of numbers."""
    return (rotations.inv() * rotation_of).as_rotvec().ravel()


def attitudes_of(numbers, times, rotation):
    """By the classical Runge-Kutta method, of ln I2, ln I3, the principal axes, ω and the first attitude."""
    axes, start = rotation.from_rotvec(numbers[2:5]), rotation.from_rotvec(numbers[8:11])
    moments = np.exp([0.0, numbers[0], numbers[1]])
    ratios = (np.roll(moments, -1) - np.roll(moments, -2)) / moments

    def slope(state):
        w, q, v = state[:3], state[3], state[4:]
        return np.concatenate([ratios * np.roll(w, -1) * np.roll(w, -2), [-0.5 * v @ w], 0.5 * (q * w + np.cross(v, w))])

    first = (start * axes).as_quat()
    state = np.concatenate([axes.inv().apply(numbers[5:8]), first[3:], first[:3]])
    states = [state]
    for step in np.diff(times) / 4:
        for _ in range(4):
            a = slope(state)
            b = slope(state + 0.5 * step * a)
            c = slope(state + 0.5 * step * b)
            state = state + step / 6 * (a + 2 * b + 2 * c + slope(state + step * c))
        states.append(state)
    made = np.array(states)
    return rotation.from_quat(made[:, [4, 5, 6, 3]]) * axes.inv()


def test_attitudes_give_what_scipy_finds():
    optimize = pytest.importorskip("scipy.optimize")
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    times = np.arange(0.0, 4.0, 1.0 / 30.0)
    exact = poinsot.Motion([3.0, 2.0, 1.0], [1.0, 6.0, 2.0]).at(times).space_from_body
    noise = rotation.from_rotvec(np.random.default_rng(3).normal(0.0, 0.002, (len(times), 3)))
    measured = rotation.from_quat(exact[:, [1, 2, 3, 0]]) * noise
    found = poinsot.fit(times, attitude=measured, drag="none")
    near = np.concatenate([np.log([0.68, 0.32]), [0.01, -0.01, 0.01], [1.02, 5.95, 2.03], [0.01, 0.01, -0.01]])
    theirs = optimize.least_squares(lambda x: turns(measured, attitudes_of(x, times, rotation)), near, xtol=1e-12, ftol=1e-12)
    np.testing.assert_allclose(found.ratios, np.exp(theirs.x[:2]), rtol=1e-5)
    np.testing.assert_allclose(found.start.omega, theirs.x[5:8], rtol=1e-5)
    assert found.residual == pytest.approx(np.sqrt(np.mean(theirs.fun**2)), rel=1e-5)
    sd = np.sqrt(np.diag(np.linalg.inv(theirs.jac.T @ theirs.jac))[:2] * np.sum(theirs.fun**2) / (len(theirs.fun) - 11))
    np.testing.assert_allclose(found.ratios_sd, found.ratios * sd, rtol=0.1)


def test_a_residual_is_the_root_mean_square_of_the_residuals(throw, throws):
    for found in (poinsot.fit(TIMES, throw), poinsot.fit(throws).flights[0]):
        assert found.residual == pytest.approx(np.sqrt(np.mean(found.residuals**2)), rel=1e-9)


def test_a_scene_of_a_fit_has_its_motion(throw, tmp_path):
    found = poinsot.fit(TIMES, throw, drag="none")
    scene = found.scene()
    np.testing.assert_allclose(scene.sample(TIMES)["omega_body"], found.predict(TIMES), atol=1e-9)
    shown = found.scene(tmp_path / "throw.toml")
    assert shown.check()["measured_rows"] == len(TIMES)
    assert shown.departure(TIMES, throw).rms["omega_rad_s"] == pytest.approx(np.sqrt(3) * found.residual, rel=0.02)
    again = poinsot.fit(tmp_path / "throw.csv", drag="none")
    np.testing.assert_array_equal(again.omega, throw)
    found.scene(tmp_path / "throw.toml")  # the same rows again
    shorter = poinsot.fit(TIMES[:-1], throw[:-1])
    shorter.scene(tmp_path / "throw.toml")  # other rows of the same scene
    for mine in (b"mine", (tmp_path / "throw.csv").read_bytes() + b"9,1,1,1\n"):
        (tmp_path / "throw.csv").write_bytes(mine)
        with pytest.raises(poinsot.InputError, match="throw.csv: exists and is not as poinsot wrote it"):
            shorter.scene(tmp_path / "throw.toml")
        assert (tmp_path / "throw.csv").read_bytes() == mine
    with pytest.raises(poinsot.InputError, match="end its name in .toml"):
        found.scene(tmp_path / "throw.txt")


def test_the_program_finds_the_same(program):
    found, said = poinsot.fit(RACKET), json.loads(program("fit", RACKET, "--json"))
    assert found.notes == notes_in(program("fit", RACKET)) and "larger than the noise" in found.notes[0]
    np.testing.assert_allclose(found.moments, said["moments"], rtol=1e-14)
    np.testing.assert_allclose(found.moments_sd, said["moments_sd"], rtol=1e-14)
    np.testing.assert_allclose(found.axes, said["axes"], atol=1e-14)
    assert found.drag.model == said["drag"] and found.residual == pytest.approx(said["residual_rad_s"], rel=1e-14)


def notes_in(said):
    return [line[len("note: "):] for line in said.decode().splitlines() if line.startswith("note: ")]


def test_a_throw_is_fitted_whole_and_a_hand_is_left_out(program, tmp_path):
    whole = poinsot.fit(RACKET)
    times, omega = whole.times, whole.omega
    assert len(times) == len(RACKET.read_text().splitlines()) - 1
    # A hand stops it within a tenth of a second, and swings it.
    later = times[-1] + 0.01 * np.arange(1, 31)
    left = np.clip(1 - (later - times[-1]) / 0.1, 0, 1)[:, None] ** 2
    swing = np.sin(9 * later[:, None] + np.arange(3)) * (1 - left)
    table = np.column_stack([np.r_[times, later], np.r_[omega, omega[-1] * left + 3 * swing]])
    file = tmp_path / "caught.csv"
    np.savetxt(file, table, delimiter=",", header="t,wx,wy,wz", comments="", fmt="%.17g")
    caught, said = poinsot.fit(file), json.loads(program("fit", str(file), "--json"))
    assert 0.9 * len(times) < len(caught.times) <= len(times) + 3
    assert caught.notes[0].startswith(f"{len(caught.times)} of {len(table)} rows are fitted, from ")
    assert caught.notes == notes_in(program("fit", str(file)))
    np.testing.assert_allclose(caught.moments, said["moments"], rtol=1e-14)
    np.testing.assert_allclose(caught.ratios, whole.ratios, atol=0.02)
    # Of many flights, the one that the program takes.
    best, said = poinsot.fit(RECORDING), json.loads(program("fit", str(RECORDING), "--json"))
    np.testing.assert_allclose(best.moments, said["moments"], rtol=1e-14)
    assert f"flight {said['flight']} of {len(said['flights'])}" in best.notes[0]


def test_the_flights_of_a_recording_are_found():
    found = poinsot.flights(RECORDING)
    assert len(found) > 20
    for flight, later in zip(found, found[1:]):
        assert flight.times[-1] < later.times[0]
        assert flight.omega.shape == (len(flight), 3) and flight.attitude is None
        assert flight.rate == pytest.approx(np.sqrt(np.mean(np.sum(flight.omega**2, axis=1))))
    assert poinsot.fit(found[3]).n_rows == len(found[3])
    assert poinsot.fit(found[:3], drag="linear").n_used == 3


@pytest.mark.parametrize("make, sentence", [
    (lambda t, w: poinsot.fit(t[:20], w[:20]), "20 rows say too little about a motion; give 30 or more"),
    (lambda t, w: poinsot.fit(t, w[:-1]), r"omega: give an array of shape \(250, 3\)"),
    (lambda t, w: poinsot.fit(t, w[:, :2]), r"omega: give an array of shape \(250, 3\)"),
    (lambda t, w: poinsot.fit(t[::-1], w), "times: row 1 does not come after the row before it"),
    (lambda t, w: poinsot.fit(t, np.where(t[:, None] > 4, np.nan, w)), "omega: row 101 is not finite"),
    (lambda t, w: poinsot.fit(t), "omega: is missing"),
    (lambda t, w: poinsot.fit([], []), "times: there is no row"),
    (lambda t, w: poinsot.fit([(t, w)]), "a list of 1 flights; give two or more"),
    (lambda t, w: poinsot.fit([(t, w), (t, w[:9])]), "flight 1: omega: give an array"),
    (lambda t, w: poinsot.fit([(t, w), 3]), "flight 1: is a table"),
    (lambda t, w: poinsot.fit("no.csv"), "no.csv: cannot be read"),
    (lambda t, w: poinsot.fit(t, w, drag="air"), "drag: is 'air'; choose one of none, linear"),
    (lambda t, w: poinsot.fit(t, w, drag=3), "drag: is the name of a model"),
    (lambda t, w: poinsot.fit(t, np.tile([4.4, 7.1, 8.5], (len(t), 1))), "do not determine the moments"),
    (lambda t, w: poinsot.fit(t, w, moments=[1, 2]), "moments: give the three principal moments"),
    (lambda t, w: poinsot.fit(t, w, moments=[1, 2, -3]), "moments: give three positive numbers"),
    (lambda t, w: poinsot.fit(t, w, moments=[1, 3, 1]), "moments: no rigid body has these moments, since 1"),
    (lambda t, w: poinsot.fit(t, w, share_drag=True), "share_drag: one flight"),
    (lambda t, w: poinsot.fit(t, w, predict=0), "predict 0: give the number of rows"),
    (lambda t, w: poinsot.fit(t, w, predict=250), "predict 250: 250 rows are fitted of 250"),
    (lambda t, w: poinsot.fit(t, w, predict=2.5), "predict: is a whole number"),
    (lambda t, w: poinsot.fit(t, w).predict(float("nan")), "times: an instant is not finite"),
    (lambda t, w: poinsot.fit(t, attitude=np.ones((250, 4))), "has not the length 1"),
    (lambda t, w: poinsot.flights(t), "omega: is missing"),
    (lambda t, w: poinsot.flights(t, w[:3]), "omega: give an array"),
])
def test_wrong_rows_are_refused_with_one_line(throw, make, sentence):
    with pytest.raises(poinsot.InputError, match=sentence) as caught:
        make(TIMES, throw)
    assert "\n" not in str(caught.value)


def test_results_say_themselves_in_two_lines_and_can_be_sent(throw, throws):
    single, joint = poinsot.fit(TIMES, throw), poinsot.fit(throws)
    [flight] = poinsot.flights(TIMES, throw)
    departure = poinsot.Scene("generic").departure(TIMES, throw)
    motion = poinsot.Motion(MOMENTS, [0.5, 8.0, 0.6])
    for held in (single, joint, flight, departure, motion.at(1.0), motion.at(TIMES)):
        assert len(repr(held).splitlines()) == 2 and repr(held).startswith("<poinsot."), held
    assert "I3/I1 = 0.3998" in repr(single) and "3 flights of one body" in repr(joint)
    assert "250 instants from 3 to 5.49 s" in repr(motion.at(TIMES)) and "omega_body (250, 3)" in repr(motion.at(TIMES))
    for held in (single, joint):
        same = pickle.loads(pickle.dumps(held))
        np.testing.assert_array_equal(same.tensor, held.tensor)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(single)).predict(TIMES), single.predict(TIMES))
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(departure))["omega_rad_s"], departure["omega_rad_s"])


def test_a_departure_is_that_of_the_program(program, tmp_path):
    file, table = ROOT / "scenes" / "generic.toml", tmp_path / "rk4.csv"
    table.write_bytes(program("sample", file, "--times", "0:5:0.05", "--set", "motion.method=rk4", "--set", "motion.step_s=0.1"))
    said = json.loads(program("check", file, "--against", table, "--json", "--tolerance", "1 rad"))
    scene = poinsot.Scene(file)
    found = scene.departure(table)
    assert said["rows"] == len(found["time_s"])
    names = [name for name in found if name not in ("time_s", "omega_rad_s")]
    assert names == [name for name, value in said.items() if isinstance(value, dict)]
    for name in names:
        assert found.largest[name] == (said[name]["largest"], said[name]["at_s"])
        assert found[name][-1] == said[name]["last"]
    assert found.rms["omega_share"] == pytest.approx(np.sqrt(np.mean(found["omega_share"] ** 2)))
    exact = scene.sample(found["time_s"])
    np.testing.assert_allclose(found["omega_rad_s"], found["omega_share"] * np.linalg.norm(exact["omega_body"], axis=1), rtol=1e-12)


def test_a_departure_takes_omega_attitudes_or_both():
    scene, times = poinsot.Scene("generic"), np.linspace(0.0, 5.0, 11)
    omega, q = (scene.sample(times)[name] for name in ("omega_body", "q"))
    turned = scene.departure(times, attitude=q)
    assert list(turned) == ["time_s", "attitude_rad"] and turned["attitude_rad"].max() < 1e-7
    assert "attitude_rad" not in scene.departure(times, omega)
    np.testing.assert_allclose(scene.departure(times, 1.01 * omega, attitude=q)["omega_share"], 0.01, rtol=1e-12)
    for wrong in (lambda: scene.departure(times), lambda: scene.departure(times, omega[:-1]), lambda: scene.departure(times, attitude=2 * q),
                  lambda: scene.departure([], np.zeros((0, 3))), lambda: scene.departure([0.0, np.nan], omega[:2])):
        with pytest.raises(poinsot.InputError):
            wrong()


def test_a_fit_shows_its_chart(throw, throws, tmp_path):
    found = poinsot.fit(TIMES, throw)
    chart = found.chart()
    assert found._repr_svg_() == chart.svg and chart.svg.startswith("<?xml") and chart.pdf.startswith(b"%PDF-")
    chart.save(tmp_path / "chart.pdf")
    joint = poinsot.fit(throws)
    assert joint._repr_svg_().startswith("<?xml")
    assert len(joint._repr_svg_()) < 1_000_000
    known = poinsot.fit(TIMES, throw, moments=[0.004, 0.01, 0.007])
    assert known.chart().svg != chart.svg


def test_the_package_shows_its_own_names_only():
    assert dir(poinsot) == sorted(poinsot.__all__)
    assert not [name for name in dir(poinsot) if name.startswith("_") and name != "__version__"]
    for name in poinsot.__all__:
        assert getattr(poinsot, name) is not None
