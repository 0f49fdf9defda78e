//! Runs programs on several ranks: no more at once than there are cores, with a time limit, and with nothing left behind.

use std::fs::{self, File};
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::{Condvar, LazyLock, Mutex, PoisonError};
use std::time::{Duration, Instant};

use sph_mpi::domain::comm::Comm;
use sph_mpi::math::Vec3;
use sph_mpi::particles::{Column, Columns, Element};
use sph_mpi::scene::Scene;
use sph_mpi::simulation::setup::{self, Plan};
use sph_mpi::step::StepSettings;
use sph_mpi::step::Stepper;
use tempfile::TempDir;

/// The program under test, which cargo builds beside the tests (for `structure`, a test of the package that has it).
pub fn program() -> &'static str {
    static PATH: LazyLock<String> = LazyLock::new(|| {
        let tests = std::env::current_exe().expect("the path of this executable");
        let path = tests.parent().and_then(Path::parent).expect("a folder of cargo's").join("sph-mpi");
        assert!(path.exists(), "{} is not built: `cargo build --release`, or `scripts/test`", path.display());
        path.into_os_string().into_string().expect("a plain path")
    });
    &PATH
}

/// Where the ranks of a test leave their answers; set in them only.
const ANSWERS: &str = "SPH_MPI_TEST_ANSWERS";
/// How many ranks there should be.
const RANKS: &str = "SPH_MPI_TEST_RANKS";

/// Processes that run at once: more than there are cores would run into their time limits, so that a job on several ranks has the
/// machine to itself where it is small. Cargo runs one test binary after another.
static CORES: LazyLock<(Mutex<usize>, Condvar)> = LazyLock::new(|| {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    (Mutex::new(cores), Condvar::new())
});

/// Cores that a job has as long as this lives.
struct Taken(usize);

impl Taken {
    /// Waits until there are as many as `ranks`, or all if these are fewer.
    fn cores(ranks: usize) -> Self {
        let (free, changed) = &*CORES;
        let wanted = ranks.clamp(1, std::thread::available_parallelism().map_or(1, usize::from));
        let free = free.lock().unwrap_or_else(PoisonError::into_inner);
        let mut free = changed.wait_while(free, |free| *free < wanted).unwrap_or_else(PoisonError::into_inner);
        *free -= wanted;
        Self(wanted)
    }
}

impl Drop for Taken {
    fn drop(&mut self) {
        let (free, changed) = &*CORES;
        *free.lock().unwrap_or_else(PoisonError::into_inner) += self.0;
        changed.notify_all();
    }
}

/// A command on several ranks, before it starts.
pub struct Launch {
    command: Command,
    ranks: usize,
    limit: Duration,
}

impl Launch {
    /// `program` with `args` under `mpirun -n ranks`.
    pub fn new<A: AsRef<std::ffi::OsStr>>(ranks: usize, program: impl AsRef<Path>, args: &[A]) -> Self {
        let mut command = Command::new("mpirun");
        command.args(["-n", &ranks.to_string(), "--bind-to", "none"]).arg(program.as_ref());
        Self::of(command, ranks, args)
    }

    /// `program` with `args`, by itself.
    pub fn alone<A: AsRef<std::ffi::OsStr>>(program: impl AsRef<Path>, args: &[A]) -> Self {
        Self::of(Command::new(program.as_ref()), 1, args)
    }

    fn of<A: AsRef<std::ffi::OsStr>>(mut command: Command, ranks: usize, args: &[A]) -> Self {
        command.args(args);
        command.env("OMPI_ALLOW_RUN_AS_ROOT", "1").env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
        command.env("OMPI_MCA_rmaps_base_oversubscribe", "1");
        // Ranks of one machine: to load what speaks to networks takes longer than many a test.
        command
            .env("OMPI_MCA_pml", "ob1")
            .env("OMPI_MCA_btl", "vader,self")
            .env("OMPI_MCA_ess_singleton_isolated", "1");
        // One thread, as long as a test asks for nothing else: `--threads` overrules it.
        command.env("RAYON_NUM_THREADS", "1");
        // A group of its own: a Ctrl-C at the terminal reaches the tests, which then end the job.
        command.process_group(0).stdin(Stdio::null());
        Self { command, ranks, limit: Duration::from_secs(120) }
    }

    /// sph-mpi with `args`.
    pub fn scene<A: AsRef<std::ffi::OsStr>>(ranks: usize, args: &[A]) -> Self {
        Self::new(ranks, program(), args)
    }

    /// sph-mpi with `more` arguments on `scene`, which is written into `dir`; the run goes into `dir/run`.
    pub fn in_directory(ranks: usize, dir: &Path, scene: &str, more: &[&str]) -> Self {
        let (scene, out) = (write_scene(dir, scene), dir.join("run"));
        let path = |path: &Path| path.to_str().expect("a plain path").to_owned();
        let args = [path(&scene), "--out".into(), path(&out)];
        Self::scene(ranks, &args.into_iter().chain(more.iter().map(|arg| arg.to_string())).collect::<Vec<_>>())
    }

    pub fn env(mut self, key: &str, value: impl AsRef<std::ffi::OsStr>) -> Self {
        self.command.env(key, value);
        self
    }

    /// Seconds after which the job is ended and the test fails.
    pub fn limit(mut self, seconds: u64) -> Self {
        self.limit = Duration::from_secs(seconds);
        self
    }

    /// Starts the job as soon as there are cores for it.
    pub fn start(mut self) -> Job {
        let taken = Taken::cores(self.ranks);
        let dir = tempfile::tempdir().expect("a temporary directory");
        let file = |name| File::create(dir.path().join(name)).expect("a file for the output");
        self.command.stdout(file("stdout")).stderr(file("stderr"));
        let child = self.command.spawn().expect("mpirun is there");
        Job { child, dir, started: Instant::now(), limit: self.limit, _taken: taken }
    }

    /// Runs the job to its end.
    pub fn run(self) -> Output {
        self.start().wait()
    }
}

/// A running job; dropped before its end, it ends with all its ranks.
pub struct Job {
    child: Child,
    /// Holds what the job prints; a file, unlike a pipe, never fills up.
    dir: TempDir,
    started: Instant,
    limit: Duration,
    _taken: Taken,
}

impl Job {
    /// Sends `signal` to mpirun.
    pub fn signal(&self, signal: i32) {
        send(self.child.id(), signal);
    }

    /// Sends `signal` to every rank, as a batch system does that started them itself.
    pub fn signal_ranks(&self, signal: i32) {
        descendants(self.child.id()).into_iter().for_each(|pid| send(pid, signal));
    }

    /// Sends `signal` to one process of the ranks, the first by its number or the last.
    pub fn signal_one(&self, last: bool, signal: i32) {
        let mut processes = self.processes();
        processes.sort_unstable();
        let one = if last { processes.last() } else { processes.first() };
        send(*one.expect("a rank"), signal);
    }

    /// The processes of the ranks.
    pub fn processes(&self) -> Vec<u32> {
        descendants(self.child.id())
    }

    /// Waits until `ready` says so; the test fails when the job ends or its time is up before.
    pub fn wait_until(&mut self, what: &str, mut ready: impl FnMut() -> bool) {
        while !ready() {
            assert!(
                self.child.try_wait().expect("mpirun can be waited for").is_none(),
                "the job ended before {what}\n{}",
                self.printed()
            );
            self.check_limit();
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Waits for the end of the job; the test fails when its time is up before.
    pub fn wait(mut self) -> Output {
        loop {
            if let Some(status) = self.child.try_wait().expect("mpirun can be waited for") {
                let read = |name| {
                    String::from_utf8_lossy(&fs::read(self.dir.path().join(name)).unwrap_or_default()).into_owned()
                };
                return Output { code: status.code(), stdout: read("stdout"), stderr: read("stderr") };
            }
            self.check_limit();
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    fn check_limit(&self) {
        assert!(self.started.elapsed() < self.limit, "no end within {:?}\n{}", self.limit, self.printed());
    }

    fn printed(&self) -> String {
        ["stdout", "stderr"]
            .map(|name| format!("--- {name}\n{}", fs::read_to_string(self.dir.path().join(name)).unwrap_or_default()))
            .concat()
    }
}

impl Drop for Job {
    fn drop(&mut self) {
        if let Ok(None) = self.child.try_wait() {
            // mpirun gives every rank a process group of its own: killing mpirun's would leave them.
            let ranks = descendants(self.child.id());
            send(self.child.id(), libc::SIGKILL);
            ranks.into_iter().for_each(|pid| send(pid, libc::SIGKILL));
            let _ = self.child.wait();
        }
    }
}

/// What a job left.
pub struct Output {
    /// Exit code of mpirun, which is that of the first rank that did not end with 0.
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Output {
    /// Fails the test, showing what was printed, unless the job ended with `code`.
    #[track_caller]
    pub fn expect_code(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "exit code\n--- stdout\n{}\n--- stderr\n{}", self.stdout, self.stderr);
        self
    }
}

/// The processes that `pid` started, and those that they started.
fn descendants(pid: u32) -> Vec<u32> {
    let mut found: Vec<u32> = Vec::new();
    let mut parents = vec![pid];
    let all: Vec<(u32, u32)> = processes();
    while let Some(parent) = parents.pop() {
        let children = all.iter().filter(|(_, its_parent)| *its_parent == parent).map(|(child, _)| *child);
        found.extend(children.clone());
        parents.extend(children);
    }
    found
}

/// (process, its parent) of every process of this machine.
fn processes() -> Vec<(u32, u32)> {
    let numbers =
        fs::read_dir("/proc").expect("/proc").flatten().filter_map(|entry| entry.file_name().to_str()?.parse().ok());
    numbers
        .filter_map(|pid: u32| {
            // pid (name) state parent ...; the name may hold anything, brackets too.
            let stat = fs::read_to_string(format!("/proc/{pid}/stat")).ok()?;
            let parent = stat.rsplit_once(')')?.1.split_whitespace().nth(1)?.parse().ok()?;
            Some((pid, parent))
        })
        .collect()
}

fn send(pid: u32, signal: i32) {
    // SAFETY: only sends a signal; a process that has ended is no error here.
    unsafe { libc::kill(pid as i32, signal) };
}

/// On a rank that [`launch`] started: runs `body`, leaves its answer, and says so.
pub fn on_rank(body: impl FnOnce(&Comm) -> String) -> bool {
    let Some(answers) = std::env::var_os(ANSWERS) else { return false };
    let comm = Comm::start();
    let expected = std::env::var(RANKS).expect("the number of ranks");
    assert_eq!(comm.size().to_string(), expected, "ranks (does mpirun belong to the MPI that this was built with?)");
    let answer = body(&comm);
    fs::write(PathBuf::from(answers).join(comm.rank().to_string()), answer).expect("a file for the answer");
    comm.finish();
    true
}

/// Starts this executable again on `n` ranks with the test `name` alone, given by its whole path, and returns the answer of
/// rank 0. A wrong name, or an mpirun of another MPI, which would start `n` jobs of one rank each, fails the test.
pub fn launch(n: usize, name: &str, env: &[(&str, &str)]) -> String {
    let answers = tempfile::tempdir().expect("a temporary directory");
    let executable = std::env::current_exe().expect("the path of this executable");
    let args = [name, "--exact", "--nocapture", "--test-threads=1"];
    let job = Launch::new(n, executable, &args).env(ANSWERS, answers.path()).env(RANKS, n.to_string()).limit(60);
    let out = env.iter().fold(job, |job, (key, value)| job.env(key, value)).run().expect_code(0);
    let answer = |rank: usize| {
        let read = fs::read_to_string(answers.path().join(rank.to_string()));
        read.unwrap_or_else(|_| panic!("rank {rank} did not run `{name}`\n{}{}", out.stdout, out.stderr))
    };
    (0..n).map(answer).next().unwrap_or_default()
}

/// Runs `body` on `n` ranks. `name` is the path of the calling test.
pub fn ranks(n: usize, name: &str, body: impl FnOnce(&Comm)) {
    let on_rank = on_rank(|comm| {
        body(comm);
        String::new()
    });
    if !on_rank {
        launch(n, name, &[]);
    }
}

/// Runs `body` on 1, 2, 3 and 4 ranks of one or two threads, which must all give the same answer on rank 0. `name` is the
/// path of the calling test.
pub fn same_on_any_ranks(name: &str, body: impl FnOnce(&Comm) -> String) {
    if on_rank(body) {
        return;
    }
    let answers = [(1, "1"), (2, "2"), (3, "1"), (4, "2")].map(|(n, threads)| {
        let answer = launch(n, name, &[("RAYON_NUM_THREADS", threads)]);
        assert!(!answer.is_empty(), "{name}: an answer that says nothing");
        answer
    });
    for (k, answer) in answers.iter().enumerate() {
        assert!(
            *answer == answers[0],
            "{name}: {} ranks answer\n{answer:.500}\none answers\n{:.500}",
            k + 1,
            answers[0]
        );
    }
}

/// Fails where a run has left a file that is not known as one of a run's: beside files of the user's it might be written over.
#[track_caller]
pub fn assert_known_files(run: &Path) {
    let entries = fs::read_dir(run).unwrap_or_else(|e| panic!("{}: {e}", run.display())).flatten();
    let unknown: Vec<_> = entries
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| name != ".sph-mpi" && !sph_mpi::process::directory::is_of_a_run(name))
        .collect();
    assert!(unknown.is_empty(), "{unknown:?} in {}", run.display());
}

/// `summary.json` of a run.
pub fn summary(run: &Path) -> serde_json::Value {
    let path = run.join("summary.json");
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// A small impact with all that can make ranks differ: strength, fracture, corrected gradient, h that follows density. It
/// takes seconds and is long enough for lists to be rebuilt, particles to change ranks and the target to break.
pub const IMPACT: &str = r#"
title = "A small impact, to be compared"

[[body]]
name = "target"
shape = { sphere = { radius = "1 km" } }
material = "basalt"
particles = 1400

[[body]]
name = "projectile"
shape = { sphere = { radius = "400 m" } }
material = "basalt"

[impact]
speed = "5 km/s"
angle = "45 deg"

[material.basalt.strength]
[material.basalt.fracture]
model = "grady_kipp"
seed = 1

[numerics]
corrected_gradient = true
smoothing_length = { follows = "density" }

[run]
until = "2 s"

[output]
picture = false
"#;

/// A search of Q*_D for small balls without strength: seconds in all.
pub const SMALL_SEARCH: &str = r#"
[[body]]
name = "target"
shape = { sphere = { radius = "10 km" } }
material = "rock"
damage = 1
particles = 200

[[body]]
name = "projectile"
shape = { sphere = { radius = "1 km" } }
material = "rock"
particles = 20

[impact]
speed = "5 km/s"

[material.rock]
base = "basalt"

[run]
until = "settled"

[threshold]
vary = "projectile.radius"
tolerance = 0.5
repeats = 0
"#;

/// Two balls of thin gas that fly into each other after a while. Its first steps are long, as nothing has happened yet.
pub const GAS_BALLS: &str = r#"
title = "Gas at rest, then struck"

[[body]]
name = "a"
shape = { sphere = { radius = "1 m" } }
material = "ideal_gas"
density = 1
internal_energy = 1
particles = 100

[[body]]
name = "b"
shape = { sphere = { radius = "1 m" } }
material = "ideal_gas"
density = 1
internal_energy = 1
particles = 100
position = [6, 0, 0]
velocity = [-20, 0, 0]

[run]
until = "0.5 s"

[output]
history_every = 1
picture = false
"#;

/// Runs give the same bits everywhere, so that only a change of the physics or of the sums moves a figure: by two per cent to
/// either side, and somebody has to look at it. What it may be at most stands beside it.
#[track_caller]
pub fn assert_as_measured(what: &str, found: f64, measured: f64) {
    assert!((found - measured).abs() <= 0.02 * measured.abs(), "{what} is {found:e}, measured before: {measured:e}");
}

/// Writes `scene` to a file of `dir`.
pub fn write_scene(dir: &Path, scene: &str) -> PathBuf {
    let path = dir.join("scene.toml");
    fs::write(&path, scene).expect("a scene can be written");
    path
}

/// A scene stepped by hand, with its particles within reach; on one rank.
pub struct ByHand<'c, const D: usize> {
    pub scene: Scene,
    pub stepper: Stepper<'c, D>,
    /// s.
    pub time: f64,
    /// The next step, s.
    pub dt: f64,
}

impl<'c, const D: usize> ByHand<'c, D> {
    /// The scene, with its particles changed by `prepare` before anything is evaluated.
    pub fn new(text: &str, comm: &'c Comm, prepare: impl FnOnce(&mut Columns)) -> Self {
        Self::with(text, &[], comm, |columns, _, _| prepare(columns))
    }

    /// The same with keys set as after `--set`, and with its settings within reach.
    pub fn with(
        text: &str,
        changes: &[&str],
        comm: &'c Comm,
        prepare: impl FnOnce(&mut Columns, &mut StepSettings, &Scene),
    ) -> Self {
        let changes: Vec<String> = changes.iter().map(|change| change.to_string()).collect();
        Self::of(Scene::parse("scene.toml", text, &changes).unwrap_or_else(|e| panic!("{e}\n{text}")), comm, prepare)
    }

    /// A scene that has been read.
    pub fn of(scene: Scene, comm: &'c Comm, prepare: impl FnOnce(&mut Columns, &mut StepSettings, &Scene)) -> Self {
        let counts = setup::count_particles(&scene, comm).expect("particles");
        let plan: Plan = setup::plan(&scene, counts).expect("effects that have what they need");
        let (mut columns, mut settings) = plan.populate(&scene, comm).expect("a scene that can start");
        prepare(&mut columns, &mut settings, &scene);
        let mut stepper = Stepper::new(comm, columns, settings);
        stepper.start().expect("a first evaluation");
        let dt = stepper.state.next;
        Self { scene, stepper, time: 0.0, dt }
    }

    /// Evaluates once more, after particles were changed by hand.
    pub fn evaluate(&mut self) {
        self.dt = self.stepper.step(0.0, self.time, 0).expect("an evaluation").dt;
    }

    /// One step, of at most `most` seconds.
    pub fn step(&mut self, most: f64) {
        let dt = self.dt.min(most);
        let stepped = self.stepper.step(dt, self.time + dt, 0).expect("a step");
        self.dt = stepped.dt;
        self.time += stepped.taken;
    }

    /// Steps to the time `end`, s, and looks at every step.
    pub fn run(&mut self, end: f64, mut look: impl FnMut(&mut Self)) {
        while self.time < end {
            self.step(end - self.time);
            look(self);
        }
    }

    pub fn steps(&self) -> u64 {
        self.stepper.state.step
    }

    pub fn particles(&self) -> std::ops::Range<usize> {
        0..self.stepper.columns.len()
    }

    pub fn column<T: Element>(&self, name: &str) -> Column<T> {
        self.stepper.columns.registry.find(name).unwrap_or_else(|| panic!("the scene has a column {name}"))
    }

    pub fn get<T: Element>(&self, name: &str, i: usize) -> T {
        self.stepper.columns.get(self.column(name), i)
    }

    pub fn set<T: Element>(&mut self, name: &str, i: usize, value: T) {
        let column = self.column(name);
        self.stepper.columns.set(column, i, value);
    }

    /// A column of single numbers.
    pub fn numbers(&self, name: &str) -> &[f64] {
        self.stepper.columns.numbers(self.column::<f64>(name).index)
    }

    pub fn id(&self, i: usize) -> u64 {
        self.stepper.columns.get(self.stepper.settings.view.core.id, i).0
    }

    /// Number of the particle's body.
    pub fn body(&self, i: usize) -> usize {
        self.stepper.columns.get(self.stepper.settings.view.core.id, i).body()
    }

    pub fn position(&self, i: usize) -> Vec3 {
        self.get("position", i)
    }

    pub fn velocity(&self, i: usize) -> Vec3 {
        self.get("velocity", i)
    }

    pub fn acceleration(&self, i: usize) -> Vec3 {
        self.get("acceleration", i)
    }

    /// Specific internal energy, J/kg.
    pub fn energy(&self, i: usize) -> f64 {
        self.get("internal_energy", i)
    }
}

/// Rows of a reference file.
pub fn reference(name: &str) -> Vec<Vec<f64>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reference").join(name);
    let text = std::fs::read_to_string(path).expect("a reference curve");
    let numbers = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    text.lines().skip(1).map(numbers).collect()
}
