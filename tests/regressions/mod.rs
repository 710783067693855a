//! One file for each bug found.

mod approximate_beliefs_close_exact_ones;
mod longer_of_two_best_pairs;
mod start_again_after_one_step;
