//! Runge-Kutta and Rosenbrock steppers in which every lane has its own step.
