//! The built-in scenes: free bodies first, then tops, forces on points, torques, and what other projects use.

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        /// Name and text of every built-in scene, in the order of reports.
        pub const FILES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("../../references/scenes/", $name, ".toml")))),*];
    };
}

files! {
    "free-asymmetric",
    "free-oblate",
    "free-rod",
    "slow-sphere",
    "fast-sphere",
    "euler-top-unit",
    "dzhanibekov",
    "exact-separatrix",
    "water-molecule",
    "planet-free-nutation",
    "heavy-asymmetric-top",
    "kovalevskaya",
    "lagrange-fast-top",
    "sleeping-top",
    "lagrange-top-pivot-spring",
    "lagrange-top-pivot-spring-undamped",
    "spinning-coin",
    "gravity-drag",
    "tether-springs",
    "bouncing-body",
    "gravity-gradient",
    "satellite-gravity-gradient",
    "satellite-low-orbit",
    "charged-body-in-fields",
    "time-dependent-field",
    "dipole-in-field",
    "sciml-rigidbody-wpd",
    "gyrostat",
    "gyrostat-axial",
    "damped-tumble",
    "magnetic-satellite",
    "satellite-circular-orbit",
    "thruster-pulse",
    "thruster-pulse-between-steps",
    "mujoco-free-box",
    "mujoco-fast-spin",
    "mujoco-middle-axis",
    "jsbsim-rotations",
    "nasa-check-case-2",
    "osrf-boxes-simple",
    "osrf-boxes-complex",
    "thin-body",
    "near-separatrix",
    "tippe-top",
    "swinging-rod",
    "disc-on-long-shaft",
    "one-stiff-spring",
    "released-top",
    "spin-1e-8",
    "spin-1e8",
}
