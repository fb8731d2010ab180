use super::Ranked;
use crate::formula::{Node, Op};

/// A sum or a product of which one sign is another, or a number is in another term, or
/// a mean for a product.
pub(super) fn terms(op: Op, a: &Node, b: &Node) -> Vec<Ranked> {
    let mut all = vec![];
    let of = |op: Op, a: &Node, b: &Node| Node::of(op, [a.clone(), b.clone()]);
    if op == Op::Mul {
        all.push(of(Op::Div, &of(Op::Add, a, b), &Node::Number(2.0)));
    }
    if matches!(op, Op::Mul | Op::Div) {
        all.extend(split(op, a, b));
    }
    match (op, a, b) {
        (Op::Mul, Node::Of(Op::Mul, two), _) => {
            let sums = [Op::Add, Op::Sub].map(|op| of(op, &two[1], b));
            all.extend(sums.map(|sum| of(Op::Mul, &two[0], &sum)));
        }
        (Op::Add, Node::Of(Op::Add, two), _) => {
            all.push(of(Op::Mul, &two[0], &of(Op::Add, &two[1], b)));
            all.push(of(Op::Sub, &two[0], &of(Op::Add, &two[1], b)));
            all.push(of(Op::Add, &two[0], &of(Op::Max, &two[1], b)));
            all.push(of(Op::Max, a, b));
            // The product of two terms, without the third.
            let pairs = [(&two[0], &two[1]), (&two[0], b), (&two[1], b)];
            all.extend(pairs.map(|(x, y)| of(Op::Mul, x, y)));
        }
        (Op::Dot, ..) => {
            let cross = of(Op::Cross, a, b);
            all.push(Node::of(Op::Length, [cross]));
        }
        _ => {}
    }
    if matches!(op, Op::Add | Op::Sub) {
        // Parentheses that end behind the first of three factors.
        if let Node::Of(Op::Mul, three) = b
            && let Node::Of(Op::Mul, two) = &three[0]
        {
            let first = of(Op::Mul, &of(op, a, &two[0]), &two[1]);
            all.push(of(Op::Mul, &first, &three[1]));
        }
        if let Some((number, rest)) = factor(a) {
            all.push(of(op, &rest, &of(Op::Mul, &number, b)));
        }
        if let (Some(a), Some(b)) = (root(a), root(b)) {
            let both = of(op, &a, &b);
            all.push(of(Op::Pow, &both, &Node::Number(2.0)));
            all.push(both);
        }
    }
    all.into_iter().map(|node| (1, node)).collect()
}

/// A product of three factors or more with a plus or a minus before one that is not the
/// last: the product ends there, and what follows is another.
fn split(op: Op, a: &Node, b: &Node) -> Vec<Node> {
    let (mut signs, mut rest) = (vec![(op, b)], a);
    while let Node::Of(op @ (Op::Mul | Op::Div), two) = rest {
        signs.push((*op, &two[1]));
        rest = &two[0];
    }
    signs.reverse();
    let product = |first: &Node, signs: &[(Op, &Node)]| {
        signs.iter().fold(first.clone(), |all, (op, next)| {
            Node::of(*op, [all, (*next).clone()])
        })
    };
    let mut sums = vec![];
    for k in 0..signs.len() - 1 {
        let two =
            [product(rest, &signs[..k]), product(signs[k].1, &signs[k + 1..])];
        sums.extend([Op::Add, Op::Sub].map(|op| Node::of(op, two.clone())));
    }
    sums
}

/// a + b d + c d² with 1 for some of its letters, or without some of its terms.
pub(super) fn fades(node: &Node) -> Vec<Ranked> {
    let Node::Of(Op::Add, two) = node else { return vec![] };
    let (Node::Of(Op::Add, first), Node::Of(Op::Mul, square)) = (&two[0], &two[1])
    else {
        return vec![];
    };
    let (a, linear, d) = (&first[0], &first[1], &square[1]);
    let one = Node::Number(1.0);
    let squared = Node::of(Op::Mul, [d.clone(), d.clone()]);
    let terms = [[a, &one], [linear, d], [&two[1], &squared]];
    let mut all = vec![];
    for which in 1..27 {
        let chosen = [which % 3, which / 3 % 3, which / 9];
        let chosen = terms.iter().zip(chosen).filter(|(_, which)| *which < 2);
        let chosen = chosen.map(|(two, which)| two[which].clone());
        let sum = chosen.reduce(|sum, term| Node::of(Op::Add, [sum, term]));
        all.extend(sum.map(|sum| (1, sum)));
    }
    all
}

/// The number with which a product begins, and what is left.
fn factor(node: &Node) -> Option<(Node, Node)> {
    let Node::Of(Op::Mul, two) = node else { return None };
    match &two[0] {
        number @ Node::Number(_) => Some((number.clone(), two[1].clone())),
        first => {
            let (number, rest) = factor(first)?;
            Some((number, Node::of(Op::Mul, [rest, two[1].clone()])))
        }
    }
}

/// What a square is the square of.
fn root(node: &Node) -> Option<Node> {
    match node {
        Node::Of(Op::Dot, two) if two[0] == two[1] => {
            Some(Node::of(Op::Length, [two[0].clone()]))
        }
        Node::Of(Op::Mul, two) if two[0] == two[1] => Some(two[0].clone()),
        _ => None,
    }
}
