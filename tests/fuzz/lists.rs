//! Changes of lists, and of texts of nested lists such as PDDL.

use crate::dice::Dice;

/// One item left out, doubled, replaced by a given one, or changed for its neighbour.
pub fn change<T: Clone>(dice: &mut Dice, items: &mut Vec<T>, given: T) {
    if items.is_empty() {
        items.push(given);
        return;
    }
    let at = dice.below(items.len());
    match dice.below(5) {
        0 => drop(items.remove(at)),
        1 => items.insert(at, items[at].clone()),
        2 => items[at] = given,
        3 => items.insert(at, given),
        _ => {
            let with = dice.below(items.len());
            items.swap(at, with);
        }
    }
}

/// A text of nested lists.
#[derive(Clone)]
enum Node {
    Atom(String),
    List(Vec<Node>),
}

/// The text with one list or atom changed, with parts of another text.
pub fn changed_text(dice: &mut Dice, text: &str, other: &str) -> String {
    let mut nodes = read(text);
    let others = read(other);
    let mut all = Vec::new();
    collect(&others, &mut all);
    collect(&nodes, &mut all);
    let given = if all.is_empty() {
        Node::Atom("and".to_owned())
    } else {
        all[dice.below(all.len())].clone()
    };
    let count = count(&nodes);
    let mut at = dice.below(count);
    change_at(dice, &mut nodes, &mut at, &given);
    let mut out = String::new();
    for node in &nodes {
        write(node, &mut out);
    }
    out
}

/// How many lists there are, the whole text included.
fn count(nodes: &[Node]) -> usize {
    1 + nodes
        .iter()
        .map(|node| if let Node::List(items) = node { count(items) } else { 0 })
        .sum::<usize>()
}

/// Changes the list of this number, counted in the order of the text; true when that was done.
fn change_at(dice: &mut Dice, nodes: &mut Vec<Node>, at: &mut usize, given: &Node) -> bool {
    if *at == 0 {
        change(dice, nodes, given.clone());
        return true;
    }
    *at -= 1;
    for node in nodes {
        if let Node::List(items) = node
            && change_at(dice, items, at, given)
        {
            return true;
        }
    }
    false
}

fn collect(nodes: &[Node], found: &mut Vec<Node>) {
    for node in nodes {
        found.push(node.clone());
        if let Node::List(items) = node {
            collect(items, found);
        }
    }
}

/// Lists that are not closed end with the text; a parenthesis too many is left out.
fn read(text: &str) -> Vec<Node> {
    let mut open: Vec<Vec<Node>> = vec![Vec::new()];
    // On one line a comment would swallow the rest.
    let lines = text.lines().map(|line| line.split(';').next().unwrap_or_default());
    let spaced = lines.collect::<Vec<_>>().join("\n").replace('(', " ( ").replace(')', " ) ");
    for word in spaced.split_whitespace() {
        match word {
            // Deeper nesting is tried by tests of its own.
            "(" if open.len() < 60 => open.push(Vec::new()),
            ")" if open.len() > 1 => close(&mut open),
            "(" | ")" => {}
            _ => open.last_mut().unwrap().push(Node::Atom(word.to_owned())),
        }
    }
    while open.len() > 1 {
        close(&mut open);
    }
    open.pop().unwrap()
}

fn close(open: &mut Vec<Vec<Node>>) {
    let items = open.pop().unwrap();
    open.last_mut().unwrap().push(Node::List(items));
}

fn write(node: &Node, out: &mut String) {
    match node {
        Node::Atom(word) => out.push_str(word),
        Node::List(items) => {
            out.push('(');
            for item in items {
                write(item, out);
            }
            out.push(')');
        }
    }
    out.push(' ');
}
