//! Minimal engines to begin with, one a language: each is whole, small, and passes the conformance run.

/// A language that there is a template for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Python 3, standard library only.
    Python,
    /// C11 with POSIX.
    C,
    /// C++17.
    Cpp,
    /// JavaScript under Node.
    Javascript,
    /// Julia, standard library only.
    Julia,
}

impl Language {
    /// All of them.
    pub const ALL: [Language; 5] =
        [Language::Python, Language::C, Language::Cpp, Language::Javascript, Language::Julia];

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Language::Python => "python",
            Language::C => "c",
            Language::Cpp => "cpp",
            Language::Javascript => "javascript",
            Language::Julia => "julia",
        }
    }

    /// A whole engine: an RK4 free body under gravity that refuses everything else.
    pub fn template(self) -> &'static str {
        match self {
            Language::Python => include_str!("templates/engine.py"),
            Language::C => include_str!("templates/engine.c"),
            Language::Cpp => include_str!("templates/engine.cpp"),
            Language::Javascript => include_str!("templates/engine.js"),
            Language::Julia => include_str!("templates/engine.jl"),
        }
    }
}
