"""SciPy's solvers on the Euler equations, an ODE peer: error control decides the steps, so that no order is claimed.

Tolerances are 1e-12; one evaluation of the right-hand side is not told as one of the forces.
"""

from polhode_engine import serve
from rotations import inverse, turned

import numpy
import scipy
from scipy.integrate import solve_ivp

TOLERANCE = 1e-12


def start(method):
    def begin(p):
        inertia, gravity = numpy.array(p.inertia), numpy.array(p.gravity)
        inverted = numpy.linalg.inv(inertia)

        def rates(_, y):
            w, x, y_, z = y[6:10]
            a, b, c = spin = y[10:13]
            turning = [-x * a - y_ * b - z * c, w * a + y_ * c - z * b, w * b + z * a - x * c, w * c + x * b - y_ * a]
            return numpy.concatenate(
                (y[3:6], gravity, 0.5 * numpy.array(turning), inverted @ numpy.cross(inertia @ spin, spin)))

        spin = turned(inverse(p.orientation), p.angular_velocity)
        state = [numpy.array([*p.position, *p.velocity, *p.orientation, *spin])]

        def advance(count):
            solution = solve_ivp(rates, (0, count * p.step), state[0], method, rtol=TOLERANCE, atol=TOLERANCE)
            if not solution.success:
                raise RuntimeError(solution.message)
            state[0] = solution.y[:, -1]

        def observe():
            q = list(state[0][6:10] / numpy.linalg.norm(state[0][6:10]))
            return state[0][:3], q, state[0][3:6], turned(q, list(state[0][10:13]))

        return advance, observe

    return begin


serve("scipy", scipy.__version__, {name: (None, 0, start(name)) for name in ("DOP853", "Radau", "LSODA")})
