//! A mantle that yields, with a fluid core: the equations of Poincaré and Hough, and of Sasao,
//! Okubo and Saito.

use super::excited::{difference, sum, times_complex};
use super::*;

/// Of the Earth, by seismology: the moments of inertia of the core and of the whole, 10^37
/// kg m^2 ...
const MOMENTS: [f64; 2] = [0.905_83, 8.011_5];
/// ... and how the tensors yield: that of the whole to its own turning, that of the whole to
/// the core's, and that of the core to the core's; each over the moment of what yields.
const YIELDING: [f64; 3] = [1.039e-3, 2.222e-4, 6.160e-4];
/// The core's share of the moment of inertia.
pub const CORE: f64 = MOMENTS[0] / MOMENTS[1];

/// Core and mantle, in units of M R^2, time in 1/Omega. The fluid turns against the mantle by
/// chi; lines of the fluid stay lines.
#[derive(Debug, Clone, Copy)]
pub struct CoreAndMantle {
    /// The moments I of the whole, as if frozen, while it turns evenly.
    whole: [f64; 3],
    /// What chi adds to the angular momentum of the whole.
    link: [f64; 3],
    /// The moments of the fluid.
    core: [f64; 3],
    /// What the tensor of the whole follows: omega, and the core's turning beyond it; and
    /// what the core's follows of that.
    pub yields: [f64; 3],
}

/// A turning of the mantle, omega, and of the core against it, chi.
type Turning = [BodyVector; 2];

// ANCHOR: parts
impl CoreAndMantle {
    /// The two momenta: that of the whole, and that of the core, which counts its vortices.
    /// The tensors are those of an even turning, and what has changed of them.
    pub fn momenta(&self, [omega, chi]: Turning) -> Turning {
        let times =
            |[x, y, z]: [f64; 3], v: BodyVector| BodyVector::new(x * v.x(), y * v.y(), z * v.z());
        let [own, both, core] = self.yields;
        let turned = omega + chi;
        let follows = |a: f64, b: f64, v: BodyVector| {
            (bulge(omega, v) - bulge(POLE, v)) * a + (bulge(turned, v) - bulge(omega, v)) * b
        };
        let of_core = follows(both, core, turned);
        let whole = times(self.whole, omega) + times(self.link, chi);
        let fluid = times(self.link, omega) + times(self.core, chi);
        [whole + follows(own, both, omega) + follows(both, core, chi), fluid + of_core]
    }

    /// How they change: L' = L x omega, as for any free body, and N' = chi x N, since the
    /// vortices go with the fluid; `sizes` against which errors count.
    pub fn law(self, sizes: [f64; 6]) -> impl Ode<6> {
        let law = ode(move |_, y: &[f64; 6]| {
            let ([l, n], [omega, chi]) = (pair(y), self.turning(pair(y)));
            joined([l.cross(&omega), chi.cross(&n)])
        });
        law.scaled(move |_| sizes)
    }
}

/// What a turning does to the tensor of a ball: (w w^T - w^2/3) v.
fn bulge(w: BodyVector, v: BodyVector) -> BodyVector {
    w * w.dot(&v) - v * (w.dot(&w) / 3.0)
}
// ANCHOR_END: parts

const POLE: BodyVector = BodyVector::new(0.0, 0.0, 1.0);

/// Two vectors from the numbers of a state, and back.
pub fn pair(&[a, b, c, d, e, f]: &[f64; 6]) -> Turning {
    [BodyVector::new(a, b, c), BodyVector::new(d, e, f)]
}

pub fn joined(pair: Turning) -> [f64; 6] {
    let [[a, b, c], [d, e, f]] = pair.map(BodyVector::to_array);
    [a, b, c, d, e, f]
}

impl CoreAndMantle {
    /// The Earth of this step of the ledger, if its core is fluid: a homogeneous ellipsoid
    /// with the moments and the flattening of the core.
    pub fn of(p: &Parameters, step: &Step) -> Result<Self> {
        let whole = body(p)?.moments().to_array();
        let (across, along) = (p.core * p.a, p.core * p.a * (1.0 + p.cavity));
        allowed! { "moment of the core": along, from_to(0.0, p.a), "the core is a part of the Earth"; }?;
        let link = (along * (2.0 * across - along)).sqrt();
        let elastic = if step.elastic { p.love / p.fluid * (p.c - p.a) } else { 0.0 };
        let own = step.following(p)? * (p.c - p.a);
        // A core of another size bears on the mantle, and yields, in proportion to it.
        let [of_whole, by_core, of_core] = YIELDING;
        let core = elastic * p.core / of_whole;
        Ok(Self {
            whole,
            link: [link, link, along],
            core: [across, across, along],
            yields: [own, core * by_core / CORE, core * of_core],
        })
    }

    /// The turnings that have these momenta: the tensors hardly change with them.
    pub fn turning(&self, [l, n]: Turning) -> Turning {
        let evenly = |momenta: Turning| {
            let [l, n] = momenta.map(BodyVector::to_array);
            let turned = [0, 1, 2].map(|k| {
                let [i, j, c] = [self.whole[k], self.link[k], self.core[k]];
                let det = i * c - j * j;
                [(c * l[k] - j * n[k]) / det, (i * n[k] - j * l[k]) / det]
            });
            [0, 1].map(|which| BodyVector::from_array(turned.map(|both| both[which])))
        };
        let mut w = evenly([l, n]);
        for _ in 0..12 {
            let [of_l, of_n] = self.momenta(w);
            let [omega, chi] = evenly([l - of_l, n - of_n]);
            w = [w[0] + omega, w[1] + chi];
        }
        w
    }

    /// The coefficients of the equation for the rates of small wobbles.
    fn equation(&self) -> [f64; 3] {
        let [own, both, core] = self.yields;
        let (c, c_f) = (self.whole[2], self.core[2]);
        let a = self.whole[0] + own;
        let link = self.link[0] + both;
        let f = self.core[0] + core;
        [(a - c) * c_f, (a - c) * f + a * c_f - link * link, a * f - link * link]
    }

    /// The rates of small wobbles over that of the day: the slow one, and the nearly daily
    /// one, which goes backward.
    pub fn rates(&self) -> [f64; 2] {
        let [c0, c1, c2] = self.equation();
        let root = c1 + (c1 * c1 - 4.0 * c0 * c2).sqrt();
        [-2.0 * c0 / root, -0.5 * root / c2]
    }

    /// Core against mantle in a small wobble of this rate, as a part of it.
    fn share(&self, rate: f64) -> f64 {
        let [_, both, core] = self.yields;
        let (link, f) = (self.link[0] + both, self.core[0] + core);
        -rate * link / (rate * f + self.core[2])
    }

    /// The time, in turns of the Earth, of `count` half circuits of the pole of rotation in
    /// the wobble of this rate.
    fn circuits(&self, rate: f64, size: f64, count: u32, step: f64) -> Result<f64> {
        let chi = BodyVector::new(size * self.share(rate), 0.0, 0.0);
        let start = self.momenta([BodyVector::new(size, 0.0, 1.0), chi]);
        let [[x, _, z], [u, _, w]] = start.map(|v| v.to_array().map(f64::abs));
        let law = self.law([x, x, z, u, u, w]);
        let pole = |y: &[f64; 6]| self.turning(pair(y))[0].y();
        let back = Dop853::new(step)?.zero(&law, joined(start), count, 1e6, pole)?;
        Ok(back.0.t / TAU)
    }

    /// The time, in turns of the Earth, until the pole of rotation is back.
    pub fn circuit(&self, size: f64, step: f64) -> Result<f64> {
        self.circuits(self.rates()[0], size, 2, step)
    }

    /// The rate of the nearly daily wobble, timed over a hundred of them; the core's is of
    /// this size.
    pub fn nutation(&self, size: f64, step: f64) -> Result<f64> {
        let rate = self.rates()[1];
        let mantle = size / self.share(rate).abs();
        Ok(-100.0 / self.circuits(rate, mantle, 200, step)?)
    }

    /// Half the rate of the slow wobble over its decay, if the whole yields late by this
    /// imaginary part: the complex root, by Newton's method from the real one.
    pub fn quality(&self, late: f64) -> f64 {
        let [c0, c1, c2] = self.equation();
        let (c_f, f) = (self.core[2], self.core[0] + self.yields[2]);
        // The coefficients are linear in what the whole yields.
        let (d0, d1, d2) = ([c0, late * c_f], [c1, late * (f + c_f)], [c2, late * f]);
        let mut root = [self.rates()[0], 0.0];
        for _ in 0..20 {
            let steep = times_complex(d2, root);
            let value = sum(d0, times_complex(sum(d1, steep), root));
            let [re, im] = sum(sum(d1, steep), steep);
            let square = re * re + im * im;
            root = difference(root, times_complex(value, [re / square, -im / square]));
        }
        0.5 * root[0] / root[1].abs()
    }

    /// Kinetic energy and that of the strain, kept by the motion, but for a constant.
    pub fn energy(&self, [omega, chi]: Turning) -> f64 {
        let [l, n] = self.momenta([omega, chi]);
        let [own, both, core] = self.yields;
        let turned = omega + chi;
        // The products of the deviators of w w^T, v v^T: (w . v)^2 - w^2 v^2/3.
        let product = |w: BodyVector, v: BodyVector| {
            let along = w.dot(&v);
            along * along - w.dot(&w) * v.dot(&v) / 3.0
        };
        let [ww, wv] = [product(omega, omega), product(omega, turned)];
        let vv = product(turned, turned);
        let strain = 0.25 * own * ww + 0.5 * both * (wv - ww) + 0.25 * core * (vv - 2.0 * wv + ww);
        // Half of the momenta times the turnings has the strain twice, and it counts three times.
        0.5 * (omega.dot(&l) + chi.dot(&n)) + strain
    }
}
