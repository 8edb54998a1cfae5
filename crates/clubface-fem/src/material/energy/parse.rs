//! Reads an expression: numbers, names, `+ - * / ^`, parentheses and functions. Nothing of it is ever run as a program.

use super::graph::{Graph, Id};
use crate::error::FemError;
use std::iter::Peekable;
use std::str::CharIndices;

/// Most characters of an expression.
const LENGTH: usize = 2000;
/// Parentheses within parentheses, or signs and powers in a row.
const DEPTH: usize = 64;
/// Most constants.
const CONSTANTS: usize = 32;
/// Names of the invariants: of the change of shape, with and without a bar.
const INVARIANTS: [[&str; 2]; 2] = [["I1", "I1bar"], ["I2", "I2bar"]];
/// Names of functions.
const FUNCTIONS: [&str; 4] = ["exp", "log", "ln", "sqrt"];

/// Names that an expression has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Names {
    /// Of an energy of the change of shape: invariants, and constants of any name.
    Shape,
    /// Of an energy of the change of volume: its ratio J, and the bulk modulus.
    Volume,
}

impl Names {
    /// The key of a file.
    fn key(self) -> &'static str {
        match self {
            Self::Shape => "energy",
            Self::Volume => "volumetric",
        }
    }
}

/// What an expression is made of.
#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(f64),
    Name(String),
    Sign(char),
    End,
}

/// A message about a place in the expression.
struct Complaint {
    place: usize,
    message: String,
}

fn complain<T>(place: usize, message: impl Into<String>) -> Result<T, Complaint> {
    Err(Complaint { place, message: message.into() })
}

/// An expression that was read.
#[derive(Debug)]
pub struct Parsed {
    /// Its parts.
    pub graph: Graph,
    /// The whole.
    pub whole: Id,
    /// Names of its constants, as they come.
    pub constants: Vec<String>,
}

/// Reads an expression.
///
/// # Errors
/// [`FemError::Input`] that says at which character what is wrong.
pub fn parse(text: &str, names: Names) -> Result<Parsed, FemError> {
    let length = text.chars().count();
    if length > LENGTH {
        let allowed = format!("it must have at most {LENGTH}");
        return Err(FemError::input(format!("characters of {}", names.key()), length, allowed));
    }
    let read = || {
        let mut parser = Parser {
            text,
            letters: text.char_indices().peekable(),
            token: Token::End,
            place: 0,
            graph: Graph::default(),
            constants: vec![],
            names,
        };
        parser.advance()?;
        let whole = parser.sum(0)?;
        if parser.token != Token::End {
            return complain(parser.place, format!("{} is not expected", parser.shown()));
        }
        Ok(Parsed { graph: parser.graph, whole, constants: parser.constants })
    };
    read().map_err(|Complaint { place, message }| {
        let character = text.get(..place).map_or(length, |before| before.chars().count()) + 1;
        FemError::input(names.key(), format!("{text:?}"), format!("at character {character}, {message}"))
    })
}

struct Parser<'a> {
    text: &'a str,
    letters: Peekable<CharIndices<'a>>,
    token: Token,
    /// Where the token begins.
    place: usize,
    graph: Graph,
    constants: Vec<String>,
    names: Names,
}

impl Parser<'_> {
    /// The token, as a message shows it.
    fn shown(&self) -> String {
        match &self.token {
            Token::Number(value) => format!("the number {value}"),
            Token::Name(name) => format!("{name:?}"),
            Token::Sign(sign) => format!("{:?}", sign.to_string()),
            Token::End => "the end".to_owned(),
        }
    }

    /// Goes to the next token.
    fn advance(&mut self) -> Result<(), Complaint> {
        while self.letters.next_if(|(_, letter)| letter.is_whitespace()).is_some() {}
        let Some(&(place, letter)) = self.letters.peek() else {
            (self.place, self.token) = (self.text.len(), Token::End);
            return Ok(());
        };
        self.place = place;
        self.token = if letter.is_ascii_digit() || letter == '.' {
            Token::Number(self.number()?)
        } else if letter.is_ascii_alphabetic() || letter == '_' {
            let mut name = String::new();
            while let Some((_, letter)) =
                self.letters.next_if(|(_, letter)| letter.is_ascii_alphanumeric() || *letter == '_')
            {
                name.push(letter);
            }
            Token::Name(name)
        } else if "+-*/^()".contains(letter) {
            self.letters.next();
            // Python's sign of a power.
            let power = letter == '*' && self.letters.next_if(|(_, next)| *next == '*').is_some();
            Token::Sign(if power { '^' } else { letter })
        } else {
            let known = "an energy has numbers, names, + - * / ^ and ( )";
            return complain(place, format!("{:?} means nothing; {known}", letter.to_string()));
        };
        Ok(())
    }

    /// A number that begins here.
    fn number(&mut self) -> Result<f64, Complaint> {
        let mut digits = String::new();
        while let Some((_, letter)) =
            self.letters.next_if(|(_, letter)| letter.is_ascii_digit() || *letter == '.')
        {
            digits.push(letter);
        }
        if let Some((_, letter)) = self.letters.next_if(|(_, letter)| matches!(letter, 'e' | 'E')) {
            digits.push(letter);
            if let Some((_, sign)) = self.letters.next_if(|(_, letter)| matches!(letter, '+' | '-')) {
                digits.push(sign);
            }
            while let Some((_, letter)) = self.letters.next_if(|(_, letter)| letter.is_ascii_digit()) {
                digits.push(letter);
            }
        }
        match digits.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => complain(self.place, format!("{digits:?} is not a number")),
        }
    }

    fn takes(&mut self, sign: char) -> Result<bool, Complaint> {
        let taken = self.token == Token::Sign(sign);
        if taken {
            self.advance()?;
        }
        Ok(taken)
    }

    /// Refuses what nests too deep or has too many parts.
    fn check(&self, depth: usize) -> Result<(), Complaint> {
        if depth > DEPTH {
            return complain(self.place, format!("more than {DEPTH} parentheses or signs within each other"));
        }
        if self.graph.full() {
            return complain(self.place, "the energy has too many parts");
        }
        Ok(())
    }

    fn sum(&mut self, depth: usize) -> Result<Id, Complaint> {
        let mut sum = self.product(depth)?;
        loop {
            self.check(depth)?;
            if self.takes('+')? {
                let term = self.product(depth)?;
                sum = self.graph.sum(sum, term);
            } else if self.takes('-')? {
                let term = self.product(depth)?;
                sum = self.graph.difference(sum, term);
            } else {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self, depth: usize) -> Result<Id, Complaint> {
        let mut product = self.signed(depth)?;
        loop {
            self.check(depth)?;
            if self.takes('*')? {
                let factor = self.signed(depth)?;
                product = self.graph.product(product, factor);
            } else if self.takes('/')? {
                let divisor = self.signed(depth)?;
                product = self.graph.quotient(product, divisor);
            } else {
                return Ok(product);
            }
        }
    }

    /// A power with its sign: `-x^2` is `-(x^2)`.
    fn signed(&mut self, depth: usize) -> Result<Id, Complaint> {
        self.check(depth)?;
        if self.takes('-')? {
            let value = self.signed(depth + 1)?;
            return Ok(self.graph.negative(value));
        }
        if self.takes('+')? {
            return self.signed(depth + 1);
        }
        let base = self.atom(depth)?;
        if self.takes('^')? {
            // `x^y^z` is `x^(y^z)`.
            let exponent = self.signed(depth + 1)?;
            return Ok(self.graph.power(base, exponent));
        }
        Ok(base)
    }

    fn atom(&mut self, depth: usize) -> Result<Id, Complaint> {
        let (place, token) = (self.place, self.token.clone());
        match token {
            Token::Number(value) => {
                self.advance()?;
                if let Token::Name(name) = &self.token {
                    return complain(self.place, format!("\"*\" is missing before {name:?}"));
                }
                Ok(self.graph.number(value))
            }
            Token::Sign('(') => {
                self.advance()?;
                self.parenthesis(place, depth)
            }
            Token::Name(name) => {
                self.advance()?;
                let calls = self.token == Token::Sign('(');
                if calls {
                    return self.call(&name, place, depth);
                }
                self.named(name, place)
            }
            _ => complain(place, format!("a number, a name or \"(\" is missing before {}", self.shown())),
        }
    }

    /// What stands in a parenthesis that was opened at a place.
    fn parenthesis(&mut self, opened: usize, depth: usize) -> Result<Id, Complaint> {
        let inside = self.sum(depth + 1)?;
        if self.takes(')')? {
            return Ok(inside);
        }
        let character = self.text.get(..opened).map_or(0, |before| before.chars().count()) + 1;
        complain(
            self.place,
            format!("\")\" is missing before {}; \"(\" is character {character}", self.shown()),
        )
    }

    fn call(&mut self, name: &str, place: usize, depth: usize) -> Result<Id, Complaint> {
        if !FUNCTIONS.contains(&name) {
            let what = if name.starts_with("I1") || name.starts_with("I2") || self.is_constant(name) {
                format!("\"*\" is missing between {name:?} and \"(\"")
            } else {
                format!("{name:?} is no function; there are exp, log (or ln) and sqrt")
            };
            return complain(place, what);
        }
        let opened = self.place;
        self.advance()?;
        let inside = self.parenthesis(opened, depth)?;
        Ok(match name {
            "exp" => self.graph.exponential(inside),
            "sqrt" => self.graph.root(inside),
            _ => self.graph.logarithm(inside),
        })
    }

    fn is_constant(&self, name: &str) -> bool {
        self.constants.iter().any(|each| each == name)
    }

    fn named(&mut self, name: String, place: usize) -> Result<Id, Complaint> {
        if self.names == Names::Volume {
            return match &*name {
                "J" => Ok(self.graph.invariant(0)),
                "bulk" => Ok(self.graph.constant(0)),
                _ => complain(
                    place,
                    format!("{name:?} is unknown; the names are J, the ratio of volumes, and bulk"),
                ),
            };
        }
        if let Some(index) = INVARIANTS.iter().position(|names| names.contains(&&*name)) {
            return Ok(self.graph.invariant(index));
        }
        if FUNCTIONS.contains(&&*name) {
            return complain(place, format!("{name} is a function, as in {name}(I1)"));
        }
        let lower = name.to_lowercase();
        if INVARIANTS.iter().flatten().any(|invariant| invariant.to_lowercase() == lower) {
            return complain(place, format!("{name} is no constant; the invariants are written I1 and I2"));
        }
        if matches!(&*lower, "j" | "i3" | "i3bar") {
            let volume =
                "the energy of a change of volume is a formula of its own, volumetric, or else K/2 (J - 1)^2";
            return complain(place, format!("{name} is not available: {volume}"));
        }
        let index = self.constants.iter().position(|each| *each == name).unwrap_or_else(|| {
            self.constants.push(name);
            self.constants.len() - 1
        });
        if index >= CONSTANTS {
            return complain(place, format!("there are more than {CONSTANTS} constants"));
        }
        Ok(self.graph.constant(index))
    }
}
