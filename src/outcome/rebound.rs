//! Bodies for an N-body program: `nbody.csv`, and `nbody.bin`, a REBOUND Simulationarchive of one snapshot.
//!
//! The archive is that of REBOUND 5 (its version 5 of the format): all numbers little-endian,
//!
//! ```text
//! header    64 bytes: "REBOUND Binary File. Version: 5.2.2", then zeros
//! fields    size of the name with its zero, u64; size of the data, u64; name; data
//!           t, G, dt: f64;   N: u64;   simulationarchive_version: i32;   particles: N records
//! record    x y z vx vy vz ax ay az m r: f64, then three pointers, which are zero in a file
//! end       a field "end" without data; 12 bytes for further snapshots, zero
//! ```
//! Settings that are not in the file keep REBOUND's defaults: its adaptive integrator IAS15, direct sums, no collisions. Units are
//! SI.

use std::fmt::Write;

use super::nbody::Sphere;
use crate::gravity::G;

/// Version in the header. Other versions of REBOUND 5 read the file with a warning.
const VERSION: &str = "5.2.2";

/// `nbody.csv`; numbers read back to the same bits.
pub fn table(bodies: &[Sphere]) -> String {
    let mut text =
        "label,particles,mass_kg,radius_m,x_m,y_m,z_m,velocity_x_m_s,velocity_y_m_s,velocity_z_m_s\n".to_string();
    for body in bodies {
        let numbers = [&[body.mass, body.radius][..], &body.position, &body.velocity].concat();
        let numbers: Vec<String> = numbers.iter().map(|x| format!("{x:e}")).collect();
        let _ = writeln!(text, "{},{},{}", body.label, body.particles, numbers.join(","));
    }
    text
}

/// `nbody.bin` at `time`, s; `step`: first time step of an integrator that needs one, s.
pub fn archive(time: f64, step: f64, bodies: &[Sphere]) -> Vec<u8> {
    let mut bytes = format!("REBOUND Binary File. Version: {VERSION}").into_bytes();
    bytes.resize(64, 0);
    let mut field = |name: &str, data: &[u8]| {
        let name = [name.as_bytes(), &[0]].concat();
        for part in [&(name.len() as u64).to_le_bytes()[..], &(data.len() as u64).to_le_bytes(), &name, data] {
            bytes.extend_from_slice(part);
        }
    };
    let record = |body: &Sphere| {
        let motion = [&body.position[..], &body.velocity, &[0.0; 3], &[body.mass, body.radius]].concat();
        let numbers: Vec<u8> = motion.iter().flat_map(|x| x.to_le_bytes()).collect();
        [&numbers[..], &[0; 24]].concat()
    };
    field("t", &time.to_le_bytes());
    field("G", &G.to_le_bytes());
    field("dt", &step.to_le_bytes());
    field("N", &(bodies.len() as u64).to_le_bytes());
    field("simulationarchive_version", &5i32.to_le_bytes());
    field("particles", &bodies.iter().flat_map(record).collect::<Vec<u8>>());
    field("end", &[]);
    bytes.extend_from_slice(&[0; 12]);
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_archive_has_the_size_of_its_parts() {
        let body = Sphere { label: 7, particles: 3, mass: 2.0, radius: 1.5, position: [1.0; 3], velocity: [0.1; 3] };
        let bytes = archive(3.0, 0.5, &[body; 4]);
        let names = ["t", "G", "dt", "N", "simulationarchive_version", "particles", "end"];
        let named: usize = names.iter().map(|name| 16 + name.len() + 1).sum();
        assert_eq!(bytes.len(), 64 + named + 4 * 8 + 4 + 4 * 112 + 12);
        assert_eq!(&bytes[64..64 + 18], &[2, 0, 0, 0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0, 0, 0, b't', 0]);
        assert!(table(&[body]).ends_with("\n7,3,2e0,1.5e0,1e0,1e0,1e0,1e-1,1e-1,1e-1\n"));
    }
}
