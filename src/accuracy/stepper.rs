//! A method made ready to run, and its variables for a scene.

use crate::body::{RigidBody, State};
use crate::effects::erased::{AnyEffect, AxisOnly};
use crate::effects::{Effect, IntegrableCase};
use crate::error::{Error, Result};
use crate::integrators::foils::{EulerOnAngles, SemiImplicitEuler};
use crate::integrators::gauss_legendre::{BodyAxes, FreeRotation};
use crate::integrators::{
    Dop853, GaussLegendre, Integrator, Method, MuntheKaas4, Rk4, SpinFree, Splitting, Work,
};
use crate::scene::Scene;

/// How fine a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Resolution {
    /// So many equal steps.
    Steps(u64),
    /// The same, the equations of each step solved to a precision: Gauss-Legendre only.
    Stages(u64, f64),
    /// Steps with an estimated error below this: DOP853 only.
    Tolerance(f64),
}

impl Resolution {
    /// The meaning of a number to a method: a tolerance to DOP853, steps to the others.
    pub const fn of(method: Method, setting: f64) -> Self {
        match method {
            Method::Dop853 => Self::Tolerance(setting),
            _ => Self::Steps(setting as u64),
        }
    }
}

/// The variables that are carried through time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variables {
    /// Attitude and momentum in space: any scene.
    Space,
    /// The same without the spin of a symmetric body under effects that see its axis only.
    SpinFree,
    /// Attitude and momentum on the body's axes, by Gauss-Legendre: a body without torque,
    /// or under effects that see its axis only.
    Body,
}

impl Variables {
    /// The variables in which `method` carries this scene in the fewest steps.
    pub fn best<E: AnyEffect>(method: Method, scene: &Scene<E>) -> Self {
        let symmetric = scene.body().moments().is_symmetric();
        let properties = scene.effects().properties();
        match method {
            Method::GaussLegendre16 if properties.torque_free => Self::Body,
            Method::Rk4 | Method::Dop853 | Method::GaussLegendre16
                if properties.axis_only && symmetric && !properties.torque_free =>
            {
                Self::SpinFree
            }
            Method::GaussLegendre16 if properties.axis_only => Self::Body,
            _ => Self::Space,
        }
    }
}

/// A method, made as fine as it is to run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stepper {
    /// [`Method::EulerOnAngles`].
    EulerOnAngles(EulerOnAngles),
    /// [`Method::SemiImplicitEuler`].
    SemiImplicitEuler(SemiImplicitEuler),
    /// [`Method::Rk4`].
    Rk4(Rk4),
    /// [`Method::MuntheKaas4`].
    MuntheKaas4(MuntheKaas4),
    /// Any splitting.
    Splitting(Splitting),
    /// [`Method::Dop853`].
    Dop853(Dop853),
    /// [`Method::GaussLegendre16`].
    GaussLegendre(GaussLegendre),
}

impl Stepper {
    /// The method, so fine.
    ///
    /// # Errors
    /// Steps for DOP853, a tolerance for any other; no steps; a refusal of the method.
    pub fn new(method: Method, resolution: Resolution) -> Result<Self> {
        let steps = match resolution {
            Resolution::Steps(steps) | Resolution::Stages(steps, _) => steps,
            Resolution::Tolerance(tolerance) if method == Method::Dop853 => {
                return Ok(Self::Dop853(Dop853::new(tolerance)?));
            }
            Resolution::Tolerance(_) => 0,
        };
        Ok(match (method, resolution) {
            (Method::EulerOnAngles, _) => Self::EulerOnAngles(EulerOnAngles::new(steps)?),
            (Method::SemiImplicitEuler, _) => {
                Self::SemiImplicitEuler(SemiImplicitEuler::new(steps)?)
            }
            (Method::Rk4, _) => Self::Rk4(Rk4::new(steps)?),
            (Method::MuntheKaas4, _) => Self::MuntheKaas4(MuntheKaas4::new(steps)?),
            (Method::GaussLegendre16, Resolution::Stages(_, precision)) => {
                Self::GaussLegendre(GaussLegendre::with_precision(steps, precision)?)
            }
            (Method::GaussLegendre16, _) => Self::GaussLegendre(GaussLegendre::new(steps)?),
            _ => {
                let scheme = method.scheme().ok_or(Error::out_of_range(
                    "steps of DOP853",
                    steps as f64,
                    "none: it chooses its steps itself, by a tolerance",
                ))?;
                Self::Splitting(Splitting::new(scheme, steps)?)
            }
        })
    }

    /// The state at `t_end` that follows from `start` at `t`, and the work done.
    ///
    /// # Errors
    /// Variables that the method or the scene does not have; a refusal of the method.
    pub fn advance<E: AnyEffect>(
        &self,
        scene: &Scene<E>,
        variables: Variables,
        span: [f64; 2],
        start: &State,
    ) -> Result<(State, Work)> {
        self.advance_any(scene, variables, span, start)
    }

    /// The same in the variables that are usual: those in space, but for Gauss-Legendre those
    /// in which it takes the fewest steps.
    ///
    /// # Errors
    /// A method that does not apply; a refusal of the method.
    pub fn advance_as_usual<E: AnyEffect>(
        &self,
        scene: &Scene<E>,
        span: [f64; 2],
        start: &State,
    ) -> Result<(State, Work)> {
        let variables = match self {
            Self::GaussLegendre(_) => Variables::best(Method::GaussLegendre16, scene),
            _ => Variables::Space,
        };
        self.advance(scene, variables, span, start)
    }

    /// Takes one of three scenes with the same motion, so that the methods are compiled for four types
    /// and not for each scene.
    fn advance_any(
        &self,
        scene: &Scene<dyn AnyEffect + '_>,
        variables: Variables,
        span: [f64; 2],
        start: &State,
    ) -> Result<(State, Work)> {
        let effects = scene.effects();
        let (properties, known) = (effects.properties(), effects.integrable_case());
        let body = Scene::new(*scene.body());
        let sees_axis = matches!(self, Self::Splitting(_)) || variables != Variables::Space;
        if !(properties.axis_only && sees_axis) {
            self.advance_anything(scene, variables, span, start)
        } else if let (true, Self::GaussLegendre(_), Variables::Body) =
            (properties.torque_free, self, variables)
        {
            let mut work = Work::default();
            let end = self.advance_free(body.body(), span, start, &mut work)?;
            Ok((end, work))
        } else if let IntegrableCase::HeavyTop(gravity) = known {
            self.advance_seeing_axis(&body.with(gravity), variables, span, start)
        } else {
            self.advance_seeing_axis(&body.with(AxisOnly(effects)), variables, span, start)
        }
    }

    /// Effects that see the axis alone, or nothing, by what makes use of that.
    fn advance_seeing_axis<E: Effect>(
        &self,
        scene: &Scene<E>,
        variables: Variables,
        span @ [t, t_end]: [f64; 2],
        start: &State,
    ) -> Result<(State, Work)> {
        if let (Self::Rk4(m), Variables::SpinFree) = (self, variables) {
            return m.advance(&SpinFree::new(scene)?, t, start, t_end);
        }
        let mut work = Work::default();
        let end = self.advance_axis(scene, variables, span, start, &mut work)?;
        Ok((end, work))
    }

    /// Any effects, in space.
    fn advance_anything(
        &self,
        scene: &Scene<dyn AnyEffect + '_>,
        variables: Variables,
        [t, t_end]: [f64; 2],
        start: &State,
    ) -> Result<(State, Work)> {
        match (self, variables) {
            (Self::EulerOnAngles(m), Variables::Space) => m.advance(scene, t, start, t_end),
            (Self::SemiImplicitEuler(m), Variables::Space) => m.advance(scene, t, start, t_end),
            (Self::MuntheKaas4(m), Variables::Space) => m.advance(scene, t, start, t_end),
            (Self::Rk4(m), Variables::Space) => m.advance(scene, t, start, t_end),
            (Self::Dop853(m), Variables::Space) => m.advance(scene, t, start, t_end),
            (Self::GaussLegendre(m), Variables::Space) => m.advance(scene, t, start, t_end),
            _ => Err(Error::sees_more(scene.effects().names().join(", "))),
        }
    }

    /// A body without torque on its own axes, by Gauss-Legendre.
    pub(super) fn advance_free(
        &self,
        body: &RigidBody,
        [t, t_end]: [f64; 2],
        start: &State,
        work: &mut Work,
    ) -> Result<State> {
        let free = FreeRotation::new(&Scene::new(*body));
        match self {
            Self::GaussLegendre(m) => m.advance_counting(&free, t, start, t_end, work),
            _ => Err(no_such_variables()),
        }
    }

    /// Effects that see the axis alone.
    pub(super) fn advance_axis<E: Effect>(
        &self,
        scene: &Scene<E>,
        variables: Variables,
        [t, t_end]: [f64; 2],
        start: &State,
        work: &mut Work,
    ) -> Result<State> {
        match (self, variables) {
            (Self::Splitting(m), Variables::Space) => {
                m.advance_counting(scene, t, start, t_end, work)
            }
            (Self::GaussLegendre(m), Variables::Body) => {
                m.advance_counting(&BodyAxes::new(scene)?, t, start, t_end, work)
            }
            (Self::GaussLegendre(m), Variables::SpinFree) => {
                m.advance_counting(&SpinFree::new(scene)?, t, start, t_end, work)
            }
            (Self::Dop853(m), Variables::SpinFree) => {
                m.advance_counting(&SpinFree::new(scene)?, t, start, t_end, work)
            }
            _ => Err(no_such_variables()),
        }
    }
}

fn no_such_variables() -> Error {
    Error::out_of_range(
        "variables on the body's axes or without the spin",
        1.0,
        "0 with this method: it has its own, or those in space",
    )
}

/// Whether `method` applies to a scene of this type.
pub const fn applies<E: Effect>(method: Method) -> bool {
    method.scheme().is_none() || (E::PROPERTIES.axis_only && !E::PROPERTIES.torque_free)
}
