//! The examples of `src/README.md`: an effect and a pair term, each as whole as in the program, and tested as there.

mod damping;
mod strain;
