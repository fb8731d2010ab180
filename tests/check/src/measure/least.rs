/// Least squares: the unknowns x₁ … x_N for which many equations, row · x = value, hold
/// best.
#[derive(Clone, Debug)]
pub(super) struct Least<const N: usize> {
    matrix: [[f64; N]; N],
    right: [f64; N],
    count: f64,
}

impl<const N: usize> Least<N> {
    /// No equation yet.
    pub fn new() -> Self {
        Self { matrix: [[0.0; N]; N], right: [0.0; N], count: 0.0 }
    }

    /// Adds one equation.
    pub fn add(&mut self, row: &[f64; N], value: f64) {
        for (k, line) in self.matrix.iter_mut().enumerate() {
            (0..N).for_each(|l| line[l] += row[k] * row[l]);
            self.right[k] += row[k] * value;
        }
        self.count += 1.0;
    }

    /// The unknowns, or None where the equations leave one of them open.
    pub fn solve(&self) -> Option<[f64; N]> {
        let inverse = inverse(self.matrix)?;
        Some(inverse.map(|line| dot(&line, &self.right)))
    }

    /// How far off each unknown may be where the values are off by `sigma`.
    pub fn errors(&self, sigma: f64) -> [f64; N] {
        let mut least = self.clone();
        (0..N).for_each(|k| least.matrix[k][k] += 1e-12 * (1.0 + self.count));
        let inverse = inverse(least.matrix);
        std::array::from_fn(|k| {
            inverse.map_or(f64::INFINITY, |lines| sigma * lines[k][k].abs().sqrt())
        })
    }
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The inverse of a matrix by Gauss and Jordan, None where it has none.
fn inverse<const N: usize>(mut a: [[f64; N]; N]) -> Option<[[f64; N]; N]> {
    let mut inverse = [[0.0; N]; N];
    (0..N).for_each(|k| inverse[k][k] = 1.0);
    for k in 0..N {
        let pivot =
            (k..N).max_by(|&l, &m| a[l][k].abs().total_cmp(&a[m][k].abs()))?;
        if a[pivot][k].abs() < 1e-14 {
            return None;
        }
        a.swap(k, pivot);
        inverse.swap(k, pivot);
        let scale = 1.0 / a[k][k];
        a[k].iter_mut().chain(&mut inverse[k]).for_each(|x| *x *= scale);
        for l in (0..N).filter(|&l| l != k) {
            let factor = a[l][k];
            for m in 0..N {
                a[l][m] -= factor * a[k][m];
                inverse[l][m] -= factor * inverse[k][m];
            }
        }
    }
    Some(inverse)
}
