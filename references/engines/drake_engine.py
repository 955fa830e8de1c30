"""Drake: a free body in a discrete plant, and in a continuous one under its integrators at a fixed step."""

from polhode_engine import serve
from rotations import quaternion

import importlib.metadata

import numpy
from pydrake.common.eigen_geometry import Quaternion
from pydrake.math import RigidTransform
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import RotationalInertia, SpatialInertia
from pydrake.systems.analysis import Simulator, ResetIntegratorFromFlags


def start(integrator):
    def begin(p):
        plant = MultibodyPlant(p.step if integrator is None else 0.0)
        i = p.inertia
        inertia = RotationalInertia(i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2])
        body = plant.AddRigidBody("body", SpatialInertia.MakeFromCentralInertia(p.mass, numpy.zeros(3), inertia))
        plant.mutable_gravity_field().set_gravity_vector(p.gravity)
        plant.Finalize()
        simulator = Simulator(plant)
        context = simulator.get_mutable_context()
        turn = Quaternion(numpy.array(p.orientation) / numpy.linalg.norm(p.orientation))
        plant.SetFreeBodyPose(context, body, RigidTransform(turn, p.position))
        plant.SetFreeBodySpatialVelocity(body, SpatialVelocity(p.angular_velocity, p.velocity), context)
        if integrator is not None:
            own = ResetIntegratorFromFlags(simulator, integrator, p.step)
            own.set_fixed_step_mode(True)
        simulator.Initialize()
        done = [0]

        def advance(count):
            done[0] += count
            # A discrete step is made at its beginning: a hair before the end, so that rounding adds none.
            simulator.AdvanceTo(done[0] * p.step - (0.0 if integrator else 1e-3 * p.step))

        def observe():
            pose, moving = plant.EvalBodyPoseInWorld(context, body), plant.EvalBodySpatialVelocityInWorld(context, body)
            return pose.translation(), quaternion(pose.rotation().matrix()), moving.translational(), moving.rotational()

        return advance, observe

    return begin


serve("drake", importlib.metadata.version("drake"), {
    "discrete": (1, 1, start(None)),
    "explicit_euler": (1, 1, start("explicit_euler")),
    "semi_explicit_euler": (1, 1, start("semi_explicit_euler")),
    "runge_kutta2": (2, 2, start("runge_kutta2")),
    "runge_kutta3": (3, 3, start("runge_kutta3")),
    "implicit_euler": (1, 0, start("implicit_euler")),
    "radau3": (3, 0, start("radau3")),
})
