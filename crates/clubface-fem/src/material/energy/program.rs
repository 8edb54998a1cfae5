//! Expressions as lists of operations on numbered registers, which packs of points go through together: what a list
//! costs beyond its arithmetic is shared by all of them.

use super::graph::{Graph, Id, Part, exponential, logarithm, power, root};
use clubface_math::{Computation, Pack, Scalar};
use std::collections::HashMap;

/// Packs that go through the operations together: as many as the runs of one-point elements have.
pub const CHUNK: usize = 3;

/// A register, by its number: the invariants, then what does not vary, then what is computed.
type Register = u16;

/// What is done.
#[derive(Clone, Copy, Debug)]
enum Operation {
    Negative(Register),
    Sum(Register, Register),
    Difference(Register, Register),
    Product(Register, Register),
    /// `a b + c`.
    ProductSum(Register, Register, Register),
    Quotient(Register, Register),
    Power(Register, Register),
    Exponential(Register),
    Logarithm(Register),
    Root(Register),
}

/// Operations that compute some expressions from the invariants.
#[derive(Clone, Debug)]
pub struct Program<const N: usize> {
    /// What is done, and where its result goes.
    operations: Vec<(Operation, Register)>,
    /// Parts of the graph that do not vary, in the order of their registers.
    constants: Vec<Id>,
    /// Registers of the results.
    results: [Register; N],
    registers: usize,
}

impl<const N: usize> Program<N> {
    /// The program of some expressions.
    pub fn new(graph: &Graph, results: [Id; N]) -> Self {
        let last = results.iter().copied().max().unwrap_or(0);
        let mut uses = vec![0_usize; last + 1];
        results.iter().for_each(|&result| uses[result] += 1);
        for part in (0..=last).rev() {
            // Operands of what does not vary are no matter of the program.
            if uses[part] > 0 && graph.varies(part) {
                graph.parts()[part].operands().for_each(|a| uses[a] += 1);
            }
        }
        let constants: Vec<Id> = (0..=last).filter(|&part| uses[part] > 0 && !graph.varies(part)).collect();
        // A product that is used by one sum alone is one operation with it.
        let mut within = HashMap::new();
        for part in (0..=last).filter(|&part| uses[part] > 0 && graph.varies(part)) {
            if let Part::Sum(a, b) = graph.parts()[part] {
                let joins =
                    |a: Id| uses[a] == 1 && graph.varies(a) && matches!(graph.parts()[a], Part::Product(..));
                if let Some(joined) = [a, b].into_iter().find(|&each| joins(each)) {
                    within.insert(joined, part);
                }
            }
        }
        let fixed = (2 + constants.len()) as Register;
        let mut building =
            Building { registers: HashMap::new(), left: uses, free: vec![], fixed, count: fixed };
        for (place, &part) in constants.iter().enumerate() {
            building.registers.insert(part, (2 + place) as Register);
        }
        let mut operations = vec![];
        for part in 0..=last {
            if building.left[part] == 0 || !graph.varies(part) || within.contains_key(&part) {
                continue;
            }
            let operation = match graph.parts()[part] {
                Part::Number(_) | Part::Constant(_) => continue,
                Part::Invariant(index) => {
                    building.registers.insert(part, index as Register);
                    continue;
                }
                Part::Sum(a, b) if within.get(&a) == Some(&part) => building.joined(graph, a, b),
                Part::Sum(a, b) if within.get(&b) == Some(&part) => building.joined(graph, b, a),
                Part::Negative(a) => Operation::Negative(building.take(a)),
                Part::Sum(a, b) => Operation::Sum(building.take(a), building.take(b)),
                Part::Difference(a, b) => Operation::Difference(building.take(a), building.take(b)),
                Part::Product(a, b) => Operation::Product(building.take(a), building.take(b)),
                Part::Quotient(a, b) => Operation::Quotient(building.take(a), building.take(b)),
                Part::Power(a, b) => Operation::Power(building.take(a), building.take(b)),
                Part::Exponential(a) => Operation::Exponential(building.take(a)),
                Part::Logarithm(a) => Operation::Logarithm(building.take(a)),
                Part::Root(a) => Operation::Root(building.take(a)),
            };
            operations.push((operation, building.give(part)));
        }
        let results = results.map(|result| building.registers[&result]);
        Self { operations, constants, results, registers: usize::from(building.count) }
    }

    /// What does not vary, from the values of all parts.
    pub fn constants<S: Copy>(&self, values: &[S]) -> Vec<S> {
        self.constants.iter().map(|&part| values[part]).collect()
    }

    /// Registers with their constants.
    pub fn registers<P: Pack>(&self, constants: &[P::Real]) -> Vec<[P; CHUNK]> {
        P::outline(MakeRegisters::<P> { count: self.registers, constants })
    }

    /// Runs the operations for the first `count` packs, whose invariants stand in the first two registers.
    #[inline(always)]
    pub fn run<P: Pack>(&self, registers: &mut [[P; CHUNK]], count: usize) {
        for &(operation, result) in &self.operations {
            // Pack by pack, since a result may take the register of an operand.
            macro_rules! each {
                (|$($a:ident = $from:ident),+| $value:expr) => {
                    for i in 0..count.min(CHUNK) {
                        $(let $a = registers[usize::from($from)][i];)+
                        registers[usize::from(result)][i] = $value;
                    }
                };
            }
            match operation {
                Operation::Negative(a) => each!(|x = a| -x),
                Operation::Sum(a, b) => each!(|x = a, y = b| x + y),
                Operation::Difference(a, b) => each!(|x = a, y = b| x - y),
                Operation::Product(a, b) => each!(|x = a, y = b| x.product(y)),
                Operation::ProductSum(a, b, c) => each!(|x = a, y = b, z = c| x.mul_add(y, z)),
                Operation::Quotient(a, b) => each!(|x = a, y = b| x / y),
                Operation::Power(a, b) => each!(|x = a, y = b| P::outline(PowerOf(&x, &y))),
                Operation::Exponential(a) => each!(|x = a| P::outline(ExponentialOf(&x))),
                Operation::Logarithm(a) => each!(|x = a| P::outline(LogarithmOf(&x))),
                Operation::Root(a) => each!(|x = a| root(x)),
            }
        }
    }
    /// A result of a pack.
    #[inline(always)]
    pub fn result<P: Copy>(&self, registers: &[[P; CHUNK]], result: usize, pack: usize) -> P {
        registers[usize::from(self.results[result])][pack]
    }
}

/// Registers while a program is made.
struct Building {
    /// Of parts that are still needed.
    registers: HashMap<Id, Register>,
    /// How often a part is still used.
    left: Vec<usize>,
    free: Vec<Register>,
    /// The first register that is computed.
    fixed: Register,
    count: Register,
}

impl Building {
    /// The register of an operand, free for others after its last use; those of constants and invariants stay.
    fn take(&mut self, part: Id) -> Register {
        let register = self.registers[&part];
        self.left[part] -= 1;
        if self.left[part] == 0 && register >= self.fixed {
            self.free.push(register);
        }
        register
    }
    /// A register for a result.
    fn give(&mut self, part: Id) -> Register {
        let register = self.free.pop().unwrap_or_else(|| {
            self.count += 1;
            self.count - 1
        });
        self.registers.insert(part, register);
        register
    }
    /// A sum with a product in it.
    fn joined(&mut self, graph: &Graph, product: Id, other: Id) -> Operation {
        let Part::Product(a, b) = graph.parts()[product] else { unreachable!("a product joins") };
        Operation::ProductSum(self.take(a), self.take(b), self.take(other))
    }
}

/// Makes registers, with the features of the CPU that packs need.
struct MakeRegisters<'a, P: Pack> {
    count: usize,
    constants: &'a [P::Real],
}

impl<P: Pack> Computation for MakeRegisters<'_, P> {
    type Output = Vec<[P; CHUNK]>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let mut registers = vec![[P::zero(); CHUNK]; self.count];
        for (register, &constant) in registers[2..].iter_mut().zip(self.constants) {
            *register = [P::splat(constant); CHUNK];
        }
        registers
    }
}

// Functions of their own: each is as long as all the other operations together.

struct PowerOf<'a, P>(&'a P, &'a P);

impl<P: Scalar> Computation for PowerOf<'_, P> {
    type Output = P;
    #[inline(always)]
    fn run(self) -> P {
        power(*self.0, *self.1)
    }
}

struct ExponentialOf<'a, P>(&'a P);

impl<P: Scalar> Computation for ExponentialOf<'_, P> {
    type Output = P;
    #[inline(always)]
    fn run(self) -> P {
        exponential(*self.0)
    }
}

struct LogarithmOf<'a, P>(&'a P);

impl<P: Scalar> Computation for LogarithmOf<'_, P> {
    type Output = P;
    #[inline(always)]
    fn run(self) -> P {
        logarithm(*self.0)
    }
}
