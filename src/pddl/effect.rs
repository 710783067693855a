//! Effects of actions: what is added and deleted, always or under a condition, for one or for all objects.

use super::atom::{LiftedAtom, Scope};
use super::cost::CostTerm;
use super::error::PddlError;
use super::expression::Expression;
use super::formula::{Bound, Formula, atom, quantified};
use super::literals::Literals;

const EXPECTED: &str = "an effect, as in (on ?x ?y), (not (on ?x ?y)), (when … …) or (and …)";

/// An atom that is added (true) or deleted where a condition holds, for all objects in the places of variables.
#[derive(Debug, Clone)]
pub struct ConditionalEffect {
    /// The variables of `forall` around it.
    pub variables: Vec<Bound>,
    /// What must hold before.
    pub condition: Formula,
    /// The atom.
    pub atom: LiftedAtom,
    /// Whether it is added.
    pub add: bool,
}

/// The effects of an action.
#[derive(Debug, Clone, Default)]
pub struct Effects {
    /// What is added (positive) and deleted (negative) always. What is both is added.
    pub always: Literals,
    /// The others.
    pub conditional: Vec<ConditionalEffect>,
    /// What the action costs: the sum of these.
    pub cost: Vec<CostTerm>,
}

/// Where in an effect one stands.
#[derive(Clone)]
struct Around {
    variables: Vec<Bound>,
    condition: Vec<Formula>,
}

impl Effects {
    /// Reads an effect. Recurses as deep as parentheses are nested, which is bounded.
    pub(super) fn read(scope: &Scope<'_>, place: Expression<'_>) -> Result<Self, PddlError> {
        let mut effects = Self::default();
        let around = Around { variables: Vec::new(), condition: Vec::new() };
        effects.part(scope, place, &around)?;
        Ok(effects)
    }

    /// How many literals there are, those in conditions among them.
    pub(super) fn len(&self) -> usize {
        let of_one = |effect: &ConditionalEffect| 1 + effect.condition.len();
        self.always.len() + self.conditional.iter().map(of_one).sum::<usize>()
    }

    fn part(
        &mut self,
        scope: &Scope<'_>,
        place: Expression<'_>,
        around: &Around,
    ) -> Result<(), PddlError> {
        if place.list().is_some_and(|mut items| items.next().is_none()) {
            return Ok(());
        }
        let (head, mut items) = place.headed(EXPECTED)?;
        let name = head.symbol().unwrap_or_default().to_ascii_lowercase();
        let declared = scope.predicates.named(&name).is_some();
        match name.as_str() {
            "and" => items.try_for_each(|item| self.part(scope, item, around)),
            "when" if !declared => {
                let (Some(condition), Some(effect), None) =
                    (items.next(), items.next(), items.next())
                else {
                    return Err(place.expected("(when CONDITION EFFECT)"));
                };
                let mut around = around.clone();
                around.condition.push(Formula::read(scope, condition)?);
                self.part(scope, effect, &around)
            }
            "forall" if !declared => {
                let (Some(variables), Some(effect), None) =
                    (items.next(), items.next(), items.next())
                else {
                    return Err(place.expected("(forall (?variable …) EFFECT)"));
                };
                let (parameters, bound) = quantified(scope, variables)?;
                let mut around = around.clone();
                around.variables.extend(bound);
                let inner = Scope { parameters: Some(&parameters), ..*scope };
                self.part(&inner, effect, &around)
            }
            "increase" if !declared => {
                if !around.condition.is_empty() || !around.variables.is_empty() {
                    let found = format!("{} under a condition or for all", place.shown());
                    return Err(place.wrong(found, "a cost that the action always has"));
                }
                self.cost.push(CostTerm::read(scope, place, items)?);
                Ok(())
            }
            "=" => Err(place.expected("an effect, which cannot make things equal")),
            "not" => {
                let (Some(negated), None) = (items.next(), items.next()) else {
                    return Err(place.expected("(not …) with one atom"));
                };
                let (head, _) = negated.headed("an atom")?;
                if ["and", "or", "not", "="].iter().any(|word| head.is(word)) {
                    return Err(negated.expected("an atom"));
                }
                self.push(atom(scope, negated)?, false, around);
                Ok(())
            }
            _ => {
                self.push(atom(scope, place)?, true, around);
                Ok(())
            }
        }
    }

    fn push(&mut self, atom: LiftedAtom, add: bool, around: &Around) {
        if around.condition.is_empty() && around.variables.is_empty() {
            if add {
                self.always.positive.push(atom);
            } else {
                self.always.negative.push(atom);
            }
            return;
        }
        self.conditional.push(ConditionalEffect {
            variables: around.variables.clone(),
            condition: Formula::And(around.condition.clone()),
            atom,
            add,
        });
    }
}
