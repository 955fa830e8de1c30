"""An engine for Polhode: a free rigid body under uniform gravity, by the classical Runge-Kutta method.

Run it:    polhode run free-asymmetric --scheme "engine:python3 engine.py" --steps 100
Check it:  polhode engine check "python3 engine.py"

Put your own simulator in the place of `rates` and `run`. One JSON object a line on stdin and stdout; stderr is
your own log. Standard library only.
"""

import json
import sys
import time

HELLO = {"polhode": 1, "name": "my-engine", "version": "0.1", "scheme": "RK4", "order": 4, "forces": ["gravity"]}


class Refused(Exception):
    """The scene is not for this engine; the text says why."""


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def times(matrix, v):
    return [sum(m * x for m, x in zip(row, v)) for row in matrix]


def inverse(m):
    rows = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])]
    determinant = sum(x * y for x, y in zip(m[0], rows[0]))
    if abs(determinant) < 1e-30:
        raise Refused("the inertia is singular: a rod or a point")
    return [[rows[j][i] / determinant for j in range(3)] for i in range(3)]


def turned(q, v):
    """R v: from body axes to world axes, q = (w, x, y, z)."""
    t = [2.0 * x for x in cross(q[1:], v)]
    return [x + q[0] * a + b for x, a, b in zip(v, t, cross(q[1:], t))]


def rates(y, gravity, inertia, inverted):
    """Time derivative of y = position, velocity, orientation, angular velocity in body axes."""
    velocity, (w, x, y_, z), spin = y[3:6], y[6:10], y[10:13]
    a, b, c = spin
    turning = [-x * a - y_ * b - z * c, w * a + y_ * c - z * b, w * b + z * a - x * c, w * c + x * b - y_ * a]
    torque = [-k for k in cross(spin, times(inertia, spin))]
    return velocity + gravity + [0.5 * k for k in turning] + times(inverted, torque)


def run(request):
    gravity = [0.0, 0.0, 0.0]
    if request["pivot"] is not None:
        raise Refused("no pivot")
    for force in request["forces"]:
        if force["law"] != "gravity":
            raise Refused(f"no law '{force['law']}'")
        gravity = [g + a for g, a in zip(gravity, force["acceleration"])]
    inertia = request["body"]["inertia"]
    inverted = inverse(inertia)
    initial, h, steps, every = request["initial"], request["step"], request["steps"], request["every"]
    q = initial["orientation"]
    to_body = [q[0], -q[1], -q[2], -q[3]]
    y = initial["position"] + initial["velocity"] + q + turned(to_body, initial["angular_velocity"])
    rate = lambda state: rates(state, gravity, inertia, inverted)
    moved = lambda s, k: [a + s * b for a, b in zip(y, k)]
    states, began = [], time.perf_counter_ns()
    for step in range(steps + 1):
        if step % every == 0 or step == steps:
            length = sum(x * x for x in y[6:10]) ** 0.5
            q = [x / length for x in y[6:10]]
            states.append({"step": step, "position": y[:3], "orientation": q, "velocity": y[3:6],
                           "angular_velocity": turned(q, y[10:13])})
        if step < steps:
            k1 = rate(y)
            k2 = rate(moved(h / 2, k1))
            k3 = rate(moved(h / 2, k2))
            k4 = rate(moved(h, k3))
            y = [v + h / 6 * (a + 2 * b + 2 * c + d) for v, a, b, c, d in zip(y, k1, k2, k3, k4)]
    return {"states": states, "elapsed_ns": time.perf_counter_ns() - began, "evaluations": 4 * steps}


for line in sys.stdin:
    request = json.loads(line)
    if request["ask"] == "bye":
        break
    if request["ask"] == "hello":
        answer = HELLO
    else:
        try:
            answer = run(request)
        except Refused as why:
            answer = {"refused": str(why)}
        except (ArithmeticError, ValueError) as why:
            answer = {"failed": str(why)}
        answer["id"] = request["id"]
    print(json.dumps(answer), flush=True)
