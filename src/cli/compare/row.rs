//! A row of a comparison.

/// How the second stands to the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Standing {
    Better,
    Same,
    Worse,
    /// Costs more, and something in the scene is better for it.
    Dearer,
    /// Nothing can be told.
    Undecided,
    /// One of the two does not take the scene.
    NotApplicable,
    /// A number to look at, which decides nothing.
    Shown,
}

impl Standing {
    /// By a ratio of what should be small, where less than `same` either way means nothing.
    pub(super) fn of_ratio(ratio: f64, same: f64) -> Standing {
        if ratio > same {
            Standing::Worse
        } else if ratio * same < 1.0 {
            Standing::Better
        } else if ratio.is_nan() {
            Standing::Undecided
        } else {
            Standing::Same
        }
    }

    /// Whether two things were held against each other.
    pub(super) fn compares(self) -> bool {
        !matches!(self, Standing::NotApplicable | Standing::Shown | Standing::Undecided)
    }

    pub(super) fn word(self) -> &'static str {
        match self {
            Standing::Better => "better",
            Standing::Same => "same",
            Standing::Worse => "worse",
            Standing::Dearer => "dearer",
            Standing::Undecided => "undecided",
            Standing::NotApplicable => "not applicable",
            Standing::Shown => "",
        }
    }
}

/// One quantity of one scene on either side.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) scene: String,
    pub(super) scheme: String,
    pub(super) quantity: String,
    /// What kind it is on either side: an order, a class of drift.
    pub(super) kinds: [String; 2],
    /// How large it is on either side.
    pub(super) sizes: [String; 2],
    /// Size of the second over that of the first, at equal step.
    pub(super) ratio: Option<f64>,
    /// The same at equal work.
    pub(super) at_equal_work: Option<f64>,
    pub(super) standing: Standing,
    /// Why, where there is something to say.
    pub(super) why: Option<String>,
}

impl Row {
    /// The cells after the scene and the scheme.
    pub(super) fn words(&self) -> [String; 8] {
        let number = |value: Option<f64>| match value {
            Some(value) if (1e-3..1e4).contains(&value) => format!("{value:.3}"),
            Some(value) => format!("{value:.1e}"),
            None => "–".to_owned(),
        };
        let [kind_a, kind_b] = self.kinds.clone();
        let [size_a, size_b] = self.sizes.clone();
        [
            self.quantity.clone(),
            kind_a,
            kind_b,
            size_a,
            size_b,
            number(self.ratio),
            number(self.at_equal_work),
            match &self.why {
                Some(why) => format!("{}: {why}", self.standing.word()),
                None => self.standing.word().to_owned(),
            },
        ]
    }
}
