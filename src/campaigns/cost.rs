//! What a scene will cost, before it runs.
use crate::domain::comm::Comm;
use crate::error::Result;
use crate::scene::Scene;

pub fn check(_scene: &Scene, _ranks: usize, _comm: &Comm) -> Result<String> {
    Ok(String::new())
}
