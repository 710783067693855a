//! Runs of a text that are set in one font: what the program's own font does not have is marked, cluster by cluster.

use std::borrow::Cow;
use std::fmt::Write;

use resvg::usvg::roxmltree::{Document, Error, Node};
use unicode_segmentation::UnicodeSegmentation;

use crate::document::is_hidden;

use super::super::svg::Escaped;
use super::fonts::{Fonts, Style, Substitute};

/// Marks in all texts of an SVG what is set in another font than the program's own. Also the characters that no font has.
///
/// A text that is left as it is would be set in the other font from end to end, if that one has all of its letters.
pub(super) fn set<'a>(svg: &'a str, fonts: &mut Fonts) -> Result<(Cow<'a, str>, Vec<char>), Error> {
    let xml = Document::parse(svg)?;
    let mut marked = String::new();
    let mut done = 0;
    let mut boxes = Vec::new();
    for node in xml.descendants().filter(is_shown) {
        let text = node.text().unwrap_or_default();
        let runs = runs(text, style(node), fonts, &mut boxes);
        if runs.iter().all(|(font, _)| font.is_none()) {
            continue;
        }
        let range = node.range();
        marked.push_str(&svg[done..range.start]);
        for (font, run) in runs {
            let run = Escaped(&run);
            // Writing to a text cannot fail.
            let _ = match font {
                None => write!(marked, "{run}"),
                Some(font) => {
                    write!(marked, r#"<tspan font-family="{}">{run}</tspan>"#, font.family())
                }
            };
        }
        done = range.end;
    }
    if done == 0 {
        return Ok((Cow::Borrowed(svg), boxes));
    }
    marked.push_str(&svg[done..]);
    Ok((Cow::Owned(marked), boxes))
}

fn is_shown(node: &Node<'_, '_>) -> bool {
    node.is_text() && node.parent().is_some_and(|parent| parent.tag_name().name() == "text")
}

/// How a text is written, by the attributes around it.
fn style(text: Node<'_, '_>) -> Style {
    let given = |name| text.ancestors().find_map(|node| node.attribute(name));
    let weight = given("font-weight").and_then(|weight| weight.parse().ok()).unwrap_or(400);
    Style::new(weight, given("font-style").is_some_and(|style| style != "normal"))
}

/// The parts of a text with the font of each; none for the program's own.
fn runs(
    text: &str,
    style: Style,
    fonts: &mut Fonts,
    boxes: &mut Vec<char>,
) -> Vec<(Option<Substitute>, String)> {
    let mut runs: Vec<(Option<Substitute>, String)> = Vec::new();
    let mut add = |font, part: &str| match runs.last_mut() {
        Some((last, run)) if *last == font => run.push_str(part),
        _ => runs.push((font, part.to_owned())),
    };
    for cluster in text.graphemes(true) {
        // What joins or varies the characters beside it has no form of its own.
        let visible: Vec<char> = cluster.chars().filter(|&part| !is_hidden(part)).collect();
        if fonts.own_has(style, &visible) {
            add(None, cluster);
        } else if let Some(font) = fonts.substitute(style, &visible) {
            add(Some(font), cluster);
        } else {
            // No font has all of it: each character by itself.
            for part in visible {
                let known = fonts.own_has(style, &[part]);
                let font = if known { None } else { fonts.substitute(style, &[part]) };
                if !known && font.is_none() && !boxes.contains(&part) {
                    boxes.push(part);
                }
                add(font, part.encode_utf8(&mut [0; 4]));
            }
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn marked(text: &str) -> (String, Vec<char>) {
        let svg = format!("<svg><title>{text}</title><text>{text}</text></svg>");
        let (set, boxes) = set(&svg, &mut Fonts::new()).unwrap();
        (set.into_owned().replace(&format!("<title>{text}</title>"), ""), boxes)
    }

    #[test]
    fn what_the_own_font_has_is_left_as_it_is() {
        for text in ["", "G1 &amp; &lt;G2>", "Größe Ж Ω … ✓ ★ e\u{301}", "\u{200b}", "a\u{fe0f}"]
        {
            assert_eq!(marked(text), (format!("<svg><text>{text}</text></svg>"), vec![]), "{text}");
        }
    }

    #[test]
    fn what_no_font_has_is_told_once() {
        let text = "a\u{378}b\u{378}\u{379}";
        let boxes = vec!['\u{378}', '\u{379}'];
        assert_eq!(marked(text), (format!("<svg><text>{text}</text></svg>"), boxes));
    }

    #[test]
    fn letters_that_the_bold_style_lacks_are_set_in_the_regular_one() {
        let mut fonts = Fonts::new();
        let letter = '\u{1d5a0}';
        assert!(!fonts.own_has(Style::Bold, &[letter]));
        let svg = format!(r#"<svg font-weight="600"><text>A{letter}&lt;B</text></svg>"#);
        let (set, boxes) = set(&svg, &mut fonts).unwrap();
        let expected = format!(
            r#"<svg font-weight="600"><text>A<tspan font-family="mo-copp-substitute-0">{letter}</tspan>&lt;B</text></svg>"#
        );
        assert_eq!((set.as_ref(), boxes), (expected.as_str(), vec![]));
    }
}
