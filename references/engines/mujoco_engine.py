"""MuJoCo: a free joint without contact and damping, its four integrators."""

from polhode_engine import serve
from rotations import inverse, turned

import sys

import mujoco

# Its warnings belong into the log of the engine, and not into a file wherever it runs.
mujoco.set_mju_user_warning(lambda text: print(text, file=sys.stderr))

DIVERGED = [mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC]


def start(integrator):
    def begin(p):
        full = " ".join(repr(p.inertia[i][j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
        model = mujoco.MjModel.from_xml_string(f"""
            <mujoco>
              <option timestep="{p.step!r}" integrator="{integrator}" gravity="{' '.join(map(repr, p.gravity))}">
                <flag contact="disable" autoreset="disable"/>
              </option>
              <worldbody>
                <body><freejoint/><inertial pos="0 0 0" mass="{p.mass!r}" fullinertia="{full}"/></body>
              </worldbody>
            </mujoco>""")
        data = mujoco.MjData(model)
        data.qpos[:3], data.qpos[3:] = p.position, p.orientation
        # A free joint has its velocity in world axes and its angular velocity in body axes.
        data.qvel[:3], data.qvel[3:] = p.velocity, turned(inverse(p.orientation), p.angular_velocity)

        def observe():
            q = list(data.qpos[3:])
            return data.qpos[:3], q, data.qvel[:3], turned(q, list(data.qvel[3:]))

        def advance(count):
            mujoco.mj_step(model, data, nstep=count)
            # Left to itself MuJoCo begins anew from zero where a run diverges, and goes on.
            if any(data.warning[kind].number for kind in DIVERGED):
                raise RuntimeError("MuJoCo warns that the run has diverged")

        return advance, observe

    return begin


serve("mujoco", mujoco.__version__, {
    "Euler": (1, 1, start("Euler")),
    "implicit": (1, 1, start("implicit")),
    "implicitfast": (1, 1, start("implicitfast")),
    "RK4": (4, 4, start("RK4")),
})
