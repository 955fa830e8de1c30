"""heyoka's Taylor method on the Euler equations, an ODE peer: to rounding at every step, so that no order is claimed."""

from polhode_engine import serve
from rotations import inverse, turned

import heyoka
import numpy


def start(p):
    names = heyoka.make_vars(*"x y z u v w q0 q1 q2 q3 a b c".split())
    q0, q1, q2, q3, *spin = names[6:]
    inverted = numpy.linalg.inv(numpy.array(p.inertia))
    moment = [sum(p.inertia[i][j] * spin[j] for j in range(3)) for i in range(3)]
    torque = [moment[1] * spin[2] - moment[2] * spin[1], moment[2] * spin[0] - moment[0] * spin[2],
              moment[0] * spin[1] - moment[1] * spin[0]]
    a, b, c = spin
    turning = [-q1 * a - q2 * b - q3 * c, q0 * a + q2 * c - q3 * b, q0 * b + q3 * a - q1 * c, q0 * c + q1 * b - q2 * a]
    rates = [*names[3:6], *(heyoka.expression(g) for g in p.gravity), *(0.5 * k for k in turning),
             *(sum(float(inverted[i][j]) * torque[j] for j in range(3)) for i in range(3))]
    spin_body = turned(inverse(p.orientation), p.angular_velocity)
    taylor = heyoka.taylor_adaptive(list(zip(names, rates)), [*p.position, *p.velocity, *p.orientation, *spin_body])
    done = [0]

    def advance(count):
        done[0] += count
        taylor.propagate_until(done[0] * p.step)

    def observe():
        y = taylor.state
        q = list(y[6:10] / numpy.linalg.norm(y[6:10]))
        return y[:3], q, y[3:6], turned(q, list(y[10:13]))

    return advance, observe


serve("heyoka", heyoka.__version__, {"Taylor": (None, 0, start)})
