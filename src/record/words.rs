//! Enumerations that are words in files.

/// An enumeration with a word for each value, which stands in files and in print.
macro_rules! words {
    ($(#[$meta:meta])* $name:ident { $($(#[$each:meta])* $value:ident = $word:literal,)+ }) => {
        $(#[$meta])*
        #[derive(
            Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize,
        )]
        pub enum $name {
            $($(#[$each])* #[serde(rename = $word)] $value,)+
        }

        impl $name {
            /// Every value.
            pub const ALL: [$name; [$($word),+].len()] = [$($name::$value),+];

            /// The word that stands in records and tables.
            pub fn word(self) -> &'static str {
                match self {
                    $($name::$value => $word,)+
                }
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.pad(self.word())
            }
        }
    };
}

pub(super) use words;

#[cfg(test)]
mod tests {
    use crate::record::{ClaimName, DriftClass, OrderStatus, Ruling, RunStatus};

    #[test]
    fn a_file_has_the_word_of_a_value() {
        let text = |json: serde_json::Result<String>| json.expect("JSON");
        for claim in ClaimName::ALL {
            assert_eq!(text(serde_json::to_string(&claim)), format!("\"{claim}\""));
        }
        assert_eq!(text(serde_json::to_string(&Ruling::NotApplicable)), "\"not-applicable\"");
        assert_eq!(text(serde_json::to_string(&RunStatus::Broken)), "\"broken\"");
        assert_eq!(serde_json::from_str::<OrderStatus>("\"too-few\"").ok(), Some(OrderStatus::TooFew));
        assert_eq!(serde_json::from_str::<DriftClass>("\"secular\"").ok(), Some(DriftClass::Secular));
        assert!(serde_json::from_str::<ClaimName>("\"no-such-claim\"").is_err());
    }
}
