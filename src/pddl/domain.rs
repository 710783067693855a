//! Domains: types, constants, predicates and action schemas.

use rustc_hash::FxHashMap;

use super::atom::Scope;
use super::cost::Functions;
use super::error::PddlError;
use super::expression::{Expression, Expressions, Tree};
use super::feature::{check_requirements, unsupported};
use super::object::Objects;
use super::predicate::Predicates;
use super::schema::Schema;
use super::types::Types;

/// A domain.
#[derive(Debug, Clone)]
pub struct Domain {
    /// Its name, in small letters.
    pub name: String,
    /// Its types.
    pub types: Types,
    /// Its constants.
    pub constants: Objects,
    /// Its predicates.
    pub predicates: Predicates,
    /// Its functions.
    pub functions: Functions,
    /// Its actions, in the order of the text.
    pub schemas: Vec<Schema>,
}

impl Domain {
    /// The position of the first action of the name that the one at a position has.
    pub fn first_case(&self, schema: usize) -> usize {
        let name = &self.schemas[schema].name;
        self.schemas.iter().position(|other| other.name == *name).unwrap_or(schema)
    }

    /// The predicates that actions change, by their numbers, some of them several times.
    pub fn changing(&self) -> impl Iterator<Item = usize> {
        let atoms = self.schemas.iter().flat_map(|schema| {
            let always = schema.effect.positive.iter().chain(&schema.effect.negative);
            always.chain(schema.conditional.iter().map(|effect| &effect.atom))
        });
        atoms.map(|atom| atom.predicate.index())
    }
}

/// Reads a domain.
///
/// # Errors
///
/// [`PddlError`] with the place of what is wrong or not supported.
///
/// ```
/// let domain = mo_copp::pddl::read_domain(
///     "(define (domain Lamp) (:predicates (lit))
///        (:action Switch-On :precondition (not (lit)) :effect (lit)))",
/// )?;
/// assert_eq!((domain.name.as_str(), domain.schemas[0].name.as_str()), ("lamp", "switch-on"));
/// # Ok::<(), mo_copp::pddl::PddlError>(())
/// ```
pub fn read_domain(text: &str) -> Result<Domain, PddlError> {
    const KNOWN: [&str; 5] = [":requirements", ":types", ":constants", ":predicates", ":functions"];
    let tree = Tree::read(text)?;
    let (name, items) = define(&tree, "domain")?;
    let mut sections: [Option<Expressions<'_>>; 5] = Default::default();
    let mut actions = Vec::new();
    for item in items {
        const EXPECTED: &str =
            "a section: :requirements, :types, :constants, :predicates, :functions or :action";
        let (head, items) = item.headed(EXPECTED)?;
        if head.is(":action") {
            actions.push((item, items));
        } else {
            section(&mut sections, &KNOWN, (item, head, items), EXPECTED)?;
        }
    }
    let [requirements, types, constants, predicates, functions] = sections;
    requirements.map_or(Ok(()), check_requirements)?;
    let types = types.map_or_else(|| Ok(Types::untyped()), Types::read)?;
    let mut objects = Objects::default();
    constants.map_or(Ok(()), |items| objects.read(&types, items))?;
    let predicates = predicates
        .map_or_else(|| Ok(Predicates::default()), |items| Predicates::read(&types, items))?;
    let functions = functions
        .map_or_else(|| Ok(Functions::default()), |items| Functions::read(&types, items))?;
    let scope = Scope {
        types: &types,
        predicates: &predicates,
        objects: &objects,
        functions: &functions,
        parameters: None,
    };
    let mut names: FxHashMap<String, usize> = FxHashMap::default();
    let mut schemas = Vec::with_capacity(actions.len());
    for (place, items) in actions {
        let schema = Schema::read(&scope, place, items)?;
        // Some domains declare an action for each of several places in which it can be taken.
        let first = *names.entry(schema.name.clone()).or_insert(schemas.len());
        if schemas.get(first).is_some_and(|first: &Schema| !first.is_case_of(&schema)) {
            let found = format!("the action {} for the second time", schema.name);
            let expected = "each action declared once, or with the same parameters and cost";
            return Err(place.wrong(found, expected));
        }
        schemas.push(schema);
    }
    Ok(Domain { name, types, constants: objects, predicates, functions, schemas })
}

/// `(define (KIND name) …)`: the name, and what follows.
pub(super) fn define<'t>(
    tree: &'t Tree<'_>,
    kind: &str,
) -> Result<(String, Expressions<'t>), PddlError> {
    let expected = format!("(define ({kind} …) …)");
    // What the text begins with is told before what follows too much.
    if let Some(first) = tree.expressions().next() {
        let (head, _) = first.headed(&expected)?;
        if !head.is("define") {
            return Err(head.expected(&expected));
        }
    }
    let whole = tree.only(&expected)?;
    let (_, mut items) = whole.headed(&expected)?;
    let expected = format!("({kind} …)");
    let Some(title) = items.next() else {
        return Err(whole.expected(&expected));
    };
    let (word, mut rest) = title.headed(&expected)?;
    match (rest.next(), rest.next()) {
        (Some(name), None) if word.is(kind) => Ok((name.name("a name")?, items)),
        _ => Err(title.expected(&expected)),
    }
}

/// Keeps a section that may stand once.
pub(super) fn section<'t, const N: usize>(
    sections: &mut [Option<Expressions<'t>>; N],
    known: &[&str; N],
    (place, head, items): (Expression<'t>, Expression<'t>, Expressions<'t>),
    expected: &str,
) -> Result<(), PddlError> {
    let Some(number) = known.iter().position(|known| head.is(known)) else {
        return Err(unsupported(place, head).unwrap_or_else(|| head.expected(expected)));
    };
    if sections[number].replace(items).is_some() {
        let found = format!("{} for the second time", head.shown());
        return Err(head.wrong(found, "each section once"));
    }
    Ok(())
}
