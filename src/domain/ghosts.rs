//! Ghosts: particles of other ranks that this one's may have as neighbours until the next list build, and the messages that
//! bring their pair records. Between builds the pattern is fixed.
//!
//! A particle is a ghost on another rank if it lies nearer to a tight box of that rank's particles than the larger of its own list radius
//! and the largest one in the box; a rank has a box for each level of cells, so that few particles which reach far bring few ghosts.
//! That is more than the neighbours; lists take what is near, so the surplus changes nothing.
//!
//! Along periodic axes the same holds for a particle's images, of which a rank may need those of its own particles, too:
//! ordinary ghosts that come with a shift.

use super::comm::{Comm, Exchange};
use crate::particles::{Lattice, Periods, Site};

/// Boxes of a rank: for the particles of the lowest levels of cells one each, and one for all above.
const BOXES: usize = 4;

/// Where a rank's particles are, and how far they reach.
#[derive(Debug, Clone, PartialEq)]
pub struct Territory<const D: usize> {
    /// Of each box that holds any.
    boxes: Vec<Extent<D>>,
}

impl<const D: usize> Territory<D> {
    /// The territories of all ranks. Collective.
    pub fn all(sites: &[Site<D>], lattice: &Lattice, comm: &Comm) -> Vec<Self> {
        let mut mine = [Extent::EMPTY; BOXES];
        sites.iter().for_each(|site| mine[(lattice.level(site.radius) as usize).min(BOXES - 1)].add(site));
        let words: Vec<f64> = mine.into_iter().flat_map(Extent::to_words).collect();
        let numbers = Extent::<D>::WORDS;
        let read = |all: &[f64]| {
            let boxes = all.chunks_exact(numbers).map(Extent::from_words).filter(|extent| !extent.is_empty());
            Self { boxes: boxes.collect() }
        };
        comm.all_gather(&words).chunks_exact(BOXES * numbers).map(read).collect()
    }

    pub fn is_empty(&self) -> bool {
        self.boxes.is_empty()
    }

    /// One box around all, inverted where there are no particles.
    pub fn whole(&self) -> Extent<D> {
        let mut whole = Extent::EMPTY;
        self.boxes.iter().for_each(|extent| whole.merge(extent));
        whole
    }

    /// Whether a particle of another rank is a ghost here.
    pub fn needs(&self, site: &Site<D>) -> bool {
        self.boxes.iter().any(|extent| extent.needs(site))
    }

    /// Whether images of the other rank's particles at this shift may be ghosts here.
    fn may_need(&self, other: &Self, shift: &[f64; D]) -> bool {
        let near = |theirs: &Extent<D>| self.boxes.iter().any(|mine| mine.may_need(&theirs.shifted(shift)));
        other.boxes.iter().any(near)
    }
}

/// A box that holds particles, and how far they reach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent<const D: usize> {
    pub low: [f64; D],
    pub high: [f64; D],
    /// Largest list radius, m.
    pub radius: f64,
}

impl<const D: usize> Extent<D> {
    /// Without particles: inverted, infinitely far from everything.
    const EMPTY: Self = Self { low: [f64::INFINITY; D], high: [f64::NEG_INFINITY; D], radius: 0.0 };

    /// Numbers of an extent.
    const WORDS: usize = 2 * D + 1;

    pub fn of(sites: &[Site<D>]) -> Self {
        let mut extent = Self::EMPTY;
        sites.iter().for_each(|site| extent.add(site));
        extent
    }

    fn add(&mut self, site: &Site<D>) {
        self.merge(&Self { low: site.position, high: site.position, radius: site.radius });
    }

    fn merge(&mut self, other: &Self) {
        for k in 0..D {
            self.low[k] = self.low[k].min(other.low[k]);
            self.high[k] = self.high[k].max(other.high[k]);
        }
        self.radius = self.radius.max(other.radius);
    }

    fn to_words(self) -> impl Iterator<Item = f64> {
        self.low.into_iter().chain(self.high).chain([self.radius])
    }

    fn from_words(words: &[f64]) -> Self {
        Self {
            low: std::array::from_fn(|k| words[k]),
            high: std::array::from_fn(|k| words[D + k]),
            radius: words[2 * D],
        }
    }

    pub fn is_empty(&self) -> bool {
        self.low[0] > self.high[0]
    }

    /// Square of the distance to a box that goes from `low` to `high`. Made of the same operations as the squared distance
    /// of a pair, each of them monotone, so that rounding cannot put a particle in the box nearer than the box.
    fn distance_squared(&self, low: &[f64; D], high: &[f64; D]) -> f64 {
        (0..D).fold(0.0, |sum, k| {
            let gap = (self.low[k] - high[k]).max(low[k] - self.high[k]).max(0.0);
            sum + gap * gap
        })
    }

    /// Whether a particle of another rank is a ghost here.
    pub fn needs(&self, site: &Site<D>) -> bool {
        let radius = self.radius.max(site.radius);
        self.distance_squared(&site.position, &site.position) < radius * radius
    }

    /// The extent of images at this shift.
    fn shifted(&self, shift: &[f64; D]) -> Self {
        let by = |corner: &[f64; D]| std::array::from_fn(|k| corner[k] + shift[k]);
        Self { low: by(&self.low), high: by(&self.high), radius: self.radius }
    }

    fn may_need(&self, other: &Self) -> bool {
        let radius = self.radius.max(other.radius);
        self.distance_squared(&other.low, &other.high) < radius * radius
    }
}

/// The fixed pattern of ghost messages between two list builds.
pub struct Ghosts {
    /// Owned particles whose records go out, in message order; a particle may go to several ranks.
    pub send_indices: Vec<u32>,
    /// Carries `words` numbers for each of `send_indices` and for each incoming particle.
    pub exchange: Exchange,
    pub words: usize,
    /// D numbers for each of `send_indices`: from the particle to its image, m. Empty without periodic axes.
    pub send_shifts: Vec<f64>,
    /// How many particles go to which ranks, and come from which, in the order of messages.
    sends: Vec<(usize, usize)>,
    receives: Vec<(usize, usize)>,
}

/// Messages that bring the records of some ghosts alone.
pub struct SomeGhosts {
    /// Numbers among all that go out.
    pub sent: Vec<u32>,
    /// Numbers among all that come in.
    pub received: Vec<u32>,
    pub exchange: Exchange,
}

impl Ghosts {
    /// Finds which particles are ghosts on which ranks. `owned`: in canonical order; `words`: numbers of a pair record. Returns the
    /// incoming particles too, in message order. Collective.
    pub fn build<const D: usize>(
        owned: &[Site<D>],
        territories: &[Territory<D>],
        words: usize,
        periods: &Periods,
        comm: &Comm,
    ) -> (Self, Vec<Site<D>>) {
        let mine = &territories[comm.rank()];
        let (mut send_indices, mut send_shifts) = (Vec::new(), Vec::new());
        let (mut sends, mut messages) = (Vec::new(), Vec::new());
        let shifts = periods.shifts::<D>();
        for (rank, territory) in territories.iter().enumerate() {
            let start = send_indices.len();
            let mut message = Vec::new();
            for (number, shift) in shifts.iter().enumerate() {
                if (rank == comm.rank() && number == 0) || !territory.may_need(mine, shift) {
                    continue;
                }
                let images = owned.iter().map(|site| site.shifted(shift)).zip(0u32..);
                for (image, i) in images.filter(|(image, _)| territory.needs(image)) {
                    send_indices.push(i);
                    message.extend(to_words(&image));
                    if shifts.len() > 1 {
                        send_shifts.extend(shift);
                    }
                }
            }
            if !message.is_empty() {
                messages.push((rank, message));
                sends.push((rank, send_indices.len() - start));
            }
        }
        let (mut incoming, mut receives) = (Vec::new(), Vec::new());
        for (rank, message) in comm.sparse_exchange(messages) {
            let sites = message.chunks_exact(D + 2).map(from_words);
            receives.push((rank, sites.len()));
            incoming.extend(sites);
        }
        let exchange = exchange_of(words, &sends, &receives, comm);
        (Self { send_indices, exchange, words, send_shifts, sends, receives }, incoming)
    }

    /// Messages of some particles: those of all that go out and come in for which this is true. Sender and receiver must agree. Collective.
    pub fn some(
        &self,
        is_sent: impl Fn(usize) -> bool,
        is_received: impl Fn(usize) -> bool,
        comm: &Comm,
    ) -> SomeGhosts {
        let (sent, sends) = chosen(&self.sends, is_sent);
        let (received, receives) = chosen(&self.receives, is_received);
        SomeGhosts { sent, received, exchange: exchange_of(self.words, &sends, &receives, comm) }
    }
}

/// Messages of so many particles, each of so many numbers.
fn exchange_of(words: usize, sends: &[(usize, usize)], receives: &[(usize, usize)], comm: &Comm) -> Exchange {
    let numbers = |all: &[(usize, usize)]| all.iter().map(|&(rank, n)| (rank, n * words)).collect::<Vec<_>>();
    Exchange::new(comm, &numbers(sends), &numbers(receives))
}

/// The numbers of the particles that are chosen, and how many are left for each rank, if any.
fn chosen(all: &[(usize, usize)], is_chosen: impl Fn(usize) -> bool) -> (Vec<u32>, Vec<(usize, usize)>) {
    let (mut numbers, mut left, mut start) = (Vec::new(), Vec::new(), 0);
    for &(rank, count) in all {
        let before = numbers.len();
        numbers.extend((start..start + count).filter(|&k| is_chosen(k)).map(|k| k as u32));
        left.extend((numbers.len() > before).then(|| (rank, numbers.len() - before)));
        start += count;
    }
    (numbers, left)
}

fn to_words<const D: usize>(site: &Site<D>) -> impl Iterator<Item = u64> {
    let numbers = site.position.into_iter().chain([site.radius]).map(f64::to_bits);
    std::iter::once(site.id).chain(numbers)
}

fn from_words<const D: usize>(words: &[u64]) -> Site<D> {
    let number = |k: usize| f64::from_bits(words[k]);
    Site { id: words[0], position: std::array::from_fn(|k| number(1 + k)), radius: number(1 + D) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sites_travel_whole() {
        let site = Site { id: u64::MAX - 3, position: [0.1, -2.5e30], radius: 7.0 };
        assert_eq!(from_words::<2>(&to_words(&site).collect::<Vec<_>>()), site);
    }

    #[test]
    fn the_larger_radius_decides() {
        let at = |x, radius| Site { id: 0, position: [x, 0.0], radius };
        let extent = Extent::of(&[at(0.0, 1.0), at(4.0, 1.5)]);
        assert_eq!(extent, Extent { low: [0.0; 2], high: [4.0, 0.0], radius: 1.5 });
        for (x, radius, ghost) in [
            (2.0, 0.1, true),
            (5.4, 0.1, true),
            (5.5, 0.1, false),
            (7.0, 3.1, true),
            (-1.6, 1.0, false),
            (-1.6, 1.7, true),
        ] {
            assert_eq!(extent.needs(&at(x, radius)), ghost, "{x} {radius}");
            assert_eq!(extent.may_need(&Extent::of(&[at(x, radius)])), ghost);
        }
        let nobody = Extent::of(&[]);
        assert!(
            nobody.is_empty() && !nobody.needs(&at(0.0, 1e9)) && !extent.may_need(&nobody) && !nobody.may_need(&extent)
        );
    }

    /// A particle that reaches far brings ghosts around itself alone.
    #[test]
    fn each_level_has_a_box() {
        let at = |x: f64, radius| Site { id: 0, position: [x, 0.0], radius };
        let sites: Vec<_> = (0..100).map(|k| at(k as f64, if k == 50 { 3.0 } else { 1.0 })).collect();
        let [near, far] = [&sites[..50], &sites[50..51]].map(Extent::of);
        let territory = Territory { boxes: vec![near, far] };
        let beside = |x: f64, y: f64| territory.needs(&Site { id: 0, position: [x, y], radius: 1.0 });
        assert!(beside(10.0, 0.9) && beside(50.0, 2.9) && beside(52.0, 2.0));
        assert!(!beside(10.0, 1.1) && !beside(46.9, 1.1) && !beside(50.0, 3.1));
        assert_eq!(territory.whole(), Extent { low: [0.0; 2], high: [50.0, 0.0], radius: 3.0 });
    }

    #[test]
    fn some_of_each_message_are_chosen() {
        let all = [(3, 4), (5, 2), (7, 3)];
        assert_eq!(chosen(&all, |k| k % 2 == 0), (vec![0, 2, 4, 6, 8], vec![(3, 2), (5, 1), (7, 2)]));
        assert_eq!(chosen(&all, |k| k == 8), (vec![8], vec![(7, 1)]));
        assert_eq!(chosen(&all, |_| false), (vec![], vec![]));
    }
}
