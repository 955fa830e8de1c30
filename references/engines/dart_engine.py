"""DART: a free joint without contact; its one semi-implicit rule."""

from polhode_engine import serve
from rotations import quaternion, turned

import dartpy
import numpy


def start(p):
    world = dartpy.simulation.World()
    world.setTimeStep(p.step)
    world.setGravity(p.gravity)
    skeleton = dartpy.dynamics.Skeleton("body")
    joint, body = skeleton.createFreeJointAndBodyNodePair()
    body.setInertia(dartpy.dynamics.Inertia(p.mass, numpy.zeros(3), numpy.array(p.inertia)))
    place = dartpy.math.Isometry3()
    place.set_translation(p.position)
    place.set_rotation(numpy.array([turned(p.orientation, axis) for axis in numpy.eye(3).tolist()]).T)
    joint.setPositions(dartpy.dynamics.FreeJoint.convertToPositions(place))
    world_axes = dartpy.dynamics.Frame.World()
    joint.setLinearVelocity(numpy.array(p.velocity), world_axes, world_axes)
    joint.setAngularVelocity(numpy.array(p.angular_velocity), world_axes, world_axes)
    world.addSkeleton(skeleton)

    def advance(count):
        for _ in range(count):
            world.step()

    def observe():
        place = body.getWorldTransform()
        return (place.translation(), quaternion(place.rotation()), body.getCOMLinearVelocity(),
                body.getAngularVelocity())

    return advance, observe


serve("dart", dartpy.__version__, {"semi-implicit": (1, 1, start)})
