//! Rooted trees: one order condition of a Runge-Kutta method for each.
//!
//! Source: J. C. Butcher; E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary
//! Differential Equations I*, II.2, theorem 2.13: the method is of order p if
//! sum_i b_i Phi_i(t) = 1 / gamma(t) for every tree with at most p nodes.

use support::Errors;

/// A rooted tree: its root's branches, in the order of their place in the list.
#[derive(Clone)]
pub struct Tree {
    pub branches: Vec<usize>,
    pub nodes: usize,
    pub gamma: f64,
}

/// All rooted trees with at most `order` nodes, smaller ones first.
pub fn up_to(order: usize) -> Vec<Tree> {
    let mut trees: Vec<Tree> = Vec::new();
    for nodes in 1..=order {
        let mut found = Vec::new();
        branches(&trees, nodes - 1, trees.len(), &mut Vec::new(), &mut found);
        for branches in found {
            let gamma = branches.iter().map(|&b| trees[b].gamma).product::<f64>() * nodes as f64;
            trees.push(Tree { branches, nodes, gamma });
        }
    }
    trees
}

/// All multisets of known trees, none after place `below`, with `left` nodes together.
fn branches(
    trees: &[Tree],
    left: usize,
    below: usize,
    chosen: &mut Vec<usize>,
    found: &mut Vec<Vec<usize>>,
) {
    if left == 0 {
        found.push(chosen.clone());
        return;
    }
    for i in 0..below {
        if trees[i].nodes <= left {
            chosen.push(i);
            branches(trees, left - trees[i].nodes, i + 1, chosen, found);
            chosen.pop();
        }
    }
}

/// The coefficients of a method, free to be damaged.
#[derive(Clone)]
pub struct Method {
    pub a: Vec<Vec<(usize, f64)>>,
    pub b: Vec<(usize, f64)>,
}

impl Method {
    /// Largest |gamma sum_i b_i Phi_i - 1| over the trees with exactly `nodes` nodes.
    pub fn defect(&self, trees: &[Tree], nodes: usize) -> f64 {
        let mut weights: Vec<Vec<f64>> = Vec::new();
        let mut defects = Errors::of("order conditions");
        for tree in trees.iter().take_while(|t| t.nodes <= nodes) {
            let phi: Vec<f64> = (0..self.a.len())
                .map(|i| {
                    let sums = tree.branches.iter().map(|&branch| {
                        self.a[i].iter().map(|&(j, a)| a * weights[branch][j]).sum::<f64>()
                    });
                    sums.product()
                })
                .collect();
            if tree.nodes == nodes {
                let sum: f64 = self.b.iter().map(|&(i, b)| b * phi[i]).sum();
                defects.push(tree.gamma * sum - 1.0);
            }
            weights.push(phi);
        }
        defects.largest()
    }
}

#[test]
fn there_are_as_many_trees_as_there_should_be() {
    // OEIS A000081.
    let trees = up_to(8);
    for (nodes, count) in [1, 1, 2, 4, 9, 20, 48, 115].into_iter().enumerate() {
        assert_eq!(trees.iter().filter(|t| t.nodes == nodes + 1).count(), count);
    }
    assert_eq!(trees.len(), 200);
}
