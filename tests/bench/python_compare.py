#!/usr/bin/env python3
"""Compares the Python package with what Python users have: the tables of docs/speed.md, "In Python".

    PYTHONPATH=build/release/python /usr/bin/python3 tests/bench/python_compare.py [motion] [calls] [pictures] [sizes]

motion:   scipy's solve_ivp (DOP853), Runge-Kutta of order 4 in NumPy and in Numba, and poinsot: the largest error against the
          reference motions of tests/motion/mechanics/reference/, and the time an instant.
calls:    what one call of the package takes.
pictures: a frame of Poinsot's construction by matplotlib, VTK (under Xvfb if there is no display) and poinsot.
sizes:    what a notebook stores for each kind of output.
Times are CPU times of all threads, medians over repeats, all in one run. What is not installed is left out. Not part of CI.
"""
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import poinsot

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = {"generic_near_mid": "generic, 50 s", "near_sep_1e-4": "1e-4 rad/s from the middle axis, 120 s",
         "near_sep_1e-30": "1e-30 rad/s from it, 500 s", "long_1e9_periods": "generic, 1e9 and 1e15 s"}
STEP_S = 0.01  # of the Runge-Kutta methods


def cpu_s(function, repeats=7, longest_s=2.0):
    """Median CPU time of a call; fewer repeats of calls that take long."""
    times = []
    while len(times) < repeats and (not times or sum(times) < longest_s):
        start = time.process_time()
        function()
        times.append(time.process_time() - start)
    return statistics.median(times)


def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


def short(seconds):
    for unit, factor in (("s", 1.0), ("ms", 1e3), ("µs", 1e6)):
        if seconds * factor >= 1.0:
            break
    else:
        unit, factor = "ns", 1e9
    return f"{float(f'{seconds * factor:.2g}'):g} {unit}"


# --- Motion ---------------------------------------------------------------------------------------


def derivative_of(moments):
    I1, I2, I3 = (float(moment) for moment in moments)
    c1, c2, c3 = (I2 - I3) / I1, (I3 - I1) / I2, (I1 - I2) / I3

    def derivative(_, y):
        a, b, c, w, x, v, z = y
        return np.array([c1 * b * c, c2 * c * a, c3 * a * b, 0.5 * (-x * a - v * b - z * c), 0.5 * (w * a + v * c - z * b),
                         0.5 * (w * b + z * a - x * c), 0.5 * (w * c + x * b - v * a)])

    return derivative


def rk4(derivative, y, times, h_most):
    """States at the instants, by equal steps of at most h_most between two of them."""
    found = np.empty((len(times), len(y)))
    t = 0.0
    for i in range(len(times)):
        n = max(1, int(np.ceil((times[i] - t) / h_most))) if times[i] > t else 0
        h = (times[i] - t) / max(n, 1)
        for _ in range(n):
            k1 = derivative(t, y)
            k2 = derivative(t, y + 0.5 * h * k1)
            k3 = derivative(t, y + 0.5 * h * k2)
            k4 = derivative(t, y + h * k3)
            y = y + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
            t += h
        t = times[i]
        found[i] = y
    return found


def methods_of(case):
    """Name → function of instants that gives (ω, q) at each of them; the first of them all."""
    moments = [float(case[name]) for name in ("I1", "I2", "I3")]
    omega = [float(value) for value in case["omega0"]]
    start = np.array([*omega, 1.0, 0.0, 0.0, 0.0])
    derivative = derivative_of(moments)
    motion = poinsot.Motion(moments, omega)
    methods = {"poinsot": lambda times: np.hstack([motion.at(times).omega_body, motion.at(times).space_from_body])}
    stepped = {}
    try:
        from scipy.integrate import solve_ivp

        for rtol in (1e-9, 1e-12):
            stepped[f"solve_ivp, DOP853, rtol {rtol:.0e}".replace("e-0", "e-")] = lambda times, rtol=rtol: solve_ivp(
                derivative, (0.0, times[-1]), start, "DOP853", times, rtol=rtol, atol=rtol).y.T
    except ImportError:
        pass
    stepped[f"RK4 in NumPy, step {STEP_S} s"] = lambda times: rk4(derivative, start, times, STEP_S)
    try:
        import numba

        compiled_derivative, compiled = numba.njit(derivative), numba.njit(rk4)
        compiled(compiled_derivative, start, np.array([0.1]), STEP_S)
        stepped[f"RK4 in Numba, step {STEP_S} s"] = lambda times: compiled(compiled_derivative, start, times, STEP_S)
    except ImportError:
        pass
    return methods, stepped


def exact_array(samples, name):
    return np.array([[np.longdouble(number) for number in sample[name]] for sample in samples])


def errors(samples, states):
    """Largest errors: of ω, relative to |ω|, and of the attitude, in rad."""
    omega, q = exact_array(samples, "omega"), exact_array(samples, "q")
    found = np.asarray(states, np.longdouble)
    found_q = found[:, 3:] / np.linalg.norm(found[:, 3:], axis=1, keepdims=True)
    chord = np.minimum(np.linalg.norm(found_q - q, axis=1), np.linalg.norm(found_q + q, axis=1))
    relative = np.linalg.norm(found[:, :3] - omega, axis=1) / np.linalg.norm(omega, axis=1)
    return float(relative.max()), float((4 * np.arcsin(np.minimum(chord / 2, 1))).max())


def motion_table():
    cases = {case["name"]: case for case in json.loads(
        (ROOT / "tests/motion/mechanics/reference/torque_free.json").read_text())["cases"]}
    row("method", *CASES.values())
    row(*["---"] * (1 + len(CASES)))
    rows = {}
    for name in CASES:
        case = cases[name]
        samples = [sample for sample in case["samples"] if name != "long_1e9_periods" or float(sample["t"]) >= 1e9]
        times = np.array([float(sample["t"]) for sample in samples])
        methods, stepped = methods_of(case)
        many = np.linspace(0.0, times[-1], 1001)
        for method, evaluated in {**stepped, **methods}.items():
            if name == "long_1e9_periods" and method in stepped:
                rows.setdefault(method, []).append("not possible")
                continue
            of_omega, of_attitude = errors(samples, evaluated(times))
            instants = np.linspace(0.0, times[-1], 1_000_000) if method == "poinsot" else many
            timed = poinsot.Motion([float(case[k]) for k in ("I1", "I2", "I3")], [float(v) for v in case["omega0"]]).at \
                if method == "poinsot" else evaluated
            per_instant = cpu_s(lambda: timed(instants)) / len(instants)
            rows.setdefault(method, []).append(f"{of_omega:.0e}; {of_attitude:.0e} rad; {short(per_instant)}")
    for method, cells in rows.items():
        row(method, *cells)


# --- Calls ----------------------------------------------------------------------------------------


def calls_table():
    motion = poinsot.Motion([4.0, 3.0, 1.5], [1.2, 0.8, 2.4])
    scene = poinsot.Scene("generic")
    million = np.linspace(0.0, 1e6, 1_000_000)
    instants = million[:10_000].tolist()
    row("call", "CPU time")
    row("---", "---")
    row("`Motion.at(t)`, one instant", short(cpu_s(lambda: [motion.at(t) for t in instants]) / len(instants)))
    row("`Motion.at(times)`, 10⁶ instants", short(cpu_s(lambda: motion.at(million))))
    row("`Scene.sample(times)`, 10⁶ instants, 11 columns", short(cpu_s(lambda: scene.sample(million))))
    row("`Motion(moments, omega)`", short(cpu_s(lambda: [poinsot.Motion([4, 3, 1.5], [1.2, 0.8, 2.4]) for _ in range(1000)]) / 1000))
    row("`Motion.constants`", short(cpu_s(lambda: [motion.constants for _ in range(1000)]) / 1000))
    row('`Scene("generic")`', short(cpu_s(lambda: poinsot.Scene("generic"))))
    row("`Scene.check()`", short(cpu_s(scene.check)))


# --- Pictures -------------------------------------------------------------------------------------


class Construction:
    """What every renderer draws: ellipsoid, plane, polhode, herpolhode, L, ω, e1, e2, e3, names, at n_frames instants."""

    def __init__(self):
        moments, omega = np.array([4.0, 3.0, 1.5]), np.array([1.2, 0.8, 2.4])
        self.motion = poinsot.Motion(moments, omega)
        constants = self.motion.constants
        self.half_axes = constants.half_axes
        L = constants.momentum_space
        # The plane is horizontal, below the body: -L is up.
        up = -L / np.linalg.norm(L)
        side = np.cross(up, [1.0, 0.0, 0.0])
        side /= np.linalg.norm(side)
        self.view = np.array([side, np.cross(up, side), up])
        self.plane_z = -constants.plane_distance
        self.polhode = self.motion.polhode()
        self.times = np.linspace(8.0, 10.0, 12)
        self.mesh = np.stack(np.broadcast_arrays(*self._sphere()), axis=-1) * self.half_axes

    @staticmethod
    def _sphere():
        u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 65), np.linspace(0, np.pi, 33))
        return np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)

    def at(self, t):
        """Rotation of the body in the picture, herpolhode up to t, tips of the arrows by name."""
        w, x, y, z = self.motion.at(float(t)).space_from_body
        rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                             [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                             [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
        herpolhode = self.motion.herpolhode(np.linspace(0.0, t, 800)) @ self.view.T
        body = self.view @ rotation
        axes = {f"e{k + 1}": 1.2 * self.half_axes[k] * body[:, k] for k in range(3)}
        return body, herpolhode, {"L": np.array([0, 0, -0.9]), "ω": 1.3 * herpolhode[-1], **axes}


def matplotlib_drawn(construction, width, height):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=(width / 100, height / 100), dpi=100)
    axes = figure.add_subplot(projection="3d", computed_zorder=False)

    def drawn(t):
        body, herpolhode, tips = construction.at(t)
        axes.clear()
        axes.set_axis_off()
        axes.set(xlim=(-0.7, 0.7), ylim=(-0.7, 0.7), zlim=(-0.7, 0.7))
        grid = np.linspace(-1, 1, 11)
        for g in grid:
            axes.plot([g, g], [-1, 1], construction.plane_z, color="0.8", linewidth=0.5)
            axes.plot([-1, 1], [g, g], construction.plane_z, color="0.8", linewidth=0.5)
        x, y, z = np.moveaxis(construction.mesh @ body.T, -1, 0)
        axes.plot_surface(x, y, z, rstride=1, cstride=1, color="tan", shade=True, alpha=0.9)
        axes.plot(*(construction.polhode @ body.T).T, color="tab:blue")
        axes.plot(*herpolhode.T, color="tab:red")
        for name, tip in tips.items():
            axes.quiver(0, 0, 0, *tip, arrow_length_ratio=0.1)
            axes.text(*tip, name)
        figure.canvas.draw()
        return np.asarray(figure.canvas.buffer_rgba())

    return drawn


def vtk_drawn(construction, width, height):
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    def polyline(points):
        data, lines = vtk.vtkPolyData(), vtk.vtkCellArray()
        held = vtk.vtkPoints()
        held.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
        lines.InsertNextCell(len(points))
        for i in range(len(points)):
            lines.InsertCellPoint(i)
        data.SetPoints(held)
        data.SetLines(lines)
        return data

    def actor(source, colour, line_width=2):
        mapper, made = vtk.vtkPolyDataMapper(), vtk.vtkActor()
        if isinstance(source, vtk.vtkPolyData):
            mapper.SetInputData(source)
        else:
            mapper.SetInputConnection(source.GetOutputPort())
        made.SetMapper(mapper)
        made.GetProperty().SetColor(*colour)
        made.GetProperty().SetLineWidth(line_width)
        renderer.AddActor(made)
        return made

    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    renderer.SetBackground(1, 1, 1)
    sphere = vtk.vtkSphereSource()
    sphere.SetThetaResolution(64)
    sphere.SetPhiResolution(32)
    sphere.SetRadius(1.0)
    scaled = vtk.vtkTransformPolyDataFilter()
    scaling = vtk.vtkTransform()
    scaling.Scale(*construction.half_axes)
    scaled.SetTransform(scaling)
    scaled.SetInputConnection(sphere.GetOutputPort())
    bodies = [actor(scaled, (0.82, 0.7, 0.55)), actor(polyline(construction.polhode), (0.1, 0.3, 0.8))]
    for g in np.linspace(-1, 1, 11):
        z = construction.plane_z
        actor(polyline(np.array([[g, -1, z], [g, 1, z]])), (0.8, 0.8, 0.8), 1)
        actor(polyline(np.array([[-1, g, z], [1, g, z]])), (0.8, 0.8, 0.8), 1)
    trail = actor(polyline(np.zeros((2, 3))), (0.8, 0.2, 0.2))
    arrow = vtk.vtkArrowSource()
    arrows = {name: (actor(arrow, (0.2, 0.2, 0.2)), vtk.vtkBillboardTextActor3D()) for name in ("L", "ω", "e1", "e2", "e3")}
    for name, (_, label) in arrows.items():
        label.SetInput("w" if name == "ω" else name)  # its font has no ω
        label.GetTextProperty().SetColor(0, 0, 0)
        renderer.AddActor(label)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.6, -2.2, 1.4)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange()

    def matrix_of(columns):
        made = vtk.vtkMatrix4x4()
        for i in range(3):
            for j in range(3):
                made.SetElement(i, j, columns[i, j])
        return made

    def drawn(t):
        body, herpolhode, tips = construction.at(t)
        for part in bodies:
            part.SetUserMatrix(matrix_of(body))
        trail.GetMapper().SetInputData(polyline(herpolhode))
        for name, tip in tips.items():
            shaft, label = arrows[name]
            length = np.linalg.norm(tip)
            along = tip / length
            across = np.cross(along, [0.3, 0.5, 0.8])
            across /= np.linalg.norm(across)
            shaft.SetUserMatrix(matrix_of(length * np.column_stack([along, across, np.cross(along, across)])))
            label.SetPosition(*tip)
        window.Render()
        grabbed = vtk.vtkWindowToImageFilter()
        grabbed.SetInput(window)
        grabbed.ReadFrontBufferOff()
        grabbed.Update()
        return vtk_to_numpy(grabbed.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)[::-1]

    return drawn


def poinsot_drawn(_, width, height):
    scene = poinsot.Scene("generic", {"film.size": [width, height]})
    return lambda t: scene.still(float(t)).pixels


def display():
    """Xvfb on a free display, for VTK; None where a display exists, or no Xvfb."""
    if "DISPLAY" in os.environ or not shutil.which("Xvfb"):
        return None
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1920x1080x24"], pass_fds=[write],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as answer:
        os.environ["DISPLAY"] = ":" + answer.readline().strip()
    return server


def pictures_table():
    construction = Construction()
    server = display()
    sizes = ((640, 360), (1280, 720))
    row("one frame of the construction", *(f"{width} × {height}" for width, height in sizes))
    row("---", "---", "---")
    try:
        for name, made in (("matplotlib, surface of 64 × 32", matplotlib_drawn), ("VTK, 4× MSAA", vtk_drawn),
                           ("`Scene.still(t).pixels`", poinsot_drawn)):
            cells = []
            for width, height in sizes:
                try:
                    drawn = made(construction, width, height)
                except ImportError:
                    break
                picture = drawn(construction.times[-1])
                if "POINSOT_PICTURES" in os.environ:
                    path = pathlib.Path(os.environ["POINSOT_PICTURES"]) / f"{made.__name__}_{width}.png"
                    path.write_bytes(poinsot.comparison.png_bytes("frame", np.ascontiguousarray(picture)))
                cells.append(short(cpu_s(lambda: [drawn(t) for t in construction.times], 5) / len(construction.times)))
            row(name, *(cells or ["not installed"] * 2))
    finally:
        if server:
            server.terminate()
            server.wait()


# --- Sizes ----------------------------------------------------------------------------------------


def kilobytes(text_or_bytes):
    return f"{len(text_or_bytes) / 1e3:.0f} kB"


def sizes_table():
    scene = poinsot.Scene("generic", {"film.size": [640, 360]})
    row("output", "the notebook stores", "file")
    row("---", "---", "---")
    with tempfile.TemporaryDirectory() as folder:
        for size in ((640, 360), (960, 540)):
            png = scene.still(size=size).png
            row(f"still, {size[0]} × {size[1]}", f"{4 / 3 * len(png) / 1e3:.0f} kB", kilobytes(png))
        for shading in ("none", "tone"):
            row(f'figure, `shading="{shading}"`', kilobytes(scene.figure(shading=shading).svg.encode()), "")
        film = scene.render(os.path.join(folder, "film.mp4"), frames=(0, 59), progress=False)
        row("film of 60 frames, 640 × 360", kilobytes(film._repr_html_()), f"{os.path.getsize(film.path) / 1e3:.0f} kB")
        row("`page()`", kilobytes(scene.page()._repr_html_()), "")
        page = scene.page(os.path.join(folder, "page.html"))
        row('`page("page.html")`', kilobytes(page._repr_html_()), f"{os.path.getsize(page.path) / 1e3:.0f} kB")


def main():
    tables = {"motion": motion_table, "calls": calls_table, "pictures": pictures_table, "sizes": sizes_table}
    chosen = sys.argv[1:] or list(tables)
    if not set(chosen) <= set(tables):
        sys.exit(__doc__)
    print(f"{time.strftime('%Y-%m-%d')}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}, poinsot {poinsot.__version__}")
    for name in chosen:
        print()
        tables[name]()


if __name__ == "__main__":
    main()
