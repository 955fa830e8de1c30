"""Bullet by pybullet: both kinds of body, without damping, sleeping and collision."""

from polhode_engine import serve
from rotations import inverse, principal, product

import importlib.metadata

import pybullet


def start(maximal):
    def begin(p):
        client = pybullet.connect(pybullet.DIRECT)
        pybullet.resetSimulation(physicsClientId=client)
        # Bullet knows principal moments only: its body axes are the principal ones, `axes` takes them to ours.
        moments, axes = principal(p.inertia)
        q = product(p.orientation, axes)
        body = pybullet.createMultiBody(baseMass=p.mass, basePosition=p.position, baseOrientation=[*q[1:], q[0]],
                                        useMaximalCoordinates=maximal, physicsClientId=client)
        # Without the mass beside it the inertia is not taken.
        pybullet.changeDynamics(body, -1, mass=p.mass, localInertiaDiagonal=moments, linearDamping=0, angularDamping=0,
                                activationState=pybullet.ACTIVATION_STATE_DISABLE_SLEEPING, physicsClientId=client)
        pybullet.resetBaseVelocity(body, p.velocity, p.angular_velocity, physicsClientId=client)
        pybullet.setGravity(*p.gravity, physicsClientId=client)
        pybullet.setTimeStep(p.step, physicsClientId=client)

        def advance(count):
            for _ in range(count):
                pybullet.stepSimulation(physicsClientId=client)

        def observe():
            position, (x, y, z, w) = pybullet.getBasePositionAndOrientation(body, physicsClientId=client)
            velocity, spin = pybullet.getBaseVelocity(body, physicsClientId=client)
            return position, product([w, x, y, z], inverse(axes)), velocity, spin

        return advance, observe

    return begin


serve("bullet", importlib.metadata.version("pybullet"), {
    "rigid-body": (1, 1, start(True)),
    "multi-body": (1, 1, start(False)),
})
