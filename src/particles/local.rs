//! The local set: owned particles and ghosts together in canonical order. A particle's number in it is its slot; pair
//! records lie in slot order, and one dummy record follows at slot `count`.
//!
//! ```text
//! columns   owned 0 .. owned-1          records   slot 0 .. count-1, dummy
//!           |                                     ^          ^
//!           +---- slot_of_owned[i] ---------------+          |
//! messages  incoming 0, 1, ... ---- slot_of_incoming[k] -----+
//! ```

use super::cells::{Lattice, Place, Site};
use super::large_pages;

#[derive(Debug)]
pub struct Local<const D: usize> {
    /// Owned particles and ghosts.
    pub count: usize,
    /// Slot of each owned particle, ascending.
    pub slot_of_owned: Vec<u32>,
    /// Slot of the k-th incoming record.
    pub slot_of_incoming: Vec<u32>,
    pub places: Vec<Place>,
    /// Build positions, one array per dimension, m.
    pub position: [Vec<f64>; D],
    /// Squares of the list radii, m^2.
    pub radius_squared: Vec<f64>,
    pub is_ghost: Vec<bool>,
    arrivals: Vec<(Place, u32)>,
}

impl<const D: usize> Default for Local<D> {
    fn default() -> Self {
        Self {
            count: 0,
            slot_of_owned: Vec::new(),
            slot_of_incoming: Vec::new(),
            places: Vec::new(),
            position: std::array::from_fn(|_| Vec::new()),
            radius_squared: Vec::new(),
            is_ghost: Vec::new(),
            arrivals: Vec::new(),
        }
    }
}

impl<const D: usize> Local<D> {
    /// Merges `owned`, in canonical order, with the ghosts in order of arrival.
    pub fn build(&mut self, lattice: &Lattice, owned: &[Site<D>], incoming: &[Site<D>]) {
        let places = owned.iter().map(|site| lattice.place(site)).collect();
        self.build_placed(lattice, owned, places, incoming);
    }

    /// [`Local::build`] where places are known.
    pub fn build_placed(&mut self, lattice: &Lattice, owned: &[Site<D>], places: Vec<Place>, incoming: &[Site<D>]) {
        self.clear();
        self.reserve(owned.len() + incoming.len());
        if incoming.is_empty() {
            self.take(owned, places);
            return;
        }
        self.slot_of_incoming.resize(incoming.len(), 0);
        let mut arrivals = std::mem::take(&mut self.arrivals);
        arrivals.extend(incoming.iter().zip(0..).map(|(site, k)| (lattice.place(site), k)));
        arrivals.sort_unstable();
        let mut ghosts = arrivals.iter().peekable();
        for (site, place) in owned.iter().zip(places) {
            while let Some((ghost, k)) = ghosts.next_if(|(ghost, _)| *ghost < place) {
                self.push_ghost(*ghost, &incoming[*k as usize], *k);
            }
            self.slot_of_owned.push(self.places.len() as u32);
            self.push(place, site, false);
        }
        for (ghost, k) in ghosts {
            self.push_ghost(*ghost, &incoming[*k as usize], *k);
        }
        arrivals.clear();
        self.arrivals = arrivals;
        self.count = self.places.len();
    }

    pub fn owned(&self) -> usize {
        self.slot_of_owned.len()
    }

    pub fn ghosts(&self) -> usize {
        self.slot_of_incoming.len()
    }

    /// Releases the data that only the making of lists reads.
    pub fn forget_places(&mut self) {
        self.places = Vec::new();
        self.position = std::array::from_fn(|_| Vec::new());
        self.radius_squared = Vec::new();
        self.is_ghost = Vec::new();
        self.arrivals = Vec::new();
    }

    /// Bytes held, spare capacity included.
    pub fn bytes(&self) -> usize {
        let words = self.position.iter().map(Vec::capacity).sum::<usize>() + self.radius_squared.capacity();
        8 * words
            + std::mem::size_of::<Place>() * self.places.capacity()
            + 4 * (self.slot_of_owned.capacity() + self.slot_of_incoming.capacity())
            + self.is_ghost.capacity()
    }

    /// Owned particles alone.
    fn take(&mut self, owned: &[Site<D>], places: Vec<Place>) {
        self.slot_of_owned.extend(0..owned.len() as u32);
        for (k, column) in self.position.iter_mut().enumerate() {
            column.extend(owned.iter().map(|site| site.position[k]));
        }
        self.radius_squared.extend(owned.iter().map(|site| site.radius * site.radius));
        self.is_ghost.resize(owned.len(), false);
        self.count = owned.len();
        self.places = places;
    }

    fn reserve(&mut self, count: usize) {
        let columns = self.position.iter_mut().chain([&mut self.radius_squared]);
        columns
            .filter(|column| column.capacity() < count)
            .for_each(|column| *column = large_pages::with_capacity(count));
    }

    fn clear(&mut self) {
        self.slot_of_owned.clear();
        self.slot_of_incoming.clear();
        self.places.clear();
        self.position.iter_mut().for_each(Vec::clear);
        self.radius_squared.clear();
        self.is_ghost.clear();
    }

    fn push_ghost(&mut self, place: Place, site: &Site<D>, arrival: u32) {
        self.slot_of_incoming[arrival as usize] = self.places.len() as u32;
        self.push(place, site, true);
    }

    fn push(&mut self, place: Place, site: &Site<D>, ghost: bool) {
        debug_assert!(
            self.places.last().is_none_or(|last| *last < place),
            "particles are in canonical order and ids unique"
        );
        self.places.push(place);
        for (column, x) in self.position.iter_mut().zip(site.position) {
            column.push(x);
        }
        self.radius_squared.push(site.radius * site.radius);
        self.is_ghost.push(ghost);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn owned_and_ghosts_stand_in_one_order() {
        let lattice = Lattice::new(1.0);
        let site = |id, x, radius| Site { id, position: [x, 0.5], radius };
        let mut owned = vec![site(7, 3.5, 1.0), site(1, 0.5, 1.0), site(4, 0.2, 2.0)];
        owned.sort_by_key(|s| lattice.place(s));
        let incoming = [site(9, 0.5, 2.0), site(0, 0.7, 1.0), site(2, 1.5, 1.0)];
        let mut local = Local::default();
        for _ in 0..2 {
            local.build(&lattice, &owned, &incoming);
            let ids: Vec<_> = local.places.iter().map(|p| p.id).collect();
            assert_eq!(ids, [0, 1, 2, 7, 4, 9]);
            assert_eq!(local.slot_of_owned, [1, 3, 4]);
            assert_eq!(local.slot_of_incoming, [5, 0, 2]);
            assert_eq!(local.is_ghost, [true, false, true, false, false, true]);
            assert_eq!(local.position[0], [0.7, 0.5, 1.5, 3.5, 0.2, 0.5]);
            assert_eq!(local.radius_squared, [1.0, 1.0, 1.0, 1.0, 4.0, 4.0]);
        }
    }
}
