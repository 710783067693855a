//! Patterns over operators: what a sensor goes by.
//!
//! `*` matches every operator, `stack` every one of that name, and `(stack a ?x - small)` those whose
//! arguments fit: an object is itself, a variable is anything of the type, or of the *group* of
//! objects, or `(either …)` of them, that stands behind its dash (and, as everywhere in PDDL, behind those before it that have
//! no dash). A variable that stands twice is the same object twice.

use std::sync::Arc;

use super::atom::{Scope, arguments_of};
use super::condition::Condition;
use super::definition::TaskDefinition;
use super::domain::Domain;
use super::error::PddlError;
use super::expression::{Expression, Tree};
use super::formula::Formula;
use super::literals::MAX_LITERALS;
use super::object::ObjectId;
use super::schema::{Parameters, Schema};
use super::types::{TypeSet, Typed, some, typed_list};

/// Objects that go by one name, sorted.
pub type Group = (String, Vec<ObjectId>);

/// What stands in the place of an argument.
#[derive(Debug, Clone)]
enum Argument {
    Object(ObjectId),
    /// The first place of a variable, and what it must be.
    Variable(Kind),
    /// The same as the argument at this position.
    Same(usize),
}

#[derive(Debug, Clone)]
enum Kind {
    Anything,
    Types(Arc<TypeSet>),
    /// One of these, sorted: of a group, or of several groups and types.
    Group(Vec<ObjectId>),
}

impl Kind {
    /// What stands behind a dash: a type, a group, or several of them with `either`. `wanted` are
    /// the types that the argument has anyhow.
    fn read(
        domain: &Domain,
        task: &TaskDefinition,
        groups: &[Group],
        typed: &Typed<'_>,
        kind: Expression<'_>,
        wanted: &TypeSet,
    ) -> Result<Self, PddlError> {
        let expected = domain.types.written(wanted);
        let group = |place: Expression<'_>| {
            let found = groups.iter().find(|(name, _)| place.is(name));
            found.map(|(_, objects)| objects.as_slice())
        };
        let or_group = |mut error: PddlError| {
            if !groups.is_empty() {
                let names = some(groups.iter().map(|(name, _)| name.as_str()));
                error.expected = format!("{}; or a group: {names}", error.expected);
            }
            error
        };
        let alternatives = typed.alternatives().map_err(or_group)?;
        if !alternatives.iter().any(|&place| group(place).is_some()) {
            let types = domain.types.resolve(typed).map_err(or_group)?;
            if !types.meets(wanted) {
                return Err(kind.expected(&expected));
            }
            return Ok(Self::Types(types));
        }
        let mut objects = Vec::new();
        for place in alternatives {
            match group(place) {
                Some(members) => objects.extend_from_slice(members),
                None => {
                    let types = domain.types.find_set(place).map_err(or_group)?;
                    let is_of = |id: &ObjectId| task.objects.types(*id).is_within(types);
                    objects.extend(task.objects.ids().filter(is_of));
                }
            }
        }
        objects.sort_unstable();
        objects.dedup();
        if !objects.iter().any(|&id| task.objects.types(id).is_within(wanted)) {
            return Err(kind.expected(&format!("a group with a {expected}")));
        }
        Ok(Self::Group(objects))
    }
}

/// A pattern over the operators of a task.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// None for any.
    schema: Option<usize>,
    /// None for whatever there are.
    arguments: Option<Vec<Argument>>,
    variables: Parameters,
    /// The argument each variable stands for.
    places: Vec<usize>,
}

const EXPECTED: &str = "an operator: *, a name, or a pattern as in (stack ?x ?y)";

impl Pattern {
    /// Reads a pattern over the objects of a task and these groups of them.
    ///
    /// # Errors
    ///
    /// [`PddlError`] with the place in this text, also for a pattern that can match no operator: an
    /// action the domain does not have, another number of arguments, objects or types that never
    /// stand there.
    pub fn read(
        domain: &Domain,
        task: &TaskDefinition,
        groups: &[Group],
        text: &str,
    ) -> Result<Self, PddlError> {
        let tree = Tree::read(text)?;
        let whole = tree.only(EXPECTED)?;
        let mut pattern = Self {
            schema: None,
            arguments: None,
            variables: Parameters::default(),
            places: Vec::new(),
        };
        if whole.is("*") {
            return Ok(pattern);
        }
        if whole.symbol().is_some() {
            pattern.schema = Some(schema(domain, whole)?);
            return Ok(pattern);
        }
        let (head, items) = whole.headed(EXPECTED)?;
        let number = schema(domain, head)?;
        let schema = &domain.schemas[number];
        let items = typed_list(items)?;
        let count = schema.parameters.len();
        if items.len() != count {
            let found = format!("{} with {}", schema.name, arguments_of(items.len()));
            return Err(whole.wrong(found, arguments_of(count)));
        }
        pattern.schema = Some(number);
        let mut arguments = Vec::with_capacity(count);
        for (position, typed) in items.iter().enumerate() {
            let types = schema.parameters.shared_types(position as u32);
            let first = |place: usize| items.get(place);
            let argument =
                pattern.argument(domain, task, groups, typed, (position, types), first)?;
            arguments.push(argument);
        }
        pattern.arguments = Some(arguments);
        Ok(pattern)
    }

    fn argument<'t>(
        &mut self,
        domain: &Domain,
        task: &TaskDefinition,
        groups: &[Group],
        typed: &Typed<'t>,
        (position, wanted): (usize, &Arc<TypeSet>),
        item: impl Fn(usize) -> Option<&'t Typed<'t>>,
    ) -> Result<Argument, PddlError> {
        let place = typed.item;
        let expected = || domain.types.written(wanted);
        if !place.symbol().is_some_and(|name| name.starts_with('?')) {
            let object = task.objects.find(place)?;
            if !task.objects.types(object).is_within(wanted) {
                return Err(place.expected(&expected()));
            }
            return Ok(Argument::Object(object));
        }
        let name = place.variable()?;
        if let Some(variable) = self.variables.position(&name) {
            let first = self.places[variable as usize];
            // In `?x ?x - room` one dash types both.
            let same_dash = item(first).is_some_and(|first| first.is_typed_as(typed));
            if let Some(kind) = typed.kind.filter(|_| !same_dash) {
                let found = format!("a type behind {} for the second time", place.shown());
                return Err(kind.wrong(found, "none there"));
            }
            return Ok(Argument::Same(first));
        }
        let kind = match typed.kind {
            None => Kind::Anything,
            Some(kind) => Kind::read(domain, task, groups, typed, kind, wanted)?,
        };
        let types = match &kind {
            Kind::Types(types) => Arc::clone(types),
            Kind::Anything | Kind::Group(_) => Arc::clone(wanted),
        };
        self.variables.push(place, name, types)?;
        self.places.push(position);
        Ok(Argument::Variable(kind))
    }

    /// The action's schema and the arguments, where all of these are objects.
    pub fn operator(&self) -> Option<(usize, Vec<ObjectId>)> {
        let object = |argument: &Argument| match argument {
            Argument::Object(object) => Some(*object),
            Argument::Variable(_) | Argument::Same(_) => None,
        };
        let arguments = self.arguments.as_ref()?.iter().map(object).collect::<Option<_>>()?;
        Some((self.schema?, arguments))
    }

    /// The position of the action's schema in the domain; none for any.
    pub fn schema(&self) -> Option<usize> {
        self.schema
    }

    /// Whether every operator of its schema matches.
    pub fn takes_all_arguments(&self) -> bool {
        self.arguments.is_none()
    }

    /// The argument that a variable stands for; its name is in small letters, its question mark
    /// included.
    pub fn place(&self, variable: &str) -> Option<usize> {
        self.variables.position(variable).map(|position| self.places[position as usize])
    }

    /// Its variables, for an error.
    pub fn written_variables(&self) -> String {
        self.variables.written()
    }

    /// Whether an operator matches.
    pub fn matches(&self, task: &TaskDefinition, schema: usize, objects: &[ObjectId]) -> bool {
        self.schema.is_none_or(|wanted| wanted == schema)
            && (0..objects.len())
                .all(|place| self.allows(task, place, objects[place], &objects[..place]))
    }

    /// Whether an object may stand in a place, after those in the places before it.
    pub(super) fn allows(
        &self,
        task: &TaskDefinition,
        place: usize,
        object: ObjectId,
        before: &[ObjectId],
    ) -> bool {
        let argument = self.arguments.as_ref().and_then(|arguments| arguments.get(place));
        argument.is_none_or(|argument| match argument {
            Argument::Object(wanted) => *wanted == object,
            Argument::Same(other) => before.get(*other) == Some(&object),
            Argument::Variable(Kind::Anything) => true,
            Argument::Variable(Kind::Types(types)) => task.objects.types(object).is_within(types),
            Argument::Variable(Kind::Group(group)) => group.binary_search(&object).is_ok(),
        })
    }

    /// Reads a condition over the pattern's variables and the objects of the task.
    ///
    /// # Errors
    ///
    /// [`PddlError`] with the place in this text.
    pub fn read_condition(
        &self,
        domain: &Domain,
        task: &TaskDefinition,
        text: &str,
    ) -> Result<Formula, PddlError> {
        let scope = Scope {
            types: &domain.types,
            predicates: &domain.predicates,
            objects: &task.objects,
            functions: &domain.functions,
            parameters: Some(&self.variables),
        };
        let tree = Tree::read(text)?;
        let whole = tree.only("a condition, as in (and (on ?x ?y) (clear ?x))")?;
        let formula = Formula::read(&scope, whole)?;
        if formula.len() > MAX_LITERALS {
            let found = format!("{} literals", formula.len());
            return Err(whole.wrong(found, format!("at most {MAX_LITERALS} in one condition")));
        }
        Ok(formula)
    }

    /// What such a condition says for an operator that matches; none where that is too much once its quantifiers
    /// are expanded.
    pub fn condition(
        &self,
        task: &TaskDefinition,
        formula: &Formula,
        objects: &[ObjectId],
    ) -> Option<Condition> {
        let values: Vec<ObjectId> = self.places.iter().map(|&place| objects[place]).collect();
        Condition::of(formula, &task.objects, &values)
    }
}

/// The action of this name.
fn schema(domain: &Domain, place: Expression<'_>) -> Result<usize, PddlError> {
    let name = place.name("the name of an action")?;
    domain.schemas.iter().position(|schema| schema.name == name).ok_or_else(|| {
        let names = some(domain.schemas.iter().map(|schema: &Schema| schema.name.as_str()));
        place.wrong(
            format!("the undeclared action {}", place.shown()),
            format!("an action of the domain: {names}"),
        )
    })
}
