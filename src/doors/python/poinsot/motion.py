"""The motion of a rigid body, without a scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Tuple, Type

from numpy.typing import ArrayLike

from . import _poinsot
from .arrays import Numbers, number, numbers, second, seconds, w_first, whole
from .errors import InputError, shown
from .toml import unicode_text


class Constants(NamedTuple):
    """The constants of a free motion. A constant that the regime does not have is None.

    One beyond the range of a float is infinite or 0, as T is for |ω| = 1e160 rad/s. The states stay exact there.

    Source: Landau & Lifshitz, Mechanics §37; Whittaker, Analytical Dynamics §69.

    Attributes:
        kinetic_energy_J, momentum_kg_m2_s: T in J, and |L| in kg m²/s.
        momentum_space: L in space axes, kg m²/s, shape (3,).
        plane_distance: √(2T)/L, the distance of the invariable plane, 1/√(kg m²).
        half_axes: 1/√I, the half-axes of the ellipsoid, 1/√(kg m²), shape (3,).
        encircled_axis: the principal axis that the polhode encircles: 1, 2 or 3.
        modulus: k of the Jacobi functions.
        polhode_period_s: the time in s after which ω is back in body axes.
        advance_per_period_rad: the angle in rad by which ω turns about L in that time.
        precession_rad_s: mean rate of ω about L, rad/s.
        herpolhode_radii_rad_s: least and greatest |ω perpendicular to L|, rad/s.
    """

    kinetic_energy_J: float
    momentum_kg_m2_s: float
    momentum_space: Numbers
    plane_distance: float
    half_axes: Numbers
    encircled_axis: int
    modulus: float
    polhode_period_s: Optional[float]
    advance_per_period_rad: Optional[float]
    precession_rad_s: float
    herpolhode_radii_rad_s: Tuple[float, float]


class TopConstants(NamedTuple):
    """The constants of a heavy symmetric top. Source: Goldstein, Classical Mechanics §5.7.

    Attributes:
        p_phi_kg_m2_s, p_psi_kg_m2_s: L along the vertical and along the symmetry axis, kg m²/s.
        energy_J: T + Mgl cos θ, J.
        theta_min_rad, theta_max_rad: the range of the nutation, rad.
        nutation_period_s: its period in s; infinite on the separatrix.
        precession_rad_s: mean φ̇, rad/s.
    """

    p_phi_kg_m2_s: float
    p_psi_kg_m2_s: float
    energy_J: float
    theta_min_rad: float
    theta_max_rad: float
    nutation_period_s: float
    precession_rad_s: float


class Cones(NamedTuple):
    """The cones of a body with two equal moments; the body cone rolls on the space cone.

    Source: Landau & Lifshitz, Mechanics §35.

    Attributes:
        symmetry_axis: the principal axis of symmetry: 1, 2 or 3.
        body_half_angle_rad: the angle from ω to the symmetry axis, rad.
        space_half_angle_rad: the angle from ω to L, rad.
        body_precession_rad_s: Ω = (I3 − I1) ω3/I1, of ω about the symmetry axis in body axes, rad/s.
        space_precession_rad_s: L/I1, of the symmetry axis about L, rad/s.
    """

    symmetry_axis: int
    body_half_angle_rad: float
    space_half_angle_rad: float
    body_precession_rad_s: float
    space_precession_rad_s: float


@dataclass(frozen=True)
class Claim:
    """One claim of a certificate: the largest residual over all instants.

    Attributes:
        name, means: what is claimed, as a name and as a sentence.
        worst, at_time_s: the largest residual, relative, and its instant in s.
        bound: what an exact motion promises.
        holds: whether worst ≤ bound.
    """

    name: str
    means: str
    worst: float
    at_time_s: float
    bound: float
    holds: bool


_GivenTorque = Tuple[str, Tuple[Tuple[str, Tuple[float, ...]], ...]]


def _given_torque(torque: Optional[Mapping[str, Any]]) -> _GivenTorque:
    """The kind of a torque, and its numbers by name."""
    if torque is None:
        return "none", ()
    if not isinstance(torque, Mapping) or not isinstance(torque.get("kind"), str):
        raise InputError('torque: give a dict with a kind and its numbers: {"kind": "dissipation", "rate_1_s": 0.05}')
    given = ((str(name), tuple(numbers(f"torque: {name}", value).ravel().tolist())) for name, value in torque.items() if name != "kind")
    return torque["kind"], tuple(given)


class Motion:
    """The motion of a body: free and exact at any instant (Jacobi's solution by theta functions), or under a torque.

    moments: the principal moments I1, I2, I3 in kg m², shape (3,), or the inertia tensor in body
    axes, shape (3, 3). omega: ω at t = 0 in body axes, rad/s, shape (3,). attitude: space_from_body
    at t = 0 as a quaternion (w, x, y, z) of any length, or a Rotation of SciPy.

    method: "exact", or the name of a stepping method (`poinsot list methods`), with step_s,
    tolerance and order as for the scene's [motion]; span_s: the interval that it covers, in s.

    torque: what acts, as the table [torque] of a scene: {"kind": "dissipation", "rate_1_s": 0.05}, or gravity,
    constant_body, constant_space or drag with their numbers in SI units. All but gravity on a symmetric body need a
    stepping method and span_s.

    The error of a free ω is at most 8e-16 of its norm and that of the attitude 1.1e-15 rad, up to 1e15 rad
    of turning. Raises InputError for moments that no body has (unless allow_unphysical), for values
    that are not finite, and for options that the method does not have.

    >>> motion = Motion([1.0, 2.0, 3.0], [0.1, 2.0, 0.0])
    >>> motion.regime
    'elliptic, about the axis of the smallest moment'
    >>> motion.at(0.0).omega_body
    array([0.1, 2. , 0. ])
    >>> motion.at([[0.0, 1.0], [2.0, 3.0]]).space_from_body.shape
    (2, 2, 4)
    """

    # The texts are those of help(). `at` is the compiled function itself, which a call reaches sooner.
    __slots__ = {
        "_native": "the compiled motion",
        "_made": "how it was made: whether it is a top, and the arguments",
        "at": """at(times): the states at these instants.

times: in s, of any shape S. Returns an object with `.time_s` (S), `.omega_body` (S + (3,), rad/s, body axes),
`.space_from_body` (S + (4,), unit quaternion (w, x, y, z)) and `.herpolhode` (S + (3,), ω perpendicular to L,
rad/s, space axes), and with `.rotation`, space_from_body as SciPy's Rotation, in a row for S of several dimensions.
All but this are contiguous arrays of float64. Raises InputError for instants that are not finite.""",
    }

    def __init__(
        self,
        moments: ArrayLike,
        omega: ArrayLike,
        *,
        attitude: Any = (1.0, 0.0, 0.0, 0.0),
        method: str = "exact",
        step_s: Optional[float] = None,
        tolerance: Optional[float] = None,
        order: Optional[int] = None,
        span_s: Tuple[float, float] = (0.0, 0.0),
        torque: Optional[Mapping[str, Any]] = None,
        allow_unphysical: bool = False,
    ) -> None:
        # Copies, so that the caller's later changes do not reach a copy of the motion.
        arrays = (numbers("moments", moments), numbers("omega", omega), numbers("attitude", w_first(attitude)))
        copies = tuple(array.copy() for array in arrays)
        steps = (
            None if step_s is None else second("step_s", step_s),
            None if tolerance is None else number("tolerance", tolerance),
            None if order is None else whole("order", order),
        )
        self._make(False, (*copies, unicode_text("method", method), *steps, _span(span_s), _given_torque(torque), bool(allow_unphysical)))

    def _make(self, is_top: bool, arguments: Tuple[Any, ...]) -> None:
        self._native = _poinsot.Motion.heavy_top(*arguments) if is_top else _poinsot.Motion.of_body(*arguments)
        self._made = (is_top, arguments)
        self.at = self._native.at

    def __reduce__(self) -> Tuple[Any, ...]:
        return _same_motion, (type(self), *self._made)

    @classmethod
    def heavy_top(
        cls,
        transverse: float,
        axial: float,
        mgl_N_m: float,
        *,
        theta_rad: float,
        omega3_rad_s: float,
        theta_dot_rad_s: float = 0.0,
        phi_dot_rad_s: float = 0.0,
    ) -> "Motion":
        """Lagrange's top, exact: moments about the fixed point in kg m², the potential Mgl cos θ.

        It starts at the tilt theta_rad from the upward vertical, 0 to π, φ = ψ = 0 (z-x-z Euler
        angles).
        Its `herpolhode` is ω perpendicular to the L of the instant.

        >>> Motion.heavy_top(1.0, 0.5, 2.0, theta_rad=0.5, omega3_rad_s=20.0).top_constants.theta_min_rad
        0.5
        """
        made = object.__new__(cls)
        given = {
            "transverse": transverse,
            "axial": axial,
            "mgl_N_m": mgl_N_m,
            "theta_rad": theta_rad,
            "theta_dot_rad_s": theta_dot_rad_s,
            "phi_dot_rad_s": phi_dot_rad_s,
            "omega3_rad_s": omega3_rad_s,
        }
        made._make(True, tuple(number(name, value) for name, value in given.items()))
        return made

    def as_scene(self) -> Dict[str, Any]:
        """The motion as the tables of a scene, to which a film, panels and a camera can be added; `Scene(motion)` draws it.

        >>> Motion([1.0, 2.0, 3.0], [0.1, 2.0, 0.0]).as_scene()
        {'body': {'moments_kg_m2': [1.0, 2.0, 3.0]}, 'start': {'omega_rad_s': [0.1, 2.0, 0.0], 'attitude': [1.0, 0.0, 0.0, 0.0]}}
        """
        is_top, given = self._made
        if is_top:
            transverse, axial, mgl_N_m, *start = given
            names = ("theta_rad", "theta_dot_rad_s", "phi_dot_rad_s", "omega3_rad_s")
            return {
                "body": {"moments_kg_m2": [transverse, transverse, axial]},
                "torque": {"kind": "gravity", "mgl_N_m": mgl_N_m},
                "start": dict(zip(names, start)),
                "panels": [{"kind": "top"}],
            }
        moments, omega, attitude, method, step_s, tolerance, order, _, (kind, of_torque), allow_unphysical = given
        scene: Dict[str, Any] = {
            "body": {"tensor_kg_m2" if moments.ndim == 2 else "moments_kg_m2": moments.tolist()},
            "start": {"omega_rad_s": omega.tolist(), "attitude": attitude.tolist()},
        }
        if allow_unphysical:
            scene["body"]["allow_unphysical"] = True
        if kind != "none":
            scene["torque"] = {"kind": kind, **{name: list(values) if len(values) > 1 else values[0] for name, values in of_torque}}
        chosen = {"method": method, "step_s": step_s, "tolerance": tolerance, "order": order}
        if method != "exact":
            scene["motion"] = {key: value for key, value in chosen.items() if value is not None}
        return scene

    def __eq__(self, other: object) -> bool:
        """Whether both were made from the same numbers and options: their states are the same bit for bit."""
        if not isinstance(other, Motion):
            return NotImplemented
        return self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> Tuple[Any, ...]:
        is_top, given = self._made
        return (is_top, *(one.tobytes() if hasattr(one, "tobytes") else one for one in given))

    @property
    def regime(self) -> str:
        """The kind of motion in few words, as `check()` of a scene names it."""
        return self._native.regime

    @property
    def description(self) -> str:
        """The kind of motion in one sentence, as `poinsot check` prints it."""
        return self._native.description

    @property
    def principal_axes(self) -> Numbers:
        """The principal axes e1, e2, e3 as columns, in the axes of the tensor: a rotation, shape (3, 3).

        v_body = principal_axes @ v_principal. Their order is that of `moments` and of `constants.half_axes`. With
        moments instead of a tensor they are the columns of the unit matrix.
        """
        return self._native.principal_axes

    @property
    def moments(self) -> Numbers:
        """The principal moments I1, I2, I3 in kg m², shape (3,), in the order of `principal_axes`."""
        return self._native.moments

    @property
    def omega(self) -> Numbers:
        """ω at t = 0 in body axes, rad/s, shape (3,)."""
        return self.at(0.0).omega_body

    @property
    def attitude(self) -> Numbers:
        """space_from_body at t = 0, a unit quaternion (w, x, y, z), shape (4,)."""
        return self.at(0.0).space_from_body

    @property
    def constants(self) -> Constants:
        """The constants of the motion. Raises InputError for a body at rest."""
        return Constants(**self._native.constants())

    @property
    def top_constants(self) -> TopConstants:
        """The constants of a heavy symmetric top. Raises InputError for other motions."""
        return TopConstants(**self._native.top_constants())

    @property
    def cones(self) -> Optional[Cones]:
        """The rolling cones of a body with exactly two equal moments; None for other bodies."""
        found = self._native.cones()
        return None if found is None else Cones(**found)

    @property
    def period_s(self) -> Optional[float]:
        """The polhode's period in s: the time after which ω is back in body axes; None without one."""
        return self.constants.polhode_period_s

    def polhode(self, tolerance: float = 1e-4) -> Numbers:
        """The path of the contact point on the ellipsoid: points ρ in body axes, shape (n, 3).

        1/√(kg m²). The polyline is within `tolerance` of the longest half-axis of the curve; that of
        a closed curve ends where it begins.
        """
        return self._native.polhode(number("tolerance", tolerance))

    def herpolhode(self, times: ArrayLike) -> Numbers:
        """The contact points ρ on the invariable plane, in space axes: shape S + (3,), 1/√(kg m²).

        times: in s, of any shape S.
        """
        return self._native.contact(seconds("times", times), True)

    def contact(self, times: ArrayLike) -> Numbers:
        """The contact points ρ = ω/√(2T) on the ellipsoid, in body axes: shape S + (3,), 1/√(kg m²)."""
        return self._native.contact(seconds("times", times), False)

    def flips(self, first_s: float, last_s: float) -> List[float]:
        """The instants in s between these two at which the body flips over.

        ω along the middle axis changes its sign in every elliptic motion. These instants count as
        flips only if that axis comes within 45° of L and of −L; else the list is empty.
        """
        return self._native.flips(second("first_s", first_s), second("last_s", last_s))

    def certificate(self, times: ArrayLike, attitude_error_rad: float = 1e-6) -> List[Claim]:
        """The residuals of Poinsot's construction at these instants, in s, against their bounds.

        attitude_error_rad: how exact a stepping method shall be, which is also compared with the
        exact motion.
        """
        given = seconds("times", times).ravel()
        error_rad = number("attitude_error_rad", attitude_error_rad)
        return [Claim(**claim) for claim in self._native.certificate(given, error_rad)]

    def __repr__(self) -> str:
        return f"<poinsot.Motion, {self.description}>"


def _span(given: Any) -> Tuple[float, float]:
    try:
        first, last = given
    except (TypeError, ValueError):
        raise InputError(f"span_s: {shown(given)} is not an interval; give the first and the last instant in s") from None
    return second("span_s", first), second("span_s", last)


def _same_motion(kind: Type[Motion], is_top: bool, arguments: Tuple[Any, ...]) -> Motion:
    """A motion that was copied or sent to another process."""
    same = object.__new__(kind)
    same._make(is_top, arguments)
    return same
