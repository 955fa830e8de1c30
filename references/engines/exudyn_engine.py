"""Exudyn: a rigid body with a Lie-group node under its explicit and implicit rules, and one with Euler parameters under the
implicit ones: its explicit solvers take no algebraic variables. DVERK6 has a name in 1.13 and no code."""

from polhode_engine import serve
from rotations import quaternion, turned

from itertools import count
from time import perf_counter_ns

import exudyn
import numpy
from exudyn.utilities import RigidBodyInertia

AXES = numpy.eye(3).tolist()


def start(solver, node, newmark=False):
    def begin(p):
        system = exudyn.SystemContainer().AddSystem()
        matrix = numpy.array([turned(p.orientation, axis) for axis in AXES]).T
        made = system.CreateRigidBody(inertia=RigidBodyInertia(p.mass, numpy.array(p.inertia)), nodeType=node,
                                      referencePosition=p.position, referenceRotationMatrix=matrix,
                                      initialVelocity=p.velocity, initialAngularVelocity=p.angular_velocity,
                                      gravity=p.gravity, returnDict=True)
        system.Assemble()
        settings = exudyn.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.solutionSettings.sensorsWritePeriod = 1e30
        settings.timeIntegration.verboseMode = 0
        settings.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
        settings.timeIntegration.generalizedAlpha.useNewmark = newmark
        settings.timeIntegration.newton.relativeTolerance = 1e-12
        settings.timeIntegration.newton.absoluteTolerance = 1e-14
        settings.timeIntegration.automaticStepSize = settings.timeIntegration.adaptiveStep = False
        # ODE23 controls its error even so: a tolerance that nothing exceeds leaves it the step that is asked for.
        settings.timeIntegration.relativeTolerance = settings.timeIntegration.absoluteTolerance = 1e9

        def observe():
            read = lambda kind: system.GetNodeOutput(made["nodeNumber"], kind)
            kinds = exudyn.OutputVariableType
            return (read(kinds.Position), quaternion(read(kinds.RotationMatrix).reshape(3, 3)),
                    read(kinds.Velocity), read(kinds.AngularVelocity))

        def whole(steps, every):
            # Generalised alpha begins anew where a run is stopped: it is looked at while it goes.
            seen, step = [], count()

            def look(*_):
                # Called once before every step; its time is that of the end of the step in some solvers.
                if (done := next(step)) % every == 0:
                    seen.append((done, observe(), perf_counter_ns() - began))
                return True

            settings.timeIntegration.endTime = steps * p.step
            settings.timeIntegration.numberOfSteps = steps
            system.SetPreStepUserFunction(look)
            began = perf_counter_ns()
            if not system.SolveDynamic(settings, solverType=solver, updateInitialValues=True, showHints=False):
                raise RuntimeError("the solver gave up")
            return [*seen, (steps, observe(), perf_counter_ns() - began)]

        return whole

    return begin


lie, parameters = exudyn.NodeType.RotationRotationVector, exudyn.NodeType.RotationEulerParameters
kinds = exudyn.DynamicSolverType
serve("exudyn", exudyn.__version__, {
    "ExplicitEuler": (1, 1, start(kinds.ExplicitEuler, lie)),
    "VelocityVerlet": (1, 1, start(kinds.VelocityVerlet, lie)),
    "ExplicitMidpoint": (2, 2, start(kinds.ExplicitMidpoint, lie)),
    "ODE23": (3, 3, start(kinds.ODE23, lie)),
    "RK33": (3, 3, start(kinds.RK33, lie)),
    "RK44": (4, 4, start(kinds.RK44, lie)),
    "DOPRI5": (5, 6, start(kinds.DOPRI5, lie)),
    "RK67": (6, 7, start(kinds.RK67, lie)),
    "GeneralizedAlpha-Lie": (2, 0, start(kinds.GeneralizedAlpha, lie)),
    "Newmark-Lie": (2, 0, start(kinds.GeneralizedAlpha, lie, newmark=True)),
    "TrapezoidalIndex2-Lie": (2, 0, start(kinds.TrapezoidalIndex2, lie)),
    "GeneralizedAlpha-EulerParameters": (2, 0, start(kinds.GeneralizedAlpha, parameters)),
    "Newmark-EulerParameters": (2, 0, start(kinds.GeneralizedAlpha, parameters, newmark=True)),
    "TrapezoidalIndex2-EulerParameters": (2, 0, start(kinds.TrapezoidalIndex2, parameters)),
})
