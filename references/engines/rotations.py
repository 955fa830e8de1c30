"""Quaternions (w, x, y, z) from body axes to world axes, and what adapters need to turn one into the other."""

import math


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turned(q, v):
    """R v, from body axes to world axes."""
    t = [2 * x for x in cross(q[1:], v)]
    return [x + q[0] * a + b for x, a, b in zip(v, t, cross(q[1:], t))]


def inverse(q):
    return [q[0], -q[1], -q[2], -q[3]]


def product(p, q):
    """Hamilton's product."""
    u = cross(p[1:], q[1:])
    return [p[0] * q[0] - sum(a * b for a, b in zip(p[1:], q[1:]))] + [
        p[0] * b + q[0] * a + c for a, b, c in zip(p[1:], q[1:], u)]


def principal(inertia):
    """Principal moments, and the quaternion that takes principal axes to body axes."""
    import numpy
    moments, axes = numpy.linalg.eigh(numpy.array(inertia))
    if numpy.count_nonzero(numpy.array(inertia) - numpy.diag(numpy.diag(inertia))) == 0:
        moments, axes = numpy.diag(inertia), numpy.eye(3)
    if numpy.linalg.det(axes) < 0:
        axes[:, 0] *= -1
    return [float(m) for m in moments], quaternion(axes)


def quaternion(m):
    """The quaternion of a rotation matrix, by its largest component."""
    s = [1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
         1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2]]
    k = s.index(max(s))
    a, b, c = m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]
    d, e, f = m[1][0] + m[0][1], m[0][2] + m[2][0], m[2][1] + m[1][2]
    q = [[s[0], a, b, c], [a, s[1], d, e], [b, d, s[2], f], [c, e, f, s[3]]][k]
    length = math.sqrt(sum(x * x for x in q))
    return [float(x / length) for x in q]
