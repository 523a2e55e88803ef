"""The body behind a measured ω(t): ratios of moments, principal axes, start and drag, by least squares."""

from __future__ import annotations

import hashlib
import math
import os
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from . import _poinsot
from .arrays import Numbers, numbers, seconds, whole
from .errors import InputError, shown
from .paths import Path, path_text
from .pictures import Figure, write_file
from .recordings import Flight, is_table, rows_of
from .scene import Scene
from .toml import unicode_text


class Start(NamedTuple):
    """Where a fitted motion starts.

    Attributes:
        time_s: the instant of the first row, s.
        omega: ω then, rad/s, in the axes of the instrument, shape (3,).
        omega_sd: its standard deviations, rad/s, shape (3,); None for a flight of a joint fit.
    """

    time_s: float
    omega: Numbers
    omega_sd: Optional[Numbers]


class Drag(NamedTuple):
    """The torque of the air along the principal axes, for principal moments I_i.

    Attributes:
        model: "none"; "linear": −γ L; "axes": −γ_i I_i ω_i; "quadratic": −γ_i I_i |ω_i| ω_i; "growing":
            −γ e^(κt) L, t from the first row on.
        rates: γ_i in 1/s, for the quadratic drag in 1/rad; three times the same for the linear one; γ, κ and 0 for
            the growing one, in 1/s. Shape (3,); None for a joint fit whose flights have a drag each.
        rates_sd: their standard deviations; None where they are not known.
    """

    model: str
    rates: Optional[Numbers]
    rates_sd: Optional[Numbers]


class Prediction(NamedTuple):
    """What the first rows of a flight predict for the others.

    Attributes:
        n_fitted, n_predicted: the number of rows that were fitted, and of the others.
        residual: in the fitted rows, the root mean square of a component, rad/s; where attitudes are fitted, rad.
        rms: in the other rows, the root mean square of |ω − predicted|, rad/s, or of the angle to the predicted
            attitude, rad.
        largest: the largest of these, and its instant in s.
        period_s: the time in which ω returns in body axes, and its standard deviation, s; None on the separatrix.
        measured_period_s: the same by a fit of all rows.
        flip_s: the first instant after the fitted rows at which ω along e2 changes its sign, and its standard
            deviation, s; None if there is none.
        measured_flip_s: the same between two rows; None if it comes after the last row.
    """

    n_fitted: int
    n_predicted: int
    residual: float
    rms: float
    largest: Tuple[float, float]
    period_s: Optional[Tuple[float, float]]
    measured_period_s: Optional[float]
    flip_s: Optional[Tuple[float, float]]
    measured_flip_s: Optional[float]


class _Body:
    """What a fit says about the body."""

    def __init__(self, found: Dict[str, Any]) -> None:
        self._found = found

    @property
    def moments(self) -> Numbers:
        """I1 ≥ I2 ≥ I3, shape (3,): in kg m² if they were given, else in units of I1, since ω(t) says no more."""
        return np.asarray(self._found["moments"] * (self._found["I1_kg_m2"] or 1.0))

    @property
    def moments_sd(self) -> Numbers:
        """Their standard deviations, shape (3,): the first is 0, and all of them if the moments were given."""
        return np.asarray(self._found["moments_sd"] * (self._found["I1_kg_m2"] or 1.0))

    @property
    def ratios(self) -> Numbers:
        """I2/I1 and I3/I1, shape (2,)."""
        return np.asarray(self._found["moments"][1:])

    @property
    def ratios_sd(self) -> Numbers:
        """Their standard deviations, shape (2,)."""
        return np.asarray(self._found["moments_sd"][1:])

    @property
    def axes(self) -> Numbers:
        """The principal axes e1, e2, e3 as columns, in the axes of the instrument: a rotation, shape (3, 3).

        v_instrument = axes @ v_principal.
        """
        return np.asarray(self._found["axes"])

    @property
    def axes_sd(self) -> Numbers:
        """The standard deviations of turns of the axes about e1, e2, e3, rad, shape (3,)."""
        return np.asarray(self._found["axes_sd"])

    @property
    def rotation(self) -> Any:
        """`axes` as a scipy.spatial.transform.Rotation, from principal axes to those of the instrument; needs SciPy."""
        from scipy.spatial.transform import Rotation

        return Rotation.from_matrix(self.axes)

    @property
    def tensor(self) -> Numbers:
        """The inertia tensor in the axes of the instrument, shape (3, 3), in the unit of `moments`."""
        made = self.axes @ np.diag(self.moments) @ self.axes.T
        return np.asarray((made + made.T) / 2)

    @property
    def drag(self) -> Drag:
        """The torque of the air: model, rates and their standard deviations."""
        found = self._found
        return Drag(found["drag"], found["drag_rates"], found["drag_rates_sd"])

    @property
    def residual(self) -> float:
        """The root mean square of a component of the residuals: rad/s of ω, or rad where attitudes were fitted."""
        return float(self._found["residual"])

    @property
    def n_rows(self) -> int:
        """The number of rows that were used."""
        return int(self._found["n_rows"])

    def chart(self) -> Figure:
        """Measured and fitted ω with the residuals below, in the axes of the instrument, as `poinsot fit --chart`.

        Of several flights also the ratios of the moments of each flight alone, with their standard deviations, and
        those of all: a line between dashed ones at its deviation. Raises InputError if the motion does not reach a row.
        """
        title, flights, together = self._charted()
        svg = _poinsot.fit_chart(title, flights, together, "svg").decode("utf-8")
        return Figure(svg, lambda: _poinsot.fit_chart(title, flights, together, "pdf"))

    def _charted(self) -> Tuple[str, List[Any], Optional[Dict[str, Any]]]:
        raise NotImplementedError

    def _title(self) -> str:
        if self._found["I1_kg_m2"] is not None:
            return "the moments are given"
        two = [with_sd(value, sd) for value, sd in zip(self.ratios, self.ratios_sd)]
        return f"$I_2/I_1$ = {two[0]}, $I_3/I_1$ = {two[1]}"

    def _repr_svg_(self) -> str:
        return self.chart().svg

    def _body_words(self) -> str:
        if self._found["I1_kg_m2"] is not None:
            return "moments {:.4g}, {:.4g}, {:.4g} kg m², as given".format(*self.moments)
        two = [with_sd(value, sd) for value, sd in zip(self.ratios, self.ratios_sd)]
        return f"I2/I1 = {two[0]}, I3/I1 = {two[1]}"


class Fit(_Body):
    """The motion of a rigid body, free but for the air, that `fit` found behind measured rows.

    Standard deviations are those that the residuals imply, as large and as alike from row to row as they are.

    Attributes:
        times, omega, attitude: the fitted rows: s, shape (n,); rad/s, axes of the instrument, shape (n, 3); unit
            quaternions, shape (n, 4), or None.
        measured: what was fitted of them: "omega", or "attitude" where ω follows from the differences of the attitudes.
        prediction: with predict=N, what the first N rows predict for the others; else None.
        left_out: of a flight of a joint fit: why it does not count; "" if it counts.
        own: of a flight of a joint fit: its fit alone; None if its rows alone do not tell the body.
        notes: what the reader must know, a sentence each, as the notes of `poinsot fit`: moments or axes that the rows
            do not tell, a residual that is not noise, gaps, values at the limit of the sensor. Of a flight of a joint
            fit: empty; those of its fit alone are in `own`.
    """

    def __init__(
        self,
        found: Dict[str, Any],
        times: Numbers,
        omega: Numbers,
        attitude: Optional[Numbers],
        measured: str = "omega",
    ) -> None:
        super().__init__(found)
        self.measured = measured
        self.times = times
        self.omega = omega
        self.attitude = attitude
        self.prediction = _prediction_of(found.get("prediction"))
        self.left_out = str(found.get("left_out", ""))
        self.notes: List[str] = list(found.get("notes", []))
        own = found.get("own")
        self.own: Optional[Fit] = None if own is None else Fit(own, times, omega, attitude, measured)

    @property
    def start(self) -> Start:
        """The first instant and ω then, with its standard deviations."""
        found = self._found
        return Start(found["first_time_s"], found["omega"], found["omega_sd"])

    @property
    def noise(self) -> Optional[float]:
        """How far a component scatters from row to row, in the unit of `residual`; a larger `residual` says that the body was not free.

        None for a flight of a joint fit.
        """
        noise: Optional[float] = self._found["noise"]
        return noise

    @property
    def residuals(self) -> Numbers:
        """Measured less fitted at all rows, in the axes of the instrument, shape (n, 3).

        ω in rad/s or, where attitudes were fitted, the turn from the fitted attitude to the measured one in rad.
        """
        return np.asarray(_poinsot.fitted_residuals(self._found, self.times, self.omega, self.attitude))

    def predict(self, times: Any) -> Numbers:
        """ω of the fitted motion at these instants: rad/s, in the axes of the instrument, shape S + (3,).

        times: in s, of any shape S. Motions without drag or with linear drag reach every instant; the others are
        followed from the first row on. Raises InputError for instants before it, and for those that are not finite.
        """
        instants = seconds("times", times)
        return _poinsot.fitted_omega(self._found, instants.ravel()).reshape(instants.shape + (3,))

    def scene(self, path: Optional[Path] = None) -> Scene:
        """A scene of the motion and its drag, as `poinsot fit -o NAME.toml` writes it.

        With drag, the scene's times begin at the first row, since a motion under drag cannot be followed far back.
        The drag is left out, as a comment of the scene says, if it does not differ from 0 or a rate is negative.

        With a path, NAME.toml, the scene is a file, with a table of the rows in NAME.csv beside it: then pictures
        show the measured points. Raises InputError for another suffix, and if NAME.csv exists and is not the table
        of an earlier NAME.toml; EnvironmentError if a file cannot be written.
        """
        if path is None:
            return Scene(self._scene_text("")[0])
        name = path_text(path)
        stem, suffix = os.path.splitext(name)
        if suffix.lower() != ".toml":
            raise InputError(f"{name}: a scene is a file in TOML; end its name in .toml")
        table = stem + ".csv"
        rows = self._table_bytes(self._scene_text("")[1])
        text, _ = self._scene_text(os.path.basename(table), hashlib.sha256(rows).hexdigest())
        _poinsot.check_rows_place(table, name, rows)
        write_file(table, rows)
        write_file(name, text.encode("utf-8"))
        return Scene(name if os.path.dirname(name) else os.path.join(os.curdir, name))

    def _charted(self) -> Tuple[str, List[Any], Optional[Dict[str, Any]]]:
        return self._title(), [(self._found, self.times, self.omega, self.attitude, False, None)], None

    def _scene_text(self, table: str, table_sha256: str = "") -> Tuple[str, float]:
        attitude = self._found["attitude"]
        if attitude is None and self.attitude is not None:
            attitude = self.attitude[0]
        words = [f"{self._body_words()}, drag: {self._found['drag']}", self._row_words()]
        return _poinsot.fitted_scene(self._found, words, float(self.times[-1]), attitude, table, table_sha256)

    def _table_bytes(self, zero_s: float) -> bytes:
        head = "time_s"
        columns = [self.times[:, np.newaxis] - zero_s]
        if self.measured == "omega":
            head += ",omega_x_rad_s,omega_y_rad_s,omega_z_rad_s"
            columns.append(self.omega)
        if self.attitude is not None:
            head += ",q_w,q_x,q_y,q_z"
            columns.append(self.attitude)
        rows = np.concatenate(columns, axis=1)
        return "\n".join([head, *(",".join(repr(float(value)) for value in row) for row in rows), ""]).encode("utf-8")

    def _row_words(self) -> str:
        span = f"{len(self.times)} rows from {self.start.time_s:.6g} to {self.times[-1]:.6g} s"
        return f"{span}, residual {self.residual:.3g} {self._found['unit']} a component"

    def __repr__(self) -> str:
        return f"<poinsot.Fit: {self._body_words()}, drag: {self._found['drag']}\n {self._row_words()}>"


class JointFit(_Body):
    """One body behind several flights, each with a start of its own.

    Its standard deviations are the larger of those that the residuals within the flights imply and those that the
    scatter from flight to flight implies (the jackknife of three or more flights).

    Attributes:
        flights: a `Fit` for each flight, with the body of all: its start, drag, residuals, `predict` and `scene`;
            `left_out` says why a flight does not count, and `own` is its fit alone.
    """

    def __init__(self, found: Dict[str, Any]) -> None:
        super().__init__(found)
        self.flights = [Fit(one, **one.pop("rows")) for one in found["flights"]]

    @property
    def n_used(self) -> int:
        """The number of flights that count."""
        return int(self._found["n_used"])

    def _charted(self) -> Tuple[str, List[Any], Optional[Dict[str, Any]]]:
        is_known = self._found["I1_kg_m2"] is not None
        held = []
        for one in self.flights:
            own = None if is_known or one.own is None else one.own._found
            held.append((one._found, one.times, one.omega, one.attitude, bool(one.left_out), own))
        return self._title(), held, None if is_known else self._found

    def __repr__(self) -> str:
        left_out = len(self.flights) - self.n_used
        return (
            f"<poinsot.JointFit: {self._body_words()}, drag: {self._found['drag']}\n"
            f" {self.n_used} flights of one body, {left_out} left out, residual {self.residual:.3g} {self._found['unit']}>"
        )


def fit(
    times: Any,
    omega: Any = None,
    *,
    attitude: Any = None,
    moments: Any = None,
    drag: Optional[str] = None,
    share_drag: bool = False,
    predict: Optional[int] = None,
) -> Any:
    """The body behind a measured ω(t), by least squares on the exact motion; as `poinsot fit`.

    times: s, shape (n,), increasing; omega: rad/s, in the axes of the instrument, shape (n, 3); attitude: space from
    body as unit quaternions (w, x, y, z), shape (n, 4), which are fitted where ω is missing. In
    place of these, `times` may be a table with named columns, such as time, omega_x, omega_y, omega_z (a DataFrame of
    pandas or polars, a dict, a record array, or the path of a CSV file), or a flight that `flights` found. Times may
    also be differences of dates (Timedelta). Returns a `Fit`.

    Where the rows are not one free motion, as those of a recording with walking and catching, the flight among them
    that says most about the body is fitted: the result holds its rows, and `notes` says which.

    A list of tables, flights or tuples (times, omega) holds several flights of one body. Returns a `JointFit`; with
    share_drag, all flights have the same drag.

    moments: the principal moments in kg m², shape (3,), in any order, if they are known; then only axes, start and
    drag are fitted. drag: "none", "linear", "axes", "quadratic" or "growing" (`help(poinsot.Drag)`); None: linear
    where this describes the rows to their noise, else the best of the three others. predict: also fits the first rows alone, this many,
    and says how far the others depart; for several flights, with the body of the others.

    The closed form is Jacobi's; with the torque −γL, ω(t) = e^(−γt) ω_free((1 − e^(−γt))/γ). Ctrl-C ends the fit.
    Raises InputError for fewer than 30 rows, a body at rest, rows too far apart to follow the turning, a turn about
    one axis, which says nothing about the other moments, motions that no rigid body makes, moments that none has, and
    two flights that hold the same rows.

    >>> import numpy as np
    >>> from poinsot import Motion
    >>> t = np.linspace(0.0, 8.0, 400)
    >>> found = fit(t, Motion([3.0, 2.0, 1.0], [0.3, 6.0, 0.2]).at(t).omega_body)
    >>> found.ratios.round(6)
    array([0.666667, 0.333333])
    """
    known = None if moments is None else numbers("moments", moments)
    if drag is not None and not isinstance(drag, str):
        raise InputError(f"drag: is the name of a model, and this is {shown(drag)}")
    model = None if drag is None else unicode_text("drag", drag)
    n_first = None if predict is None else whole("predict", predict)
    is_list = omega is None and attitude is None and isinstance(times, (list, tuple))
    if not is_list:
        if share_drag:
            raise InputError("share_drag: one flight shares its drag with none; give a list of flights")
        rows = rows_of(times, omega, attitude)
        found = _poinsot.fit(*rows, isinstance(times, (Flight, Fit)), known, model, n_first)
        return Fit(found, **found.pop("rows"))
    held = [_rows_in_list(place, one) for place, one in enumerate(times)]
    if len(held) < 2:
        raise InputError(f"times: a list of {len(held)} flights; give two or more, or times and omega of one flight")
    return JointFit(_poinsot.fit_together(held, known, model, bool(share_drag), n_first))


def _rows_in_list(place: int, given: Any) -> Any:
    if is_table(given):
        return rows_of(given)
    if isinstance(given, (list, tuple)) and len(given) == 2:
        return rows_of(*given)
    raise InputError(
        f"flight {place}: is a table, a flight of poinsot.flights or a tuple (times, omega), and this is of type "
        f"{type(given).__name__}"
    )


def _prediction_of(found: Optional[Dict[str, Any]]) -> Optional[Prediction]:
    return None if found is None else Prediction(**found)


def with_sd(value: float, sd: float) -> str:
    """A number and its standard deviation, with as many decimals as this has a say in."""
    if not sd > 1e-15 or not abs(value) < 1e9:
        return f"{value:.10g} ± {sd:.2g}"
    decimals = min(max(1 - math.floor(math.log10(sd)), 0), 15)
    return f"{value:.{decimals}f} ± {sd:.{decimals}f}"
