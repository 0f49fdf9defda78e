//! Input as it comes: `--check` and the run say the same of a scene, what is far too large is counted and not listed, what has no
//! end is not read, and nothing of it reaches the terminal but as text.

use std::fs;
use std::path::Path;

use crate::common::{Launch, Output, program, write_scene};
use crate::errors::assert_refused;

/// Runs the program on a scene in `dir`, into `dir/run`, by itself.
fn alone(dir: &Path, scene: &str, more: &[&str]) -> Launch {
    let scene = write_scene(dir, scene);
    let out = dir.join("run");
    let args = [scene.to_str().expect("a plain path"), "--out", out.to_str().expect("a plain path")];
    Launch::alone(program(), &[&args[..], more].concat()).limit(60)
}

/// The one line of an error.
#[track_caller]
fn error(output: &Output) -> &str {
    let mut lines = output.stderr.lines().filter(|line| line.contains("error"));
    let line = lines.next().unwrap_or_else(|| panic!("no error in {}", output.stderr));
    assert!(lines.next().is_none() && line.starts_with("error: "), "{}", output.stderr);
    line
}

fn body(name: &str, shape: &str, more: &str) -> String {
    format!("[[body]]\nname = \"{name}\"\nshape = {{ {shape} }}\nspacing = 0.2\n{more}\n")
}

/// Scenes of few particles that make the problems there are to compare with.
fn problems() -> Vec<(&'static str, String)> {
    let gas = "[material.gas]\neos = { ideal_gas = { gamma = 1.4 } }\n";
    let strong = "[material.basalt.strength]\n";
    let brick = "box = { size = [2, 1] }";
    let disc = "disc = { radius = 1 }";
    let thin =
        |name: &str, x: f64, more: &str| body(name, brick, &format!("position = [{x}, 0]\nmaterial = \"gas\"\n{more}"));
    let rock = |name: &str, x: f64, more: &str| {
        body(name, brick, &format!("position = [{x}, 0]\nmaterial = \"basalt\"\n{more}"))
    };
    let flyer = rock("flyer", -1.0, "velocity = [2000, 0]") + &rock("plate", 1.0, "");
    let ball = |material: &str, more: &str| body("ball", disc, &format!("material = \"{material}\"\n{more}"));
    vec![
        (
            "riemann",
            thin("a", -1.0, "density = 1\npressure = 1") + &thin("b", 1.0, "density = 0.1\npressure = 0.1") + gas,
        ),
        ("blast", ball("gas", "density = 1\nblast = { energy = 1, radius = 0.5 }") + gas),
        ("implosion", ball("gas", "density = 1\nflow = { radial = -1 }") + gas),
        ("piston", rock("a", -1.0, "motion = { velocity = [10, 0] }") + &rock("b", 1.0, "") + strong),
        ("impact", flyer.clone()),
        ("release", flyer),
        (
            "standing_wave",
            rock("a", 0.0, "flow = { wave = { along = \"x\", moves = \"x\", wavelength = 2, speed = 1 } }") + strong,
        ),
        ("vibration", ball("basalt", "flow = { mode = { shape = \"radial\", speed = 1 } }") + strong),
        ("rotation", ball("basalt", "spin = 1") + strong),
        ("rest", rock("a", 0.0, "") + "[gravity]\nuniform = [0, -1]\n"),
    ]
}

/// `--check` takes a scene if and only if the run takes it, and refuses it with the same words.
#[test]
fn check_and_run_agree_on_what_a_scene_is_compared_with() {
    let problems = problems();
    assert_eq!(problems.len(), 10);
    let nothing = body("ball", "disc = { radius = 1 }", "material = \"basalt\"");
    for (kind, scene) in problems {
        for (bodies, code) in [(&scene, 0), (&nothing, 2)] {
            let dir = tempfile::tempdir().expect("a temporary directory");
            let text = format!(
                "dimension = 2\n{bodies}[compare]\nwith = \"{kind}\"\n[run]\nuntil = 1\nsteps = 1\n[output]\npicture = false\n"
            );
            let check = alone(dir.path(), &text, &["--check"]).run().expect_code(code);
            assert!(!dir.path().join("run").exists());
            let run = alone(dir.path(), &text, &[]).run();
            if code == 0 {
                // It began; one step is no quarter of a period.
                assert!(run.code == Some(0) || run.stderr.contains("show no vibration"), "{kind}: {}", run.stderr);
            } else {
                assert_eq!(run.code, Some(code), "{kind}: {}", run.stderr);
                assert_eq!(error(&check), error(&run), "{kind}");
                assert!(
                    error(&run).contains("scene.toml:8: compare.with: the scene does not make this problem"),
                    "{}",
                    run.stderr
                );
                assert!(!dir.path().join("run").exists(), "what is refused leaves nothing");
            }
        }
    }
}

/// On any ranks, with the place of the key.
#[test]
fn a_mode_without_strength_is_refused() {
    let scene = body(
        "b",
        "sphere = { radius = 1 }",
        "material = \"basalt\"\nflow = { mode = { shape = \"radial\", speed = 1 } }",
    );
    let dir = tempfile::tempdir().expect("a temporary directory");
    let path = write_scene(dir.path(), &format!("{scene}[run]\nuntil = 1\n"));
    for check in [&[][..], &["--check"]] {
        assert_refused(&path, check, &["scene.toml:6: body b, flow.mode: material `basalt` has no strength"]);
    }
}

/// What no machine holds is told at once, by its volume.
#[test]
fn particles_beyond_any_memory() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let ball = body("ball", "sphere = { radius = \"8 km\" }", "material = \"basalt\"");
    let scene = ball.replace("spacing = 0.2", "particles = 1_000_000_000_000") + "[run]\nuntil = 1\n";
    let check = alone(dir.path(), &scene, &["--check"]).limit(20).run().expect_code(0);
    let fits = check.stdout.lines().find(|line| line.contains("it does not fit")).expect("a warning");
    assert!(fits.contains("TB") && check.stdout.contains("those that volumes give"), "{}", check.stdout);
    let run = alone(dir.path(), &scene, &[]).limit(20).run().expect_code(2);
    assert!(error(&run).contains("particles need about") && error(&run).contains(" TB on a machine"), "{}", run.stderr);
}

#[test]
fn a_scene_may_come_through_a_pipe() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let ball = body("ball", "disc = { radius = 1 }", "material = \"basalt\"");
    let scene = format!("dimension = 2\n{ball}[run]\nuntil = 1\nsteps = 1\n[output]\npicture = false\n");
    write_scene(dir.path(), &scene);
    for command in [
        "cd $0; cat scene.toml | $1 /dev/stdin && test -f runs/stdin/summary.json",
        "cd $0; $1 /dev/stdin --check < scene.toml",
        "cd $0; (sleep 0.3; cat scene.toml) | $1 /dev/stdin --check",
        "cd $0; $1 <(cat scene.toml) --out here && test -f here/summary.json",
        "cd $0; cat scene.toml | mpirun -n 2 $1 /dev/stdin --out two && test -f two/summary.json",
    ] {
        let args = ["-c", command, dir.path().to_str().expect("a plain path"), program()];
        Launch::alone("bash", &args).limit(60).run().expect_code(0);
    }
}

#[test]
fn what_has_no_end_is_not_read() {
    assert_refused(
        Path::new("/dev/zero"),
        &[],
        &["/dev/zero: cannot read the scene: it is neither a regular file nor a pipe"],
    );
    let dir = tempfile::tempdir().expect("a temporary directory");
    let pores = "[material.basalt.porosity.p_alpha]\nmeasured = { file = \"/dev/zero\" }\n";
    let ball = body("ball", "sphere = { radius = 1 }", "material = \"basalt\"");
    let scene = write_scene(dir.path(), &format!("{ball}{pores}[run]\nuntil = 1\n"));
    assert_refused(
        &scene,
        &[],
        &["scene.toml:7: material.basalt.porosity.p_alpha.measured.file", "neither a regular file"],
    );
}

/// Titles, names, keys and values reach the terminal and the log as text.
#[test]
fn a_scene_does_not_steer_the_terminal() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let ball = body("b\\u001b[2J\\u0007", "disc = { radius = 1 }", "material = \"basalt\"");
    let scene = format!("title = \"\\u001b]0;mine\\u0007\\u202e\"\ndimension = 2\n{ball}[run]\nuntil = 1\nsteps = 1\n");
    let acts = |text: &str| text.chars().any(|c| (c.is_control() && c != '\n') || c == '\u{202e}');
    for (more, code) in [
        (&["--check"][..], 0),
        (&[][..], 0),
        (&["--set", "b\u{1b}[31mall.x=1"], 2),
        (&["--set", "run.until=\u{1b}]0;x\u{7}"], 2),
        (&["--check", "--out\u{1b}[2J", "x"], 2),
        (&["--threads", "\u{1b}[2J"], 2),
    ] {
        let output = alone(dir.path(), &scene, more).run().expect_code(code);
        assert!(!acts(&output.stdout) && !acts(&output.stderr), "{more:?}: {:?} {:?}", output.stdout, output.stderr);
        let spelt = output.stderr.contains("\\u{1b}");
        assert!(code == 0 || more[0] != "--set" || spelt, "{more:?}: {}", output.stderr);
    }
    let log = fs::read_to_string(dir.path().join("run/log.txt")).expect("a log");
    assert!(!acts(&log), "{log:?}");
}

/// What is asked of the machine is understood or refused, by the run and by `--check`.
#[test]
fn requests_that_make_no_sense() {
    let ball = body("ball", "disc = { radius = 1 }", "material = \"basalt\"");
    let scene = format!("dimension = 2\n{ball}[run]\nuntil = 1\nsteps = 1\n");
    for (args, (variable, value), says) in [
        (&["--threads", "9999"][..], ("X", ""), ["--threads: 9999 threads on ", "allowed: 1 to "]),
        (&[], ("SPH_MPI_SIMD", "sse9"), ["SPH_MPI_SIMD: `sse9` is not an instruction set", "portable, avx2, avx512"]),
        (&[], ("SPH_MPI_FAULT", "nonsense"), ["SPH_MPI_FAULT: `nonsense` is not a fault", "KIND:RANK:STEP"]),
        (&[], ("SPH_MPI_FAULT", "panic:0:5:6"), ["SPH_MPI_FAULT: `panic:0:5:6`", "KIND:RANK:STEP"]),
    ] {
        for check in [&[][..], &["--check"]] {
            let dir = tempfile::tempdir().expect("a temporary directory");
            let output = alone(dir.path(), &scene, &[args, check].concat()).env(variable, value).run().expect_code(2);
            assert!(says.iter().all(|part| error(&output).contains(part)), "{}", output.stderr);
            assert!(!dir.path().join("run").exists());
        }
    }
}

/// Numbers in cgs, read as SI: what is unlikely about them is said before the run and in its log.
#[test]
fn unlikely_numbers_are_told() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let ball = body("ball", "disc = { radius = 1 }", "material = \"mine\"");
    let rock = "[material.mine]\nbase = \"basalt\"\neos = { tillotson = { rho_0 = 2.7, A = 2.67e11 } }\n";
    let scene = format!("dimension = 2\n{ball}{rock}[run]\nuntil = 1\nsteps = 1\n[output]\npicture = false\n");
    let says =
        "scene.toml:9: material.mine.eos.tillotson.rho_0: 2.7 without a unit is 2.7 kg/m^3, lighter than any solid";
    let check = alone(dir.path(), &scene, &["--check"]).run().expect_code(0);
    assert!(check.stdout.contains(&format!("units: {}", dir.path().join(says).display())), "{}", check.stdout);
    alone(dir.path(), &scene, &[]).run().expect_code(0);
    let log = fs::read_to_string(dir.path().join("run/log.txt")).expect("a log");
    assert!(log.lines().any(|line| line.contains(" WARN ") && line.contains(says)), "{log}");
}
