//! Which packs there are: what a page alone needs is its own, what several need is shared.

use crate::slim::{Node, Slim, closure};
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;

/// What a list of packs must hold.
pub type Need = BTreeSet<Node>;

/// For each page the nodes that stand for it: its data and its functions.
///
/// The module keeps tables of all pages, two addresses for each; no other data name as many.
///
/// # Errors
/// There is no such table.
pub fn entries(module: &Slim, pages: usize) -> Result<Vec<Vec<Node>>, Box<dyn Error>> {
    let table = |node: &Node| match node {
        Node::Datum(d) => {
            module.data[*d].1.len() == 8 * pages && module.names[node].len() == 2 * pages
        }
        Node::Function(_) => false,
    };
    let mut entries = vec![Vec::new(); pages];
    for (_, names) in module.names.iter().filter(|(node, _)| table(node)) {
        for (entry, pair) in entries.iter_mut().zip(names.chunks(2)) {
            entry.extend(pair);
        }
    }
    if entries.iter().any(Vec::is_empty) {
        return Err(format!("no table of {pages} pages is in the module").into());
    }
    Ok(entries)
}

/// All that a page may need, whatever is called.
pub fn reached(module: &Slim, entries: &[Vec<Node>], page: usize) -> Need {
    let own: BTreeSet<&Node> = entries[page].iter().collect();
    let others: BTreeSet<&Node> = entries
        .iter()
        .flatten()
        .filter(|node| !own.contains(node))
        .collect();
    closure(
        module.roots(),
        |node| module.names[&node].clone(),
        |node| !others.contains(&node),
    )
}

/// These functions and the data that they name, as far as a page may need it.
pub fn with_data(module: &Slim, functions: Need, reached: &Need) -> Need {
    let wanted = |node: Node| {
        functions.contains(&node) || (matches!(node, Node::Datum(_)) && reached.contains(&node))
    };
    let roots = functions.iter().copied().chain(module.roots());
    closure(roots, |node| module.names[&node].clone(), wanted)
}

/// Nodes that the same lists need.
#[derive(Clone, Debug, Default)]
pub struct Group {
    /// The numbers of the lists.
    pub lists: BTreeSet<usize>,
    pub nodes: BTreeSet<Node>,
    pub bytes: usize,
}

impl Group {
    /// How many bytes more the lists load if the two are one.
    fn cost(&self, other: &Self) -> usize {
        let gain = |from: &Self, to: &Self| from.bytes * to.lists.difference(&from.lists).count();
        gain(self, other) + gain(other, self)
    }

    fn join(&mut self, other: &Self) {
        self.lists.extend(&other.lists);
        self.nodes.extend(&other.nodes);
        self.bytes += other.bytes;
    }
}

/// Groups of what the same lists need. Two are joined as long as what lists then load in vain
/// is less than `file` bytes for each list that then has a file less, and this grows until no
/// list has more than `most` files.
pub fn groups(module: &Slim, needs: &[Need], most: usize, file: usize) -> Vec<Group> {
    let mut users: BTreeMap<Node, BTreeSet<usize>> = BTreeMap::new();
    for (list, need) in needs.iter().enumerate() {
        for node in need {
            users.entry(*node).or_default().insert(list);
        }
    }
    let mut by_lists: BTreeMap<BTreeSet<usize>, Group> = BTreeMap::new();
    for (node, lists) in users {
        let group = by_lists.entry(lists.clone()).or_insert_with(|| Group {
            lists,
            ..Group::default()
        });
        group.nodes.insert(node);
        group.bytes += match node {
            Node::Function(f) => module.bodies[f].len(),
            Node::Datum(d) => module.data[d].1.len(),
        };
    }
    let mut groups: Vec<Group> = by_lists.into_values().collect();
    let mut file = file;
    loop {
        join(&mut groups, file);
        let files = |list: usize| {
            groups
                .iter()
                .filter(|group| group.lists.contains(&list))
                .count()
        };
        if (0..needs.len()).all(|list| files(list) <= most) {
            return groups;
        }
        file += file / 4 + 1;
    }
}

/// Joins groups as long as this pays.
fn join(groups: &mut Vec<Group>, file: usize) {
    let loss = |a: &Group, b: &Group| {
        let both = a.lists.intersection(&b.lists).count();
        (both > 0)
            .then(|| a.cost(b).checked_signed_diff(file * both))
            .flatten()
    };
    let best = |groups: &[Group], row: usize| {
        let others = (0..groups.len()).filter(|other| *other != row);
        others
            .filter_map(|other| Some((loss(&groups[row], &groups[other])?, other)))
            .min()
    };
    let mut bests: Vec<_> = (0..groups.len()).map(|row| best(groups, row)).collect();
    loop {
        let pairs = bests
            .iter()
            .enumerate()
            .filter_map(|(row, best)| best.map(|(loss, other)| (loss, row, other)));
        let Some((lost, a, b)) = pairs.min() else {
            break;
        };
        if lost > 0 {
            break;
        }
        let (a, b) = (a.min(b), a.max(b));
        let gone = groups.swap_remove(b);
        groups[a].join(&gone);
        bests.swap_remove(b);
        let moved = groups.len();
        for row in 0..groups.len() {
            bests[row] = match bests[row] {
                Some(found) if row != a && ![a, b, moved].contains(&found.1) => {
                    let with = loss(&groups[row], &groups[a]).map(|loss| (loss, a));
                    Some(with.map_or(found, |with| with.min(found)))
                }
                _ => best(groups, row),
            };
        }
    }
}
