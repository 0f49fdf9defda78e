//! All tests that need the whole program or several ranks, by topic, in one binary: it links once.

mod allocations;
mod architecture;
mod balance;
mod boundaries;
mod common;
mod compaction;
mod craters;
mod errors;
mod exact;
mod faults;
mod fracture;
mod friction;
mod gravity;
mod hard_cases;
mod hard_neighbours;
mod hard_pores;
mod hard_pores_shocks;
mod output;
mod pair_loop;
mod pay_for_use;
mod ranks;
mod ranks_domain;
mod ranks_outcome;
mod sameness;
mod scenes;
mod studies;
