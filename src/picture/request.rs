//! What other programs ask of a picture.

use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Reader;
use crate::problem::Problem;

use super::{Boards, PictureOptions, Steps, Theme};

const KEYS: [&str; 9] = [
    "step",
    "animate",
    "milliseconds",
    "board",
    "captions",
    "true_goal",
    "ended",
    "numbers",
    "theme",
];

/// The options written as a JSON object, as the JavaScript API takes them; `last` is the last step of the plan, which is
/// drawn where no other is named.
///
/// # Errors
///
/// [`DocumentError`] with the option, what was given and what would do.
///
/// ```
/// use mo_copp::{domain::Delivery, picture::{Steps, read_picture_options}};
/// let problem = Delivery::figure_1().problem()?;
/// let options = read_picture_options(r#"{"theme": "dark"}"#, &problem, 3)?;
/// assert_eq!(options.steps, Steps::One(3));
/// let error = read_picture_options(r#"{"step": 4}"#, &problem, 3).unwrap_err();
/// assert_eq!(error.to_string(), "step: found 4, expected a whole number from 0 to 3");
/// # Ok::<(), mo_copp::document::DocumentError>(())
/// ```
pub fn read_picture_options(
    text: &str,
    problem: &Problem,
    last: usize,
) -> Result<PictureOptions, DocumentError> {
    let json = Json::parse(text)?;
    let fields = Reader::of("options", &json).fields(&KEYS)?;
    let mut options = PictureOptions::step(last);
    if let Some(step) = fields.optional("step") {
        options.steps = Steps::One(step.integer(0..=last as u32)? as usize);
    }
    if let Some(animate) = fields.optional("animate")
        && animate.boolean()?
    {
        options.steps = Steps::Animated { milliseconds: 1000 };
    }
    if let Some(reader) = fields.optional("milliseconds") {
        let milliseconds = reader.integer(100..=60_000)?;
        if let Steps::Animated { .. } = options.steps {
            options.steps = Steps::Animated { milliseconds };
        }
    }
    if let Some(board) = fields.optional("board") {
        options.boards = match board.text()? {
            "all" => Boards::All,
            "actor" => Boards::Actor,
            name => {
                let observer = problem.observer_named(name);
                let expected = "all, actor or the name of an observer";
                Boards::Observer(observer.ok_or_else(|| board.expected(expected))?)
            }
        };
    }
    if let Some(captions) = fields.optional("captions") {
        options.captions = captions.boolean()?;
    }
    if let Some(true_goal) = fields.optional("true_goal") {
        options.true_goal = true_goal.boolean()?;
    }
    if let Some(ended) = fields.optional("ended") {
        options.ended = ended.boolean()?;
    }
    if let Some(numbers) = fields.optional("numbers") {
        options.numbers = numbers.boolean()?;
    }
    if let Some(theme) = fields.optional("theme") {
        let named = Theme::named(theme.text()?);
        options.theme = named.ok_or_else(|| theme.expected("light or dark"))?;
    }
    Ok(options)
}
