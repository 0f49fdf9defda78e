//! The tables of a scene, one file each: what may be written (`...Table`, whose documentation is that of the keys), the defaults that
//! follow from other keys (`complete`), and what becomes of it (`validate`).

pub mod body;
pub mod compare;
pub mod domain;
pub mod gravity;
pub mod impacts;
pub mod integrator;
pub mod motion;
pub mod numerics;
pub mod output;
pub mod regions;
pub mod run;
pub mod skin;
pub mod two_rates;
