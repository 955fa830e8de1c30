// An engine for Polhode: a free rigid body under uniform gravity, by the classical Runge-Kutta method.
//
// Run it:    polhode run free-asymmetric --scheme "engine:node engine.js" --steps 100
// Check it:  polhode engine check "node engine.js"
//
// Put your own simulator in the place of `rates` and `run`. One JSON object a line on stdin and stdout; stderr is
// your own log. No packages.
"use strict";

const HELLO = { polhode: 1, name: "my-engine", version: "0.1", scheme: "RK4", order: 4, forces: ["gravity"] };

class Refused extends Error {}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const times = (m, v) => m.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);

function inverse(m) {
  const rows = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];
  const determinant = m[0].reduce((sum, x, i) => sum + x * rows[0][i], 0);
  if (Math.abs(determinant) < 1e-30) throw new Refused("the inertia is singular: a rod or a point");
  return [0, 1, 2].map((i) => [0, 1, 2].map((j) => rows[j][i] / determinant));
}

// R v: from body axes to world axes, q = [w, x, y, z].
function turned(q, v) {
  const axis = q.slice(1);
  const t = cross(axis, v).map((x) => 2 * x);
  const u = cross(axis, t);
  return v.map((x, i) => x + q[0] * t[i] + u[i]);
}

// Time derivative of y = position, velocity, orientation, angular velocity in body axes.
function rates(y, gravity, inertia, inverted) {
  const [w, x, z2, z] = y.slice(6, 10);
  const spin = y.slice(10, 13);
  const [a, b, c] = spin;
  const turning = [-x * a - z2 * b - z * c, w * a + z2 * c - z * b, w * b + z * a - x * c, w * c + x * b - z2 * a];
  const torque = cross(spin, times(inertia, spin)).map((k) => -k);
  return [...y.slice(3, 6), ...gravity, ...turning.map((k) => 0.5 * k), ...times(inverted, torque)];
}

function run(request) {
  if (request.pivot !== null) throw new Refused("no pivot");
  let gravity = [0, 0, 0];
  for (const force of request.forces) {
    if (force.law !== "gravity") throw new Refused(`no law '${force.law}'`);
    gravity = gravity.map((g, i) => g + force.acceleration[i]);
  }
  const inertia = request.body.inertia;
  const inverted = inverse(inertia);
  const { step: h, steps, every, initial } = request;
  const [w, x, y2, z] = initial.orientation;
  const spin = turned([w, -x, -y2, -z], initial.angular_velocity);
  let y = [...initial.position, ...initial.velocity, ...initial.orientation, ...spin];
  const rate = (state) => rates(state, gravity, inertia, inverted);
  const moved = (s, k) => y.map((value, i) => value + s * k[i]);
  const states = [];
  const began = process.hrtime.bigint();
  for (let step = 0; step <= steps; step++) {
    if (step % every === 0 || step === steps) {
      const length = Math.hypot(...y.slice(6, 10));
      const orientation = y.slice(6, 10).map((value) => value / length);
      states.push({
        step, position: y.slice(0, 3), orientation, velocity: y.slice(3, 6),
        angular_velocity: turned(orientation, y.slice(10, 13)),
      });
    }
    if (step < steps) {
      const k1 = rate(y);
      const k2 = rate(moved(h / 2, k1));
      const k3 = rate(moved(h / 2, k2));
      const k4 = rate(moved(h, k3));
      y = y.map((value, i) => value + (h / 6) * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]));
    }
  }
  if (!y.every(Number.isFinite)) return { failed: "the state is no longer finite" };
  return { states, elapsed_ns: Number(process.hrtime.bigint() - began), evaluations: 4 * steps };
}

function answer(request) {
  if (request.ask === "hello") return HELLO;
  try {
    return { id: request.id, ...run(request) };
  } catch (error) {
    return { id: request.id, [error instanceof Refused ? "refused" : "failed"]: error.message };
  }
}

require("readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const request = JSON.parse(line);
  if (request.ask === "bye") process.exit(0);
  process.stdout.write(JSON.stringify(answer(request)) + "\n");
});
