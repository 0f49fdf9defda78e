//! Porous matter for tests.

use super::law::Porous;
use crate::material::MaterialTable;

/// A material with these tables.
pub fn material(eos: &str, porosity: &str) -> MaterialTable {
    toml::from_str(&format!("eos = {eos}\n[porosity]\n{porosity}\n")).unwrap()
}

fn matter(eos: &str, porosity: &str, alpha_0: f64) -> Porous {
    let porosity = format!("distention = {}\n{porosity}", alpha_0.max(1.5));
    Porous::of(&material(eos, &porosity), alpha_0).unwrap()
}

pub fn simple_eos(c: f64) -> String {
    format!("{{ simplified_tillotson = {{ rho_0 = 2700, c = {c}, A = 7.5e10 }} }}")
}

pub const ALUMINIUM: &str = r#"{ tillotson = { rho_0 = 2700, a = 0.5, b = 1.63, A = "75.2 GPa", B = "65 GPa", E_0 = 5e6, E_iv = 3e6,
    E_cv = 1.39e7, alpha = 5, beta = 5 } }"#;

const ICE: &str = r#"{ tillotson = { rho_0 = 917, a = 0.3, b = 0.1, A = "9.47 GPa", B = "9.47 GPa", E_0 = 1e7, E_iv = 7.73e5,
    E_cv = 3.04e6, alpha = 10, beta = 5 } }"#;

/// P-alpha with rigid pores: figures 1 to 3 of Jutzi et al. 2008.
pub fn simple(alpha_0: f64, c: f64) -> Porous {
    matter(&simple_eos(c), "p_alpha = { quadratic = { P_e = 8e7, P_s = 7e8 } }", alpha_0)
}

/// rho-alpha with the crush curve of [`simple`].
pub fn cold(alpha_0: f64) -> Porous {
    matter(&simple_eos(2.0), "rho_alpha = { quadratic = { P_e = 8e7, P_s = 7e8 } }", alpha_0)
}

/// epsilon-alpha with the matrix of [`simple`].
pub fn strained(alpha_0: f64) -> Porous {
    matter(&simple_eos(2.0), "epsilon_alpha = { kappa = 0.98, P_e = 8e7, alpha_X = 1.2 }", alpha_0)
}

/// Table 1 of Jutzi et al. 2008, elastic pores.
pub fn aluminium(alpha_0: f64) -> Porous {
    let porosity = "p_alpha = { quadratic = { P_e = 8e7, P_s = 7e8 }, elastic = { c_e = 4110, c_0 = 5350 } }";
    matter(ALUMINIUM, porosity, alpha_0)
}

/// Ice of Jutzi et al. 2008, section 5.3.
pub fn ice(alpha_0: f64) -> Porous {
    matter(ICE, "p_alpha = { quadratic = { P_e = 1e6, P_s = 2e8 } }", alpha_0)
}
