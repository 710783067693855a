//! Colours of pictures, light and dark.
//!
//! Enemy and friend are vermilion and blue, which every common kind of
//! colour blindness tells apart; shapes say the same without colour.

/// Light or dark.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Theme {
    /// Dark signs on a light ground.
    #[default]
    Light,
    /// Light signs on a dark ground.
    Dark,
}

impl Theme {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Light, Self::Dark];

    /// The name in options.
    pub fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Dark => "dark",
        }
    }

    /// The theme of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|theme| theme.name() == name)
    }
}

/// What each thing is painted with, as SVG writes colours.
#[derive(Debug)]
pub(super) struct Palette {
    pub paper: &'static str,
    pub card: &'static str,
    pub ink: &'static str,
    pub muted: &'static str,
    pub floor: &'static str,
    pub wall: &'static str,
    pub star: &'static str,
    pub star_edge: &'static str,
    pub parcel: &'static str,
    pub parcel_edge: &'static str,
    pub enemy: Tone,
    pub friend: Tone,
    pub actor: Tone,
    pub on_strong: &'static str,
}

/// The colours of one side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tone {
    /// For signs and lines.
    pub strong: &'static str,
    /// For the ground of what is believed.
    pub tint: &'static str,
}

const LIGHT: Palette = Palette {
    paper: "#ffffff",
    card: "#fffefb",
    ink: "#22262e",
    muted: "#585e69",
    floor: "#eceae3",
    wall: "#4a505b",
    star: "#f0b429",
    star_edge: "#5c4300",
    parcel: "#ead1a3",
    parcel_edge: "#8a6a35",
    enemy: Tone { strong: "#b3401a", tint: "#f5cdb8" },
    friend: Tone { strong: "#0a62a3", tint: "#b9d9f1" },
    actor: Tone { strong: "#22262e", tint: "#eceae3" },
    on_strong: "#ffffff",
};

const DARK: Palette = Palette {
    paper: "#14171c",
    card: "#1c2027",
    ink: "#ecebe6",
    muted: "#a9afba",
    floor: "#2a303a",
    wall: "#0a0c0f",
    star: "#f5c451",
    star_edge: "#2b2000",
    parcel: "#7d6438",
    parcel_edge: "#c8a566",
    enemy: Tone { strong: "#f59265", tint: "#6e3a22" },
    friend: Tone { strong: "#74bdf2", tint: "#1f4f75" },
    actor: Tone { strong: "#ecebe6", tint: "#2a303a" },
    on_strong: "#14171c",
};

impl Palette {
    pub(super) fn of(theme: Theme) -> &'static Self {
        match theme {
            Theme::Light => &LIGHT,
            Theme::Dark => &DARK,
        }
    }
}
