//! Families C: z-x-z angles and rotation vectors of quaternions.
//!
//! Rows: `w x y z` and a matrix (not read) -> `phi theta zeta` and the quaternion
//! rebuilt from them, or the rotation vector.

use super::{Answer, numbers};
use rotation_dynamics::attitude::Attitude;

/// The function for a family of part C.
pub fn answerer(family: &str) -> Option<fn(&[&str]) -> Answer> {
    if family.starts_with("C_log") {
        Some(logarithm)
    } else if family.starts_with("C_") {
        Some(euler)
    } else {
        None
    }
}

fn attitude(columns: &[&str]) -> Result<Attitude, String> {
    let quaternion = numbers(columns)?
        .first_chunk::<4>()
        .copied()
        .ok_or("a row of family C has at least four columns")?;
    Attitude::from_quaternion(quaternion).map_err(|e| e.to_string())
}

fn euler(columns: &[&str]) -> Answer {
    let angles = attitude(columns)?.euler_angles();
    let rebuilt = Attitude::from_euler(angles).map_err(|e| e.to_string())?;
    let mut answer = vec![angles.phi, angles.theta, angles.zeta];
    answer.extend(rebuilt.quaternion());
    Ok(answer)
}

fn logarithm(columns: &[&str]) -> Answer {
    Ok(attitude(columns)?.rotation_vector().to_array().to_vec())
}
