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
    let others: BTreeSet<&Node> =
        entries.iter().flatten().filter(|node| !own.contains(node)).collect();
    closure(module.roots(), |node| module.names[&node].clone(), |node| !others.contains(&node))
}

/// These functions and the data that they name, as far as a page may need it.
pub fn with_data(module: &Slim, functions: Need, reached: &Need) -> Need {
    let wanted = |node: Node| {
        functions.contains(&node) || (matches!(node, Node::Datum(_)) && reached.contains(&node))
    };
    let roots = functions.iter().copied().chain(module.roots());
    closure(roots, |node| module.names[&node].clone(), wanted)
}

/// A list of packs that some page loads.
#[derive(Clone, Debug)]
pub struct List {
    pub page: usize,
    /// How often it is loaded, against others: what is loaded in vain counts as often.
    pub weight: usize,
    pub need: Need,
}

/// What one file more in a list is worth, in bytes before they are compressed: so many more are
/// loaded in vain rather than asked for apart.
const FILE: usize = 10_000;

/// What a byte that is there once more weighs, against one that a list loads in vain.
const COPY: usize = 14;

/// Nodes that go together.
#[derive(Clone, Debug, Default)]
pub struct Group {
    /// The numbers of the lists that load them.
    pub lists: BTreeSet<usize>,
    pub nodes: BTreeSet<Node>,
    bytes: usize,
}

/// Shares the nodes out. Groups of what the same lists need are joined, or put into each page's
/// own, as long as what lists then load in vain, and what is then there more than once, is
/// less than [`FILE`] for each list that has a file less.
pub fn groups(module: &Slim, lists: &[List]) -> Vec<Group> {
    let mut users: BTreeMap<Node, BTreeSet<usize>> = BTreeMap::new();
    for (number, list) in lists.iter().enumerate() {
        for node in &list.need {
            users.entry(*node).or_default().insert(number);
        }
    }
    let mut by_lists: BTreeMap<BTreeSet<usize>, Group> = BTreeMap::new();
    for (node, lists) in users {
        let group =
            by_lists.entry(lists.clone()).or_insert_with(|| Group { lists, ..Group::default() });
        group.nodes.insert(node);
        group.bytes += module.size(node);
    }
    let mut sharing = Sharing { lists, groups: by_lists.into_values().collect() };
    sharing.share();
    sharing.groups
}

/// What becomes of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Step {
    /// It is joined with another.
    Join(usize),
    /// Each of its pages has it among its own.
    Own,
}

struct Sharing<'a> {
    lists: &'a [List],
    groups: Vec<Group>,
}

impl Sharing<'_> {
    fn weight<'l>(&self, lists: impl Iterator<Item = &'l usize>) -> usize {
        lists.map(|list| self.lists[*list].weight).sum()
    }

    /// The lists of a group, page by page.
    fn pages(&self, group: &Group) -> BTreeMap<usize, BTreeSet<usize>> {
        let mut pages: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        for list in &group.lists {
            pages.entry(self.lists[*list].page).or_default().insert(*list);
        }
        pages
    }

    /// What is lost, less what is won, if two groups are one; `None` if they share no list.
    fn joined(&self, a: &Group, b: &Group) -> Option<isize> {
        let both = self.weight(a.lists.intersection(&b.lists));
        let vain = a.bytes * self.weight(b.lists.difference(&a.lists))
            + b.bytes * self.weight(a.lists.difference(&b.lists));
        (both > 0).then(|| vain.checked_signed_diff(FILE * both)).flatten()
    }

    /// The same if each page has the group among its own; `None` if it is one page's.
    fn owned(&self, group: &Group) -> Option<isize> {
        let pages = self.pages(group).len();
        let more = COPY * group.bytes * (pages - 1);
        (pages > 1)
            .then(|| more.checked_signed_diff(FILE * self.weight(group.lists.iter())))
            .flatten()
    }

    /// The best step for a group, and what is lost by it.
    fn best(&self, row: usize) -> Option<(isize, Step)> {
        let group = &self.groups[row];
        let others = (0..self.groups.len()).filter(|other| *other != row);
        let joins = others.filter_map(|other| {
            Some((self.joined(group, &self.groups[other])?, Step::Join(other)))
        });
        joins.chain(self.owned(group).map(|loss| (loss, Step::Own))).min()
    }

    /// Takes the best step as long as it pays.
    fn share(&mut self) {
        let mut bests: Vec<_> = (0..self.groups.len()).map(|row| self.best(row)).collect();
        loop {
            let steps = bests
                .iter()
                .enumerate()
                .filter_map(|(row, best)| best.map(|(loss, step)| (loss, row, step)));
            let Some((_, row, step)) = steps.min().filter(|(loss, ..)| *loss < 0) else {
                return;
            };
            // The groups that change, and those that are gone.
            let (changed, gone) = match step {
                Step::Join(other) => {
                    let joined = self.groups[row.max(other)].clone();
                    self.groups[row.min(other)].take(joined);
                    (vec![row.min(other)], row.max(other))
                }
                Step::Own => (self.own(row), row),
            };
            bests.resize(self.groups.len(), None);
            self.groups.swap_remove(gone);
            bests.swap_remove(gone);
            let moved = self.groups.len();
            let changed: Vec<usize> =
                changed.into_iter().map(|row| if row == moved { gone } else { row }).collect();
            let lost = |other| other == gone || other == moved || changed.contains(&other);
            let again = |(row, found): (usize, Option<(isize, Step)>)| match found {
                Some((_, Step::Join(other))) if lost(other) => self.best(row),
                _ if changed.contains(&row) => self.best(row),
                found => {
                    let joins = changed.iter().filter_map(|other| {
                        let loss = self.joined(&self.groups[row], &self.groups[*other])?;
                        Some((loss, Step::Join(*other)))
                    });
                    joins.chain(found).min()
                }
            };
            bests = bests.into_iter().enumerate().map(again).collect();
        }
    }

    /// Puts a group into each page's own; their numbers.
    fn own(&mut self, row: usize) -> Vec<usize> {
        let group = self.groups[row].clone();
        let mut changed = Vec::new();
        for (_, lists) in self.pages(&group) {
            let own = Group { lists: lists.clone(), ..group.clone() };
            match self.groups.iter().position(|other| other.lists == lists) {
                Some(known) => {
                    self.groups[known].take(own);
                    changed.push(known);
                }
                None => {
                    changed.push(self.groups.len());
                    self.groups.push(own);
                }
            }
        }
        changed
    }
}

impl Group {
    fn take(&mut self, other: Self) {
        self.lists.extend(other.lists);
        self.nodes.extend(other.nodes);
        self.bytes += other.bytes;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bodies of these sizes.
    fn module(sizes: &[usize]) -> Slim {
        Slim {
            sections: Default::default(),
            kinds: vec![0; sizes.len()],
            slots: 0,
            bodies: sizes.iter().map(|size| vec![0; *size]).collect(),
            data: Vec::new(),
            exports: BTreeMap::new(),
            names: BTreeMap::new(),
            called: BTreeMap::new(),
        }
    }

    fn shared(sizes: &[usize], needs: &[&[usize]]) -> Vec<(Vec<usize>, Vec<Node>)> {
        let list = |(page, need): (usize, &&[usize])| List {
            page,
            weight: 1,
            need: need.iter().copied().map(Node::Function).collect(),
        };
        let lists: Vec<List> = needs.iter().enumerate().map(list).collect();
        let mut groups: Vec<_> = groups(&module(sizes), &lists)
            .into_iter()
            .map(|group| (group.lists.into_iter().collect(), group.nodes.into_iter().collect()))
            .collect();
        groups.sort();
        groups
    }

    #[test]
    fn what_is_large_stays_apart_and_what_is_small_is_not_worth_a_file() {
        use Node::Function as F;
        let (large, small) = (10 * FILE, 1);
        // The page 0 needs 0 and 1, the page 1 needs 0 and 2.
        let needs: [&[usize]; 2] = [&[0, 1], &[0, 2]];
        assert_eq!(
            shared(&[large, large, large], &needs),
            [(vec![0], vec![F(1)]), (vec![0, 1], vec![F(0)]), (vec![1], vec![F(2)])]
        );
        assert_eq!(shared(&[large, small, small], &needs), [(vec![0, 1], vec![F(0), F(1), F(2)])]);
        assert_eq!(
            shared(&[small, large, large], &needs),
            [(vec![0], vec![F(0), F(1)]), (vec![1], vec![F(0), F(2)])]
        );
    }
}
