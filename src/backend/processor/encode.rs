//! From contacts to words: each contact in its place, with the links at its ends.

use super::tree::{Bridge, Contact, Tree};
use super::word::{Address, Attribute, Word};

/// Words of a circuit, and what had to be put into flags before it.
#[derive(Debug, Default)]
pub struct Fitted {
    /// Inner lists that are computed first, each into a flag, in this order.
    pub before: Vec<(Vec<Word>, Address)>,
    /// The circuit itself.
    pub words: Vec<Word>,
}

/// How many levels of lists are tried in both orders.
const LEVELS_TRIED: usize = 10;

/// The words of a tree that two stacks of so many bits can hold. The branches of its lists keep their order
/// where that fits; else the deepest go to the ends of their lists; else inner lists go into
/// flags, which `new_flag` gives.
pub fn fit(tree: &Tree, depth: usize, mut new_flag: impl FnMut() -> Address) -> Fitted {
    let mut fitted = Fitted::default();
    let mut tree = tree.clone();
    loop {
        if let Some(words) = fitting(&tree, depth) {
            fitted.words = words;
            return fitted;
        }
        let flag = new_flag();
        let inner = take_inner(&mut tree, depth, flag).expect("what does not fit has inner lists");
        let words = fitting(&inner, depth).expect("a list of this height always fits");
        fitted.before.push((words, flag));
    }
}

/// The words in some order of branches that fits, if there is one.
fn fitting(tree: &Tree, depth: usize) -> Option<Vec<Word>> {
    let words = encode(tree);
    if fits(&words, depth) {
        return Some(words);
    }
    // A list costs stack 1 in its first branch and stack 2 in its last, so twice as many levels is
    // all that both can hold.
    let levels = tree.height().min(2 * depth).min(LEVELS_TRIED);
    (0..1_u32 << levels)
        .map(|ends| encode(&ordered(tree, ends, 0)))
        .find(|words| fits(words, depth))
}

/// The same with the deepest branch of each list at one of its ends, by a bit for each level, and
/// the next at the other.
fn ordered(tree: &Tree, ends: u32, level: u32) -> Tree {
    match tree {
        Tree::Contact(contact) => Tree::Contact(*contact),
        Tree::Series(parts) => {
            Tree::Series(parts.iter().map(|part| ordered(part, ends, level)).collect())
        }
        Tree::Parallel(branches) => {
            let mut list: Vec<&Tree> = branches.iter().collect();
            list.sort_by_key(|branch| branch.height());
            let deepest = list.pop();
            let next = list.pop();
            let (first, last) = if ends.checked_shr(level).unwrap_or(0) & 1 == 0 {
                (deepest, next)
            } else {
                (next, deepest)
            };
            let all = first.into_iter().chain(list).chain(last);
            Tree::Parallel(all.map(|branch| ordered(branch, ends, level + 1)).collect())
        }
        Tree::Bridge(bridge) => {
            let [upper_left, lower_left, upper_right, lower_right] =
                bridge.arms().map(|arm| ordered(arm, ends, level + 2));
            let middle = bridge.middle;
            Tree::Bridge(Box::new(Bridge {
                upper_left,
                lower_left,
                middle,
                upper_right,
                lower_right,
            }))
        }
    }
}

/// Puts a contact on a flag in the place of an inner list or bridge, the first of half the height
/// that always fits, and returns that.
fn take_inner(tree: &mut Tree, depth: usize, flag: Address) -> Option<Tree> {
    let inner: Vec<&mut Tree> = match tree {
        Tree::Contact(_) => return None,
        Tree::Series(parts) | Tree::Parallel(parts) => parts.iter_mut().collect(),
        Tree::Bridge(bridge) => {
            let Bridge { upper_left, lower_left, upper_right, lower_right, .. } = &mut **bridge;
            vec![upper_left, lower_left, upper_right, lower_right]
        }
    };
    let mut inner: Vec<&mut Tree> = inner.into_iter().filter(|part| part.height() > 0).collect();
    inner.sort_by_key(|part| std::cmp::Reverse(part.height()));
    let deepest = inner.into_iter().next()?;
    if deepest.height() <= depth && !matches!(deepest, Tree::Series(_)) {
        return Some(std::mem::replace(deepest, Tree::on(flag)));
    }
    take_inner(deepest, depth, flag)
}

/// The words of a tree, whatever the stacks hold.
pub fn encode(tree: &Tree) -> Vec<Word> {
    let mut words = Vec::new();
    if tree.is_wire() {
        part(&Tree::constant(true), Attribute::new(false, false, false), &mut words);
    } else {
        part(tree, Attribute::new(false, false, false), &mut words);
    }
    words
}

/// A part that still owes these links: the OPEN is due at its first contact, or, where that is in
/// a list, at that of the list's last branch, since the power at the left comes back there; the UP
/// and the RETURN are due at its last contact, the UP of a list in its first branch.
fn part(tree: &Tree, owed: Attribute, words: &mut Vec<Word>) {
    let Attribute { open, up, ret } = owed;
    match tree {
        Tree::Contact(Contact { address, negated }) => {
            words.push(Word::Contact { negated: *negated, attribute: owed, address: *address });
        }
        Tree::Series(parts) => {
            let last = parts.len() - 1;
            for (index, inner) in parts.iter().enumerate() {
                let (is_first, is_last) = (index == 0, index == last);
                let links = Attribute::new(open && is_first, up && is_last, ret && is_last);
                part(inner, links, words);
            }
        }
        Tree::Parallel(branches) => {
            let last = branches.len() - 1;
            for (index, branch) in branches.iter().enumerate() {
                let links = match index {
                    0 => Attribute::new(true, up, true),
                    index if index == last => Attribute::new(open, true, ret),
                    _ => Attribute::new(true, true, true),
                };
                part(branch, links, words);
            }
        }
        Tree::Bridge(bridge) => {
            let Contact { address, negated } = bridge.middle;
            part(&bridge.upper_left, Attribute::new(true, false, true), words);
            part(&bridge.lower_left, Attribute::new(open, false, false), words);
            let attribute = Attribute::new(true, true, false);
            words.push(Word::Contact { negated, attribute, address });
            part(&bridge.upper_right, Attribute::new(false, up, true), words);
            part(&bridge.lower_right, Attribute::new(false, true, ret), words);
        }
    }
}

/// True if neither stack has to hold more than it can.
fn fits(words: &[Word], depth: usize) -> bool {
    let (mut left, mut results) = (0_usize, 0_usize);
    for word in words {
        let Word::Contact { attribute, .. } = word else { continue };
        left = left + usize::from(attribute.pushes_left()) - usize::from(attribute.pops_left());
        results = results + usize::from(attribute.ret) - usize::from(attribute.up);
        if left > depth || results > depth {
            return false;
        }
    }
    true
}
