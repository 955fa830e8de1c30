"""What every adapter shares: Polhode's protocol on one side, two functions on the other.

An adapter is a function `start(problem)` that sets its simulator going and returns

    advance(count)   makes so many steps of problem.step
    observe()        (position, orientation w x y z, velocity, angular velocity), world axes, of the centre of mass

(or, where a stop would change the run, one function `whole(steps, every)` that yields step, what observe() returns and
nanoseconds spent so far), and a call of `serve`. What the simulator cannot do it refuses: `raise Refused("why")`. Its name on the command line:

    polhode gate --scheme "engine:python3 references/engines/mujoco_engine.py RK4"

Whatever a library prints to stdout goes to stderr: the protocol has the real stdout for itself.
"""

import json
import os
import sys
import time
from math import isfinite
from types import SimpleNamespace

from rotations import principal

_out = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)


class Refused(Exception):
    """The scene is not for this engine; the text says why."""


def problem(request):
    """A request as a free body under uniform gravity, or a refusal."""
    if request["pivot"] is not None:
        raise Refused("no pivot")
    gravity = [0.0, 0.0, 0.0]
    for force in request["forces"]:
        if force["law"] != "gravity":
            raise Refused(f"no law '{force['law']}'")
        gravity = [g + a for g, a in zip(gravity, force["acceleration"])]
    moments = principal(request["body"]["inertia"])[0]
    if min(moments) <= 1e-12 * max(moments):
        raise Refused("the inertia is singular: a rod or a point")
    if 2 * max(moments) > sum(moments) * (1 + 1e-12):
        raise Refused("no positive masses have this inertia")
    return SimpleNamespace(gravity=gravity, mass=request["body"]["mass"], inertia=request["body"]["inertia"],
                           step=request["step"], **request["initial"])


def in_parts(advance, observe):
    """Makes whole runs of a simulator that can be stopped and looked at."""
    def whole(steps, every):
        spent, done = 0, 0
        while True:
            yield done, observe(), spent
            if done == steps:
                return
            count = min(every, steps - done)
            began = time.perf_counter_ns()
            advance(count)
            spent += time.perf_counter_ns() - began
            done += count
    return whole


def run(start, request, evaluations):
    made = start(problem(request))
    whole = made if callable(made) else in_parts(*made)
    states, spent, keys = [], 0, ("position", "orientation", "velocity", "angular_velocity")
    for step, seen, spent in whole(request["steps"], request["every"]):
        state = {key: [float(x) for x in value] for key, value in zip(keys, seen)}
        if not all(isfinite(x) for value in state.values() for x in value):
            return {"failed": "the state is no longer finite", "step": step}
        states.append({"step": step, **state})
    return {"states": states, "elapsed_ns": spent, "evaluations": evaluations * request["steps"]}


def serve(name, version, schemes):
    """Answers until the end. `schemes`: name → (order or None, evaluations a step, start)."""
    scheme = (sys.argv[1:] or list(schemes))[0]
    if scheme not in schemes:
        sys.exit(f"{name} has no scheme '{scheme}'; it has {', '.join(schemes)}")
    order, evaluations, start = schemes[scheme]
    hello = {"polhode": 1, "name": name, "version": str(version), "scheme": scheme, "forces": ["gravity"]}
    for line in sys.stdin:
        request = json.loads(line)
        if request["ask"] == "bye":
            break
        answer = hello if order is None else {**hello, "order": order}
        if request["ask"] == "run":
            try:
                answer = run(start, request, evaluations)
            except Refused as why:
                answer = {"refused": str(why)}
            except Exception as why:
                answer = {"failed": f"{type(why).__name__}: {why}"}
            answer["id"] = request["id"]
        print(json.dumps(answer), file=_out, flush=True)
