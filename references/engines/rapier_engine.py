"""Rapier's Python wheel, in single precision: its rule with four substeps, as it comes, and with one.

Rounding to single precision drowns the first order of the rule below h = 0.01 s, so that no order is claimed.
"""

from polhode_engine import serve
from rotations import principal

import importlib.metadata

import rapier3d
from rapier3d import Isometry3, MassProperties, RigidBody, Rotation3, Vec3


def rotation(q):
    w, x, y, z = q
    made = Rotation3(w, x, y, z)
    if abs(made.w - w) > 1e-6:
        raise RuntimeError("this version of Rapier orders quaternions in another way")
    return made


def start(substeps):
    def begin(p):
        world = rapier3d.PhysicsWorld(gravity=Vec3(*p.gravity))
        parameters = world.integration_parameters
        parameters.dt, parameters.num_solver_iterations = p.step, substeps
        moments, axes = principal(p.inertia)
        mass = MassProperties(Vec3(0.0, 0.0, 0.0), p.mass, Vec3(*moments), rotation(axes))
        builder = RigidBody.dynamic().additional_mass_properties(mass).can_sleep(False).gyroscopic_forces(True)
        builder = builder.linear_damping(0.0).angular_damping(0.0).allow_fast_rotation(True)
        builder = builder.position(Isometry3(Vec3(*p.position), rotation(p.orientation)))
        handle = world.add_body(builder.linvel(Vec3(*p.velocity)).angvel(Vec3(*p.angular_velocity)))

        def advance(count):
            for _ in range(count):
                world.step()

        def observe():
            body = world.rigid_bodies[handle]
            x, q, v, w = body.translation, body.rotation, body.linvel, body.angvel
            q = [q.w, q.i, q.j, q.k]
            return (x.x, x.y, x.z), q, (v.x, v.y, v.z), (w.x, w.y, w.z)

        return advance, observe

    return begin


serve("rapier", importlib.metadata.version("rapier3d"), {
    "f32-4-substeps": (None, 4, start(4)),
    "f32-1-substep": (None, 1, start(1)),
})
