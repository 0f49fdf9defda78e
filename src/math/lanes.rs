//! Vector widths: which instructions this processor has, and which the user allows.

use std::sync::OnceLock;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    Portable,
    Avx2,
    Avx512,
}

/// The widest the processor has, or what `SPH_MPI_SIMD` asks for where the processor has it.
pub fn width() -> Width {
    static WIDTH: OnceLock<Width> = OnceLock::new();
    *WIDTH.get_or_init(|| {
        let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        let avx512 = avx2 && is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq");
        match std::env::var("SPH_MPI_SIMD").as_deref() {
            Ok("portable") => Width::Portable,
            Ok("avx2") if avx2 => Width::Avx2,
            _ if avx512 => Width::Avx512,
            _ if avx2 => Width::Avx2,
            _ => Width::Portable,
        }
    })
}
