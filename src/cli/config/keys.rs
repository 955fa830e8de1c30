//! The keys of `polhode.toml`: what may stand in the file, from which the check, the schema and the commented file of `polhode init` follow.

/// What a value may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A list of texts.
    Texts,
    /// A text.
    Text,
    /// The name of a quantity.
    Quantity,
    /// A number above 0.
    Positive,
    /// An order of convergence, 1 to 12.
    Order,
    /// A number of steps: a power of two, so that every sample time ends a step.
    Steps,
}

/// A key.
pub(super) struct Key {
    pub(super) name: &'static str,
    pub(super) kind: Kind,
    pub(super) what: &'static str,
    /// A value as TOML writes it.
    pub(super) example: &'static str,
}

const fn key(name: &'static str, kind: Kind, example: &'static str, what: &'static str) -> Key {
    Key { name, kind, what, example }
}

/// How a table stands in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// The file itself.
    Top,
    /// `[name]`.
    One,
    /// `[name]` whose keys are names of the user's, each with a text.
    Named,
    /// `[[name]]`, any number of times.
    Many,
}

/// A table.
pub(super) struct Section {
    pub(super) name: &'static str,
    pub(super) form: Form,
    pub(super) what: &'static str,
    pub(super) keys: &'static [Key],
}

const SCENE: Key = key("scene", Kind::Text, "\"kovalevskaya\"", "name of the scene; every scene without it");

/// The tables in the order of the file.
pub(super) const SECTIONS: &[Section] = &[
    Section {
        name: "",
        form: Form::Top,
        what: "What gate, report, compare and stability measure where the command line names nothing.",
        keys: &[
            key(
                "schemes",
                Kind::Texts,
                "[\"peskin-rk2\", \"mine\"]",
                "schemes, `all`, or names of [engines]",
            ),
            key(
                "scenes",
                Kind::Texts,
                "[\"kovalevskaya\", \"my-body.toml\"]",
                "built-in scenes or scene files",
            ),
        ],
    },
    Section {
        name: "engines",
        form: Form::Named,
        what: "Programs under test: --scheme mine stands for --scheme 'engine:python3 my_engine.py'.",
        keys: &[key(
            "mine",
            Kind::Text,
            "\"python3 my_engine.py\"",
            "a name of your own, and its command line",
        )],
    },
    Section {
        name: "gate",
        form: Form::One,
        what: "Options of polhode gate and polhode bless.",
        keys: &[
            key(
                "baseline",
                Kind::Text,
                "\"polhode-baseline.json\"",
                "records that constants and errors are compared with",
            ),
            key(
                "order",
                Kind::Order,
                "2",
                "order that every scheme is held to, in the place of what it claims",
            ),
        ],
    },
    Section {
        name: "tolerances",
        form: Form::Many,
        what: "What may change against the baseline. The last table that fits a scene and a quantity counts.",
        keys: &[
            SCENE,
            key("quantity", Kind::Quantity, "\"orientation\"", "the quantity; every quantity without it"),
            key("constant", Kind::Positive, "0.01", "largest relative change of an error constant"),
            key("error", Kind::Positive, "0.5", "largest relative change of the error of a run"),
        ],
    },
    Section {
        name: "ladders",
        form: Form::Many,
        what: "The runs of halved steps. The last table that fits a scene counts.",
        keys: &[
            SCENE,
            key("coarsest", Kind::Steps, "16", "steps of the first run, a power of two"),
            key("finest", Kind::Steps, "4096", "most steps of a run, a power of two"),
        ],
    },
];

/// The commented file that `polhode init` writes.
pub(in crate::cli) fn commented() -> String {
    let mut text = "# Polhode's settings for this folder. The command line comes first, then this file, then the defaults.\n\
                    # Completion in editors: polhode init --schema > polhode.schema.json, and then the line\n\
                    #:schema ./polhode.schema.json\n"
        .to_owned();
    for section in SECTIONS {
        text += &format!("\n# {}\n", section.what);
        text += &match section.form {
            Form::Top => String::new(),
            Form::One | Form::Named => format!("# [{}]\n", section.name),
            Form::Many => format!("# [[{}]]\n", section.name),
        };
        for key in section.keys {
            let line = format!("{} = {}", key.name, key.example);
            text += &format!("# {line:42}  # {}\n", key.what);
        }
    }
    text
}
